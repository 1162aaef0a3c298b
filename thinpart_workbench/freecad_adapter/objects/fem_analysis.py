# SPDX-License-Identifier: LGPL-2.1-or-later
"""Analyses of FreeCAD's FEM workbench: what one needs beside a mesh, supports and loads."""

from itertools import chain

from .fem_mesh import meshed_owners

STEEL = {"YoungsModulus": "210000 MPa", "PoissonRatio": "0.30", "Density": "7850 kg/m^3"}
"""The material of a new analysis, which the user replaces."""


def analysis_for(document, owner):
    """The analysis that a mesh of an object may join, DocumentObject; None if there is none.

    One that has a mesh of the object, or else one without any mesh, since FEM solves an analysis with one mesh only.

    Parameters
    ----------
    document : FreeCAD.Document
    owner : FreeCAD.DocumentObject
    """
    found = [each for each in document.Objects if each.isDerivedFrom("Fem::FemAnalysis")]
    meshes = [[member for member in each.Group if member.isDerivedFrom("Fem::FemMeshObject")] for each in found]
    own = (each for each, its in zip(found, meshes) if any(owner in meshed_owners(mesh) for mesh in its))
    free = (each for each, its in zip(found, meshes) if not its)
    return next(chain(own, free), None)


def new_analysis(document, label, material_label):
    """Make an analysis with CalculiX as its solver and a material for all of it: DocumentObject; within a transaction.

    Supports, loads and a mesh are missing.

    Parameters
    ----------
    document : FreeCAD.Document
    label, material_label : str
        What people see.
    """
    import ObjectsFem

    analysis = ObjectsFem.makeAnalysis(document, "Analysis")
    analysis.Label = label
    # FreeCAD 1.0 writes the name of the solver in another way.
    make_solver = getattr(ObjectsFem, "makeSolverCalculiXCcxTools", None) or ObjectsFem.makeSolverCalculixCcxTools
    solver, material = make_solver(document), ObjectsFem.makeMaterialSolid(document, "Material")
    material.Label, material.Material = material_label, {"Name": material_label, **STEEL}
    for each in (solver, material):
        analysis.addObject(each)
        each.purgeTouched()
    return analysis

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shells for FreeCAD's FEM workbench: a mid-surface, its mesh of triangles, and the thickness of its faces."""

import json

from ...core.errors import ThinPartError
from ...core.message import message
from ...core.problem import problem_of
from ..shapes.brep_file import read_brep
from .fem_mesh import SETTINGS, SHELL_OF, join_analysis, part_property, read_mesh

_GROUP = "ThinPart"


def mid_surface_of(document, owner):
    """The mid-surface of an object; None if there is none."""
    return next((each for each in document.Objects if getattr(each, SHELL_OF, None) == owner), None)


def fem_shell_of(document, middle):
    """The FEM mesh of a mid-surface; None if there is none."""
    return next((each for each in document.Objects if hasattr(each, SETTINGS) and each.isDerivedFrom("Fem::FemMeshObject")
                 and getattr(each, part_property(each), None) == middle), None)


def shell_thicknesses(document, middle):
    """The objects with the thickness of a mid-surface, in the order of their names in the document."""
    return [each for each in document.Objects if hasattr(each, SETTINGS) and hasattr(each, "Thickness")
            and any(owner == middle for owner, _ in each.References)]


def set_fem_shell(document, owner, labels, shape, file, settings, size, order, thicknesses, analysis=None):
    """Make or update the shell of an object; to be called in a transaction.

    Returns a FreeCAD.DocumentObject: the mesh. Raises ThinPartError, kind ``unreadable`` if a file cannot be read.

    FEM finds the elements of a thickness by the faces that it refers to, so the mid-surface is an object too; supports and
    loads are put on it. The part is hidden, since it covers its shell.

    Parameters
    ----------
    document : FreeCAD.Document
    owner : FreeCAD.DocumentObject
    labels : tuple of str
        What people see of the mid-surface and of its mesh, where these are new.
    shape, file : str
        The mid-surface, BREP, and its mesh, UNV.
    settings : dict
        What it was made with, of plain values.
    size : float, mm
        Of the elements.
    order : int
        Of the elements.
    thicknesses : list of tuple
        Label, thickness in mm, and numbers of faces of the mid-surface, from 0.
    analysis : FreeCAD.DocumentObject, optional
        What is made joins it.
    """
    import ObjectsFem

    surface, nodes = _read_shape(shape), read_mesh(file)
    middle = mid_surface_of(document, owner)
    if middle is None:
        middle = document.addObject("Part::Feature", "ThinPart_MidSurface")
        middle.addProperty("App::PropertyLinkHidden", SHELL_OF, _GROUP, "What this is the mid-surface of")
        setattr(middle, SHELL_OF, owner)
        middle.Label = labels[0]
    old = shell_thicknesses(document, middle)
    middle.Shape = surface
    middle.purgeTouched()
    mesh = fem_shell_of(document, middle)
    if mesh is None:
        mesh = ObjectsFem.makeMeshGmsh(document, "ThinPart_ShellMesh")
        mesh.Label = labels[1]
        setattr(mesh, part_property(mesh), middle)
        mesh.addProperty("App::PropertyString", SETTINGS, _GROUP, "Settings of the shell by ThinPart")
    setattr(mesh, SETTINGS, json.dumps(settings))
    mesh.CharacteristicLengthMax = size
    mesh.ElementOrder = "2nd" if order == 2 else "1st"
    mesh.ElementDimension = "2D"
    mesh.FemMesh = nodes
    mesh.purgeTouched()
    own = _set_thicknesses(document, middle, old, thicknesses)
    join_analysis(document, owner, analysis, [mesh, *own])
    owner.Visibility = middle.Visibility = False
    mesh.Visibility = True
    if getattr(mesh, "ViewObject", None) is not None and hasattr(mesh.ViewObject, "BackfaceCulling"):
        mesh.ViewObject.BackfaceCulling = False  # or else walls are seen from one side only
    return mesh


def _set_thicknesses(document, middle, old, thicknesses):
    import ObjectsFem

    for each in old[len(thicknesses):]:
        document.removeObject(each.Name)
    found = old[:len(thicknesses)]
    for number, (label, thickness, faces) in enumerate(thicknesses):
        if number == len(found):
            made = ObjectsFem.makeElementGeometry2D(document, thickness, "ThinPart_Thickness")
            made.addProperty("App::PropertyString", SETTINGS, _GROUP, "Made by ThinPart")
            found.append(made)
        each = found[number]
        each.Thickness, each.Label = thickness, label
        each.References = [(middle, tuple(f"Face{face + 1}" for face in faces))]
        each.purgeTouched()
    return found


def _read_shape(path):
    try:
        return read_brep(path)
    except Exception as error:  # FreeCAD raises its own exception classes
        raise ThinPartError(message("The mid-surface cannot be read ({problem}): free some disk space and try again.",
                                    problem=problem_of(error, message("FreeCAD cannot read it"))), "unreadable") from None

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes of FreeCAD's FEM workbench, with a mesh region for each wall that has a size."""

import json
import os

from ...core.errors import ThinPartError
from ...core.message import message
from ...core.problem import problem_of
from ..occurrence import object_at
from ..occurrences.face_owners import face_indices
from ..shapes.part import SolidPart

SETTINGS = "ThinPartSizes"
"""Property of the mesh object: the settings it was made with, as JSON. Its mesh regions by ThinPart have it too, empty."""

SHELL_OF = "ThinPartShellOf"
"""Property of a mid-surface: the object that it is of. Hidden, so that either can be deleted without the other."""

_GROUP = "ThinPart"


def missing_fem():
    """Why FEM meshes cannot be made, in a sentence; empty if they can."""
    try:
        import Fem  # noqa: F401  whether it is there
        import ObjectsFem  # noqa: F401
    except ImportError:
        return message("This FreeCAD has no FEM workbench: install it (Debian: 'apt-get install freecad', elsewhere the "
                       "installer of freecad.org, which has it), then start FreeCAD again.")
    return ""


def preferred_gmsh():
    """The path of Gmsh in the preferences of FEM; empty where none is set."""
    import FreeCAD

    return FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Mod/Fem/Gmsh").GetString("gmshBinaryPath", "")


def meshed_object(document, part):
    """The object whose FEM mesh would be that of a part, and the part as it lies in it.

    Returns `owner` (FreeCAD.DocumentObject), `part` (SolidPart; with the shape of the owner) and `faces` (list of int;
    number of each face of the part among those of the owner, from 0). Raises ThinPartError, kind ``no_solid`` if there is
    none.

    Parameters
    ----------
    document : FreeCAD.Document
    part : SolidPart or MeshedPart
    """
    if not isinstance(part, SolidPart):
        raise ThinPartError(message("{part} is made of triangles, which are no solid to mesh.", part=part.label), "no_solid")
    occurrence = part.occurrences[0]
    leaf = object_at(occurrence.top(document), occurrence.path)
    owner = leaf.getLinkedObject(True) or leaf
    if owner.Document != document:
        raise ThinPartError(message(
            "{part} belongs to another document, {file}: open that one, and prepare its mesh there.",
            part=part.label, file=owner.Document.Label), "no_solid")
    if len(owner.Shape.Solids) != 1:
        raise ThinPartError(message(
            "'{part}' consists of {count} solids, which FEM meshes as one: take it apart first (Part workbench: Compound > "
            "Explode compound), then select one solid.", part=owner.Label, count=len(owner.Shape.Solids)), "no_solid")
    solid = owner.Shape.Solids[0]
    placed = SolidPart(part.name, part.label, part.occurrences, part.warnings, solid)
    return owner, placed, face_indices(owner.Shape, 0)


def fem_mesh_of(document, owner):
    """The Gmsh mesh of an object: that of ThinPart, or else the first one; None if there is none."""
    found = [each for each in document.Objects if getattr(getattr(each, "Proxy", None), "Type", "") == "Fem::FemMeshGmsh"
             and getattr(each, part_property(each)) == owner]
    return next((each for each in found if hasattr(each, SETTINGS)), found[0] if found else None)


def set_fem_mesh(document, owner, file, settings, global_size, order, walls, analysis=None):
    """Make or update the Gmsh mesh of an object, FreeCAD.DocumentObject; to be called in a transaction.

    Raises ThinPartError, kind ``unreadable`` if the mesh cannot be read.

    Regions of FEM are sizes at the corners of faces, in FreeCAD 0.20 to 1.1 alike: what FEM itself would mesh with them is
    fine near corners and not in the middle of large faces. So the mesh is the one that was made with the background field,
    and the regions say where it is fine.

    Parameters
    ----------
    document : FreeCAD.Document
    owner : FreeCAD.DocumentObject
    file : str
        The mesh, UNV.
    settings : dict
        What it was made with, of plain values.
    global_size : float, mm
    order : int
        Of the elements.
    walls : list of tuple
        Label, size in mm, and numbers of faces of the owner, from 0.
    analysis : FreeCAD.DocumentObject, optional
        The mesh joins it.
    """
    import ObjectsFem

    nodes = read_mesh(file)
    mesh = fem_mesh_of(document, owner)
    if mesh is None:
        mesh = ObjectsFem.makeMeshGmsh(document, "ThinPart_Mesh")
        mesh.Label = f"{owner.Label} mesh"
        setattr(mesh, part_property(mesh), owner)
    if not hasattr(mesh, SETTINGS):
        mesh.addProperty("App::PropertyString", SETTINGS, _GROUP, "Settings of the element sizes by ThinPart")
    setattr(mesh, SETTINGS, json.dumps(settings))
    mesh.CharacteristicLengthMax = global_size
    mesh.ElementOrder = "2nd" if order == 2 else "1st"
    _set_regions(document, mesh, owner, walls)
    mesh.FemMesh = nodes
    owner.Visibility, mesh.Visibility = False, True  # two surfaces in the same place flicker
    mesh.purgeTouched()
    join_analysis(document, owner, analysis, [mesh])
    return mesh


def _set_regions(document, mesh, owner, walls):
    old = [each for each in mesh.MeshRegionList if hasattr(each, SETTINGS)]
    mesh.MeshRegionList = [each for each in mesh.MeshRegionList if each not in old]
    for each in old:
        document.removeObject(each.Name)
    import ObjectsFem

    taken = set()
    # FEM uses a face once; the smallest size is the one that counts.
    for label, size, faces in sorted(walls, key=lambda wall: wall[1]):
        own = [face for face in faces if face not in taken]
        taken.update(own)
        if own:
            region = ObjectsFem.makeMeshRegion(document, mesh, size, "ThinPart_MeshRegion")
            region.addProperty("App::PropertyString", SETTINGS, _GROUP, "Made by ThinPart")
            region.Label = label
            region.References = [(owner, tuple(f"Face{face + 1}" for face in own))]
            region.purgeTouched()


def read_mesh(file):
    """A FEM mesh from a file of the format UNV; a ThinPartError of the kind ``unreadable`` where that cannot be read."""
    import Fem

    try:
        return Fem.read(os.fspath(file))
    except Exception as error:  # FreeCAD raises its own exception classes
        raise ThinPartError(message("The mesh cannot be read ({problem}): free some disk space and try again.",
                                    problem=problem_of(error, message("FreeCAD cannot read it"))), "unreadable") from None


def join_analysis(document, owner, analysis, members):
    """Put objects into an analysis, of which the first is a mesh.

    FEM solves an analysis with one mesh only. So what ThinPart made of the same object the other way, as a shell or as a
    solid, leaves the analysis; it stays in the document.

    Parameters
    ----------
    document : FreeCAD.Document
    owner : FreeCAD.DocumentObject
        What the mesh is of.
    analysis : FreeCAD.DocumentObject or None
        None for that which the mesh is in already.
    members : list of FreeCAD.DocumentObject
    """
    mesh = members[0]
    analysis = analysis or next((each for each in mesh.InList if each.isDerivedFrom("Fem::FemAnalysis")), None)
    if analysis is None:
        return
    for each in list(analysis.Group):
        if each not in members and hasattr(each, SETTINGS) and owner in meshed_owners(each):
            analysis.removeObject(each)
    for each in members:
        if each not in analysis.Group:
            analysis.addObject(each)


def meshed_owners(made):
    """What a mesh or a thickness by ThinPart is of: the object itself, also where it refers to its mid-surface."""
    found = [owner for owner, *_ in getattr(made, "References", ())]
    if made.isDerivedFrom("Fem::FemMeshObject"):
        found.append(getattr(made, part_property(made)))
    return found + [getattr(each, SHELL_OF) for each in found if hasattr(each, SHELL_OF)]


def part_property(mesh):
    """The property with the object that is meshed: ``Part`` in FreeCAD 0.20, ``Shape`` from 1.0 on."""
    return "Part" if "Part" in mesh.PropertiesList else "Shape"

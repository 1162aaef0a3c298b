# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parts of a FreeCAD shape, mesh, object or document that a program passes in."""

from ...core.errors import ThinPartError
from ..bootstrap import load_freecad
from ..mesh_arrays import mesh_arrays
from ..shapes.part import MeshedPart
from .document_parts import DocumentContent, document_content, object_content
from .shape_parts import shape_parts

_LABEL = "shape"
"""Label of parts without a name of their own."""


def held_content(source):
    """Distinct parts of a Part.Shape, Mesh.Mesh, DocumentObject or Document: DocumentContent, not empty.

    Raises ThinPartError, kind ``usage`` for any other type, ``empty`` or ``no_solid`` if it holds no part.
    """
    load_freecad()
    import FreeCAD
    import Mesh
    import Part

    if isinstance(source, Part.Shape):
        if source.isNull():
            raise ThinPartError("The shape is empty.", "empty")
        content = DocumentContent(shape_parts(source, _LABEL, "The shape"))
        name = "The shape"
    elif isinstance(source, Mesh.Mesh):
        content = DocumentContent([_meshed_part(source)])
        name = "The mesh"
    elif isinstance(source, FreeCAD.Document):
        content, name = document_content(source), f"The document {source.Label}"
    elif isinstance(source, FreeCAD.DocumentObject):
        content, name = object_content(source), f"'{source.Label}'"
    else:
        raise ThinPartError(
            f"{type(source).__name__} is nothing that can be classified: give a file, a shape, a mesh, an object or "
            "document of FreeCAD, or vertices and triangles.", "usage")
    if not content.parts and not content.broken:
        raise ThinPartError(f"{name} holds no closed solid, only surfaces, wires or points: "
                            "close or thicken it first.", "no_solid")
    return content


def _meshed_part(mesh):
    points, triangles = mesh_arrays(mesh)
    if not len(triangles):
        raise ThinPartError("The mesh has no triangles.", "empty")
    return MeshedPart("Mesh", "mesh", points=points, triangles=triangles)

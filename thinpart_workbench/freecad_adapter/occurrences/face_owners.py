# SPDX-License-Identifier: LGPL-2.1-or-later
"""Find the document objects whose view providers draw the faces of a part."""

from ..occurrence import object_at
from ..shapes.part import SolidPart


def face_owners(document, part):
    """The objects that draw the faces of a part: list of tuple.

    ``(object, indices)``: face k of the part is ``object.Shape.Faces[indices[k]]``; a mesh is one face.

    A link shows the faces of its linked object, and a body those of its tip: these own the colours. Objects of
    other documents are left out, because their colours belong to the user of that document.

    Parameters
    ----------
    document : FreeCAD.Document
    part : SolidPart or MeshedPart
    """
    owners = {}
    for occurrence in part.occurrences:
        owner = _owner(document, occurrence)
        if owner is None or owner.Document != document or owner.Name in owners:
            continue
        if not isinstance(part, SolidPart):
            owners[owner.Name] = (owner, [0])
            continue
        indices = face_indices(owner.Shape, occurrence.solid)
        if len(indices) == len(part.shape.Faces):
            owners[owner.Name] = (owner, indices)
    return list(owners.values())


def _owner(document, occurrence):
    root = occurrence.top(document)
    if root is None:
        return None
    leaf = object_at(root, occurrence.path)
    source = leaf.getLinkedObject(True) or leaf
    if source.isDerivedFrom("PartDesign::Body"):
        return source.Tip
    return source if source.isDerivedFrom("Part::Feature") or source.isDerivedFrom("Mesh::Feature") else None


def face_indices(shape, solid):
    """Indices of the faces of the solid with a given index among all faces of its shape.

    list of int, empty if there is no such solid.
    """
    solids = shape.Solids
    if solid >= len(solids):
        return []
    if len(solids) == 1:
        faces = solids[0].Faces
        if len(faces) == len(shape.Faces):
            return list(range(len(faces)))
    by_hash = {}
    for index, face in enumerate(shape.Faces):
        by_hash.setdefault(face.hashCode(), []).append((index, face))
    found = []
    for face in solids[solid].Faces:
        found += [index for index, candidate in by_hash.get(face.hashCode(), ()) if candidate.isSame(face)][:1]
    return found

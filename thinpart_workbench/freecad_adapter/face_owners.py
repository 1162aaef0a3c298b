"""The objects of a document whose views draw the faces of a part."""

from .part import SolidPart


def face_owners(document, part):
    """Where the faces of a part are drawn.

    Parameters
    ----------
    document : FreeCAD.Document
    part : SolidPart or MeshedPart

    Returns
    -------
    list of tuple
        ``(object, indices)``: the part's face number k is ``object.Shape.Faces[indices[k]]``.

    Notes
    -----
    A link shows the faces of what it links to, and a body those of its tip: these own the colours.
    What lies in another document is left out, for its colours belong to that document's user.
    """
    if not isinstance(part, SolidPart):
        return []
    owners = {}
    for place in part.occurrences:
        owner = _owner(document, place)
        if owner is None or owner.Document != document or owner.Name in owners:
            continue
        indices = face_indices(owner.Shape, place.solid)
        if len(indices) == len(part.shape.Faces):
            owners[owner.Name] = (owner, indices)
    return list(owners.values())


def _owner(document, place):
    root = document.getObject(place.root)
    if root is None:
        return None
    leaf = root.getSubObjectList(place.path)[-1] if place.path else root
    source = leaf.getLinkedObject(True) or leaf
    if source.isDerivedFrom("PartDesign::Body"):
        return source.Tip
    return source if source.isDerivedFrom("Part::Feature") else None


def face_indices(shape, solid):
    """Places of the faces of a solid, by its number, among all faces of the shape that holds it.

    list of int, empty where there is no such solid.
    """
    solids = shape.Solids
    if solid >= len(solids):
        return []
    if len(solids) == 1:
        wanted = solids[0].Faces
        if len(wanted) == len(shape.Faces):
            return list(range(len(wanted)))
    places = {}
    for index, face in enumerate(shape.Faces):
        places.setdefault(face.hashCode(), []).append((index, face))
    found = []
    for face in solids[solid].Faces:
        found += [index for index, each in places.get(face.hashCode(), ()) if each.isSame(face)][:1]
    return found

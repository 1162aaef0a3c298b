"""Where the parts of a document stand, and the objects and faces that stand there."""

import numpy as np

from .equal_solids import motion
from .face_owners import face_indices
from .part import SolidPart
from .source_signature import links_in


def places_of(document, part, measured):
    """From where a part stood when it was measured to each of its places.

    Parameters
    ----------
    document : FreeCAD.Document
    part : SolidPart or MeshedPart
        As it is in the document now.
    measured : SolidPart or MeshedPart
        The same part as it was; see `same_parts`.

    Returns
    -------
    ndarray of shape (p, 4, 4), mm
        In the order of the part's occurrences.
    """
    if not isinstance(part, SolidPart):
        return np.eye(4)[None]  # the points of a mesh would be others if it had been moved
    first = motion(measured.shape, part.shape)
    others = [motion(part.shape, _shape_at(document, place).Solids[place.solid])
              for place in part.occurrences[1:]]
    return np.stack([first, *(each @ first for each in others)])


def sources_of(document, parts):
    """The objects of a document whose change changes parts or where they stand, each once.

    Parameters
    ----------
    document : FreeCAD.Document
    parts : list of SolidPart or MeshedPart

    Returns
    -------
    list of App.DocumentObject
        Of what lies in another document, the link that leads there; of what lies in linked containers, the
        links too.
    """
    found = {}
    for part in parts:
        for place in part.occurrences:
            chain = [each for each in _chain(document, place) if each.Document == document]
            # A link to a container moves what lies in that, which itself stays where it is.
            for each in (*chain[-1:], *links_in(chain)):
                found.setdefault(each.Name, each)
    return list(found.values())


def face_at(parts, document, root, path):
    """The part and the face that a sub-object path leads to.

    Parameters
    ----------
    parts : list of SolidPart or MeshedPart
    document : FreeCAD.Document
    root, path : str
        As FreeCAD's selection has them; the path ends with the name of a face.

    Returns
    -------
    part : SolidPart or None
    face : int or None
        From 0.
    """
    way, _, element = path.rpartition(".")
    way = way + "." if way else ""
    if not element.startswith("Face"):
        return None, None
    number = int(element[4:]) - 1
    for part in parts:
        if isinstance(part, SolidPart):
            for place in part.occurrences:
                if place.root == root and way.startswith(place.path):
                    indices = face_indices(_shape_at(document, place), place.solid)
                    if number in indices:
                        return part, indices.index(number)
    return None, None


def face_paths(document, part, faces):
    """Sub-object paths of faces of a part where it stands first.

    Parameters
    ----------
    document : FreeCAD.Document
    part : SolidPart or MeshedPart
    faces : iterable of int
        From 0.

    Returns
    -------
    root : str
    paths : list of str
        Empty where there are no faces, as in a mesh.
    """
    place = part.occurrences[0]
    if not isinstance(part, SolidPart):
        return place.root, []
    indices = face_indices(_shape_at(document, place), place.solid)
    return place.root, [f"{place.path}Face{indices[face] + 1}" for face in faces if face < len(indices)]


def _shape_at(document, place):
    import Part

    return Part.getShape(document.getObject(place.root), place.path, needSubElement=False, transform=True)


def _chain(document, place):
    """What a place leads through, from the top object to what stands there."""
    top = document.getObject(place.root)
    chain = top.getSubObjectList(place.path) if place.path else [top]
    return [each for each in chain if each is not None]

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The matrices of the occurrences of parts, and the objects and faces at them."""

import numpy as np

from ..occurrence import objects_along, shape_at, split_at_element
from ..shapes.equal_solids import motion
from ..shapes.part import SolidPart
from ..shapes.placements import links_in
from .face_owners import face_indices


def occurrence_matrices(document, part, measured):
    """Matrices from the position of a part when it was measured to each of its occurrences: ndarray of shape (p, 4, 4), mm.

    In the order of the part's occurrences.

    Parameters
    ----------
    document : FreeCAD.Document
    part : SolidPart or MeshedPart
        As it is in the document now.
    measured : SolidPart or MeshedPart
        The same part at the time of the measurement; see `same_parts`.
    """
    if not isinstance(part, SolidPart):
        return np.eye(4)[None]  # a mesh that was moved has other points, so it is not the same part
    first = motion(measured.shape, part.shape)
    others = [motion(part.shape, _shape_at(document, occurrence).Solids[occurrence.solid])
              for occurrence in part.occurrences[1:]]
    return np.stack([first, *(matrix @ first for matrix in others)])


def sources_of(document, parts):
    """The objects of a document that parts and their placements depend on, without duplicates: list of App.DocumentObject.

    For a part in another document the link to it; for a part in a linked container the links too.

    Parameters
    ----------
    document : FreeCAD.Document
    parts : list of SolidPart or MeshedPart
    """
    found = {}
    for part in parts:
        for occurrence in part.occurrences:
            chain = [source for source in objects_along(occurrence.top(document), occurrence.path)
                     if source.Document == document]
            # A link to a container moves the objects in it, whose own placements do not change.
            for source in (*chain[-1:], *links_in(chain)):
                found.setdefault(source.Name, source)
    return list(found.values())


def face_at(parts, document, root, path):
    """The part and the face at a sub-object path. Returns `part` (SolidPart or None) and `face` (int or None; from 0).

    Parameters
    ----------
    parts : list of SolidPart or MeshedPart
    document : FreeCAD.Document
    root, path : str
        As FreeCAD's selection gives them; the path ends with the name of a face.
    """
    object_path, element = split_at_element(path)
    if not element.startswith("Face"):
        return None, None
    number = int(element[4:]) - 1
    for part in parts:
        if isinstance(part, SolidPart):
            for occurrence in part.occurrences:
                if occurrence.is_around(root, object_path):
                    indices = face_indices(_shape_at(document, occurrence), occurrence.solid)
                    if number in indices:
                        return part, indices.index(number)
    return None, None


def face_paths(document, part, faces):
    """Sub-object paths of faces of a part at its first occurrence.

    Returns `root` (str) and `paths` (list of str; empty if the part has no faces, as a mesh).

    Parameters
    ----------
    document : FreeCAD.Document
    part : SolidPart or MeshedPart
    faces : iterable of int
        From 0.
    """
    occurrence = part.occurrences[0]
    if not isinstance(part, SolidPart):
        return occurrence.root, []
    indices = face_indices(_shape_at(document, occurrence), occurrence.solid)
    return occurrence.root, [f"{occurrence.path}Face{indices[face] + 1}" for face in faces if face < len(indices)]


def _shape_at(document, occurrence):
    return shape_at(occurrence.top(document), occurrence.path)

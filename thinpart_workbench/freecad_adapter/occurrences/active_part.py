# SPDX-License-Identifier: LGPL-2.1-or-later
"""Find the parts of a document that the selection or the active body refers to."""

from ...core.errors import ThinPartError
from ...core.message import message
from ..occurrence import object_at, objects_along, split_at_element
from ..reading.document_parts import part_at
from ..shapes.part import SolidPart


def selected_parts(document, parts, selection, active=None):
    """The parts that the selection may refer to; if there are several, the user has to choose.

    Returns a list: at least one part. Raises ThinPartError, kind ``empty`` for a document without parts, ``no_solid`` for a
    selection without any.

    Parameters
    ----------
    document : FreeCAD.Document
    parts : list
        From `document_parts`.
    selection : list of tuple
        ``(name of the top object, sub-object path)`` of every selected object or face.
    active : tuple, optional
        The same for the active body.
    """
    if not parts:
        raise ThinPartError(_nothing_in(document), "empty")
    chosen = _distinct(parts, [_parts_at(document, parts, *selected) for selected in selection])
    if chosen:
        return chosen
    if selection:
        raise ThinPartError(
            message("There is no closed solid in '{object}': select a solid, a body, or a face of one.",
                    object=_label(document, *selection[0])), "no_solid",
        )
    if active is not None:
        chosen = _parts_at(document, parts, *active)
    return chosen or list(parts)


def _nothing_in(document):
    if document.Objects:
        return message("There is no closed solid in the document '{document}': make or import a solid first.",
                       document=document.Label)
    return message("The document '{document}' is empty: make or import a solid first.", document=document.Label)


def _distinct(parts, chosen):
    chosen_ids = {id(part) for group in chosen for part in group}
    return [part for part in parts if id(part) in chosen_ids]


def _parts_at(document, parts, root, path):
    """Parts at, below or around a path; if there are none, those made from the object at the path."""
    top = document.getObject(root)
    if top is None:
        return []
    found = _parts_below(parts, root, path) or _parts_of_objects(
        document, parts, set(objects_along(top, path))
    )
    if not found:
        found = _parts_of_objects(document, parts, set(top.InListRecursive))
    face = split_at_element(path)[1]
    if face.startswith("Face") and len(found) > 1:
        found = [part for part in found if _has_face(top, path, part)] or found
    return found


def _parts_below(parts, root, path):
    containing = part_at(parts, root, path)
    if containing is not None:
        # All solids of one object share its path.
        object_path = next(occurrence.path for occurrence in containing.occurrences
                     if occurrence.is_around(root, path))
        return [part for part in parts
                if any((occurrence.root, occurrence.path) == (root, object_path) for occurrence in part.occurrences)]
    return [part for part in parts
            if any(occurrence.is_within(root, path) for occurrence in part.occurrences)]


def _parts_of_objects(document, parts, objects):
    """Parts with an occurrence at one of the given objects."""
    return [
        part for part in parts
        if any(object_at(occurrence.top(document), occurrence.path) in objects
               for occurrence in part.occurrences)
    ]


def _has_face(top, path, part):
    """Whether a selected face belongs to a part, whatever the part's placement."""
    if not isinstance(part, SolidPart):
        return False
    face = top.getSubObject(path)
    return face is not None and any(other.isPartner(face) for other in part.shape.Faces)


def _label(document, root, path):
    top = document.getObject(root)
    return root if top is None else objects_along(top, path)[-1].Label

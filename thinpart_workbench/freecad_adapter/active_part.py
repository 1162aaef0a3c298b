"""Which part of a document is meant by what is selected or active."""

from ..core.errors import ThinPartError
from .document_parts import part_at
from .part import SolidPart


def parts_meant(document, parts, selection, active=None):
    """The parts that the user may mean; where there is more than one, they have to choose.

    Parameters
    ----------
    document : FreeCAD.Document
    parts : list
        From `document_parts`.
    selection : list of tuple
        ``(name of the top object, sub-object path)`` of everything selected, faces included.
    active : tuple, optional
        The same of the active body.

    Returns
    -------
    list
        At least one part.

    Raises
    ------
    ThinPartError
        kind ``empty`` for a document without parts, ``no_solid`` for a selection without.
    """
    if not parts:
        raise ThinPartError(_nothing_in(document), "empty")
    chosen = _distinct(parts, [_parts_at(document, parts, *place) for place in selection])
    if chosen:
        return chosen
    if selection:
        raise ThinPartError(
            f"There is no closed solid in '{_label(document, *selection[0])}': select a solid, a "
            "body, or a face of one.", "no_solid",
        )
    if active is not None:
        chosen = _parts_at(document, parts, *active)
    return chosen or list(parts)


def _nothing_in(document):
    if document.Objects:
        return (f"There is no closed solid in the document '{document.Label}': make or import a "
                "solid first.")
    return f"The document '{document.Label}' is empty: make or import a solid first."


def _distinct(parts, chosen):
    wanted = {id(part) for some in chosen for part in some}
    return [part for part in parts if id(part) in wanted]


def _parts_at(document, parts, root, path):
    """Parts at, below or around a place; else those that use up the object that stands there."""
    top = document.getObject(root)
    if top is None:
        return []
    found = _parts_below(parts, root, path) or _parts_of_objects(
        document, parts, set(_chain(top, path))
    )
    if not found:
        found = _parts_of_objects(document, parts, set(top.InListRecursive))
    face = path.rpartition(".")[2]
    if face.startswith("Face") and len(found) > 1:
        found = [each for each in found if _has_face(top, path, each)] or found
    return found


def _parts_below(parts, root, path):
    at = part_at(parts, root, path)
    if at is not None:
        # The solids of one object stand at one place.
        place = next(each.path for each in at.occurrences
                     if each.root == root and path.startswith(each.path))
        return [part for part in parts
                if any((each.root, each.path) == (root, place) for each in part.occurrences)]
    return [part for part in parts
            if any(each.root == root and each.path.startswith(path) for each in part.occurrences)]


def _parts_of_objects(document, parts, objects):
    """Parts one of whose places ends in, or leads through, one of some objects."""
    return [
        part for part in parts
        if any(_chain(document.getObject(each.root), each.path)[-1] in objects
               for each in part.occurrences)
    ]


def _chain(top, path):
    chain = top.getSubObjectList(path) if path else []
    return [each for each in chain if each is not None] or [top]


def _has_face(top, path, part):
    """Whether a selected face belongs to a part, wherever the part stands."""
    if not isinstance(part, SolidPart):
        return False
    face = top.getSubObject(path)
    return face is not None and any(each.isPartner(face) for each in part.shape.Faces)


def _label(document, root, path):
    top = document.getObject(root)
    return root if top is None else _chain(top, path)[-1].Label

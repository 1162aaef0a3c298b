# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parts of an open document: those that are selected, whether they are as they were, and what files may be opened."""

from ...freecad_adapter.objects.thickness_object import is_thickness
from ...freecad_adapter.occurrence import object_at
from ...freecad_adapter.occurrences.active_part import selected_parts
from ...freecad_adapter.reading.closed_links import check_links
from ...freecad_adapter.reading.document_parts import document_content, document_parts
from ...freecad_adapter.reading.document_safety import check_document
from ...freecad_adapter.shapes.part import SolidPart
from ...freecad_adapter.shapes.placements import global_placement, same_placement
from ...freecad_adapter.shapes.same_parts import same_parts
from ...freecad_adapter.shapes.source_signature import same_signature, signature
from ...freecad_adapter.thin_colours import preferred_colours


def content_of(document):
    """What a document consists of now: DocumentContent, with ``parts`` and ``broken`` ones.

    Raises a ThinPartError, kind ``empty`` or ``no_solid``, where it has no parts.

    Examples
    --------
    >>> [part.label for part in content_of(document).parts]
    ['plate']
    """
    return document_content(document)


def parts_selected(document, selected, active=None, parts=None):
    """The parts of a document that a selection means: list of SolidPart or MeshedPart. Raises as `content_of`.

    Parameters
    ----------
    document : FreeCAD.Document
    selected : list of (str, str)
        Name of an object at the top, and path below it, of everything that is selected. A thickness map means its parts.
    active : (str, str), optional
        The same of the active body or part.
    parts : list, optional
        The parts of the document, where they are known.

    Examples
    --------
    >>> [part.label for part in parts_selected(document, [])]
    ['plate']
    """
    meant = [each for path in selected for each in _meant_by(document, *path)]
    return selected_parts(document, content_of(document).parts if parts is None else parts, meant, active)


def _meant_by(document, root, path):
    """What a selected object stands for: paths as in `parts_selected`."""
    top = document.getObject(root)
    chosen = None if top is None else object_at(top, path)
    if chosen is None or not is_thickness(chosen):
        return [(root, path)]
    sources = [source for source in chosen.Sources if source is not None and source.Document == document]
    return [(source.Name, "") for source in sources] or [(root, path)]


def parts_as_measured(document, measured, is_whole=True):
    """The parts of a document that were measured, as they are in it now; None where they have changed.

    Parameters
    ----------
    document : FreeCAD.Document
    measured : list of SolidPart or MeshedPart
    is_whole : bool, optional
        Whether all parts were measured, so that a further one is a change.

    Examples
    --------
    >>> len(parts_as_measured(document, content_of(document).parts))
    1
    """
    current = document_parts(document)
    if not is_whole:
        names = {part.name for part in measured}
        current = [part for part in current if part.name in names]
    return current if same_parts(measured, current) else None


class SourcesState:
    """Shapes and places of objects of a document, to be compared later."""

    def __init__(self, objects):
        self._objects, self._before = objects, self._now(objects)

    @property
    def is_unchanged(self):
        """Whether they are as they were."""
        (shapes, placements), (now, places) = self._before, self._now(self._objects)
        return same_signature(shapes, now) and all(map(same_placement, placements, places))

    @staticmethod
    def _now(objects):
        return signature(objects), [global_placement(each) for each in objects]


def colours_of_thin_faces(record, part):
    """Colours of the thin faces of a part, as the preferences have them: dict of (r, g, b) from 0 to 1 by face, from 0.

    The faces of a SolidPart are told apart, a MeshedPart is shown as one.

    Examples
    --------
    >>> 0 in colours_of_thin_faces(record, content_of(document).parts[0])
    True
    """
    return preferred_colours(record, isinstance(part, SolidPart))


def check_file(file):
    """Check that FreeCAD may open a file: that it runs nothing, and links to nothing outside its folder.

    Raises a ThinPartError, kind ``unsafe`` or ``unreadable``.

    Examples
    --------
    >>> check_file(plate)
    """
    check_document(file)
    check_links(file)

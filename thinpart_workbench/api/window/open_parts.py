"""The parts of an open document, and those of them that are selected."""

from ...freecad_adapter.occurrences.active_part import selected_parts
from ...freecad_adapter.reading.document_parts import document_content


def parts_selected(document, selected, active=None):
    """The parts of a document that a selection means.

    Parameters
    ----------
    document : FreeCAD.Document
    selected : list of (str, str)
        Name of an object at the top, and path below it, of everything that is selected.
    active : (str, str), optional
        The same of the active body or part.

    Returns
    -------
    list of SolidPart or MeshedPart

    Raises
    ------
    ThinPartError
        kind ``empty`` or ``no_solid`` where the document has no parts.

    Examples
    --------
    >>> [part.label for part in parts_selected(document, [])]
    ['plate']
    """
    return selected_parts(document, document_content(document).parts, selected, active)

"""The part record of what is active in FreeCAD's window."""

import FreeCAD as App
import FreeCADGui as Gui

from ..core.errors import ThinPartError
from ..freecad_adapter.active_part import parts_meant
from ..freecad_adapter.document_parts import document_content
from ..workflow.kept_notes import info_file_of, the_record
from .chosen_in_window import active_place, selected_places
from .classify import current_session
from .document_observer import OBSERVER
from .part_dialog import ask_for_part
from .qt import translate


def active_record():
    """The record of the part that is selected or active.

    Returns
    -------
    record : dict or None
        None where the user was asked for a part and named none.
    info_file : str or None
        Where it is from; None for a classification that is not stored.

    Raises
    ------
    ThinPartError
        Where there is no part, or it was not classified.
    """
    document = App.ActiveDocument
    if document is None:
        raise ThinPartError(translate("ThinPart", "There is no document: open or create one first."), "empty")
    parts = parts_meant(document, document_content(document).parts, selected_places(document),
                        active_place(document))
    chosen = parts[0] if len(parts) == 1 else ask_for_part(parts, Gui.getMainWindow())
    if chosen is None:
        return None, None
    session = current_session()
    shown = session.record_of(document.Name, chosen.name) if session is not None else None
    if shown is not None and OBSERVER.differs_from_file(document):
        return shown, None  # newer than what may be stored
    try:
        info_file = info_file_of(document.FileName) if document.FileName else None
        if info_file is not None:
            return the_record(info_file, chosen.name), str(info_file)
    except ThinPartError:
        pass  # not stored, or without this part
    if shown is not None:
        return shown, None
    raise ThinPartError(translate(
        "ThinPart", "'{}' was not classified yet: classify the part first.").format(chosen.label), "missing")

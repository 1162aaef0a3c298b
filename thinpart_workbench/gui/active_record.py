"""The part that is active in FreeCAD's window, and where its record is."""

import os
from collections import namedtuple

import FreeCAD as App
import FreeCADGui as Gui

from ..core.errors import ThinPartError
from ..freecad_adapter.active_part import parts_meant
from ..freecad_adapter.document_parts import document_content
from ..workflow.info_location import preferred_info_location
from .chosen_in_window import active_place, selected_places
from .classify import current_session
from .document_observer import OBSERVER
from .part_dialog import ask_for_part
from .qt import translate

ActiveRecord = namedtuple("ActiveRecord", "name label shown info_file")
ActiveRecord.__doc__ = """A part, and what is known of it without looking at a file.

`shown` is the record that the Classify panel has of it, None where it has none. `info_file` is where a
record may be stored that is just as new; None where there is none.
"""


def active_record():
    """The part that is selected or active.

    Returns
    -------
    ActiveRecord or None
        None where the user was asked for a part and named none.

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
        return None
    session = current_session()
    shown = session.record_of(document.Name, chosen.name) if session is not None else None
    info_file = None
    if document.FileName and (shown is None or not OBSERVER.differs_from_file(document)):
        info_file = os.fspath(preferred_info_location(document.FileName))
    active = ActiveRecord(chosen.name, chosen.label, shown, info_file)
    if shown is None and info_file is None:
        raise ThinPartError(not_classified(active), "missing")
    return active


def not_classified(active):
    """A sentence on a part that has no record."""
    return translate(
        "ThinPart", "'{}' was not classified yet: classify the part first.").format(active.label)

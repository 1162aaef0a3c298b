# SPDX-License-Identifier: LGPL-2.1-or-later
"""Finds the active part in FreeCAD and the location of its record."""

import os
from collections import namedtuple

import FreeCAD as App
import FreeCADGui as Gui

from ...api.window.open_parts import parts_selected
from ...core.errors import ThinPartError
from ...freecad_adapter.preferences import preference
from ...storage.info.info_location import info_location
from ..application import lifelong
from ..application.qt import translate
from ..document.active_task import CLASSIFICATION, open_session
from ..document.part_chooser import ask_for_part
from ..document.selection import active_path, selected_paths

ActiveRecord = namedtuple("ActiveRecord", "name label shown info_file")
ActiveRecord.__doc__ = """A part and the data available without file access.

`shown` is the record shown in the Classify panel, or None. `info_file` is the path where an equally recent
record may be stored, or None.
"""


def active_record():
    """The selected or active part.

    Returns
    -------
    ActiveRecord or None
        None if the user was asked for a part and chose none.

    Raises
    ------
    ThinPartError
        If there is no part, or it was not classified.
    """
    document = App.ActiveDocument
    if document is None:
        raise ThinPartError(translate("ThinPart", "There is no document: open or create one first."), "empty")
    parts = parts_selected(document, selected_paths(document), active_path(document))
    chosen = parts[0] if len(parts) == 1 else ask_for_part(parts, Gui.getMainWindow())
    if chosen is None:
        return None
    session = open_session(CLASSIFICATION)
    shown = session.record_of(document.Name, chosen.name) if session is not None else None
    info_file = None
    if document.FileName and (shown is None or not lifelong.observer.differs_from_file(document)):
        info_file = os.fspath(info_location(document.FileName, preference("InfoFolder")))
    active = ActiveRecord(chosen.name, chosen.label, shown, info_file)
    if shown is None and info_file is None:
        raise ThinPartError(not_classified(active), "missing")
    return active


def not_classified(active):
    """Message about a part without a record."""
    return translate(
        "ThinPart", "'{}' has not been classified yet: classify the part first.").format(active.label)

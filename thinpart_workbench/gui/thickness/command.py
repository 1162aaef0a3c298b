# SPDX-License-Identifier: LGPL-2.1-or-later
"""Starts the display of wall thickness."""

import FreeCAD as App
import FreeCADGui as Gui

from ..application import lifelong
from ..application.sentences import translated
from ..document.active_task import THICKNESS, begin_session, open_session

_measuring = {}  # ThicknessMeasurement without a panel, by (document name, map name)


def show_thickness():
    """Measure the selected parts and show their map; only show the map if one is selected."""
    # Imported late: it imports numpy and scipy, which would slow down the start of FreeCAD.
    from ...freecad_adapter.objects.thickness_object import is_thickness
    from .controller import ThicknessController

    document = App.ActiveDocument
    selected = Gui.Selection.getSelection(document.Name) if document is not None else []
    begin_session(THICKNESS, ThicknessController, document, next(filter(is_thickness, selected), None))


def show_thickness_map(thickness):
    """Open the panel of a map."""
    from .controller import ThicknessController

    begin_session(THICKNESS, ThicknessController, thickness.Document, thickness)


def measure_map_again(document_name, name):
    """Measure the sources of a map again in the background, or in its panel if that is open."""
    document = App.listDocuments().get(document_name)
    thickness = document.getObject(name) if document is not None else None
    if thickness is None:
        return  # deleted in the meantime
    from ...core.errors import ThinPartError
    from .measurement import ThicknessMeasurement

    session = open_session(THICKNESS)
    if session is not None and session.shown == thickness:
        session.measure()
        return
    stop_measuring(document_name, name)
    key = document_name, name
    measuring = _measuring[key] = ThicknessMeasurement(document)
    measuring.ended.connect(lambda _, sentence: _finish(key, sentence))
    try:
        measuring.start_again(thickness)
    except ThinPartError as error:
        _finish(key, translated(error))


def is_measuring_again():
    """Whether a measurement without a panel is running."""
    return bool(_measuring)


def stop_measuring(document_name, name=None):
    """Stop measuring a map, or all maps of a document, without a panel."""
    for key in [key for key in _measuring if key[0] == document_name and name in (None, key[1])]:
        _measuring.pop(key).leave()


def _finish(key, sentence):
    # The measurement itself emits the signal, so delete it only when Qt returns to the event loop.
    measuring = _measuring.pop(key, None)
    if measuring is not None:
        measuring.leave()
        measuring.deleteLater()
    if sentence:
        document = App.listDocuments().get(key[0])
        lifelong.notifications.report_warning(sentence, *([] if document is None else [document.Label]))

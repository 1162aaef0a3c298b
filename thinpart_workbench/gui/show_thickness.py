"""Starting to show where a part is how thick."""

import FreeCAD as App
import FreeCADGui as Gui

from .document_observer import OBSERVER
from .measure_requests import on_measure_request
from .notices import NOTICES
from .sentences import translated
from .task_session import begin_session, can_open_session, is_free_for_session, open_session

_KIND = "thickness"
_measuring = {}  # what measures without a panel, by (document, map)


def can_show_thickness():
    """Whether the command makes sense now; see `can_open_session`."""
    return can_open_session()


def show_thickness():
    """Measure the selected parts and show their map; a selected map is shown as it is."""
    # Not at the top: it brings numpy and scipy, and FreeCAD should start as fast as without them.
    from ..freecad_adapter.thickness_object import is_thickness
    from .thickness_session import ThicknessSession

    document = App.ActiveDocument
    selected = Gui.Selection.getSelection(document.Name) if document is not None else []
    maps = [each for each in selected if is_thickness(each)]
    if is_free_for_session():
        begin_session(_KIND, ThicknessSession(document, maps[0] if maps else None))


def show_thickness_map(thickness):
    """Open the panel of a map."""
    from .thickness_session import ThicknessSession

    if is_free_for_session():
        begin_session(_KIND, ThicknessSession(thickness.Document, thickness))


def measure_map_again(document_name, name):
    """Measure the sources of a map again in the background, in its panel where that is open."""
    document = App.listDocuments().get(document_name)
    thickness = document.getObject(name) if document is not None else None
    if thickness is None:
        return  # it is gone meanwhile
    from ..core.errors import ThinPartError
    from .thickness_measuring import ThicknessMeasuring

    session = open_session(_KIND)
    if session is not None and session.shown == thickness:
        session.measure()
        return
    stop_measuring(document_name, name)
    key = document_name, name
    measuring = _measuring[key] = ThicknessMeasuring(document)
    measuring.ended.connect(lambda _, sentence: _tell(key, sentence))
    try:
        measuring.start_again(thickness)
    except ThinPartError as error:
        _tell(key, translated(error))


def is_measuring_again():
    """Whether anything is measured without a panel."""
    return bool(_measuring)


def stop_measuring(document_name, name=None):
    """Stop what measures a map again, or all maps of a document, without a panel."""
    for key in [key for key in _measuring if key[0] == document_name and name in (None, key[1])]:
        _measuring.pop(key).leave()


def _tell(key, sentence):
    # It is told of by the object that is about to go, so that goes when the window has its turn.
    measuring = _measuring.pop(key, None)
    if measuring is not None:
        measuring.leave()
        measuring.deleteLater()
    if sentence:
        document = App.listDocuments().get(key[0])
        NOTICES.report(sentence, *([] if document is None else [document.Label]))


def follow_requests():
    """Measure again whatever map asks for it; called once, when FreeCAD starts."""
    on_measure_request(measure_map_again)
    OBSERVER.on_close(stop_measuring)

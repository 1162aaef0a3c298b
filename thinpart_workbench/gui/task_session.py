"""The one task of ThinPart that is open: FreeCAD shows one task panel at a time."""

import FreeCAD as App
import FreeCADGui as Gui

from .document_observer import OBSERVER
from .measure_tool import MeasureTool
from .notices import NOTICES
from .qt import QtCore, translate

_sessions = []  # (what it is, session): the one that is open, or none
_measure_tool = []  # MeasureTool, once there was a session


def open_session(kind=None):
    """The session whose panel is open, or None; only one of a kind where that is given."""
    for known, session in _sessions:
        if session.panel.is_open and kind in (None, known):
            return session
    return None


def can_open_session():
    """Whether a command that opens a panel makes sense now: a document is open."""
    return App.ActiveDocument is not None


def is_free_for_session():
    """Whether a panel can be opened, and say why where it cannot: a task of FreeCAD, such as measuring, is open.

    Notes
    -----
    The commands are not greyed out then: a grey button does not say what it waits for.
    """
    if open_session() is not None or not Gui.Control.activeDialog():
        return True
    _say_one_at_a_time()
    return False


def _say_one_at_a_time():
    NOTICES.tell_failure(translate(
        "ThinPart", "FreeCAD shows one task at a time: close the one that is open, then try again."))


def _is_in_the_way():
    """Whether our panel keeps FreeCAD from opening its measure tool, and say so."""
    if open_session() is None:
        return False
    _say_one_at_a_time()
    return True


def begin_session(kind, session):
    """Start a session in the place of the one that is open.

    Parameters
    ----------
    kind : str
    session : object
        With ``panel``, ``document_name``, ``start`` and ``close``.
    """
    end_session()
    if not _measure_tool:
        _measure_tool.append(MeasureTool(_is_in_the_way))
    _measure_tool[0].watch()
    _sessions.append((kind, session))
    session.start()


def end_session():
    """Close the panel and stop what is being measured."""
    while _sessions:
        _sessions.pop()[1].close()


def _document_closed(name):
    session = open_session()
    if session is not None and session.document_name == name:
        # Not within FreeCAD's own closing of the document, which still goes through its panels.
        session.panel.closed.emit()
        QtCore.QTimer.singleShot(0, end_session)


OBSERVER.on_close(_document_closed)

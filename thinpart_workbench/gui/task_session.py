"""The one task of ThinPart that is open: FreeCAD shows one task panel at a time."""

import FreeCAD as App
import FreeCADGui as Gui

from .document_observer import OBSERVER
from .qt import QtCore

_sessions = []  # (what it is, session): the one that is open, or none


def open_session(kind=None):
    """The session whose panel is open, or None; only one of a kind where that is given."""
    for known, session in _sessions:
        if session.panel.is_open and kind in (None, known):
            return session
    return None


def can_open_session():
    """Whether a command that opens a panel makes sense now: a document is open and no task of others."""
    if App.ActiveDocument is None:
        return False
    return not Gui.Control.activeDialog() or open_session() is not None


def begin_session(kind, session):
    """Start a session in the place of the one that is open.

    Parameters
    ----------
    kind : str
    session : object
        With ``panel``, ``document_name``, ``start`` and ``close``.
    """
    end_session()
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

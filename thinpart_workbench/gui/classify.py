"""Starting a classification. There is one at a time, as FreeCAD shows one task panel at a time."""

import FreeCAD as App
import FreeCADGui as Gui

from .document_observer import OBSERVER
from .qt import QtCore

_sessions = []  # the one that is open, or none


def current_session():
    """The session whose panel is open, or None."""
    return _sessions[0] if _sessions and _sessions[0].panel.is_open else None


def can_classify():
    """Whether the command makes sense now: a document is open and no task of others."""
    if App.ActiveDocument is None:
        return False
    return not Gui.Control.activeDialog() or current_session() is not None


def classify_active_document():
    """Classify the part that is meant in the active document."""
    # Not at the top: it brings numpy and scipy, and FreeCAD should start as fast as without them.
    from .classification_session import ClassificationSession

    end_session()
    session = ClassificationSession(App.ActiveDocument)
    _sessions.append(session)
    session.start()


def end_session():
    """Close the panel and stop what is being measured."""
    while _sessions:
        _sessions.pop().close()


def _document_closed(name):
    session = current_session()
    if session is not None and session.document_name == name:
        # Not within FreeCAD's own closing of the document, which still goes through its panels.
        session.panel.closed.emit()
        QtCore.QTimer.singleShot(0, end_session)


OBSERVER.on_close(_document_closed)

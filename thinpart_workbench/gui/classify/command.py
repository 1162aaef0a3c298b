"""Starts a classification."""

import FreeCAD as App

from ..application import lifelong
from ..application.qt import translate
from ..document.active_task import (
    CLASSIFICATION,
    begin_session,
    can_open_session,
    end_session,
    is_task_view_free,
    open_session,
)

__all__ = ["can_classify", "classify_active_document", "classify_or_explain", "current_session", "end_session"]

def current_session():
    """The session whose panel is open, or None."""
    return open_session(CLASSIFICATION)


def can_classify():
    """Whether the command is available; see `can_open_session`."""
    return can_open_session()


def classify_active_document():
    """Classify the selected or active part of the active document."""
    # Imported late: it imports numpy and scipy, which would slow down the start of FreeCAD.
    from .controller import ClassificationController

    if is_task_view_free(App.ActiveDocument):
        begin_session(CLASSIFICATION, ClassificationController(App.ActiveDocument))


def classify_or_explain():
    """Classify the selected or active part, or explain in the status bar why that is not possible."""
    if can_classify():
        classify_active_document()
    else:
        lifelong.notifications.show_message(translate(
            "ThinPart", "To classify a part, open a document and close the task that is open."))

"""Starting a classification."""

import FreeCAD as App

from .task_session import begin_session, can_open_session, end_session, is_free_for_session, open_session

__all__ = ["can_classify", "classify_active_document", "current_session", "end_session"]

_KIND = "classification"


def current_session():
    """The session whose panel is open, or None."""
    return open_session(_KIND)


def can_classify():
    """Whether the command makes sense now; see `can_open_session`."""
    return can_open_session()


def classify_active_document():
    """Classify the part that is meant in the active document."""
    # Not at the top: it brings numpy and scipy, and FreeCAD should start as fast as without them.
    from .classification_session import ClassificationSession

    if is_free_for_session():
        begin_session(_KIND, ClassificationSession(App.ActiveDocument))

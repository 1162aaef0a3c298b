"""Shows the dialog that learns thresholds; there is one instance."""

from ..widgets.single_dialog import end_single_dialog, show_single_dialog


def show_learn_dialog():
    """Bring the dialog to the front without interrupting its work.

    Returns
    -------
    LearnDialog
    """
    # Imported late: it imports numpy, which would slow down the start of FreeCAD.
    from .dialog import LearnDialog

    return show_single_dialog(LearnDialog)


def end_learn_dialog():
    """Stop the work of the dialog and delete it."""
    end_single_dialog("LearnDialog")

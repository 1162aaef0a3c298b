"""Shows the dialog that classifies a folder. A single instance keeps its results until FreeCAD ends."""

from ..widgets.single_dialog import end_single_dialog, show_single_dialog


def show_folder_dialog():
    """Bring the dialog to the front without interrupting its work.

    Returns
    -------
    FolderDialog
    """
    # Imported late: it imports numpy and scipy, which would slow down the start of FreeCAD.
    from .dialog import FolderDialog

    return show_single_dialog(FolderDialog)


def end_folder_dialog():
    """Stop the work of the dialog and delete it."""
    end_single_dialog("FolderDialog")

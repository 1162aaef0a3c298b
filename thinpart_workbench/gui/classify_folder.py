"""Showing the window for whole folders. There is one, which keeps its results until FreeCAD ends."""

import FreeCADGui as Gui

_dialogs = []  # the one that was made, or none


def show_folder_dialog():
    """Bring the dialog to the front, with whatever is going on in it.

    Returns
    -------
    FolderDialog
    """
    # Not at the top: it brings numpy and scipy, and FreeCAD should start as fast as without them.
    from .folder_dialog import FolderDialog

    if not _dialogs:
        _dialogs.append(FolderDialog(Gui.getMainWindow()))
    dialog = _dialogs[0]
    dialog.show()
    dialog.raise_()
    dialog.activateWindow()
    return dialog


def end_folder_dialog():
    """Stop what is going on and forget the dialog."""
    while _dialogs:
        _dialogs.pop().end()

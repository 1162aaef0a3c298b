"""Showing the dialog for reports. There is one, which is about the document that was active last."""

import FreeCAD as App
import FreeCADGui as Gui

_dialogs = []  # the one that was made, or none


def can_report():
    """Whether the command makes sense now."""
    return App.ActiveDocument is not None


def show_report_dialog():
    """Bring the dialog to the front, about the active document where it is not at work on another.

    Returns
    -------
    ReportDialog
    """
    # Not at the top: it brings numpy, and FreeCAD should start as fast as without it.
    from .report_dialog import ReportDialog

    if not _dialogs:
        _dialogs.append(ReportDialog(Gui.getMainWindow()))
    dialog = _dialogs[0]
    dialog.show_document(App.ActiveDocument)
    dialog.show()
    dialog.raise_()
    dialog.activateWindow()
    return dialog


def end_report_dialog():
    """Stop what is going on and forget the dialog."""
    while _dialogs:
        _dialogs.pop().end()

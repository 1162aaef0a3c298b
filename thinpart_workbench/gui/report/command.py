"""Shows the report dialog. Its single instance is about the most recently active document."""

import FreeCAD as App

from ..widgets.single_dialog import end_single_dialog, show_single_dialog, single_dialog


def can_report():
    """Whether the command is available."""
    return App.ActiveDocument is not None


def show_report_dialog():
    """Bring the dialog to the front; unless busy, it switches to the active document.

    Returns
    -------
    ReportDialog
    """
    # Imported late: it imports numpy, which would slow down the start of FreeCAD.
    from .dialog import ReportDialog

    single_dialog(ReportDialog).show_document(App.ActiveDocument)
    return show_single_dialog(ReportDialog)


def end_report_dialog():
    """Stop the work of the dialog and delete it."""
    end_single_dialog("ReportDialog")

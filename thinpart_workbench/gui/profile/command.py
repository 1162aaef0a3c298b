# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shows the profile editor: a window of its own, or a modal dialog over another one, such as FreeCAD's preferences."""

from ...freecad_adapter.preferences import preference
from ..application.qt import QtWidgets, execute
from ..widgets.controls import prepare_controls
from ..widgets.single_dialog import show_single_dialog, single_dialog


def show_profile_editor(name=None):
    """Bring the editor to the front.

    Parameters
    ----------
    name : str, optional
        Profile to edit: name of a shipped one, or path of a file. By default what is being edited already, else the
        preferred one.

    Returns
    -------
    ProfileDialog
        Where it is modal, after it was closed.
    """
    # Imported late: it imports numpy, which would slow down the start of FreeCAD.
    from .dialog import ProfileDialog

    modal = QtWidgets.QApplication.activeModalWidget()
    if modal is not None:
        dialog = ProfileDialog(modal)
        dialog.begin(name or preference("Profile"), behind_modal=True)
        prepare_controls(dialog)
        execute(dialog)
        dialog.end()
        return dialog
    dialog = single_dialog(ProfileDialog)
    if not dialog.isVisible():
        dialog.begin(name or preference("Profile"))
    elif name is not None:
        dialog.choose(name)
    return show_single_dialog(ProfileDialog)

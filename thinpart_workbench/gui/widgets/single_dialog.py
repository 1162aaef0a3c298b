# SPDX-License-Identifier: LGPL-2.1-or-later
"""Dialogs of which there is one each: it is shown again rather than made again, and keeps what it has."""

import FreeCADGui as Gui

from .controls import prepare_controls

_dialogs = {}  # by the name of their class


def single_dialog(dialog_class):
    """The one dialog of a class of QDialog with ``end()``: made where there is none."""
    name = dialog_class.__name__
    if name not in _dialogs:
        _dialogs[name] = dialog_class(Gui.getMainWindow())
    return _dialogs[name]


def show_single_dialog(dialog_class):
    """Bring the one dialog of a class to the front, without interrupting its work, and return it."""
    dialog = single_dialog(dialog_class)
    prepare_controls(dialog)
    dialog.show()
    dialog.raise_()
    dialog.activateWindow()
    return dialog


def end_single_dialog(name):
    """Stop the work of the dialog of a class, and delete it; named, so that its module need not be imported."""
    dialog = _dialogs.pop(name, None)
    if dialog is not None:
        dialog.end()

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Asks for folders, and for files to be written."""

import os

from ..application.qt import QtWidgets, execute, translate


def choose_folder(parent, folder, show, title=""):
    """Let the user choose a folder.

    Parameters
    ----------
    parent : QWidget
    folder : str
        Where to begin.
    show : callable
        Called with the path, unless the user cancels.
    title : str, optional
    """
    chosen = QtWidgets.QFileDialog.getExistingDirectory(parent, title or translate("ThinPart", "Choose a folder"), folder)
    if chosen:
        show(chosen)


def chosen_output(parent, name, title, proposed, kinds):
    """Ask for a file to be written: its path, empty where the user cancels.

    Parameters
    ----------
    parent : QWidget
    name : str
        Object name of the dialog.
    title : str
    proposed : str
        A path; its ending is added to a name without one.
    kinds : str
        Of files, as Qt has them: ``Tables (*.csv)``.
    """
    dialog = QtWidgets.QFileDialog(parent, title, os.path.dirname(proposed), kinds)
    dialog.setObjectName(name)
    dialog.setAcceptMode(QtWidgets.QFileDialog.AcceptSave)
    dialog.setDefaultSuffix(proposed.rpartition(".")[2])
    dialog.selectFile(os.path.basename(proposed))
    chosen = dialog.selectedFiles() if execute(dialog) else [""]
    dialog.deleteLater()
    return chosen[0]

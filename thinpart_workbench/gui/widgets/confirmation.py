# SPDX-License-Identifier: LGPL-2.1-or-later
"""Confirmation of actions that cannot be undone."""

from ...storage.output_file import ForeignFile, check_output
from ..application.qt import QtCore, QtWidgets, execute, translate


def is_confirmed(parent, name, icon, sentence, question, answer):
    """Ask the user to confirm an action; Enter and Escape cancel. `answer` is the standard button that confirms."""
    box = QtWidgets.QMessageBox(icon, "", sentence, answer | QtWidgets.QMessageBox.Cancel, parent)
    box.setObjectName(name)
    box.setTextFormat(QtCore.Qt.PlainText)  # names and addresses come from untrusted files
    box.setInformativeText(question)
    box.setDefaultButton(QtWidgets.QMessageBox.Cancel)
    clicked = execute(box)
    box.deleteLater()
    return clicked == answer


def may_overwrite(parent, path, mark, inputs=()):
    """Ask plainly before a chosen file is overwritten that ThinPart did not write: a file dialog asks that of any file.

    Parameters
    ----------
    parent : QWidget
    path, mark, inputs
        See `check_output`.

    Returns
    -------
    bool or None
        What to tell `write_output` as ``overwrite``: True where the user said so, False where nothing had to be asked. None
        where the file is to stay.

    Raises
    ------
    ThinPartError
        Where it must not be overwritten.
    OSError
        Where it cannot be written.
    """
    try:
        check_output(path, mark, inputs=inputs)
    except ForeignFile:
        is_wanted = is_confirmed(
            parent, "ThinPart_OverwriteQuestion", QtWidgets.QMessageBox.Warning,
            translate("ThinPart", "{} was not written by ThinPart.").format(path),
            translate("ThinPart", "Replace it? What it contains will be lost."), QtWidgets.QMessageBox.Yes)
        return True if is_wanted else None
    return False

"""Confirmation of actions that cannot be undone."""

from ..application.qt import QtCore, QtWidgets, execute


def is_confirmed(parent, name, icon, sentence, question, answer):
    """Ask the user to confirm an action; Enter and Escape cancel.

    Parameters
    ----------
    parent : QWidget
    name : str
        The box's object name.
    icon : QMessageBox.Icon
    sentence, question : str
    answer : QMessageBox.StandardButton
        The button that confirms; the other one is Cancel.
    """
    box = QtWidgets.QMessageBox(icon, "", sentence, answer | QtWidgets.QMessageBox.Cancel, parent)
    box.setObjectName(name)
    box.setTextFormat(QtCore.Qt.PlainText)  # names and addresses come from untrusted files
    box.setInformativeText(question)
    box.setDefaultButton(QtWidgets.QMessageBox.Cancel)
    clicked = execute(box)
    box.deleteLater()
    return clicked == answer

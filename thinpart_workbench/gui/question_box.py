"""A question before something that cannot be taken back."""

from .qt import QtWidgets, execute


def is_confirmed(parent, name, icon, sentence, question, answer):
    """Whether the user agrees; Enter and Escape do not.

    Parameters
    ----------
    parent : QWidget
    name : str
        The box's object name.
    icon : QMessageBox.Icon
    sentence, question : str
    answer : QMessageBox.StandardButton
        What agrees; beside it there is Cancel.
    """
    box = QtWidgets.QMessageBox(icon, "", sentence, answer | QtWidgets.QMessageBox.Cancel, parent)
    box.setObjectName(name)
    box.setInformativeText(question)
    box.setDefaultButton(QtWidgets.QMessageBox.Cancel)
    given = execute(box)
    box.deleteLater()
    return given == answer

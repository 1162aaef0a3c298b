"""A button with a name that tests and style sheets find it by."""

from .qt import QtWidgets


def add_button(row, parent, name, text, act):
    """Add a button to a row.

    Parameters
    ----------
    row : QLayout
    parent : QWidget
    name : str
        The button's object name.
    text : str
    act : callable
        Without arguments; what pressing does.

    Returns
    -------
    QPushButton
    """
    button = QtWidgets.QPushButton(text, parent)
    button.setObjectName(name)
    button.clicked.connect(lambda *_: act())
    row.addWidget(button)
    return button

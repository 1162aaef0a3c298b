"""Push buttons with an object name, by which tests and style sheets find them."""

from ..application.qt import QtWidgets


def add_button(layout, parent, name, text, callback):
    """Add a button to a layout.

    Parameters
    ----------
    layout : QLayout
    parent : QWidget
    name : str
        The button's object name.
    text : str
    callback : callable
        Called without arguments when the button is clicked.

    Returns
    -------
    QPushButton
    """
    button = QtWidgets.QPushButton(text, parent)
    button.setObjectName(name)
    button.clicked.connect(lambda *_: callback())
    layout.addWidget(button)
    return button

"""Push buttons with an object name, by which tests and style sheets find them."""

from ..application.qt import QtWidgets


def add_button(layout, parent, name, text, callback, *place, is_for_enter=True):
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
    *place : int
        Row and column, where the layout is a grid.
    is_for_enter : bool
        Whether Enter presses it in a dialog while it has the focus; if not, Enter presses the default button.

    Returns
    -------
    QPushButton
    """
    button = QtWidgets.QPushButton(text, parent)
    button.setObjectName(name)
    if not is_for_enter:
        button.setAutoDefault(False)
    button.clicked.connect(lambda *_: callback())
    layout.addWidget(button, *place)
    return button

"""Small flat buttons with a symbol."""

from ..application.qt import QtWidgets


def small_button(parent, name, symbol, meaning, callback):
    """A QToolButton with a symbol and a tool tip.

    Parameters
    ----------
    parent : QWidget
    name : str
        Object name.
    symbol, meaning : str
    callback : callable
        Called without arguments when the button is clicked.
    """
    button = QtWidgets.QToolButton(parent)
    button.setObjectName(name)
    button.setText(symbol)
    button.setToolTip(meaning)
    button.setAccessibleName(meaning)
    button.setAutoRaise(True)
    button.clicked.connect(lambda *_: callback())
    return button

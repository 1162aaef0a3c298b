# SPDX-License-Identifier: LGPL-2.1-or-later
"""Buttons with an object name, by which tests and style sheets find them."""

from ..application.qt import QtWidgets


def push_button(parent, name, text, callback, is_for_enter=True):
    """A QPushButton.

    Parameters
    ----------
    parent : QWidget
    name : str
        Object name.
    text : str
    callback : callable
        Called without arguments when the button is clicked.
    is_for_enter : bool, optional
        Whether Enter presses it in a dialog while it has the focus; if not, Enter presses the default button.
    """
    button = QtWidgets.QPushButton(text, parent)
    button.setObjectName(name)
    if not is_for_enter:
        button.setAutoDefault(False)
    button.clicked.connect(lambda *_: callback())
    return button


def add_button(layout, parent, name, text, callback, *place, is_for_enter=True):
    """Add a `push_button` to a QLayout, at a row and column `place` where that is a grid, and return it."""
    button = push_button(parent, name, text, callback, is_for_enter)
    layout.addWidget(button, *place)
    return button


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

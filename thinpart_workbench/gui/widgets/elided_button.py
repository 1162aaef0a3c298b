# SPDX-License-Identifier: LGPL-2.1-or-later
"""Flat buttons for the status bar that elide their text instead of widening the window."""

import FreeCADGui as Gui

from ..application.qt import QtCore, QtWidgets


class ElidedButton(QtWidgets.QToolButton):
    """Shows as much of its text as fits, up to a number of average characters; the caller sets the tool tip."""

    def __init__(self, name, max_characters, parent=None):
        super().__init__(parent)
        self.setObjectName(name)
        self._max_characters = max_characters
        self.setAutoRaise(True)
        self.setToolButtonStyle(QtCore.Qt.ToolButtonTextOnly)
        self.setSizePolicy(QtWidgets.QSizePolicy.Preferred, QtWidgets.QSizePolicy.Fixed)

    def sizeHint(self):
        """Wide enough for all of the text, up to the greatest width."""
        hint = super().sizeHint()
        return QtCore.QSize(min(hint.width(), self._width(self._max_characters)), hint.height())

    def minimumSizeHint(self):
        """At most 16 characters wide."""
        hint = self.sizeHint()
        return QtCore.QSize(min(hint.width(), self._width(16)), hint.height())

    def paintEvent(self, _event):
        """Draw the button with elided text."""
        option = QtWidgets.QStyleOptionToolButton()
        self.initStyleOption(option)
        available = self.width() - self.fontMetrics().averageCharWidth() * 2
        option.text = self.fontMetrics().elidedText(self.text(), QtCore.Qt.ElideRight, available)
        painter = QtWidgets.QStylePainter(self)
        painter.drawComplexControl(QtWidgets.QStyle.CC_ToolButton, option)
        painter.end()

    def _width(self, characters):
        return characters * self.fontMetrics().averageCharWidth()


class StatusBarButton:
    """An `ElidedButton` in FreeCAD's status bar, made when it is first shown.

    Parameters
    ----------
    name : str
    max_characters : int
        See `ElidedButton`.
    clicked : callable
        Called without arguments.

    Attributes
    ----------
    widget : ElidedButton or None
    """

    def __init__(self, name, max_characters, clicked):
        self._form, self._clicked, self.widget = (name, max_characters), clicked, None

    def show(self, text, tool_tip):
        """Show the button, with another text."""
        if self.widget is None:
            self.widget = ElidedButton(*self._form)
            self.widget.clicked.connect(lambda *_: self._clicked())
            Gui.getMainWindow().statusBar().addPermanentWidget(self.widget)
        self.widget.setText(text)
        self.widget.setToolTip(tool_tip)
        self.widget.updateGeometry()
        self.widget.show()

    def hide(self):
        """Hide the button."""
        if self.widget is not None:
            self.widget.hide()

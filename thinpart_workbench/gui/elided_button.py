"""A flat button in the status bar that shortens its text before it widens the window."""

from .qt import QtCore, QtWidgets


class ElidedButton(QtWidgets.QToolButton):
    """Shows as much of its text as there is room for; the tool tip is up to whoever uses it.

    Parameters
    ----------
    name : str
        The button's object name.
    letters : int
        Width that it takes at most.
    """

    def __init__(self, name, letters, parent=None):
        super().__init__(parent)
        self.setObjectName(name)
        self._letters = letters
        self.setAutoRaise(True)
        self.setToolButtonStyle(QtCore.Qt.ToolButtonTextOnly)
        self.setSizePolicy(QtWidgets.QSizePolicy.Preferred, QtWidgets.QSizePolicy.Fixed)

    def sizeHint(self):
        """All of the text, up to the most."""
        hint = super().sizeHint()
        return QtCore.QSize(min(hint.width(), self._width(self._letters)), hint.height())

    def minimumSizeHint(self):
        """A few letters."""
        hint = self.sizeHint()
        return QtCore.QSize(min(hint.width(), self._width(16)), hint.height())

    def paintEvent(self, _event):
        """Draw the text shortened."""
        option = QtWidgets.QStyleOptionToolButton()
        self.initStyleOption(option)
        room = self.width() - self.fontMetrics().averageCharWidth() * 2
        option.text = self.fontMetrics().elidedText(self.text(), QtCore.Qt.ElideRight, room)
        painter = QtWidgets.QStylePainter(self)
        painter.drawComplexControl(QtWidgets.QStyle.CC_ToolButton, option)
        painter.end()

    def _width(self, letters):
        return letters * self.fontMetrics().averageCharWidth()

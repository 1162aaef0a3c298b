# SPDX-License-Identifier: LGPL-2.1-or-later
"""A title that shows or hides the widget below it."""

from ..application.qt import QtCore, QtWidgets


class Fold(QtWidgets.QWidget):
    """Closed at first."""

    def __init__(self, title, name, content, parent=None):
        super().__init__(parent)
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(2)
        self._button = QtWidgets.QToolButton(self)
        self._button.setObjectName(name)
        self._button.setText(title)
        self._button.setCheckable(True)
        self._button.setAutoRaise(True)
        self._button.setToolButtonStyle(QtCore.Qt.ToolButtonTextBesideIcon)
        self._button.toggled.connect(self._show)
        column.addWidget(self._button)
        self._content = content
        column.addWidget(content)
        self._show(False)

    def _show(self, is_open):
        self._button.setArrowType(QtCore.Qt.DownArrow if is_open else QtCore.Qt.RightArrow)
        self._content.setVisible(is_open)

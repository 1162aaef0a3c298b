# SPDX-License-Identifier: LGPL-2.1-or-later
"""A layout that wraps its widgets into further lines where the window is too narrow, like text."""

from ..application.qt import QtCore, QtWidgets


def add_flow(layout, parent):
    """Add a widget with a `FlowLayout` to a layout, and return the `FlowLayout`."""
    container = QtWidgets.QWidget(parent)
    layout.addWidget(container)
    return FlowLayout(container)


class FlowLayout(QtWidgets.QLayout):
    """Places widgets side by side, in as many lines as necessary."""

    def __init__(self, parent=None):
        super().__init__(parent)
        self._items = []
        self.setContentsMargins(0, 0, 0, 0)
        self.setSpacing(8)

    def addItem(self, item):
        """Called by `addWidget`."""
        self._items.append(item)

    def count(self):
        """Number of widgets."""
        return len(self._items)

    def itemAt(self, index):
        """The item at an index, or None."""
        return self._items[index] if 0 <= index < len(self._items) else None

    def takeAt(self, index):
        """Remove and return the item at an index, or None."""
        return self._items.pop(index) if 0 <= index < len(self._items) else None

    def expandingDirections(self):
        """The layout does not expand."""
        return QtCore.Qt.Orientation(0)

    def hasHeightForWidth(self):
        """The height depends on the width."""
        return True

    def heightForWidth(self, width):
        """Height of all lines."""
        return self._arrange(QtCore.QRect(0, 0, width, 0), move=False)

    def sizeHint(self):
        """Size with all widgets in one line."""
        sizes = [item.sizeHint() for item in self._items]
        width = sum(size.width() for size in sizes) + self.spacing() * max(0, len(sizes) - 1)
        return QtCore.QSize(width, max((size.height() for size in sizes), default=0))

    def minimumSize(self):
        """Size with one widget per line, as wide as the widest."""
        size = QtCore.QSize()
        for item in self._items:
            size = size.expandedTo(item.minimumSize())
        return size

    def setGeometry(self, rectangle):
        """Position the widgets in a rectangle."""
        super().setGeometry(rectangle)
        self._arrange(rectangle, move=True)

    def _arrange(self, rectangle, move):
        lines, x = [[]], 0
        for item in self._items:
            size = item.sizeHint()
            if lines[-1] and x + size.width() > rectangle.width():
                lines.append([])
                x = 0
            lines[-1].append((x, item, size))
            x += size.width() + self.spacing()
        y = 0
        for line in filter(None, lines):
            height = max(size.height() for _, _, size in line)
            if move:
                for x, item, size in line:
                    position = rectangle.topLeft() + QtCore.QPoint(x, y + (height - size.height()) // 2)
                    item.setGeometry(QtCore.QRect(position, size))
            y += height + self.spacing() // 2
        return max(0, y - self.spacing() // 2)

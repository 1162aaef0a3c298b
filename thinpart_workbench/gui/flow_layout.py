"""A layout that goes on in the next line where the window is too narrow, as text does."""

from .qt import QtCore, QtWidgets


class FlowLayout(QtWidgets.QLayout):
    """Widgets beside each other, in as many lines as their texts need."""

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
        """An item, None beyond the last."""
        return self._items[index] if 0 <= index < len(self._items) else None

    def takeAt(self, index):
        """An item, which is taken out."""
        return self._items.pop(index) if 0 <= index < len(self._items) else None

    def expandingDirections(self):
        """It takes what it needs and no more."""
        return QtCore.Qt.Orientation(0)

    def hasHeightForWidth(self):
        """The narrower, the higher."""
        return True

    def heightForWidth(self, width):
        """Height of all lines."""
        return self._arrange(QtCore.QRect(0, 0, width, 0), move=False)

    def sizeHint(self):
        """All in one line."""
        sizes = [item.sizeHint() for item in self._items]
        width = sum(size.width() for size in sizes) + self.spacing() * max(0, len(sizes) - 1)
        return QtCore.QSize(width, max((size.height() for size in sizes), default=0))

    def minimumSize(self):
        """The widest widget alone."""
        size = QtCore.QSize()
        for item in self._items:
            size = size.expandedTo(item.minimumSize())
        return size

    def setGeometry(self, rectangle):
        """Put every widget in its place."""
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
                    place = rectangle.topLeft() + QtCore.QPoint(x, y + (height - size.height()) // 2)
                    item.setGeometry(QtCore.QRect(place, size))
            y += height + self.spacing() // 2
        return max(0, y - self.spacing() // 2)

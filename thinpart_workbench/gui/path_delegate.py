"""Cells of a table that show paths."""

from .qt import QtCore, QtWidgets


class PathDelegate(QtWidgets.QStyledItemDelegate):
    """Of a path that is too long, both ends say most."""

    def initStyleOption(self, option, index):
        """Called by Qt for each cell."""
        super().initStyleOption(option, index)
        option.textElideMode = QtCore.Qt.ElideMiddle

"""How tables look and behave that show one record per row."""

from ..application.qt import QtCore, QtWidgets


def show_whole_rows(view):
    """Set up a QTableView for records: one row is selected at a time, and Tab leaves the table."""
    view.setSelectionBehavior(QtWidgets.QAbstractItemView.SelectRows)
    view.setSelectionMode(QtWidgets.QAbstractItemView.SingleSelection)
    view.setHorizontalScrollMode(QtWidgets.QAbstractItemView.ScrollPerPixel)
    view.setTabKeyNavigation(False)
    view.setAlternatingRowColors(True)
    view.setShowGrid(False)
    view.setWordWrap(False)


class PathDelegate(QtWidgets.QStyledItemDelegate):
    """Elides long paths in the middle, because both ends are the most informative."""

    def initStyleOption(self, option, index):
        """Called by Qt for each cell."""
        super().initStyleOption(option, index)
        option.textElideMode = QtCore.Qt.ElideMiddle

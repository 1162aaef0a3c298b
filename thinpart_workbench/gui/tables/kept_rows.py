# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rows that are all in memory, and may come while they are shown: sorted and filtered here."""

from ..application.qt import QtCore
from .row_model import RowModel

_SORT_DELAY = 500
"""Milliseconds after which added rows are sorted in."""


class KeptRows(RowModel):
    """Model of rows that it keeps.

    Notes
    -----
    What rows are sorted by is computed once for each, and Python sorts a mostly sorted list in one pass, so that 100,000
    rows stay responsive while more come. A QSortFilterProxyModel would compare in Python, which takes seconds.
    """

    def __init__(self, columns, parent=None):
        super().__init__(columns, parent)
        self._all, self._shown, self._keys = [], [], []  # rows; numbers of those that are shown; what they are sorted by
        self._is_wanted = self._sorted_by = None
        self._descending = False
        self._sort_timer = QtCore.QTimer(self, singleShot=True, interval=_SORT_DELAY)
        self._sort_timer.timeout.connect(lambda: self._change_order(self._arrange))

    @property
    def all_rows(self):
        """list: all rows, also hidden ones, in the order in which they came."""
        return self._all

    @property
    def rows(self):
        """list: the shown rows in their order."""
        return [self._all[number] for number in self._shown]

    def row_at(self, number):
        """The row with this number among those that are shown."""
        return self._all[self._shown[number]]

    def collect(self, done):
        """Call a function with the shown rows."""
        done(self.rows)

    def rowCount(self, parent=QtCore.QModelIndex()):
        """Number of shown rows."""
        return 0 if parent.isValid() else len(self._shown)

    def set_rows(self, rows):
        """Show other rows; the sort order stays, and so do the numbers of selected rows if there are as many as before."""
        is_as_long = self._is_wanted is None and len(rows) == len(self._all)
        if not is_as_long:
            self.beginResetModel()
        self._all, self._shown = list(rows), []
        self._compute_keys()
        self._shown = self._wanted(0)
        self._arrange()
        if is_as_long:
            self.rows_changed(0, len(rows))
        else:
            self.endResetModel()

    def add(self, rows):
        """Append rows; a timer sorts them in."""
        first = len(self._all)
        self._all += rows
        self._compute_keys(first)
        new = self._wanted(first)
        if new:
            start = len(self._shown)
            self.beginInsertRows(QtCore.QModelIndex(), start, start + len(new) - 1)
            self._shown += new
            self.endInsertRows()
            if self._sorted_by is not None and not self._sort_timer.isActive():
                self._sort_timer.start()

    def replace(self, number, row):
        """Show another row in place of the one with this number among `all_rows`; it stays where it is."""
        self._all[number] = row
        if self._sorted_by is not None:
            self._keys[number] = self._sorted_by.sort_key(row)
        if number in self._shown:
            shown = self._shown.index(number)
            self.rows_changed(shown, shown + 1)

    def select(self, is_wanted):
        """Show only rows that satisfy a predicate, also of those that come later; None for all."""
        self.beginResetModel()
        self._is_wanted = is_wanted
        self._shown = self._wanted(0)
        self._arrange()
        self.endResetModel()

    def show_columns(self, columns):
        """Replace the columns; rows stay sorted by the same one."""
        super().show_columns(columns)
        if self._sorted_by is not None:
            self._sorted_by = next((column for column in columns if column.key == self._sorted_by.key), None)

    def sort(self, column, order=QtCore.Qt.AscendingOrder):
        """Sort by a column, or not at all where it is negative; equal rows stay in the order in which they are."""
        self._sorted_by = self.columns[column] if 0 <= column < len(self.columns) else None
        self._descending = order == QtCore.Qt.DescendingOrder
        self._compute_keys()
        if self._sorted_by is None:
            self._change_order(self._shown.sort)
        else:
            self._change_order(self._arrange)

    def _wanted(self, first):
        """Numbers of the rows from `first` on that are to be shown: list of int."""
        return [number for number in range(first, len(self._all))
                if self._is_wanted is None or self._is_wanted(self._all[number])]

    def _compute_keys(self, first=0):
        del self._keys[first:]
        if self._sorted_by is not None:
            self._keys += map(self._sorted_by.sort_key, self._all[first:])

    def _arrange(self):
        """Sort the shown rows."""
        if self._sorted_by is not None:
            known = [number for number in self._shown if self._keys[number] is not None]
            unknown = [number for number in self._shown if self._keys[number] is None]
            known.sort(key=self._keys.__getitem__, reverse=self._descending)
            self._shown = known + unknown

    def _change_order(self, change):
        """Change the order of rows and keep the selection."""
        self.layoutAboutToBeChanged.emit()
        before = self.persistentIndexList()
        numbers = [self._shown[index.row()] for index in before]
        change()
        places = {number: row for row, number in enumerate(self._shown)} if before else {}
        self.changePersistentIndexList(before, [
            self.index(places[number], index.column()) for number, index in zip(numbers, before)])
        self.layoutChanged.emit()

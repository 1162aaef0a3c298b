# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rows of a query that are fetched when they are shown, and sorted and filtered where they come from."""

from collections import OrderedDict

from ..application.qt import QtCore, Signal
from .row_model import RowModel

PAGE = 100
"""Number of rows per request."""

MAX_PAGES = 40
"""Pages that are kept."""

BLOCK = 1000
"""Number of rows per request where all of them are wanted."""

WAITING = "\u2026"


class FetchedRows(RowModel):
    """Model of the rows of a query.

    Parameters
    ----------
    columns : list of Column
    waiting : str
        Key of the column that says that a row is to come.

    Signals
    -------
    rows_requested(int, int)
        The rows are needed from the first number up to, excluding, the second; see `set_rows`.
    sort_requested(str, bool)
        Key of a column, and whether the order is descending.
    """

    rows_requested = Signal(int, int)
    sort_requested = Signal(str, bool)

    def __init__(self, columns, waiting, parent=None):
        super().__init__(columns, parent)
        self._count, self._pages, self._requested = 0, OrderedDict(), set()
        self._waiting = waiting
        self._collected, self._done = [], []  # the first rows, and who waits for all of them

    def show_result(self, count, rows):
        """Replace the content by the result of a query.

        Parameters
        ----------
        count : int
        rows : list
            The first rows; None for those that are gone.
        """
        self.beginResetModel()
        self._count = count
        self._pages.clear()
        self._requested.clear()
        self.endResetModel()
        self.set_rows(0, rows)
        if self._done:  # they wait for what is shown
            self._collected = []
            self._go_on()

    def set_rows(self, start, rows):
        """Take requested rows, beginning with row number `start`."""
        if self._done and start == len(self._collected):
            self._collected += rows
            self._go_on()
            if len(rows) > PAGE:
                return  # pages that are shown are not dropped for those that are not
        for offset in range(0, len(rows), PAGE):
            page = (start + offset) // PAGE
            self._pages[page] = rows[offset:offset + PAGE]
            self._requested.discard(page)
        while len(self._pages) > MAX_PAGES:
            self._pages.popitem(last=False)
        self.rows_changed(start, start + len(rows))

    def row_at(self, number):
        """The row with this number; None where it is not fetched, or gone."""
        page = self._pages.get(number // PAGE)
        if page is None:
            return None
        self._pages.move_to_end(number // PAGE)
        return page[number % PAGE] if number % PAGE < len(page) else None

    def collect(self, done):
        """Fetch all rows, and call a function with them: None for those that are gone."""
        self._done.append(done)
        if len(self._done) == 1:
            self._collected = []
            self._go_on()

    def rowCount(self, parent=QtCore.QModelIndex()):
        """Number of rows."""
        return 0 if parent.isValid() else self._count

    def sort(self, column, order=QtCore.Qt.AscendingOrder):
        """Request sorting by a column; nothing where it is negative."""
        if column >= 0 and self.columns[column].is_sortable:
            self.sort_requested.emit(self.columns[column].key, order == QtCore.Qt.DescendingOrder)

    def waiting(self, index):
        """Request a row that is not fetched."""
        page = index.row() // PAGE
        if page not in self._pages and page not in self._requested:
            self._requested.add(page)
            self.rows_requested.emit(page * PAGE, min((page + 1) * PAGE, self._count))
        return WAITING if self.columns[index.column()].key == self._waiting else None

    def _go_on(self):
        start = len(self._collected)
        if start < self._count:
            self.rows_requested.emit(start, min(start + BLOCK, self._count))
            return
        done, self._done = self._done, []
        for each in done:
            each(self._collected)

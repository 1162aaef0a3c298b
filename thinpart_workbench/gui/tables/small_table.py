# SPDX-License-Identifier: LGPL-2.1-or-later
"""Small tables, such as those of panels: as high as their rows, up to a number of lines."""

from ..application import lifelong
from ..application.qt import QtCore, QtWidgets, Signal
from .kept_rows import KeptRows
from .table_view import TableView

_FITTED_ROWS = 200
"""Rows to which the columns are fitted."""


class SmallTable(TableView):
    """Compact view of `KeptRows`.

    Parameters
    ----------
    name : str
        Object name.
    columns : list of Column
    lines : int
        Rows above which it scrolls.

    Signals
    -------
    row_chosen(object)
        The user has made a row the current one.
    """

    row_chosen = Signal(object)

    def __init__(self, name, columns, lines, parent=None):
        self._lines, self._is_selecting = lines, False
        super().__init__(name, KeptRows(columns), parent, has_brief_headings=True)
        self.model().setParent(self)
        self.horizontalHeader().setResizeContentsPrecision(_FITTED_ROWS)
        self.horizontalHeader().setMinimumSectionSize(20)
        self.setSizePolicy(QtWidgets.QSizePolicy.Expanding, QtWidgets.QSizePolicy.Fixed)
        self.selectionModel().currentRowChanged.connect(self._on_current_row_changed)
        self.message.connect(lambda sentence: lifelong.notifications.show_message(sentence))
        self.failed.connect(lambda sentence: lifelong.notifications.show_failure(sentence))
        self._fit_rows()

    @property
    def rows(self):
        """list: the rows in the displayed order."""
        return self.model().rows

    def show_rows(self, rows, columns=None, unit=None, is_same=None, subject=()):
        """Show rows.

        Parameters
        ----------
        rows : list
        columns : list of Column, optional
            By default those that it has.
        unit : LengthUnit, optional
            By default the one in which lengths are shown already.
        is_same : callable, optional
            Whether two rows represent the same object: the selected one stays selected. By default, none is selected.
        subject : tuple of str, optional
            See `TableView`.
        """
        selected = self.current_row if is_same else None
        self.subject = subject
        self.model().unit = unit or self.model().unit
        self.model().show_columns(self.model().columns if columns is None else columns)
        self.model().set_rows(rows)
        self._fit_rows()
        self.fit_columns()  # what was unknown may be a long word now
        self.select(None if selected is None else lambda row: is_same(row, selected))

    def select(self, predicate):
        """Select the first row that satisfies a predicate, without emitting a signal; clear the selection for None."""
        number = next((number for number, row in enumerate(self.rows) if predicate(row)), None) if predicate else None
        self._is_selecting = True
        try:
            if number is None:
                self.selectionModel().clear()
            else:
                self.selectRow(number)
                self.scrollTo(self.model().index(number, 0))
        finally:
            self._is_selecting = False

    def changeEvent(self, event):
        """Adapt the row height to the font."""
        super().changeEvent(event)
        if event.type() in (QtCore.QEvent.FontChange, QtCore.QEvent.StyleChange):
            self._fit_rows()

    def showEvent(self, event):
        """Adapt rows and columns: the font size is final only now."""
        super().showEvent(event)
        self._fit_rows()
        self.fit_columns()

    def _fit_rows(self):
        self.set_row_height(1 + 6 / self.fontMetrics().height())
        lines = max(2, min(self.model().rowCount(), self._lines))
        self.setFixedHeight(lines * self.verticalHeader().defaultSectionSize() + self.horizontalHeader().sizeHint().height()
                            + self.horizontalScrollBar().sizeHint().height() + 2 * self.frameWidth())

    def _on_current_row_changed(self, current, _before):
        if not self._is_selecting and current.isValid():
            self.row_chosen.emit(self.rows[current.row()])

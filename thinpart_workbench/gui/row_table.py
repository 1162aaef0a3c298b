"""Small tables of rows that are sorted by any column."""

from dataclasses import dataclass

from .qt import QtCore, QtGui, QtWidgets, Signal, colour, number_of


@dataclass(frozen=True)
class RowColumn:
    """A column.

    Attributes
    ----------
    title : str
    text : callable
        From a row to what is shown.
    key : callable
        From a row to what is sorted by: a text, or a number or None.
    is_number : bool
        Whether it stands on the right.
    swatch : callable, optional
        From a row to red, green and blue from 0 to 1, or None.
    meaning : str
        Tool tip of the heading.
    takes_rest : bool
        Whether it is as wide as the others leave it.
    """

    title: str
    text: object
    key: object
    is_number: bool = False
    swatch: object = None
    meaning: str = ""
    takes_rest: bool = False


class RowModel(QtCore.QAbstractTableModel):
    """Rows in the order of one of the columns.

    Attributes
    ----------
    rows : list
        In the order in which they are shown.
    """

    def __init__(self, columns, parent=None):
        super().__init__(parent)
        self.columns = list(columns)
        self.rows = []
        self._given = []
        self._sorted_by = -1, QtCore.Qt.AscendingOrder

    def set_rows(self, rows):
        """Show other rows, in the order chosen before."""
        self.beginResetModel()
        self._given = list(rows)
        self._arrange()
        self.endResetModel()

    def set_columns(self, columns):
        """Show the same rows in other columns."""
        self.beginResetModel()
        self.columns = list(columns)
        self.endResetModel()

    def replace_rows(self, rows):
        """Other content of as many rows; what is selected stays so, though not in its place."""
        self._given = list(rows)
        self._arrange()
        if self.rows:
            self.dataChanged.emit(self.index(0, 0), self.index(len(self.rows) - 1, len(self.columns) - 1))

    def sort(self, column, order=QtCore.Qt.AscendingOrder):
        """Sort by a column; as given where it is negative. What has no value comes last both ways."""
        self.layoutAboutToBeChanged.emit()
        before = self.persistentIndexList()
        kept = [self.rows[index.row()] for index in before]
        self._sorted_by = column, order
        self._arrange()
        place = {id(row): number for number, row in enumerate(self.rows)}
        self.changePersistentIndexList(
            before, [self.index(place[id(row)], index.column()) for row, index in zip(kept, before)])
        self.layoutChanged.emit()

    def rowCount(self, parent=QtCore.QModelIndex()):
        """Number of rows."""
        return 0 if parent.isValid() else len(self.rows)

    def columnCount(self, parent=QtCore.QModelIndex()):
        """Number of columns."""
        return 0 if parent.isValid() else len(self.columns)

    def headerData(self, section, orientation, role=QtCore.Qt.DisplayRole):
        """Titles and what they mean."""
        if orientation == QtCore.Qt.Horizontal and section < len(self.columns):
            if role == QtCore.Qt.DisplayRole:
                return self.columns[section].title
            if role == QtCore.Qt.ToolTipRole:
                return self.columns[section].meaning or self.columns[section].title
        return None

    def data(self, index, role=QtCore.Qt.DisplayRole):
        """Text, side and swatch of a cell."""
        column, row = self.columns[index.column()], self.rows[index.row()]
        if role in (QtCore.Qt.DisplayRole, QtCore.Qt.ToolTipRole):
            return column.text(row)
        if role == QtCore.Qt.TextAlignmentRole and column.is_number:
            return number_of(QtCore.Qt.AlignRight | QtCore.Qt.AlignVCenter)
        if role == QtCore.Qt.DecorationRole and column.swatch is not None:
            rgb = column.swatch(row)
            return None if rgb is None else _square(rgb)
        return None

    def _arrange(self):
        column, order = self._sorted_by
        if not 0 <= column < len(self.columns):
            self.rows = list(self._given)
            return
        keyed = [(self.columns[column].key(row), row) for row in self._given]
        known = [pair for pair in keyed if pair[0] is not None]
        known.sort(key=lambda pair: pair[0], reverse=order == QtCore.Qt.DescendingOrder)
        self.rows = [row for _, row in known] + [row for key, row in keyed if key is None]


class RowTable(QtWidgets.QTableView):
    """Shows a `RowModel` in little room.

    Signals
    -------
    row_chosen(object)
        The user has made a row the current one.
    """

    row_chosen = Signal(object)

    def __init__(self, name, columns, lines, parent=None):
        super().__init__(parent)
        self.setObjectName(name)
        self._lines, self._is_set = lines, False
        self._rows = RowModel(columns, self)
        self.setModel(self._rows)
        self.setSelectionBehavior(QtWidgets.QAbstractItemView.SelectRows)
        self.setSelectionMode(QtWidgets.QAbstractItemView.SingleSelection)
        self.setHorizontalScrollMode(QtWidgets.QAbstractItemView.ScrollPerPixel)
        self.setTabKeyNavigation(False)
        self.setAlternatingRowColors(True)
        self.setShowGrid(False)
        self.setWordWrap(False)
        self.verticalHeader().hide()
        header = self.horizontalHeader()
        header.setHighlightSections(False)
        header.setMinimumSectionSize(20)
        header.setDefaultAlignment(QtCore.Qt.AlignLeft | QtCore.Qt.AlignVCenter)
        header.setSortIndicator(-1, QtCore.Qt.AscendingOrder)
        self.setSortingEnabled(True)
        self.setSizePolicy(QtWidgets.QSizePolicy.Expanding, QtWidgets.QSizePolicy.Fixed)
        self.selectionModel().currentRowChanged.connect(self._tell)
        self._fit_rows()

    @property
    def rows(self):
        """list: the rows in the order in which they are shown."""
        return self._rows.rows

    @property
    def current_row(self):
        """The row that is selected, or None."""
        chosen = self.selectionModel().selectedRows()
        return self.rows[chosen[0].row()] if chosen else None

    def set_rows(self, rows):
        """Show other rows; none of them is selected."""
        self._rows.set_rows(rows)
        self._fit_rows()
        self._fit_columns()

    def set_columns(self, columns):
        """Show the same rows in other columns; the one that is selected stays so."""
        if [each.title for each in columns] != [each.title for each in self._rows.columns]:
            chosen = self.current_row
            self._rows.set_columns(columns)
            self._fit_columns()
            self.select(None if chosen is None else lambda row: row is chosen)

    def update_rows(self, rows, is_same):
        """Show what has become of the rows; the one that is selected stays so.

        Parameters
        ----------
        rows : list
        is_same : callable
            Whether two rows are about the same thing.
        """
        chosen = self.current_row
        if len(rows) != len(self.rows):
            self.set_rows(rows)
        else:
            self._rows.replace_rows(rows)
        self.select(None if chosen is None else lambda row: is_same(row, chosen))

    def select(self, wanted):
        """Select the row that a function is true of, without a signal; none where it is None."""
        self._is_set = True
        try:
            number = next((number for number, row in enumerate(self.rows) if wanted(row)), None) \
                if wanted is not None else None
            if number is None:
                self.selectionModel().clear()
            else:
                self.selectRow(number)
                self.scrollTo(self._rows.index(number, 0))
        finally:
            self._is_set = False

    def changeEvent(self, event):
        """Rows are as high as the letters."""
        super().changeEvent(event)
        if event.type() in (QtCore.QEvent.FontChange, QtCore.QEvent.StyleChange):
            self._fit_rows()

    def _fit_rows(self):
        row = self.fontMetrics().height() + 6
        self.verticalHeader().setSectionResizeMode(QtWidgets.QHeaderView.Fixed)
        self.verticalHeader().setMinimumSectionSize(row)
        self.verticalHeader().setDefaultSectionSize(row)
        lines = max(2, min(len(self.rows), self._lines))
        bar = self.horizontalScrollBar().sizeHint().height()
        self.setFixedHeight(lines * row + self.horizontalHeader().sizeHint().height() + bar
                            + 2 * self.frameWidth())

    def resizeEvent(self, event):
        """One column takes the room that the others leave."""
        super().resizeEvent(event)
        self._fit_columns()

    def showEvent(self, event):
        """Only now the letters have their size."""
        super().showEvent(event)
        self._fit_rows()
        self._fit_columns()

    def _fit_columns(self):
        self.horizontalHeader().setResizeContentsPrecision(50)
        letter, widths = self.fontMetrics().averageCharWidth(), []
        for number in range(self._rows.columnCount()):
            wanted = max(self.sizeHintForColumn(number), self.horizontalHeader().sectionSizeHint(number))
            widths.append(min(wanted + 4, 18 * letter))
        for number, column in enumerate(self._rows.columns):
            if column.takes_rest:
                left = self.viewport().width() - sum(widths) + widths[number]
                widths[number] = max(left, 8 * letter)
        for number, width in enumerate(widths):
            self.setColumnWidth(number, width)

    def _tell(self, current, _before):
        if not self._is_set and current.isValid():
            self.row_chosen.emit(self.rows[current.row()])


def _square(rgb):
    square = QtGui.QPixmap(12, 12)
    square.fill(colour(rgb))
    return square

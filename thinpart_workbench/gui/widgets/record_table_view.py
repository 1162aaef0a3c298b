"""Small tables that can be sorted by any column."""

from dataclasses import dataclass

from ..application.qt import QtCore, QtGui, QtWidgets, Signal, colour, flags_as_int
from .row_table import show_whole_rows


@dataclass(frozen=True)
class RecordColumn:
    """A column.

    Attributes
    ----------
    title : str
    text : callable
        Maps a row to the displayed text.
    key : callable
        Maps a row to its sort key: a text, a number, or None.
    is_number : bool
        Whether cells are right-aligned.
    swatch : callable, optional
        Maps a row to red, green and blue from 0 to 1, or None.
    meaning : str
        Tool tip of the heading.
    stretches : bool
        Whether the column takes the width that the others leave.
    most_characters : int
        Greatest width of a column that does not stretch.
    is_struck : callable, optional
        Maps a row to whether the text is struck through.
    """

    title: str
    text: object
    key: object
    is_number: bool = False
    swatch: object = None
    meaning: str = ""
    stretches: bool = False
    most_characters: int = 18
    is_struck: object = None


class RecordTableModel(QtCore.QAbstractTableModel):
    """Table model of rows sorted by one of the columns.

    Attributes
    ----------
    rows : list
        In the displayed order.
    """

    def __init__(self, columns, parent=None):
        super().__init__(parent)
        self.columns = list(columns)
        self.rows = []
        self._unsorted_rows = []
        self._sort_order = -1, QtCore.Qt.AscendingOrder

    def set_rows(self, rows):
        """Replace the rows and reset the model; the sort order stays the same."""
        self.beginResetModel()
        self._unsorted_rows = list(rows)
        self._sort_rows()
        self.endResetModel()

    def set_columns(self, columns):
        """Replace the columns; the rows stay the same."""
        self.beginResetModel()
        self.columns = list(columns)
        self.endResetModel()

    def replace_rows(self, rows):
        """Replace the rows by as many others without a reset: selected row numbers stay selected."""
        self._unsorted_rows = list(rows)
        self._sort_rows()
        if self.rows:
            self.dataChanged.emit(self.index(0, 0), self.index(len(self.rows) - 1, len(self.columns) - 1))

    def sort(self, column, order=QtCore.Qt.AscendingOrder):
        """Sort by a column, or not at all where it is negative. Rows without a value come last in either order."""
        self.layoutAboutToBeChanged.emit()
        before = self.persistentIndexList()
        indexed_rows = [self.rows[index.row()] for index in before]
        self._sort_order = column, order
        self._sort_rows()
        numbers = {id(row): number for number, row in enumerate(self.rows)}
        self.changePersistentIndexList(
            before, [self.index(numbers[id(row)], index.column()) for row, index in zip(indexed_rows, before)])
        self.layoutChanged.emit()

    def rowCount(self, parent=QtCore.QModelIndex()):
        """Number of rows."""
        return 0 if parent.isValid() else len(self.rows)

    def columnCount(self, parent=QtCore.QModelIndex()):
        """Number of columns."""
        return 0 if parent.isValid() else len(self.columns)

    def headerData(self, section, orientation, role=QtCore.Qt.DisplayRole):
        """Titles and tool tips of the columns."""
        if orientation == QtCore.Qt.Horizontal and section < len(self.columns):
            if role == QtCore.Qt.DisplayRole:
                return self.columns[section].title
            if role == QtCore.Qt.ToolTipRole:
                return self.columns[section].meaning or self.columns[section].title
        return None

    def data(self, index, role=QtCore.Qt.DisplayRole):
        """Text, alignment and swatch of a cell."""
        column, row = self.columns[index.column()], self.rows[index.row()]
        if role in (QtCore.Qt.DisplayRole, QtCore.Qt.ToolTipRole):
            return column.text(row)
        if role == QtCore.Qt.TextAlignmentRole and column.is_number:
            return flags_as_int(QtCore.Qt.AlignRight | QtCore.Qt.AlignVCenter)
        if role == QtCore.Qt.FontRole and column.is_struck is not None and column.is_struck(row):
            font = QtGui.QFont(QtWidgets.QApplication.font("QTableView"))
            font.setStrikeOut(True)
            return font
        if role == QtCore.Qt.DecorationRole and column.swatch is not None:
            rgb = column.swatch(row)
            return None if rgb is None else _square(rgb)
        return None

    def _sort_rows(self):
        column, order = self._sort_order
        if not 0 <= column < len(self.columns):
            self.rows = list(self._unsorted_rows)
            return
        keyed = [(self.columns[column].key(row), row) for row in self._unsorted_rows]
        known = [pair for pair in keyed if pair[0] is not None]
        known.sort(key=lambda pair: pair[0], reverse=order == QtCore.Qt.DescendingOrder)
        self.rows = [row for _, row in known] + [row for key, row in keyed if key is None]


class RecordTableView(QtWidgets.QTableView):
    """Compact view of a `RecordTableModel`.

    Signals
    -------
    row_chosen(object)
        The user has made a row the current one.
    """

    row_chosen = Signal(object)

    def __init__(self, name, columns, lines, parent=None):
        super().__init__(parent)
        self.setObjectName(name)
        self._lines, self._is_selecting = lines, False
        self._model = RecordTableModel(columns, self)
        self.setModel(self._model)
        show_whole_rows(self)
        self.verticalHeader().hide()
        header = self.horizontalHeader()
        header.setHighlightSections(False)
        header.setMinimumSectionSize(20)
        header.setDefaultAlignment(QtCore.Qt.AlignLeft | QtCore.Qt.AlignVCenter)
        header.setSortIndicator(-1, QtCore.Qt.AscendingOrder)
        self.setSortingEnabled(True)
        self.setSizePolicy(QtWidgets.QSizePolicy.Expanding, QtWidgets.QSizePolicy.Fixed)
        self.selectionModel().currentRowChanged.connect(self._on_current_row_changed)
        self._fit_rows()

    @property
    def rows(self):
        """list: the rows in the displayed order."""
        return self._model.rows

    @property
    def current_row(self):
        """The selected row, or None."""
        selected = self.selectionModel().selectedRows()
        return self.rows[selected[0].row()] if selected else None

    def set_rows(self, rows):
        """Replace the rows; none of them is selected."""
        self._model.set_rows(rows)
        self._fit_rows()
        self._fit_columns()

    def set_columns(self, columns):
        """Replace the columns; the selected row stays selected."""
        if [column.title for column in columns] != [column.title for column in self._model.columns]:
            selected = self.current_row
            self._model.set_columns(columns)
            self._fit_columns()
            self.select(None if selected is None else lambda row: row is selected)

    def update_rows(self, rows, is_same):
        """Show updated rows; the selected one stays selected.

        Parameters
        ----------
        rows : list
        is_same : callable
            Whether two rows represent the same object.
        """
        selected = self.current_row
        if len(rows) != len(self.rows):
            self.set_rows(rows)
        else:
            self._model.replace_rows(rows)
            self._fit_columns()  # what was unknown may be a long word now
        self.select(None if selected is None else lambda row: is_same(row, selected))

    def select(self, predicate):
        """Select the first row that satisfies a predicate, without emitting a signal; clear the selection for None."""
        self._is_selecting = True
        try:
            number = next((number for number, row in enumerate(self.rows) if predicate(row)), None) \
                if predicate is not None else None
            if number is None:
                self.selectionModel().clear()
            else:
                self.selectRow(number)
                self.scrollTo(self._model.index(number, 0))
        finally:
            self._is_selecting = False

    def changeEvent(self, event):
        """Adapt the row height to the font."""
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
        """Adapt the column that stretches."""
        super().resizeEvent(event)
        self._fit_columns()

    def showEvent(self, event):
        """Adapt rows and columns: the font size is final only now."""
        super().showEvent(event)
        self._fit_rows()
        self._fit_columns()

    def _fit_columns(self):
        self.horizontalHeader().setResizeContentsPrecision(50)
        character, widths = self.fontMetrics().averageCharWidth(), []
        for number in range(self._model.columnCount()):
            width = max(self.sizeHintForColumn(number), self.horizontalHeader().sectionSizeHint(number))
            widths.append(min(width + 4, self._model.columns[number].most_characters * character))
        for number, column in enumerate(self._model.columns):
            if column.stretches:
                remaining = self.viewport().width() - sum(widths) + widths[number]
                widths[number] = max(remaining, 8 * character)
        for number, width in enumerate(widths):
            self.setColumnWidth(number, width)

    def _on_current_row_changed(self, current, _before):
        if not self._is_selecting and current.isValid():
            self.row_chosen.emit(self.rows[current.row()])


def _square(rgb):
    square = QtGui.QPixmap(12, 12)
    square.fill(colour(rgb))
    return square

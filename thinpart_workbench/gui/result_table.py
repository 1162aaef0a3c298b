"""The table of results while a folder is classified, for Qt's views."""

from ..core.errors import KINDS
from .length_unit import MILLIMETRE
from .qt import QtCore, QtGui, Signal, colour, number_of, translate
from .result_order import FAILED, ResultOrder
from .row_table import RowColumn
from .sentences import translated
from .verdict_text import category_colour, category_title, number

FAILED_COLOUR = (0.80, 0.07, 0.07)
_REARRANGE = 500
"""Milliseconds after which rows that came since are put in their places."""


class ResultTable(QtCore.QAbstractTableModel):
    """Parts and failures, of which some are shown.

    Signals
    -------
    counts_changed
        `counts` are others now.
    """

    counts_changed = Signal()

    def __init__(self, parent=None):
        super().__init__(parent)
        self._order = ResultOrder()
        self._profile, self._unit = None, MILLIMETRE
        self._columns = self._new_columns()
        self._rearrange = QtCore.QTimer(self, singleShot=True, interval=_REARRANGE)
        self._rearrange.timeout.connect(lambda: self._change_order(self._order.arrange))

    @property
    def counts(self):
        """Counter of all rows, shown or not, by category or `FAILED`."""
        return self._order.counts

    @property
    def shown_rows(self):
        """list of PartRow: what is shown, in its order."""
        return [self._order.rows[index] for index in self._order.shown]

    @property
    def failed_files(self):
        """set of str: files of which something failed."""
        return {row.file for row in self._order.rows if row.error_kind}

    def row_at(self, index):
        """The PartRow at a place of the view."""
        return self._order.rows[self._order.shown[index.row()]]

    def clear(self, profile):
        """Start anew.

        Parameters
        ----------
        profile : Profile
            By which the next rows are judged; it has the words for their categories.
        """
        self.beginResetModel()
        self._profile = profile
        self._order.clear()
        self.endResetModel()
        self.counts_changed.emit()

    def show_unit(self, unit):
        """Write lengths in a LengthUnit from now on; rows are sorted as they were."""
        if unit != self._unit:
            self._unit = unit
            self._columns = self._new_columns()
            self.headerDataChanged.emit(QtCore.Qt.Horizontal, 0, len(self._columns) - 1)
            if self._order.shown:
                self.dataChanged.emit(
                    self.index(0, 0), self.index(len(self._order.shown) - 1, len(self._columns) - 1))

    def add(self, rows):
        """Add rows: at the end at first, in their places a moment later."""
        shown = self._order.add(rows)
        if shown:
            first = len(self._order.shown)
            self.beginInsertRows(QtCore.QModelIndex(), first, first + len(shown) - 1)
            self._order.shown += shown
            self.endInsertRows()
            if self._order.is_sorted_by_key and not self._rearrange.isActive():
                self._rearrange.start()
        self.counts_changed.emit()

    def remove_files(self, files):
        """Take out all rows of some files."""
        self.beginResetModel()
        self._order.remove_files(files)
        self.endResetModel()
        self.counts_changed.emit()

    def select(self, words, hidden):
        """Show what holds all words and is of no hidden category; see `ResultOrder.select`."""
        self.beginResetModel()
        self._order.select(words, hidden)
        self.endResetModel()

    def sort(self, column, order=QtCore.Qt.AscendingOrder):
        """Sort by a column; by the order in which rows came where it is negative."""
        key = self._columns[column].key if column >= 0 else None
        self._change_order(
            lambda: self._order.sort(key, order == QtCore.Qt.DescendingOrder))

    def rowCount(self, parent=QtCore.QModelIndex()):
        """Number of shown rows."""
        return 0 if parent.isValid() else len(self._order.shown)

    def columnCount(self, parent=QtCore.QModelIndex()):
        """Number of columns."""
        return 0 if parent.isValid() else len(self._columns)

    def headerData(self, section, orientation, role=QtCore.Qt.DisplayRole):
        """Titles of the columns, on the side on which their cells stand."""
        if orientation != QtCore.Qt.Horizontal:
            return None
        column = self._columns[section]
        if role == QtCore.Qt.DisplayRole:
            return column.title
        if role == QtCore.Qt.TextAlignmentRole:
            return _alignment(column)
        return None

    def data(self, index, role=QtCore.Qt.DisplayRole):
        """One cell."""
        if not index.isValid():
            return None
        row, column = self.row_at(index), self._columns[index.column()]
        if role == QtCore.Qt.DisplayRole:
            return column.text(row)
        if role == QtCore.Qt.TextAlignmentRole:
            return _alignment(column)
        if role == QtCore.Qt.DecorationRole and column is self._columns[CATEGORY]:
            return None if row.error_kind else colour(category_colour(row.category))
        if role == QtCore.Qt.ForegroundRole and row.error_kind:
            return QtGui.QBrush(colour(FAILED_COLOUR))
        if role == QtCore.Qt.ToolTipRole:
            return translated(row.error or row.warnings or "") or row.file
        return None

    def _change_order(self, change):
        """Change which row stands where, and let what is selected stay selected."""
        self.layoutAboutToBeChanged.emit()
        before = self.persistentIndexList()
        numbers = [self._order.shown[index.row()] for index in before]
        change()
        place = {number_: at for at, number_ in enumerate(self._order.shown)} if before else {}
        self.changePersistentIndexList(before, [
            self.index(place[number_], index.column())
            for number_, index in zip(numbers, before)])
        self.layoutChanged.emit()

    def _category_text(self, row):
        if row.error_kind:
            return "\u2717 " + translate("ThinPart", "Failed: {}").format(
                translated(KINDS.get(row.error_kind, row.error_kind)))
        title = category_title(row.category, self._profile)
        if row.borderline:
            return translate("ThinPart", "{} (borderline)").format(title)
        return title

    def _new_columns(self):
        return (
            RowColumn(translate("ThinPart", "File"), lambda row: row.file,
                         lambda row: row.file.casefold()),
            RowColumn(translate("ThinPart", "Part"), _part, lambda row: _part(row).casefold()),
            RowColumn(translate("ThinPart", "Category"), self._category_text,
                         self._category_text),
            RowColumn(translate("ThinPart", "Criteria"), _criteria, _criteria),
            RowColumn(translate("ThinPart", "Box, {}").format(self._unit.symbol), self._box,
                         lambda row: row.d1_mm, True),
            _quantity("V/VBB", "volume_ratio", number),
            _quantity(translate("ThinPart", "Thinnest, {}").format(self._unit.symbol), "thinnest_mm",
                         self._unit.number),
            RowColumn(translate("ThinPart", "Instances"),
                         lambda row: "" if row.instances is None else str(row.instances),
                         lambda row: row.instances, True),
        )

    def _box(self, row):
        if row.d1_mm is None:
            return ""
        return " \u00d7 ".join(map(self._unit.number, (row.d1_mm, row.d2_mm, row.d3_mm)))


FILE, PART, CATEGORY, CRITERIA, BOX, RATIO, THINNEST, INSTANCES = range(8)


def group_title(group, profile):
    """A category, or `FAILED`, in plain words."""
    if group == FAILED:
        return "\u2717 " + translate("ThinPart", "Failed")
    return category_title(group, profile)


def _alignment(column):
    side = QtCore.Qt.AlignRight if column.is_number else QtCore.Qt.AlignLeft
    return number_of(side | QtCore.Qt.AlignVCenter)


def _quantity(title, name, text):
    def value(row):
        return getattr(row, name)

    return RowColumn(
        title, lambda row: "" if row.error_kind else text(value(row)), value, True)


def _part(row):
    return row.label or row.part or ""


def _criteria(row):
    return (row.criteria or "").replace(" ", ", ")


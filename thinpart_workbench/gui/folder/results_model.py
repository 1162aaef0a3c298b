"""Qt table model of the results of a folder classification."""

from ...core.errors import KINDS
from ...core.length_unit import MILLIMETRE
from ..application.numbers import number
from ..application.qt import QtCore, QtGui, Signal, colour, flags_as_int, translate
from ..application.sentences import translated
from ..record.category_marks import FAILED_COLOUR
from ..record.label_button import labels_sentence
from ..record.verdict_text import category_colour, category_title, criterion_titles
from ..record.wall_checks import SYMBOLS
from ..widgets.record_table_view import RecordColumn
from .results_order import ResultsOrder

_SORT_DELAY = 500
"""Milliseconds after which appended rows are sorted in."""


class ResultsModel(QtCore.QAbstractTableModel):
    """Table model of parts and failures, filtered and sorted.

    Signals
    -------
    counts_changed
        `counts` has changed.
    """

    counts_changed = Signal()

    def __init__(self, parent=None):
        super().__init__(parent)
        self._order = ResultsOrder()
        self._profile, self._limits, self._unit, self._titles = None, (), MILLIMETRE, {}
        self._columns = self._new_columns()
        self._sort_timer = QtCore.QTimer(self, singleShot=True, interval=_SORT_DELAY)
        self._sort_timer.timeout.connect(lambda: self._change_order(self._order.arrange))

    @property
    def counts(self):
        """Counter of all rows by category or `FAILED`, including hidden rows."""
        return self._order.counts

    @property
    def shown_rows(self):
        """list of PartRow: the visible rows in their order."""
        return [self._order.rows[index] for index in self._order.shown]

    @property
    def failed_files(self):
        """set of str: files with a failure."""
        return {row.file for row in self._order.rows if row.error_kind}

    def row_at(self, index):
        """The PartRow at a QModelIndex."""
        return self._order.rows[self._order.shown[index.row()]]

    @property
    def limits(self):
        """tuple of WallLimits: what the parts are checked against, a column for each."""
        return self._limits

    def clear(self, profile, limits=()):
        """Remove all rows and set the profile.

        Parameters
        ----------
        profile : Profile
            Profile of the next rows; it provides the titles of their categories.
        limits : tuple of WallLimits, optional
            What the next rows are checked against.
        """
        self.beginResetModel()
        self._profile, self._limits, self._titles = profile, limits, criterion_titles(profile)
        self._columns = self._new_columns()
        self._order.clear()
        self.endResetModel()
        self.counts_changed.emit()

    def show_unit(self, unit):
        """Show lengths in a LengthUnit; the order of rows stays."""
        if unit != self._unit:
            self._unit = unit
            self._columns = self._new_columns()
            self.headerDataChanged.emit(QtCore.Qt.Horizontal, 0, len(self._columns) - 1)
            if self._order.shown:
                self.dataChanged.emit(
                    self.index(0, 0), self.index(len(self._order.shown) - 1, len(self._columns) - 1))

    def add(self, rows):
        """Append rows; a timer sorts them in."""
        shown = self._order.add(rows)
        if shown:
            first = len(self._order.shown)
            self.beginInsertRows(QtCore.QModelIndex(), first, first + len(shown) - 1)
            self._order.shown += shown
            self.endInsertRows()
            if self._order.is_sorted_by_key and not self._sort_timer.isActive():
                self._sort_timer.start()
        self.counts_changed.emit()

    def remove_files(self, files):
        """Remove all rows of some files."""
        self.beginResetModel()
        self._order.remove_files(files)
        self.endResetModel()
        self.counts_changed.emit()

    def relabel(self, file, part, labels):
        """Show other labels of a part.

        Parameters
        ----------
        file, part : str
            As in its PartRow.
        labels : list of dict
            As in a part record.
        """
        for number_, row in enumerate(self._order.rows):
            if (row.file, row.part) == (file, part) and not row.error_kind:
                self._order.rows[number_] = row.relabelled(labels)
                if number_ in self._order.shown:
                    shown = self._order.shown.index(number_)
                    self.dataChanged.emit(self.index(shown, 0), self.index(shown, len(self._columns) - 1))
                return

    def select(self, words, hidden):
        """Filter by words and hidden categories; see `ResultsOrder.select`."""
        self.beginResetModel()
        self._order.select(words, hidden)
        self.endResetModel()

    def sort(self, column, order=QtCore.Qt.AscendingOrder):
        """Sort by a column, or in order of arrival if it is negative."""
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
        """Titles of the columns, aligned like their cells."""
        if orientation != QtCore.Qt.Horizontal:
            return None
        column = self._columns[section]
        if role == QtCore.Qt.DisplayRole:
            return column.title
        if role == QtCore.Qt.TextAlignmentRole:
            return _alignment(column)
        return None

    def data(self, index, role=QtCore.Qt.DisplayRole):
        """Data of a cell for a role."""
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
        if role == QtCore.Qt.ToolTipRole and 0 <= index.column() - FIRST_CHECK < len(self._limits):
            check = _check(row, index.column() - FIRST_CHECK)
            return check and translated(check["sentence"], self._unit)
        if role == QtCore.Qt.ToolTipRole and index.column() == CRITERIA + len(self._limits) and row.criteria:
            return column.text(row)
        if role == QtCore.Qt.ToolTipRole:
            return translated(row.error or row.warnings or "", self._unit) or row.file
        return None

    def _change_order(self, change):
        """Change the order of rows and keep the selection."""
        self.layoutAboutToBeChanged.emit()
        before = self.persistentIndexList()
        numbers = [self._order.shown[index.row()] for index in before]
        change()
        new_rows = {number_: row for row, number_ in enumerate(self._order.shown)} if before else {}
        self.changePersistentIndexList(before, [
            self.index(new_rows[number_], index.column())
            for number_, index in zip(numbers, before)])
        self.layoutChanged.emit()

    def _category_text(self, row):
        if row.error_kind:
            return "\u2717 " + translate("ThinPart", "Failed: {}").format(
                translated(KINDS.get(row.error_kind, row.error_kind)))
        title = category_title(row.category, self._profile)
        if row.borderline:
            return translate("ThinPart", "{} (unsure)").format(title)
        return title

    def _labels_text(self, row):
        return labels_sentence(getattr(row, "said", ()), self._profile)

    def _criteria_text(self, row):
        return ", ".join(self._titles.get(name, name) for name in (row.criteria or "").split())

    def _new_columns(self):
        return (
            RecordColumn(translate("ThinPart", "File"), lambda row: row.file,
                         lambda row: row.file.casefold()),
            RecordColumn(translate("ThinPart", "Part"), _part, lambda row: _part(row).casefold()),
            RecordColumn(translate("ThinPart", "Category"), self._category_text,
                         self._category_text),
            *(RecordColumn(translated(limits.full_title), lambda row, number=number: _check_text(row, number),
                           lambda row, number=number: _check_text(row, number))
              for number, limits in enumerate(self._limits)),
            RecordColumn(translate("ThinPart", "Criteria"), self._criteria_text, self._criteria_text),
            RecordColumn(translate("ThinPart", "Box, {}").format(self._unit.symbol), self._box,
                         lambda row: row.d1_mm, True),
            _quantity("V/VBB", "volume_ratio", number),
            _quantity(translate("ThinPart", "Thinnest, {}").format(self._unit.symbol), "thinnest_mm",
                         self._unit.number),
            RecordColumn(translate("ThinPart", "Instances"),
                         lambda row: "" if row.instances is None else str(row.instances),
                         lambda row: row.instances, True),
            RecordColumn(translate("ThinPart", "Labels"), self._labels_text, self._labels_text),
        )

    def _box(self, row):
        if row.d1_mm is None:
            return ""
        return " \u00d7 ".join(map(self._unit.number, (row.d1_mm, row.d2_mm, row.d3_mm)))


FILE, PART, CATEGORY, CRITERIA, BOX, RATIO, THINNEST, INSTANCES, LABELS = range(9)
"""The columns where nothing is checked."""

FIRST_CHECK = CATEGORY + 1
"""Column of the first check, if there is one: what comes after the category stands after all checks then."""


def _alignment(column):
    side = QtCore.Qt.AlignRight if column.is_number else QtCore.Qt.AlignLeft
    return flags_as_int(side | QtCore.Qt.AlignVCenter)


def _quantity(title, name, text):
    def value(row):
        return getattr(row, name)

    return RecordColumn(
        title, lambda row: "" if row.error_kind else text(value(row)), value, True)


def _check(row, number):
    """The result of a check of a row, None for a failure."""
    checks = getattr(row, "checks", ())
    return checks[number] if number < len(checks) else None


def _check_text(row, number):
    check = _check(row, number)
    if check is None:
        return ""
    words = {True: translate("ThinPart", "passes"), False: translate("ThinPart", "fails"),
             None: translate("ThinPart", "unknown")}
    return f"{SYMBOLS[check['passes']]} {words[check['passes']]}"


def _part(row):
    return row.label or row.part or ""

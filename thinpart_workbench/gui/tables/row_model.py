# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Qt table model of rows, whatever they are and wherever they come from."""

from ..application.length_unit import MILLIMETRE
from ..application.qt import QtCore, QtGui, QtWidgets, Signal, colour, flags_as_int

FAILED_COLOUR = (0.80, 0.07, 0.07)

# Looking a name up in Qt's namespace takes longer than all the rest that a cell needs.
_ALIGNMENT, _SHOWN, _EDITED, _TIP, _PICTURE, _COLOUR, _FONT, _CHECK = (
    QtCore.Qt.TextAlignmentRole, QtCore.Qt.DisplayRole, QtCore.Qt.EditRole, QtCore.Qt.ToolTipRole, QtCore.Qt.DecorationRole,
    QtCore.Qt.ForegroundRole, QtCore.Qt.FontRole, QtCore.Qt.CheckStateRole)


class RowModel(QtCore.QAbstractTableModel):
    """Table model whose columns, a list of Column, are data; `KeptRows` and `FetchedRows` have the rows.

    Both give ``row_at(number)``, the row with a number from 0, None where it is not known, and ``collect(done)``, which
    calls a function with a list of all shown rows in their order, at once or when they have come.

    Attributes
    ----------
    unit : LengthUnit
        The one in which lengths are shown.

    Signals
    -------
    edited(str, int, object)
        The user has edited a cell: the key of its column, the number of its row, and the new text, or whether it is checked.
    """

    edited = Signal(str, int, object)

    def __init__(self, columns, parent=None):
        super().__init__(parent)
        self.columns, self.unit = list(columns), MILLIMETRE
        self._brief = set()  # keys of columns whose headings are without their unit

    def is_failed(self, row):
        """Whether a row is about a failure, which is shown in red."""
        return bool(getattr(row, "error_kind", None))

    def tip(self, row, column):
        """The tool tip of a row in a column that has none itself."""
        return column.shown(row, self.unit)

    def number_of(self, key):
        """Number of the column with this key: int."""
        return next(number for number, column in enumerate(self.columns) if column.key == key)

    def show_unit(self, unit):
        """Show lengths in a LengthUnit; the order of rows stays."""
        if unit != self.unit:
            self.unit = unit
            self.show_columns(self.columns)

    def show_brief(self, keys):
        """Leave out the unit in the headings of some columns: set of str, their keys."""
        if keys != self._brief:
            self._brief = keys
            self.headerDataChanged.emit(QtCore.Qt.Horizontal, 0, len(self.columns) - 1)

    def show_columns(self, columns):
        """Replace the columns; the rows stay, also their selection where there are as many columns as before."""
        if [column.key for column in columns] != [column.key for column in self.columns]:
            self.beginResetModel()
            self.columns = list(columns)
            self.endResetModel()
            return
        self.columns = list(columns)
        self.headerDataChanged.emit(QtCore.Qt.Horizontal, 0, len(columns) - 1)
        self.rows_changed(0, self.rowCount())

    def rows_changed(self, start, end):
        """Tell views that the cells of some rows are others: from number `start` up to, excluding, `end`."""
        if end > start:
            self.dataChanged.emit(self.index(start, 0), self.index(end - 1, len(self.columns) - 1))

    def columnCount(self, parent=QtCore.QModelIndex()):
        """Number of columns."""
        return 0 if parent.isValid() else len(self.columns)

    def headerData(self, section, orientation, role=_SHOWN):
        """Headings of the columns, aligned like their cells."""
        if orientation != QtCore.Qt.Horizontal or section >= len(self.columns):
            return None
        column = self.columns[section]
        is_brief = column.key in self._brief
        if role == _SHOWN:
            return column.brief(self.unit) if is_brief else column.heading(self.unit)
        if role == _TIP:
            said = (column.heading(self.unit) if is_brief or not column.meaning else "", column.meaning)
            return "\n".join(filter(None, said))
        return column.alignment if role == _ALIGNMENT else None

    def data(self, index, role=_SHOWN):
        """Data of a cell for a role."""
        if not index.isValid():
            return None
        column, row = self.columns[index.column()], self.row_at(index.row())
        if role == _ALIGNMENT:
            return column.alignment
        if row is None:
            return self.waiting(index) if role == _SHOWN else None
        if role in (_SHOWN, _EDITED):
            return column.shown(row, self.unit)
        if role == _TIP:
            return column.tip and column.tip(row, self.unit) or self.tip(row, column)
        if role == _PICTURE:
            return column.picture and column.picture(row)
        if role == _COLOUR and self.is_failed(row):
            return QtGui.QBrush(colour(FAILED_COLOUR))
        if role == _FONT and column.is_struck and column.is_struck(row):
            font = QtGui.QFont(QtWidgets.QApplication.font("QTableView"))
            font.setStrikeOut(True)
            return font
        if role == _CHECK and column.is_checked and column.is_checked(row) is not None:
            return flags_as_int(QtCore.Qt.Checked if column.is_checked(row) else QtCore.Qt.Unchecked)
        return None

    def waiting(self, index):
        """What a cell shows whose row is not known yet."""
        return None

    def flags(self, index):
        """Which cells may be checked and edited."""
        flags = super().flags(index)
        row = self.row_at(index.row()) if index.isValid() else None
        if row is not None:
            column = self.columns[index.column()]
            if column.is_checked and column.is_checked(row) is not None:
                flags |= QtCore.Qt.ItemIsUserCheckable
            if column.is_editable and column.is_editable(row):
                flags |= QtCore.Qt.ItemIsEditable
        return flags

    def setData(self, index, value, role=QtCore.Qt.EditRole):
        """Tell what the user wants in a cell; who listens shows other rows."""
        if role == QtCore.Qt.CheckStateRole:
            value = value in (QtCore.Qt.Checked, flags_as_int(QtCore.Qt.Checked))
        self.edited.emit(self.columns[index.column()].key, index.row(), value)
        return True

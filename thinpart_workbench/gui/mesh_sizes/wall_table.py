"""The editable table of the walls of a part: on or off, size, layers."""

from ...core.sizing.sizing_settings import divisions_of
from ..application.length_unit import MILLIMETRE
from ..application.numbers import marked
from ..application.qt import QtCore, QtGui, QtWidgets, Signal, colour, grouped, translate
from ..record.regions_table import kind_word

_LINES = 7
WALL, SIZE, LAYERS, ELEMENTS = range(4)


class WallTable(QtWidgets.QTableWidget):
    """A row for each wall; what is edited holds for all selected rows.

    Signals
    -------
    edited(object)
        dict: size in mm, or None for off, by number of the region.
    faces_chosen(object)
        Tuple of face numbers of the part, from 0, of the selected rows.
    """

    edited = Signal(object)
    faces_chosen = Signal(object)

    def __init__(self, parent=None):
        super().__init__(0, 4, parent)
        self.setObjectName("ThinPart_WallSizes")
        self.setSelectionBehavior(QtWidgets.QAbstractItemView.SelectRows)
        self.verticalHeader().hide()
        self.setSizePolicy(QtWidgets.QSizePolicy.Expanding, QtWidgets.QSizePolicy.Fixed)
        self.setToolTip(translate(
            "ThinPart", "Double-click a size or a number of layers to change it, for all selected walls. Without "
                        "the check mark, a wall asks for no small elements."))
        self.rows, self._unit = [], MILLIMETRE
        self.itemChanged.connect(self._on_changed)
        self.itemSelectionChanged.connect(self._on_selected)

    def show_rows(self, rows, unit, colours):
        """Show walls.

        Parameters
        ----------
        rows : list of dict
            As ``regions`` of `PartSizing.proposed`.
        unit : LengthUnit
        colours : list of tuple
            Red, green and blue from 0 to 1 of each row.
        """
        blocked = self.blockSignals(True)
        self.rows, self._unit = rows, unit
        self.setHorizontalHeaderLabels([
            translate("ThinPart", "Wall"), translate("ThinPart", "Size, {}").format(unit.symbol),
            translate("ThinPart", "Layers"), translate("ThinPart", "Elements")])
        if self.rowCount() != len(rows):
            self.setRowCount(len(rows))
        for number, (row, rgb) in enumerate(zip(rows, colours)):
            is_on = row["size"] is not None
            texts = [f"{kind_word(row['kind'])} {unit.text(row['thickness'])}", unit.number(row["size"]),
                     marked(f"{row['layers']:.3g}") if is_on else "\u2013", grouped(row["elements"]) if is_on else "\u2013"]
            for column, text in enumerate(texts):
                self.setItem(number, column, self._cell(column, text, is_on, rgb))
        self.blockSignals(blocked)
        self._fit()

    @property
    def faces(self):
        """Tuple of int: the faces of the selected walls."""
        return tuple(face for number in self._selected() for face in self.rows[number]["faces"])

    def _cell(self, column, text, is_on, rgb):
        cell = QtWidgets.QTableWidgetItem(text)
        flags = QtCore.Qt.ItemIsSelectable | QtCore.Qt.ItemIsEnabled
        if column == WALL:
            flags |= QtCore.Qt.ItemIsUserCheckable
            cell.setCheckState(QtCore.Qt.Checked if is_on else QtCore.Qt.Unchecked)
            square = QtGui.QPixmap(12, 12)
            square.fill(colour(rgb))
            cell.setIcon(QtGui.QIcon(square))
        else:
            cell.setTextAlignment(QtCore.Qt.AlignRight | QtCore.Qt.AlignVCenter)
        if column in (SIZE, LAYERS) and is_on:
            flags |= QtCore.Qt.ItemIsEditable
        cell.setFlags(flags)
        return cell

    def _selected(self):
        return sorted({index.row() for index in self.selectedIndexes()})

    def _on_selected(self):
        self.faces_chosen.emit(self.faces)

    def _on_changed(self, cell):
        chosen = self._selected()
        chosen = chosen if cell.row() in chosen else [cell.row()]
        if cell.column() == WALL:
            is_on = cell.checkState() == QtCore.Qt.Checked
            self.edited.emit({self.rows[number]["region"]: self.rows[number]["proposed_size"] if is_on else None
                              for number in chosen})
            return
        value = _number(cell.text())
        if value is None:
            self.edited.emit({})  # which shows the former text again
            return
        self.edited.emit({self.rows[number]["region"]: value * self._unit.millimetres if cell.column() == SIZE
                          else self.rows[number]["thickness"] / divisions_of(value) for number in chosen})

    def _fit(self):
        row = self.fontMetrics().height() + 8
        self.verticalHeader().setDefaultSectionSize(row)
        self.setFixedHeight(min(max(2, len(self.rows)), _LINES) * row + self.horizontalHeader().sizeHint().height()
                            + 2 * self.frameWidth() + 2)
        self.resizeColumnsToContents()
        self.horizontalHeader().setSectionResizeMode(WALL, QtWidgets.QHeaderView.Stretch)


def _number(text):
    try:
        value = float(text.strip().replace(",", "."))
    except ValueError:
        return None
    return value if 1e-6 <= value <= 1e6 else None

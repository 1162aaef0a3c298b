"""The walls that were probed one by one."""

from dataclasses import dataclass

from .flow_layout import FlowLayout
from .length_unit import MILLIMETRE
from .push_button import add_button
from .qt import QtCore, QtWidgets, Signal, translate
from .result_view import show_text, text_line
from .row_table import RowColumn, RowTable

_LINES = 6


@dataclass(frozen=True)
class ProbeRow:
    """A probe: its number from 0, and the wall in mm."""

    number: int
    thickness: float


class ProbeBox(QtWidgets.QWidget):
    """A list of probes, and buttons.

    Signals
    -------
    picking_toggled(bool)
        Whether clicks on the part pin probes from now on.
    removed(int)
    cleared
    visited(int)
        A probe was double-clicked.
    """

    picking_toggled = Signal(bool)
    removed = Signal(int)
    cleared = Signal()
    visited = Signal(int)

    def __init__(self, parent=None):
        super().__init__(parent)
        self.setObjectName("ThinPart_ProbeBox")
        self._unit = MILLIMETRE
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(6, 6, 6, 6)
        row = QtWidgets.QWidget(self)
        flow = FlowLayout(row)
        self.probe_button = add_button(
            flow, row, "ThinPart_ProbeButton", translate("ThinPart", "&Probe"),
            lambda: self.picking_toggled.emit(self.probe_button.isChecked()))
        self.probe_button.setCheckable(True)
        self.probe_button.setToolTip(translate(
            "ThinPart", "Shows the wall under the cursor; a click pins it"))
        self._remove = add_button(flow, row, "ThinPart_RemoveProbe", translate("ThinPart", "&Remove"),
                                  self._remove_current)
        self._clear = add_button(flow, row, "ThinPart_ClearProbes", translate("ThinPart", "C&lear all"),
                                 self.cleared.emit)
        column.addWidget(row)
        self._hovered = text_line(self, column, "ThinPart_HoveredWall")
        self.table = RowTable("ThinPart_ProbeTable", [
            RowColumn(translate("ThinPart", "Probe"), lambda row: str(row.number + 1),
                      lambda row: row.number),
            RowColumn(translate("ThinPart", "Wall"), lambda row: self._unit.text(row.thickness),
                      lambda row: row.thickness, is_number=True),
        ], _LINES, self)
        self.table.activated.connect(lambda index: self.visited.emit(self.table.rows[index.row()].number))
        self.table.selectionModel().selectionChanged.connect(lambda *_: self._show_buttons())
        column.addWidget(self.table)
        self.show_hovered(None)

    def show_probes(self, values, unit):
        """Show the probes of a map: their walls in mm, in the order in which they were pinned, and in which unit."""
        self._unit = unit
        self.table.update_rows([ProbeRow(place, value) for place, value in enumerate(values)],
                               lambda one, other: one.number == other.number)
        self._show_buttons()

    def show_picking(self, is_on):
        """Show whether clicks pin probes."""
        self.probe_button.setChecked(is_on)
        self.show_hovered(None)

    def show_hovered(self, wall):
        """Show what is under the cursor: a dict of the picker, or None."""
        if not self.probe_button.isChecked():
            show_text(self._hovered, "")
        elif wall is None:
            show_text(self._hovered, translate(
                "ThinPart", "Move over the part; a click pins the wall there."))
        elif wall["thickness"] is None:
            show_text(self._hovered, translate("ThinPart", "No wall was measured here."))
        else:
            show_text(self._hovered, translate("ThinPart", "Here: {}").format(self._unit.text(wall["thickness"])))

    def keyPressEvent(self, event):
        """Delete removes the probe that is selected."""
        if event.key() == QtCore.Qt.Key_Delete and self.table.current_row is not None:
            self._remove_current()
        else:
            super().keyPressEvent(event)

    def _remove_current(self):
        row = self.table.current_row
        if row is not None:
            self.removed.emit(row.number)

    def _show_buttons(self):
        self._remove.setEnabled(self.table.current_row is not None)
        self._clear.setEnabled(bool(self.table.rows))

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The list of pinned probes."""

from dataclasses import dataclass

from ...core.analysis_settings import RAY
from ..application.length_unit import MILLIMETRE
from ..application.qt import QtCore, QtWidgets, Signal, translate
from ..record.measure_text import here_sentence, value_title
from ..record.record_view import show_text, text_line
from ..tables.column import Column
from ..tables.small_table import SmallTable
from ..widgets.buttons import add_button
from ..widgets.flow_layout import FlowLayout

_VISIBLE_ROWS = 6


@dataclass(frozen=True)
class ProbeRow:
    """A probe: its number from 0, and the wall thickness in mm."""

    number: int
    thickness: float


class ProbeBox(QtWidgets.QWidget):
    """The table of probes and its buttons.

    Signals
    -------
    picking_toggled(bool)
        Whether clicks on the part should pin probes.
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
        self._unit, self._measure, self._least, self._most = MILLIMETRE, RAY, 0.0, 0.0
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(6, 6, 6, 6)
        row = QtWidgets.QWidget(self)
        flow = FlowLayout(row)
        self.probe_button = add_button(
            flow, row, "ThinPart_ProbeButton", translate("ThinPart", "&Probe"),
            lambda: self.picking_toggled.emit(self.probe_button.isChecked()))
        self.probe_button.setCheckable(True)
        self.probe_button.setToolTip(translate(
            "ThinPart", "A click on the part pins the wall there"))
        self._remove = add_button(flow, row, "ThinPart_RemoveProbe", translate("ThinPart", "&Remove"),
                                  self._remove_current)
        self._clear = add_button(flow, row, "ThinPart_ClearProbes", translate("ThinPart", "C&lear all"),
                                 self.cleared.emit)
        column.addWidget(row)
        self.table = SmallTable("ThinPart_ProbeTable", self._columns(), _VISIBLE_ROWS, self)
        self.table.activated.connect(lambda index: self.visited.emit(self.table.rows[index.row()].number))
        self.table.selectionModel().selectionChanged.connect(lambda *_: self._show_buttons())
        column.addWidget(self.table)
        self._hover_text = text_line(self, column, "ThinPart_HoveredWall")
        self.show_hovered(None)

    def show_probes(self, values, unit, measure, file):
        """Show the probes of a map in a unit: list of values in mm by one of `SHOWN_MEASURES`, in the order of pinning.

        They may be on several parts of the document `file`.
        """
        self._unit, self._measure = unit, measure
        self.table.show_rows([ProbeRow(number, value) for number, value in enumerate(values)], self._columns(), unit,
                             lambda one, other: one.number == other.number, (file, "", ""))
        self._show_buttons()

    def show_picking(self, is_on):
        """Show whether clicks pin probes."""
        self.probe_button.setChecked(is_on)
        self.show_hovered(None)

    def show_limits(self, least, most):
        """Tell of the wall under the cursor whether it lies within limits in mm; 0 for none."""
        self._least, self._most = least, most

    def _hovered_sentence(self, value, is_thick):
        text = self._unit.text(value)
        if self._measure != RAY or not (self._least or self._most):
            return here_sentence(self._measure, text)  # limits are those of the wall across
        if value < self._least:
            return translate("ThinPart", "\u2717 {}: at least {} are needed here").format(
                text, self._unit.text(self._least))
        if is_thick:
            return translate("ThinPart", "\u2717 The largest ball here is too large: at most {} are allowed").format(
                self._unit.text(self._most))
        return translate("ThinPart", "\u2713 {}: within the limits").format(text)

    def show_hovered(self, wall, is_thick=False):
        """Show the wall under the cursor: a dict of the picker, or None; and whether it is too thick for what is checked."""
        if wall is None:
            show_text(self._hover_text, translate("ThinPart", "Move over the part; a click pins the wall there.")
                      if self.probe_button.isChecked() else "")
        elif wall["thickness"] is None:
            show_text(self._hover_text, translate("ThinPart", "No wall was measured here."))
        else:
            show_text(self._hover_text, self._hovered_sentence(wall["thickness"], is_thick))

    def keyPressEvent(self, event):
        """Remove the selected probe on Delete."""
        if event.key() == QtCore.Qt.Key_Delete and self.table.current_row is not None:
            self._remove_current()
        else:
            super().keyPressEvent(event)

    def _columns(self):
        return [
            Column("probe", translate("ThinPart", "Probe"), lambda row: row.number + 1,
                   lambda row, unit: str(row.number + 1)),
            Column("thickness_mm", value_title(self._measure), lambda row: row.thickness,
                   lambda row, unit: unit.text(row.thickness), is_number=True),
        ]

    def _remove_current(self):
        row = self.table.current_row
        if row is not None:
            self.removed.emit(row.number)

    def _show_buttons(self):
        self._remove.setEnabled(self.table.current_row is not None)
        self._clear.setEnabled(bool(self.table.rows))

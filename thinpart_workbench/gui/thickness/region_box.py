# SPDX-License-Identifier: LGPL-2.1-or-later
"""The list of wall regions of one mapped part."""

from ..application.length_unit import MILLIMETRE
from ..application.qt import QtWidgets, Signal, translate
from ..record.record_view import other_regions_text, show_text, text_line
from ..record.regions_table import RegionsTable, notes_text
from ..widgets.buttons import add_button
from .region_menu import RegionMenu


class RegionBox(QtWidgets.QWidget):
    """The table of wall regions, or a hint why it is empty.

    Signals
    -------
    faces_chosen(object)
        The user selected a row: tuple of face numbers, from 0.
    visited(object)
        The user wants to see a wall: see `RegionsTable`.
    hovered(object)
        See `RegionsTable`.
    isolated(object)
        The user wants to see only some walls: tuple of face numbers, from 0, None for everything again.
    said(object, object)
        The user says something of regions: a tuple of their entries in the record, and a dict with one of ``excluded`` and
        ``mesh_size_mm``; see `note_regions`.
    """

    faces_chosen = Signal(object)
    visited = Signal(object)
    hovered = Signal(object)
    isolated = Signal(object)
    said = Signal(object, object)

    def __init__(self, parent=None):
        super().__init__(parent)
        self.setObjectName("ThinPart_RegionBox")
        self._unit, self._refusal, self._is_isolated = MILLIMETRE, "", False
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(6, 6, 6, 6)
        self._hint = text_line(self, column, "ThinPart_RegionWords")
        self.table = RegionsTable(self)
        self.table.faces_chosen.connect(self.faces_chosen)
        self.table.visited.connect(self.visited)
        self.table.hovered.connect(self.hovered)
        self.table.row_menu = self._menu
        column.addWidget(self.table)
        self._all = add_button(column, self, "ThinPart_ShowAllWalls", translate("ThinPart", "Show &all walls"),
                               lambda: self._act(None, "show_all"))
        self._others, self._said, self._message = (
            text_line(self, column, f"ThinPart_{name}") for name in ("OtherRegions", "RegionNotes", "RegionMessage"))
        self.show_message("")
        self.show_isolated(False)
        self.show_no_part()

    def show_regions(self, record, unit, features=(), notes=(), refusal="", file=""):
        """Show the regions of a part record.

        Parameters
        ----------
        record, unit, features, notes, file
            See `RegionsTable.show_regions`.
        refusal : str
            Why nothing can be kept of them; empty if it can.
        """
        self._unit, self._refusal = unit, refusal
        self.table.show_regions(record, unit, features, notes, file)
        self._all.setVisible(bool(self.table.rows))
        show_text(self._hint, "" if self.table.rows else translate(
            "ThinPart", "No wall regions are recorded: measure the part again."))
        show_text(self._others, other_regions_text(record))
        show_text(self._said, "\n".join(notes_text(self.table.rows, unit)))

    def show_message(self, sentence):
        """Show what went wrong when something was kept."""
        show_text(self._message, sentence)

    def show_isolated(self, is_isolated):
        """Show whether the map shows only some walls."""
        self._is_isolated = is_isolated
        self._all.setEnabled(is_isolated)

    def _menu(self, group):
        if group is None:
            return QtWidgets.QMenu(self)
        return RegionMenu(group, self._unit, self._refusal, self._is_isolated, lambda *done: self._act(group, *done), self)

    def _act(self, group, what, value=None):
        if what == "isolate":
            self.isolated.emit(group.faces)
        elif what == "show_all":
            self.isolated.emit(None)
        else:
            self.said.emit(group.regions, {what: value})

    def show_no_part(self):
        """Hide the table, because several parts are shown."""
        show_text(self._hint, translate("ThinPart", "Choose a part in the list to see its walls."))
        show_text(self._others, "")
        show_text(self._said, "")
        self.table.model().set_rows([])
        self.table.hide()
        self._all.hide()

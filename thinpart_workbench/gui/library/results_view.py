# SPDX-License-Identifier: LGPL-2.1-or-later
"""The view of the found parts and the actions on a part."""

from ...storage.part_table import STORED_PARTS
from ..application.qt import QtCore, QtWidgets, Signal, translate
from .part_files_view import PartFilesView

_LIKE = ("score", "reasons")
"""Columns of a search for parts that are alike."""


class FoundPartsView(PartFilesView):
    """Shows `FoundRows`.

    Signals
    -------
    current_changed(object)
        The selected part, or None.
    notes_requested, similar_requested(object)
        The corresponding entry of the context menu was chosen for a part.
    """

    current_changed = Signal(object)
    notes_requested = Signal(object)
    similar_requested = Signal(object)

    def __init__(self, table, parent=None):
        self._fitted = self._is_updating = False
        super().__init__("ThinPart_FoundTable", table, parent)
        self.csv_form, self.row_menu = STORED_PARTS, self._part_menu
        self.setSelectionMode(QtWidgets.QAbstractItemView.ExtendedSelection)
        self.setDragEnabled(True)
        self.setDragDropMode(QtWidgets.QAbstractItemView.DragOnly)
        self.show_sorted_by("file", False)
        self.selectionModel().currentRowChanged.connect(self._emit_current)
        table.dataChanged.connect(self._emit_when_fetched)
        self._reported = None
        self.show_columns(dict.fromkeys(_LIKE, False))

    def show_result(self, result, is_similarity):
        """Show a search result; the selected part stays selected if it was found."""
        self._is_updating = True
        scroll_position = self.verticalScrollBar().value()
        self._table.show_result(result["count"], result["rows"])
        if is_similarity == self.isColumnHidden(self._table.number_of("score")):
            self.show_columns(dict.fromkeys(_LIKE, is_similarity))
            self._fitted = False
        if result["current"] is not None:
            index = self._table.index(result["current"], self._table.number_of("label"))
            self.selectionModel().setCurrentIndex(
                index, QtCore.QItemSelectionModel.ClearAndSelect | QtCore.QItemSelectionModel.Rows)
        if result["same"]:
            self.verticalScrollBar().setValue(scroll_position)
        elif result["current"] is not None:
            self.scrollTo(index)
        else:
            self.scrollToTop()
        self._is_updating = False
        if not self._fitted and result["rows"]:
            self._fitted = True
            self.fit_columns()

    def show_sorted_by(self, key, descending):
        """Set the sort indicator of the header to a column without requesting a sort."""
        header = self.horizontalHeader()
        header.blockSignals(True)
        header.setSortIndicator(self._table.number_of(key), QtCore.Qt.DescendingOrder if descending
                                else QtCore.Qt.AscendingOrder)
        header.blockSignals(False)

    def _part_menu(self, part):
        menu = QtWidgets.QMenu(self)
        menu.setObjectName("ThinPart_FoundMenu")
        for name, text, callback, works_for_failed in (
            *((*action, True) for action in self.file_actions()),
            ("Notes", translate("ThinPart", "Edit notes"), lambda: self.notes_requested.emit(part), False),
            ("Similar", translate("ThinPart", "Parts like this one"),
             lambda: self.similar_requested.emit(part), False),
        ):
            action = menu.addAction(text)
            action.setObjectName(f"ThinPart_Found{name}")
            action.setEnabled(part is not None and (works_for_failed or not part.error_kind))
            action.triggered.connect(lambda *_, callback=callback: callback())
        return menu

    def _emit_current(self, *_):
        part = self.current_part
        if self._is_updating and part is None:
            return  # the rows are being replaced: keep the reported part
        self._reported = part
        self.current_changed.emit(part)

    def _emit_when_fetched(self, *_):
        if self._reported is None and self.current_part is not None:
            self._emit_current()

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The view of the found parts and the actions on a part."""

import os

from ...storage.part_table import STORED_PARTS
from ..application.qt import QtCore, QtGui, QtWidgets, Signal, translate
from ..application.sentences import translated
from ..document.insert_part import insert_part
from ..document.open_part import DANGEROUS, confirm_dangerous_open, open_part, told_by
from ..tables.table_view import TableView

_LIKE = ("score", "reasons")
"""Columns of a search for parts that are alike."""


class FoundPartsView(TableView):
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
        self._table = table
        self._fitted = self._is_updating = False
        super().__init__("ThinPart_FoundTable", table, parent)
        self.csv_form, self.row_menu = STORED_PARTS, self._part_menu
        self.setSelectionMode(QtWidgets.QAbstractItemView.ExtendedSelection)
        self.setDragEnabled(True)
        self.setDragDropMode(QtWidgets.QAbstractItemView.DragOnly)
        self._fit_rows()
        self.show_sorted_by("file", False)
        self.doubleClicked.connect(lambda _: self.open_current())
        self.selectionModel().currentRowChanged.connect(self._emit_current)
        table.dataChanged.connect(self._emit_when_fetched)
        self._reported = None
        self.show_columns(dict.fromkeys(_LIKE, False))

    @property
    def current_part(self):
        """The part at the current index, or None."""
        index = self.currentIndex()
        return self._table.row_at(index.row()) if index.isValid() else None

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

    def open_current(self):
        """Open the part's document."""
        part = self.current_part
        if part is None:
            return
        if part.error_kind in DANGEROUS and not confirm_dangerous_open(translated(part.error_message), self):
            return
        self.message.emit(told_by(lambda: open_part(part.file, part.name)))

    def insert_current(self):
        """Insert the part into the active document."""
        part = self.current_part
        if part is not None:
            self.message.emit(told_by(lambda: insert_part(part.file, part.name)))

    def show_folder(self):
        """Show the part's folder in the desktop's file manager."""
        folder = os.path.dirname(self.current_part.file)
        if not os.path.isdir(folder):
            self.message.emit(translate("ThinPart", "The folder {} no longer exists.").format(folder))
        elif not QtGui.QDesktopServices.openUrl(QtCore.QUrl.fromLocalFile(folder)):
            self.message.emit(translate(
                "ThinPart", "No file manager was found: open the folder {} yourself.").format(folder))

    def copy_path(self):
        """Put the path of the part's document on the clipboard."""
        QtWidgets.QApplication.clipboard().setText(self.current_part.file)

    def _part_menu(self, part):
        menu = QtWidgets.QMenu(self)
        menu.setObjectName("ThinPart_FoundMenu")
        for name, text, callback, works_for_failed in (
            ("Open", translate("ThinPart", "Open"), self.open_current, True),
            ("Insert", translate("ThinPart", "Insert into active document"), self.insert_current, True),
            ("Folder", translate("ThinPart", "Show in file manager"), self.show_folder, True),
            ("CopyPath", translate("ThinPart", "Copy path"), self.copy_path, True),
            ("Notes", translate("ThinPart", "Edit notes"), lambda: self.notes_requested.emit(part), False),
            ("Similar", translate("ThinPart", "Parts like this one"),
             lambda: self.similar_requested.emit(part), False),
        ):
            action = menu.addAction(text)
            action.setObjectName(f"ThinPart_Found{name}")
            action.setEnabled(part is not None and (works_for_failed or not part.error_kind))
            action.triggered.connect(lambda *_, callback=callback: callback())
        return menu

    def keyPressEvent(self, event):
        """Open the part on Enter."""
        if event.key() in (QtCore.Qt.Key_Return, QtCore.Qt.Key_Enter):
            self.open_current()
            return
        super().keyPressEvent(event)

    def changeEvent(self, event):
        """Adapt the row height to the font."""
        super().changeEvent(event)
        if event.type() in (QtCore.QEvent.FontChange, QtCore.QEvent.StyleChange):
            self._fit_rows()

    def _fit_rows(self):
        self.set_row_height(2.6)
        height = self.verticalHeader().defaultSectionSize()
        size = QtCore.QSize(round((height - 4) * 4 / 3), height - 4)
        self.setIconSize(size)
        self._table.picture_size, self._table.screen_ratio = size, self.devicePixelRatioF()

    def _emit_current(self, *_):
        part = self.current_part
        if self._is_updating and part is None:
            return  # the rows are being replaced: keep the reported part
        self._reported = part
        self.current_changed.emit(part)

    def _emit_when_fetched(self, *_):
        if self._reported is None and self.current_part is not None:
            self._emit_current()

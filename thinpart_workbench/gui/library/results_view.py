"""The view of the found parts and the actions on a part."""

import os

from ...core.errors import ThinPartError
from ..application.qt import QtCore, QtGui, QtWidgets, Signal, translate
from ..application.sentences import translated
from ..document.insert_part import insert_part
from ..document.open_part import DANGEROUS, confirm_dangerous_open, open_part
from ..widgets.row_table import PathDelegate, show_whole_rows
from .results_model import FILE, PART, REASONS, SCORE

_MAX_WIDTH = 34
"""Maximum width of an automatically sized column, in characters."""


class FoundPartsView(QtWidgets.QTableView):
    """Shows a `FoundPartsModel`.

    Signals
    -------
    current_changed(object)
        The selected part, or None.
    message(str)
        Outcome of an action, or the reason of its failure.
    notes_requested, similar_requested(object)
        The corresponding entry of the context menu was chosen for a part.
    """

    current_changed = Signal(object)
    message = Signal(str)
    notes_requested = Signal(object)
    similar_requested = Signal(object)

    def __init__(self, table, parent=None):
        super().__init__(parent)
        self._table = table
        self._fitted = self._is_updating = False
        self.setObjectName("ThinPart_FoundTable")
        self.setModel(table)
        show_whole_rows(self)
        self.setSelectionMode(QtWidgets.QAbstractItemView.ExtendedSelection)
        self.setDragEnabled(True)
        self.setDragDropMode(QtWidgets.QAbstractItemView.DragOnly)
        self.setItemDelegateForColumn(FILE, PathDelegate(self))
        self._set_row_height()
        header = self.horizontalHeader()
        header.setHighlightSections(False)
        header.setSortIndicator(FILE, QtCore.Qt.AscendingOrder)
        self.setSortingEnabled(True)
        self.doubleClicked.connect(lambda _: self.open_current())
        self.selectionModel().currentRowChanged.connect(self._emit_current)
        table.dataChanged.connect(self._emit_when_fetched)
        self._reported = None
        self._show_similar_columns(False)

    @property
    def current_part(self):
        """The part at the current index, or None."""
        index = self.currentIndex()
        return self._table.part_at(index.row()) if index.isValid() else None

    def show_result(self, result, is_similarity):
        """Show a search result; the selected part stays selected if it was found."""
        self._is_updating = True
        scroll_position = self.verticalScrollBar().value()
        self._table.show_result(result["count"], result["rows"])
        self._show_similar_columns(is_similarity)
        if result["current"] is not None:
            index = self._table.index(result["current"], PART)
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
            self._fit_columns()

    def show_sorted_by(self, column, descending):
        """Set the sort indicator of the header without requesting a sort."""
        header = self.horizontalHeader()
        header.blockSignals(True)
        header.setSortIndicator(column, QtCore.Qt.DescendingOrder if descending
                                else QtCore.Qt.AscendingOrder)
        header.blockSignals(False)

    def open_current(self):
        """Open the part's document."""
        part = self.current_part
        if part is None:
            return
        if part.error_kind in DANGEROUS and not confirm_dangerous_open(translated(part.error_message), self):
            return
        self._run(lambda: open_part(part.file, part.name) or "")

    def insert_current(self):
        """Insert the part into the active document."""
        part = self.current_part
        if part is not None:
            self._run(lambda: insert_part(part.file, part.name))

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

    def menu(self):
        """QMenu with the actions on the current part."""
        part = self.current_part
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

    def contextMenuEvent(self, event):
        """Show the menu of the current part."""
        menu = self.menu()
        menu.popup(event.globalPos())
        menu.aboutToHide.connect(menu.deleteLater)

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
            self._set_row_height()

    def _set_row_height(self):
        # Fixed row height: with individual heights, Qt would have to measure 100,000 rows.
        height = round(2.6 * self.fontMetrics().height())
        rows = self.verticalHeader()
        rows.setSectionResizeMode(QtWidgets.QHeaderView.Fixed)
        rows.setDefaultSectionSize(height)
        rows.hide()
        size = QtCore.QSize(round((height - 4) * 4 / 3), height - 4)
        self.setIconSize(size)
        self._table.picture_size, self._table.screen_ratio = size, self.devicePixelRatioF()

    def _show_similar_columns(self, shown):
        for column in (SCORE, REASONS):
            self.setColumnHidden(column, not shown)
        header = self.horizontalHeader()
        if shown and header.sectionSize(SCORE) < header.sectionSizeHint(SCORE):
            header.resizeSection(SCORE, header.sectionSizeHint(SCORE))

    def _fit_columns(self):
        self.resizeColumnsToContents()
        header = self.horizontalHeader()
        widest = _MAX_WIDTH * self.fontMetrics().averageCharWidth()
        for column in range(self._table.columnCount()):
            if not self.isColumnHidden(column):
                wide = widest + (self.iconSize().width() if column == PART else 0)
                header.resizeSection(column, min(header.sectionSize(column), wide))
        for column in (SCORE, REASONS):
            if self.isColumnHidden(column):
                header.resizeSection(column, self.fontMetrics().averageCharWidth() * (
                    8 if column == SCORE else 45))

    def _emit_current(self, *_):
        part = self.current_part
        if self._is_updating and part is None:
            return  # the rows are being replaced: keep the reported part
        self._reported = part
        self.current_changed.emit(part)

    def _emit_when_fetched(self, *_):
        if self._reported is None and self.current_part is not None:
            self._emit_current()

    def _run(self, action):
        QtWidgets.QApplication.setOverrideCursor(QtCore.Qt.WaitCursor)
        try:
            sentence = action()
        except ThinPartError as error:
            sentence = translated(error)
        finally:
            QtWidgets.QApplication.restoreOverrideCursor()
        self.message.emit(sentence)

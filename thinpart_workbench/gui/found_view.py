"""The list of parts that were found, and what can be done with a part."""

import os

from ..core.errors import ThinPartError
from .found_table import FILE, PART, REASONS, SCORE
from .insert_part import insert_part
from .open_part import DANGEROUS, ask_to_dare, open_part
from .path_delegate import PathDelegate
from .qt import QtCore, QtGui, QtWidgets, Signal, translate
from .sentences import translated

_WIDEST = 34
"""Letters to which a column is widened by itself; a user may widen it further."""


class FoundView(QtWidgets.QTableView):
    """Shows a `FoundTable`.

    Signals
    -------
    current_changed(object)
        The part that is selected, or None.
    told(str)
        A sentence on what was done or why it could not be.
    notes_asked, similar_asked(object)
        What the context menu has been asked for, with the part.
    """

    current_changed = Signal(object)
    told = Signal(str)
    notes_asked = Signal(object)
    similar_asked = Signal(object)

    def __init__(self, table, parent=None):
        super().__init__(parent)
        self._table = table
        self._fitted = self._settling = False
        self.setObjectName("ThinPart_FoundTable")
        self.setModel(table)
        self.setSelectionBehavior(QtWidgets.QAbstractItemView.SelectRows)
        self.setSelectionMode(QtWidgets.QAbstractItemView.ExtendedSelection)
        self.setDragEnabled(True)
        self.setDragDropMode(QtWidgets.QAbstractItemView.DragOnly)
        self.setHorizontalScrollMode(QtWidgets.QAbstractItemView.ScrollPerPixel)
        self.setTabKeyNavigation(False)
        self.setAlternatingRowColors(True)
        self.setShowGrid(False)
        self.setWordWrap(False)
        self.setItemDelegateForColumn(FILE, PathDelegate(self))
        self._set_row_height()
        header = self.horizontalHeader()
        header.setHighlightSections(False)
        header.setSortIndicator(FILE, QtCore.Qt.AscendingOrder)
        self.setSortingEnabled(True)
        self.doubleClicked.connect(lambda _: self.open_current())
        self.selectionModel().currentRowChanged.connect(self._tell_current)
        table.dataChanged.connect(self._tell_when_there)
        self._told = None
        self._show_similar_columns(False)

    @property
    def current_part(self):
        """The part that the cursor stands on, or None."""
        index = self.currentIndex()
        return self._table.part_at(index.row()) if index.isValid() else None

    def show_found(self, found, is_like):
        """Show what was found, with the part that was selected still selected if it is there."""
        self._settling = True
        place = self.verticalScrollBar().value()
        self._table.show_found(found["count"], found["rows"])
        self._show_similar_columns(is_like)
        if found["current"] is not None:
            index = self._table.index(found["current"], PART)
            self.selectionModel().setCurrentIndex(
                index, QtCore.QItemSelectionModel.ClearAndSelect | QtCore.QItemSelectionModel.Rows)
        if found["same"]:
            self.verticalScrollBar().setValue(place)
        elif found["current"] is not None:
            self.scrollTo(index)
        else:
            self.scrollToTop()
        self._settling = False
        if not self._fitted and found["rows"]:
            self._fitted = True
            self._fit_columns()

    def show_sorted_by(self, column, descending):
        """Have the header say what the rows are sorted by, without asking for it."""
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
        if part.error_kind in DANGEROUS and not ask_to_dare(translated(part.error_message), self):
            return
        self._do(lambda: open_part(part.file, part.name) or "")

    def insert_current(self):
        """Insert the part into the active document."""
        part = self.current_part
        if part is not None:
            self._do(lambda: insert_part(part.file, part.name))

    def show_folder(self):
        """Show the part's folder in the desktop's file manager."""
        folder = os.path.dirname(self.current_part.file)
        if not os.path.isdir(folder):
            self.told.emit(translate("ThinPart", "There is no folder {} any more.").format(folder))
        elif not QtGui.QDesktopServices.openUrl(QtCore.QUrl.fromLocalFile(folder)):
            self.told.emit(translate("ThinPart", "No program shows folders here; it is {}.").format(folder))

    def copy_path(self):
        """Put the path of the part's document on the clipboard."""
        QtWidgets.QApplication.clipboard().setText(self.current_part.file)

    def menu(self):
        """QMenu of what can be done with the part."""
        part = self.current_part
        menu = QtWidgets.QMenu(self)
        menu.setObjectName("ThinPart_FoundMenu")
        for name, text, act, possible in (
            ("Open", translate("ThinPart", "Open"), self.open_current, True),
            ("Insert", translate("ThinPart", "Insert into active document"), self.insert_current, True),
            ("Folder", translate("ThinPart", "Show in file manager"), self.show_folder, True),
            ("CopyPath", translate("ThinPart", "Copy path"), self.copy_path, True),
            ("Notes", translate("ThinPart", "Edit notes"), lambda: self.notes_asked.emit(part), False),
            ("Similar", translate("ThinPart", "Parts like this one"),
             lambda: self.similar_asked.emit(part), False),
        ):
            action = menu.addAction(text)
            action.setObjectName(f"ThinPart_Found{name}")
            action.setEnabled(part is not None and (possible or not part.error_kind))
            action.triggered.connect(lambda *_, act=act: act())
        return menu

    def contextMenuEvent(self, event):
        """Show the menu of the part under the pointer."""
        menu = self.menu()
        menu.popup(event.globalPos())
        menu.aboutToHide.connect(menu.deleteLater)

    def keyPressEvent(self, event):
        """Enter opens."""
        if event.key() in (QtCore.Qt.Key_Return, QtCore.Qt.Key_Enter):
            self.open_current()
            return
        super().keyPressEvent(event)

    def changeEvent(self, event):
        """Rows are as high as the letters want."""
        super().changeEvent(event)
        if event.type() in (QtCore.QEvent.FontChange, QtCore.QEvent.StyleChange):
            self._set_row_height()

    def _set_row_height(self):
        # One height for all rows: with heights of their own, 100,000 rows would have to be measured.
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
        widest = _WIDEST * self.fontMetrics().averageCharWidth()
        for column in range(self._table.columnCount()):
            if not self.isColumnHidden(column):
                wide = widest + (self.iconSize().width() if column == PART else 0)
                header.resizeSection(column, min(header.sectionSize(column), wide))
        for column in (SCORE, REASONS):
            if self.isColumnHidden(column):
                header.resizeSection(column, self.fontMetrics().averageCharWidth() * (
                    8 if column == SCORE else 45))

    def _tell_current(self, *_):
        part = self.current_part
        if self._settling and part is None:
            return  # rows are being changed: what is told of the part stays
        self._told = part
        self.current_changed.emit(part)

    def _tell_when_there(self, *_):
        if self._told is None and self.current_part is not None:
            self._tell_current()

    def _do(self, act):
        QtWidgets.QApplication.setOverrideCursor(QtCore.Qt.WaitCursor)
        try:
            sentence = act()
        except ThinPartError as error:
            sentence = translated(error)
        finally:
            QtWidgets.QApplication.restoreOverrideCursor()
        self.told.emit(sentence)

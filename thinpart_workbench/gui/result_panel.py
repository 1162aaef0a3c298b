"""The results of a folder: filter, table, and what can be done with a row or with all of them."""

import os

from ..core.errors import ThinPartError
from .length_unit import length_unit
from .open_part import DANGEROUS, ask_to_dare, open_part
from .path_delegate import PathDelegate
from .path_question import ask_about_path
from .qt import QtCore, QtGui, QtWidgets, Signal, execute, translate
from .result_filter import ResultFilter
from .result_table import CATEGORY, FILE, PART, ResultTable
from .sentences import translated
from .table_export import TableExport
from .unit_watch import UNITS

_WIDEST, _NARROWEST = 50, {CATEGORY: 35, FILE: 26, PART: 26}
"""Letters to which columns of texts are sized by themselves; a user may go beyond."""


class ResultPanel(QtWidgets.QWidget):
    """Shows what was found in a folder.

    Signals
    -------
    told, failed : str
        A sentence on what a button did, or why it could not; empty takes the last one away.
    """

    told = Signal(str)
    failed = Signal(str)

    def __init__(self, profile, parent=None):
        super().__init__(parent)
        self._settings = None
        self._export = None
        self._is_fitting = self._user_has_fitted = False
        self._fit_at = 1
        self.table = ResultTable(self)
        self.table.clear(profile)
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        self._filter = ResultFilter(self.table, profile, self)
        column.addWidget(self._filter)
        self.view = self._new_view()
        column.addWidget(self.view, 1)
        self.open_button = self._button(
            "ThinPart_FolderOpen", translate("ThinPart", "&Open part"), self.open_current)
        self.info_button = self._button(
            "ThinPart_FolderShowInfo", translate("ThinPart", "Show info file\u2019s folder"),
            self.show_info_folder)
        self.export_button = self._button(
            "ThinPart_FolderExport", translate("ThinPart", "&Export CSV\u2026"), self.export)
        self.view.selectionModel().selectionChanged.connect(lambda *_: self._show_buttons())
        for signal in (self.table.modelReset, self.table.rowsInserted, self.table.layoutChanged):
            signal.connect(lambda *_: self._show_buttons())
        UNITS.changed.connect(self._show_unit)
        self._show_buttons()

    def begin(self, settings, profile):
        """Start anew.

        Parameters
        ----------
        settings : FolderSettings
            Of the run whose results follow.
        profile : Profile
        """
        self._settings = settings
        self._fit_at = 1
        self.table.clear(profile)
        self._filter.show_categories(profile)

    def add(self, rows):
        """Show more rows."""
        self.table.add(rows)
        if self.table.rowCount() >= self._fit_at:
            self._fit_at = 4 * self.table.rowCount()
            self.fit_columns()

    def showEvent(self, event):
        """Give the columns the room that there is."""
        super().showEvent(event)
        self._show_unit()

    def _show_unit(self):
        self.table.show_unit(length_unit())
        self.fit_columns()

    def fit_columns(self):
        """Make columns as wide as what is seen in them, unless the user has said how wide."""
        if self._user_has_fitted:
            return
        self._is_fitting = True
        self.view.resizeColumnsToContents()
        header, letter = self.view.horizontalHeader(), self.view.fontMetrics().averageCharWidth()
        for column in range(self.table.columnCount()):
            header.resizeSection(column, min(header.sectionSize(column), _WIDEST * letter))
        # A long failure, the longest first, must not push the numbers out of sight.
        for column, letters in _NARROWEST.items():
            room = self.view.viewport().width() - header.length()
            size = header.sectionSize(column)
            if room < 0 and size > letters * letter:
                header.resizeSection(column, max(size + room, letters * letter))
        room = self.view.viewport().width() - header.length()
        if room > 0:
            header.resizeSection(FILE, header.sectionSize(FILE) + room)
        self._is_fitting = False

    def open_current(self):
        """Open the selected part's file in FreeCAD."""
        row = self._current_row()
        if row is None or (row.error_kind in DANGEROUS and not ask_to_dare(translated(row.error), self)):
            return
        QtWidgets.QApplication.setOverrideCursor(QtCore.Qt.WaitCursor)
        try:
            open_part(self._path(row), row.part)
        except ThinPartError as error:
            self.failed.emit(translated(error))
        else:
            self.told.emit("")
        finally:
            QtWidgets.QApplication.restoreOverrideCursor()

    def show_info_folder(self):
        """Show the folder of the selected part's info file in the desktop's file manager."""
        row = self._current_row()
        if row is None:
            return
        path = self._settings.info_file(self._path(row))
        ask_about_path(path.is_file, lambda there: self._show_place(row, path, there), self)

    def _show_place(self, row, path, there):
        if not there:
            self.failed.emit(translate("ThinPart", "{} has no info file.").format(row.file))
        elif QtGui.QDesktopServices.openUrl(QtCore.QUrl.fromLocalFile(os.fspath(path.parent))):
            self.told.emit("")
        else:
            self.told.emit(translate(
                "ThinPart", "No program shows folders here; the info file is {}.").format(path))

    def export(self):
        """Ask for a file and write what is shown to it."""
        dialog = QtWidgets.QFileDialog(
            self, translate("ThinPart", "Export the rows that are shown"), self._settings.folder,
            translate("ThinPart", "Tables (*.csv)"))
        dialog.setObjectName("ThinPart_FolderExportDialog")
        dialog.setAcceptMode(QtWidgets.QFileDialog.AcceptSave)
        dialog.setDefaultSuffix("csv")
        dialog.selectFile(os.path.basename(self._settings.folder) + ".csv")
        chosen = dialog.selectedFiles() if execute(dialog) else []
        dialog.deleteLater()
        if not chosen:
            return
        if not chosen[0].lower().endswith(".csv"):
            self.failed.emit(translate(
                "ThinPart", "Nothing was written to {}: give the table a name that ends with .csv."
            ).format(chosen[0]))
            return
        self._export = TableExport(chosen[0], self.table.shown_rows, self)
        self._export.finished.connect(self._exported)
        self._export.start()
        self._show_buttons()

    def _exported(self):
        export, self._export = self._export, None
        if export.error:
            self.failed.emit(export.error)
        else:
            self.told.emit(translate(
                "ThinPart", "The {} rows that are shown were written to {}."
            ).format(len(export.rows), export.path))
        export.deleteLater()
        self._show_buttons()

    def _new_view(self):
        view = QtWidgets.QTableView(self)
        view.setObjectName("ThinPart_FolderTable")
        view.setModel(self.table)
        view.setSelectionBehavior(QtWidgets.QAbstractItemView.SelectRows)
        view.setSelectionMode(QtWidgets.QAbstractItemView.SingleSelection)
        view.setHorizontalScrollMode(QtWidgets.QAbstractItemView.ScrollPerPixel)
        view.setTabKeyNavigation(False)
        view.setAlternatingRowColors(True)
        view.setShowGrid(False)
        view.setWordWrap(False)
        view.setItemDelegateForColumn(FILE, PathDelegate(view))
        # One height for all rows: with heights of their own, 100,000 rows would have to be measured.
        rows = view.verticalHeader()
        rows.setSectionResizeMode(QtWidgets.QHeaderView.Fixed)
        rows.setDefaultSectionSize(round(1.5 * view.fontMetrics().height()))
        rows.hide()
        view.setMinimumHeight(6 * rows.defaultSectionSize())
        header = view.horizontalHeader()
        header.setHighlightSections(False)
        header.setSortIndicator(-1, QtCore.Qt.AscendingOrder)
        view.setSortingEnabled(True)
        header.sectionResized.connect(lambda *_: self._note_width())
        view.doubleClicked.connect(lambda _: self.open_current())
        return view

    def _note_width(self):
        self._user_has_fitted = self._user_has_fitted or not self._is_fitting

    def _button(self, name, text, act):
        button = QtWidgets.QPushButton(text, self)
        button.setObjectName(name)
        button.clicked.connect(lambda *_: act())
        return button

    def _show_buttons(self):
        selected = self.view.selectionModel().hasSelection()
        self.open_button.setEnabled(selected)
        self.info_button.setEnabled(selected)
        self.export_button.setEnabled(self.table.rowCount() > 0 and self._export is None)

    def _current_row(self):
        rows = self.view.selectionModel().selectedRows()
        return self.table.row_at(rows[0]) if rows else None

    def _path(self, row):
        return os.path.join(self._settings.folder, row.file)

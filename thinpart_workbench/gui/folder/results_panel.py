"""The results of a folder: filter, table, and the actions on one or all rows."""

import os

from ...core.errors import ThinPartError
from ...core.kinds.file_marks import TABLE
from ..application import lifelong
from ..application.length_unit import length_unit
from ..application.qt import QtCore, QtGui, QtWidgets, Signal, execute, translate
from ..application.sentences import translated
from ..application.thread_work import check_path_in_thread
from ..document.open_part import DANGEROUS, confirm_dangerous_open, open_part
from ..processes.request_queue import LABEL
from ..record.label_button import LabelButton
from ..widgets.confirmation import may_overwrite
from ..widgets.row_table import PathDelegate, show_whole_rows
from .csv_export import CsvExport, not_written
from .results_filter import ResultsFilter
from .results_model import CATEGORY, CRITERIA, FILE, PART, ResultsModel

_MAX_WIDTH, _MIN_CRITERIA, _MIN_WIDTHS = 50, 14, {CATEGORY: 35, FILE: 26, PART: 26}
"""Maximum and minimum width of automatically sized text columns, in characters. Names of criteria give way first, since
a tool tip shows them whole."""


class ResultsPanel(QtWidgets.QWidget):
    """Shows the results of a folder.

    Signals
    -------
    message, failed : str
        Outcome of an action, or the reason of its failure; empty clears the last one.
    """

    message = Signal(str)
    failed = Signal(str)

    def __init__(self, profile, parent=None):
        super().__init__(parent)
        self._settings, self._profile = None, profile
        self._labelled_files = {}  # by path of the info file
        self._export = None
        self._is_fitting = self._user_has_resized = False
        self._fit_at = 1
        self.table = ResultsModel(self)
        self.table.clear(profile)
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        self._filter = ResultsFilter(self.table, profile, self)
        column.addWidget(self._filter)
        self.view = self._new_view()
        column.addWidget(self.view, 1)
        self.open_button = self._button(
            "ThinPart_FolderOpen", translate("ThinPart", "&Open part"), self.open_current)
        self.label_button = LabelButton(self)
        self.label_button.setObjectName("ThinPart_FolderLabel")
        self.label_button.label_chosen.connect(self.label_current)
        self.info_button = self._button(
            "ThinPart_FolderShowInfo", translate("ThinPart", "Show info file\u2019s folder"),
            self.show_info_folder)
        self.export_button = self._button(
            "ThinPart_FolderExport", translate("ThinPart", "&Export CSV\u2026"), self.export)
        self.view.selectionModel().selectionChanged.connect(lambda *_: self._show_buttons())
        for signal in (self.table.modelReset, self.table.rowsInserted, self.table.layoutChanged):
            signal.connect(lambda *_: self._show_buttons())
        lifelong.units.changed.connect(self._show_unit)
        lifelong.requests.answered.connect(self._show_kept_label)
        self._show_buttons()

    def begin(self, settings, profile):
        """Remove the results and prepare for a new run.

        Parameters
        ----------
        settings : FolderSettings
            Settings of the run.
        profile : Profile
        """
        self._settings, self._profile = settings, profile
        self._fit_at = 1
        self.table.clear(profile, settings.limits())
        self._filter.show_categories(profile)

    def add(self, rows):
        """Add rows to the table."""
        self.table.add(rows)
        if self.table.rowCount() >= self._fit_at:
            self._fit_at = 4 * self.table.rowCount()
            self.fit_columns()

    def showEvent(self, event):
        """Update the unit and fit the columns to the available width."""
        super().showEvent(event)
        self._show_unit()

    def _show_unit(self):
        self.table.show_unit(length_unit())
        self.fit_columns()

    def fit_columns(self):
        """Fit the columns to their visible content, unless the user has resized one."""
        if self._user_has_resized:
            return
        self._is_fitting = True
        self.view.resizeColumnsToContents()
        header, letter = self.view.horizontalHeader(), self.view.fontMetrics().averageCharWidth()
        for column in range(self.table.columnCount()):
            header.resizeSection(column, min(header.sectionSize(column), _MAX_WIDTH * letter))
        # Shrink the text columns, so that a long failure message does not push the numbers out of view.
        criteria = CRITERIA + len(self.table.limits)
        for column, letters in ((criteria, _MIN_CRITERIA), *_MIN_WIDTHS.items()):
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
        if row is None or (row.error_kind in DANGEROUS and not confirm_dangerous_open(translated(row.error), self)):
            return
        QtWidgets.QApplication.setOverrideCursor(QtCore.Qt.WaitCursor)
        try:
            open_part(self._path(row), row.part)
        except ThinPartError as error:
            self.failed.emit(translated(error))
        else:
            self.message.emit("")
        finally:
            QtWidgets.QApplication.restoreOverrideCursor()

    def label_current(self, category, is_sure):
        """Keep what the user says of the selected part."""
        row = self._current_row()
        if row is not None:
            path = os.fspath(self._settings.info_file(self._path(row)))
            self._labelled_files[path] = row.file
            lifelong.requests.keep(LABEL, path=path, part=row.part, category=category, is_sure=is_sure)

    def _show_kept_label(self, request):
        file = self._labelled_files.get(request.arguments["path"]) if request.function == LABEL else None
        if file is None:
            return  # not a label, or one of another panel
        self.failed.emit(request.sentence)
        if not request.sentence:
            self.table.relabel(file, request.arguments["part"], request.answer)
            self._show_buttons()

    def show_info_folder(self):
        """Show the folder of the selected part's info file in the desktop's file manager."""
        row = self._current_row()
        if row is None:
            return
        path = self._settings.info_file(self._path(row))
        check_path_in_thread(path.is_file, lambda exists: self._open_info_folder(row, path, exists), self)

    def _open_info_folder(self, row, path, exists):
        if not exists:
            self.failed.emit(translate("ThinPart", "{} has no info file.").format(row.file))
        elif QtGui.QDesktopServices.openUrl(QtCore.QUrl.fromLocalFile(os.fspath(path.parent))):
            self.message.emit("")
        else:
            self.message.emit(translate(
                "ThinPart", "No file manager was found: open the info file {} yourself.").format(path))

    def export(self):
        """Ask for a file and write the visible rows to it."""
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
                "ThinPart", "The table was not written to {}: choose a file name that ends with .csv."
            ).format(chosen[0]))
            return
        try:
            overwrite = may_overwrite(self, chosen[0], TABLE)
        except ThinPartError as error:
            self.failed.emit(translated(error))
            return
        except OSError as error:
            self.failed.emit(not_written(chosen[0], error))
            return
        if overwrite is None:
            return
        self._export = CsvExport(chosen[0], self.table.shown_rows, [limits.name for limits in self.table.limits], overwrite,
                                 self)
        self._export.finished.connect(self._on_exported)
        self._export.start()
        self._show_buttons()

    def _on_exported(self):
        export, self._export = self._export, None
        if export.error:
            self.failed.emit(export.error)
        else:
            self.message.emit(translate(
                "ThinPart", "The {} rows that are shown were written to {}."
            ).format(len(export.rows), export.path))
        export.deleteLater()
        self._show_buttons()

    def _new_view(self):
        view = QtWidgets.QTableView(self)
        view.setObjectName("ThinPart_FolderTable")
        view.setModel(self.table)
        show_whole_rows(view)
        view.setItemDelegateForColumn(FILE, PathDelegate(view))
        # Fixed row height: with individual heights, Qt would have to measure 100,000 rows.
        rows = view.verticalHeader()
        rows.setSectionResizeMode(QtWidgets.QHeaderView.Fixed)
        rows.setDefaultSectionSize(round(1.5 * view.fontMetrics().height()))
        rows.hide()
        view.setMinimumHeight(6 * rows.defaultSectionSize())
        header = view.horizontalHeader()
        header.setHighlightSections(False)
        header.setSortIndicator(-1, QtCore.Qt.AscendingOrder)
        view.setSortingEnabled(True)
        header.sectionResized.connect(lambda *_: self._on_section_resized())
        view.doubleClicked.connect(lambda _: self.open_current())
        return view

    def _on_section_resized(self):
        self._user_has_resized = self._user_has_resized or not self._is_fitting

    def _button(self, name, text, callback):
        button = QtWidgets.QPushButton(text, self)
        button.setObjectName(name)
        button.clicked.connect(lambda *_: callback())
        return button

    def _show_buttons(self):
        selected = self.view.selectionModel().hasSelection()
        row = self._current_row()
        self.label_button.setEnabled(row is not None and not row.error_kind)
        self.label_button.show_labels(getattr(row, "said", ()), self._profile)
        self.open_button.setEnabled(selected)
        self.info_button.setEnabled(selected)
        self.export_button.setEnabled(self.table.rowCount() > 0 and self._export is None)

    def _current_row(self):
        rows = self.view.selectionModel().selectedRows()
        return self.table.row_at(rows[0]) if rows else None

    def _path(self, row):
        return os.path.join(self._settings.folder, row.file)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The results of a folder: filter, table, and the actions on one or all rows."""

import os

from ...core.errors import ThinPartError
from ...storage.part_table import part_table
from ..application import lifelong
from ..application.length_unit import length_unit
from ..application.qt import QtCore, QtGui, QtWidgets, Signal, translate
from ..application.sentences import translated
from ..application.thread_work import check_path_in_thread
from ..document.open_part import DANGEROUS, confirm_dangerous_open, open_part
from ..processes.request_queue import LABEL
from ..record.label_button import LabelButton, common_label
from ..record.thumbnails import PicturesView, Thumbnails
from ..widgets.buttons import push_button
from .result_columns import Results
from .results_filter import ResultsFilter


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
        self._fit_at = 1
        self._pictures = Thumbnails(self)
        self.table = Results(profile, self._pictures, self)
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        self._filter = ResultsFilter(self.table, profile, self)
        column.addWidget(self._filter)
        self.view = PicturesView("ThinPart_FolderTable", self.table, self)
        self.view.csv_dialog = "ThinPart_FolderExportDialog"
        self.view.setSelectionMode(QtWidgets.QAbstractItemView.ExtendedSelection)
        self.view.setMinimumHeight(4 * self.view.verticalHeader().defaultSectionSize())
        self.view.message.connect(self.message)
        self.view.failed.connect(self.failed)
        self.view.doubleClicked.connect(lambda _: self.open_current())
        column.addWidget(self.view, 1)
        self.open_button = push_button(self, "ThinPart_FolderOpen", translate("ThinPart", "&Open part"), self.open_current)
        self.label_button = LabelButton(self)
        self.label_button.setObjectName("ThinPart_FolderLabel")
        self.label_button.label_chosen.connect(self.label_selected)
        self.info_button = push_button(
            self, "ThinPart_FolderShowInfo", translate("ThinPart", "Show info file\u2019s folder"),
            self.show_info_folder)
        self.export_button = push_button(
            self, "ThinPart_FolderExport", translate("ThinPart", "&Export CSV\u2026"), self.view.save_csv)
        self.view.selectionModel().selectionChanged.connect(lambda *_: self._show_buttons())
        for signal in (self.table.modelReset, self.table.rowsInserted, self.table.layoutChanged, self.view.saving_changed):
            signal.connect(lambda *_: self._show_buttons())
        lifelong.units.changed.connect(self._show_unit)
        lifelong.requests.answered.connect(self._show_kept_label)
        self._show_buttons()

    def begin(self, settings, profile):
        """Remove the results and prepare for a new run with FolderSettings and a Profile."""
        self._settings, self._profile, limits = settings, profile, settings.limits()
        self._fit_at = 1
        self._pictures.clear()  # those that were missing may be drawn by now
        self.table.begin(profile, limits)
        self.view.csv_form = part_table(each.name for each in limits)
        self.view.csv_file = os.path.join(settings.folder, os.path.basename(settings.folder))
        self._filter.begin(profile)

    @property
    def failed_files(self):
        """set of str: files with a failure."""
        return {row.file for row in self.table.all_rows if row.error_kind}

    def add(self, rows):
        """Add rows to the table."""
        self.table.add(rows)
        self._filter.count(rows)
        if self.table.rowCount() >= self._fit_at:
            self._fit_at = 4 * self.table.rowCount()
            self.view.fit_columns()

    def remove_files(self, files):
        """Remove all rows of some files."""
        self.table.set_rows([row for row in self.table.all_rows if row.file not in files])
        self._filter.count_again()

    def showEvent(self, event):
        """Update the unit and fit the columns to the available width."""
        super().showEvent(event)
        self._show_unit()

    def _show_unit(self):
        self.table.show_unit(length_unit())
        self.view.fit_columns()

    def open_current(self):
        """Open the selected part's file in FreeCAD."""
        row = self.view.current_row
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

    def label_selected(self, category, is_sure):
        """Keep what the user says of the selected parts."""
        for row in self._labelled_rows():
            path = os.fspath(self._settings.info_file(self._path(row)))
            self._labelled_files[path] = row.file
            lifelong.requests.keep(LABEL, path=path, part=row.part, category=category, is_sure=is_sure)

    def _show_kept_label(self, request):
        file = self._labelled_files.get(request.arguments["path"]) if request.function == LABEL else None
        if file is None:
            return  # not a label, or one of another panel
        self.failed.emit(request.sentence)
        if not request.sentence:
            for number, row in enumerate(self.table.all_rows):
                if (row.file, row.part) == (file, request.arguments["part"]) and not row.error_kind:
                    self.table.replace(number, row.relabelled(request.answer))
            self._show_buttons()

    def show_info_folder(self):
        """Show the folder of the selected part's info file in the desktop's file manager."""
        row = self.view.current_row
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

    def _show_buttons(self):
        selected = self.view.selectionModel().hasSelection()
        rows = self._labelled_rows()
        self.label_button.setEnabled(bool(rows))
        self.label_button.show_labels(common_label([getattr(row, "said", ()) for row in rows]), self._profile, len(rows))
        self.open_button.setEnabled(selected)
        self.info_button.setEnabled(selected)
        self.export_button.setEnabled(self.view.can_save)

    def _labelled_rows(self):
        """The selected rows that are parts."""
        return [row for row in self.view.selected_rows if not row.error_kind]

    def _path(self, row):
        return os.path.join(self._settings.folder, row.file)

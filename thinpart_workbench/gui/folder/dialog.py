# SPDX-License-Identifier: LGPL-2.1-or-later
"""The dialog that classifies a folder."""

import os
from dataclasses import replace

import FreeCADGui as Gui

from ...core.errors import ThinPartError
from ...core.judging.criteria import load_profile
from ...freecad_adapter.preferences import preference_list
from ..application import lifelong
from ..application.icons import icon
from ..application.qt import QtCore, QtWidgets, execute, translate
from ..application.sentences import translated
from ..guide.command import help_button
from ..library.command import show_find_parts
from ..processes.command_line_run import DONE, STOPPED, CommandLineRun
from ..record.record_view import show_text, text_line
from ..widgets.buttons import add_button
from ..widgets.folder_field import contains
from .form import FolderForm
from .progress_bar import RunProgressBar
from .results_panel import ResultsPanel
from .settings import store_settings, stored_settings

IDLE, SEARCHING, RUNNING, PAUSING, PAUSED, STOPPING = range(6)


class FolderDialog(QtWidgets.QDialog):
    """Non-modal dialog with the settings at the top, progress in the middle and results below."""

    def __init__(self, parent):
        super().__init__(parent)
        self.setObjectName("ThinPart_FolderDialog")
        self.setWindowTitle(translate("ThinPart", "Classify folder"))
        self.setWindowIcon(icon("ThinPart_ClassifyFolder"))
        self.setWindowFlags(QtCore.Qt.Window)
        self._state = IDLE
        self._settings = None
        self._run = CommandLineRun(self)
        self._run.found.connect(self._on_rows_found)
        self._run.progressed.connect(self._show_progress)
        self._run.state_changed.connect(self._on_state_changed)
        self._run.ended.connect(self._show_end)
        column = QtWidgets.QVBoxLayout(self)
        self._form = FolderForm(self)
        self._stored = stored_settings()
        self._form.show_settings(self._stored)
        column.addWidget(self._form)
        self._add_run_row(column)
        self._results = ResultsPanel(load_profile(), self)
        self._results.message.connect(lambda text: show_text(self._message, text))
        self._results.failed.connect(self._show_problem)
        column.addWidget(self._results, 1)
        self._message = text_line(self, column, "ThinPart_FolderMessage")
        self._add_last_row(column)
        self._show_problem("")
        self._set_state(IDLE)
        self._fit_screen()

    @property
    def is_running(self):
        """Whether a folder is being classified."""
        return self._run.is_running

    def start(self):
        """Classify the chosen folder."""
        settings = self._form.settings()
        try:
            profile = settings.check()
        except ThinPartError as error:
            self._show_problem(translated(error))
            return
        store_settings(settings)
        self._stored = stored_settings()
        self._form.show_settings(settings)
        self._settings = settings
        self._results.begin(settings, profile)
        self._start_run(settings)

    def retry(self):
        """Classify the failed files again, with the currently chosen limits."""
        current = self._form.settings()
        settings = replace(self._settings, jobs=current.jobs, seconds=current.seconds, force=False)
        # A folder that could not be searched is also a failure, but not a file to retry.
        files = {file: os.path.join(settings.folder, file)
                 for file in sorted(self._results.failed_files)}
        files = {file: path for file, path in files.items() if not os.path.isdir(path)}
        if not files:
            self._show_problem(translate(
                "ThinPart", "The failures are folders that could not be searched: make them readable and start again."))
            return
        self._results.remove_files(set(files))
        self._start_run(settings, files.values())

    def pause_or_resume(self):
        """Pause or resume the run, as the button says."""
        if self._state == PAUSED or self._state == PAUSING:
            self._run.resume()
            self._set_state(RUNNING)
            return
        self._run.pause()
        self._set_state(PAUSING)
        self._progress.show_waiting(translate("ThinPart", "pausing"))

    def cancel(self):
        """Stop the run; finished files keep their results."""
        self._run.stop()
        self._set_state(STOPPING)
        self._progress.show_waiting(translate("ThinPart", "stopping"))

    def add_to_libraries(self):
        """Make the folder of the info files one of those that 'Find parts' searches, and open that in place of this."""
        show_find_parts().search_in(_info_folder(self._settings))
        self._show_offer()
        self.hide()  # it would be in front of the panel

    def end(self):
        """Stop at once and delete the dialog, without asking the user."""
        self._run.end_now()
        lifelong.running_jobs.end("folder")
        self.hide()
        self.deleteLater()

    def reject(self):
        """Close on Escape or the Close button; ask first if a run is in progress."""
        if self.is_running and self._state != STOPPING:
            answer = self._ask_how_to_leave()
            if answer is None:
                return
            if answer == "stop" and self.is_running:
                self.cancel()
        super().reject()

    def showEvent(self, event):
        """Apply preferences that have changed since the dialog was last shown."""
        super().showEvent(event)
        before, self._stored = self._stored, stored_settings()
        if before != self._stored and not self.is_running:
            self._form.apply_preferences(before, self._stored)

    def closeEvent(self, event):
        """Ask when the user closes the window, but not when FreeCAD closes all windows on exit."""
        if event.spontaneous() and self.is_running:
            event.ignore()
            self.reject()
            return
        event.accept()

    def keyPressEvent(self, event):
        """Enter starts the run; in the table it opens the part, in the filter it does nothing."""
        focus = self.focusWidget()
        if event.key() in (QtCore.Qt.Key_Return, QtCore.Qt.Key_Enter) and focus is not None:
            if focus is self._results.view:
                self._results.open_current()
                return
            if self._results.isAncestorOf(focus):
                return
        super().keyPressEvent(event)

    def _add_run_row(self, column):
        row = QtWidgets.QHBoxLayout()
        self._progress = RunProgressBar(self)
        self._start = add_button(row, self, "ThinPart_FolderStart", translate("ThinPart", "&Start"), self.start)
        self._start.setDefault(True)
        self._pause = add_button(row, self, "ThinPart_FolderPause", "", self.pause_or_resume)
        self._cancel = add_button(
            row, self, "ThinPart_FolderCancel", translate("ThinPart", "&Cancel"), self.cancel)
        self._retry = add_button(
            row, self, "ThinPart_FolderRetry", translate("ThinPart", "&Retry failed"), self.retry)
        self._offer = add_button(
            row, self, "ThinPart_FolderAddLibrary", translate("ThinPart", "Search in it\u2026"), self.add_to_libraries)
        self._offer.setToolTip(translate("ThinPart", "Adds the folder to the libraries of 'Find parts', and opens that"))
        row.addWidget(self._progress, 1)
        column.addLayout(row)

    def _add_last_row(self, column):
        row = QtWidgets.QHBoxLayout()
        for button in (self._results.open_button, self._results.label_button, self._results.info_button,
                       self._results.export_button):
            row.addWidget(button)
        row.addStretch(1)
        row.addWidget(help_button(self, "ThinPart_ClassifyFolder"))
        add_button(row, self, "ThinPart_FolderClose", translate("ThinPart", "Close"), self.reject)
        column.addLayout(row)

    def _fit_screen(self):
        letter = self.fontMetrics().averageCharWidth()
        screen = Gui.getMainWindow().screen().availableGeometry()
        self.resize(min(165 * letter, screen.width()), min(105 * letter, screen.height()))

    def _start_run(self, settings, only=()):
        self._show_problem("")
        try:
            self._run.start(settings, only)
        except ThinPartError as error:
            self._show_problem(translated(error))
            return
        self._progress.show_searching()
        self._set_state(SEARCHING)

    def _on_rows_found(self, rows):
        self._results.add(rows)

    def _show_progress(self, progress):
        if self._state == SEARCHING:
            self._set_state(RUNNING)
        self._progress.show_progress(progress)
        self._show_job()
        if self._state == PAUSED:
            self._progress.show_waiting(translate("ThinPart", "paused"))

    def _on_state_changed(self, state):
        if state == "paused" and self._state == PAUSING:
            self._set_state(PAUSED)
            self._progress.show_waiting(translate("ThinPart", "paused"))

    def _show_end(self, end):
        self._set_state(IDLE)
        self._results.view.fit_columns()
        sentence = {
            DONE: "", STOPPED: translate(
                "ThinPart", "cancelled: finished results are saved, Start continues with the rest"),
        }.get(end.outcome, translate("ThinPart", "not finished"))
        self._progress.show_end(sentence)
        self._show_problem(end.sentence)
        if not self.isVisible():
            Gui.getMainWindow().statusBar().showMessage(
                translate("ThinPart", "Classifying the folder has ended: {}").format(
                    self._progress.text), 20000)

    def _set_state(self, state):
        self._state = state
        is_running = state != IDLE
        self._form.setEnabled(not is_running)
        self._start.setEnabled(not is_running)
        self._pause.setEnabled(state in (RUNNING, PAUSING, PAUSED))
        self._pause.setText(translate("ThinPart", "Resu&me") if state in (PAUSING, PAUSED)
                            else translate("ThinPart", "&Pause"))
        self._cancel.setEnabled(is_running and state != STOPPING)
        self._retry.setEnabled(not is_running and bool(self._results.failed_files))
        self._show_job()
        self._show_offer()

    def _show_offer(self):
        """Offer a classified folder as a library, unless it is in one."""
        is_done = self._settings is not None and self._state == IDLE and self._results.table.rowCount() > 0
        self._offer.setVisible(is_done and not any(
            contains(root, _info_folder(self._settings)) for root in preference_list("Libraries")))

    def _show_job(self):
        """Show the run in the status bar, or its end."""
        if self._state == IDLE:
            lifelong.running_jobs.end("folder")
        else:
            lifelong.running_jobs.show("folder", self._progress.text, self)

    def _show_problem(self, sentence):
        """Show a problem, or clear it if the text is empty."""
        show_text(self._message, "\u26a0 " + sentence if sentence else "")

    def _ask_how_to_leave(self):
        """Ask the user: returns ``"go on"``, ``"stop"``, or None to keep the dialog open."""
        box = QtWidgets.QMessageBox(self)
        box.setObjectName("ThinPart_FolderQuestion")
        box.setIcon(QtWidgets.QMessageBox.Question)
        box.setText(translate("ThinPart", "The folder is still being classified."))
        box.setInformativeText(translate(
            "ThinPart", "Continue in the background? 'Classify folder' shows the progress again. Finished results are "
                        "saved either way."))
        go_on = box.addButton(translate("ThinPart", "Go on"), QtWidgets.QMessageBox.AcceptRole)
        stop = box.addButton(translate("ThinPart", "Stop"), QtWidgets.QMessageBox.DestructiveRole)
        stay = box.addButton(QtWidgets.QMessageBox.Cancel)
        for button, name in ((go_on, "GoOn"), (stop, "Stop"), (stay, "Stay")):
            button.setObjectName(f"ThinPart_Folder{name}")
        box.setDefaultButton(go_on)
        execute(box)
        answer = {go_on: "go on", stop: "stop"}.get(box.clickedButton())
        box.deleteLater()
        return answer


def _info_folder(settings):
    """Folder of the info files of a run."""
    if settings.beside:
        return settings.preferred_folder or settings.folder
    return settings.info_folder

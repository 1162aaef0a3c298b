"""The window in which a whole folder is classified."""

import os
from dataclasses import replace
from pathlib import Path

import FreeCADGui as Gui

from ..core.criteria import load_profile
from ..core.errors import ThinPartError
from .folder_form import FolderForm
from .folder_run import DONE, STOPPED, FolderRun
from .folder_settings import keep_settings, kept_settings
from .qt import QtCore, QtGui, QtWidgets, execute, translate
from .result_panel import ResultPanel
from .result_view import show_text, text_line
from .run_progress import RunProgress
from .sentences import translated

ICON = Path(__file__).resolve().parents[2] / "resources" / "icons" / "ThinPart_ClassifyFolder.svg"
IDLE, SEARCHING, RUNNING, PAUSING, PAUSED, STOPPING = range(6)


class FolderDialog(QtWidgets.QDialog):
    """Choices above, progress in the middle, results below; stays beside the work in FreeCAD."""

    def __init__(self, parent):
        super().__init__(parent)
        self.setObjectName("ThinPart_FolderDialog")
        self.setWindowTitle(translate("ThinPart", "Classify folder"))
        self.setWindowIcon(QtGui.QIcon(str(ICON)))
        self.setWindowFlags(QtCore.Qt.Window)
        self._state = IDLE
        self._settings = None
        self._run = FolderRun(self)
        self._run.found.connect(self._take)
        self._run.progressed.connect(self._show_progress)
        self._run.state_changed.connect(self._take_state)
        self._run.ended.connect(self._show_end)
        column = QtWidgets.QVBoxLayout(self)
        self._form = FolderForm(self)
        self._kept = kept_settings()
        self._form.show_settings(self._kept)
        column.addWidget(self._form)
        self._message = text_line(self, column, "ThinPart_FolderMessage")
        self._add_run_row(column)
        self._results = ResultPanel(load_profile("paper"), self)
        self._results.told.connect(lambda text: show_text(self._message, text))
        self._results.failed.connect(self._tell)
        column.addWidget(self._results, 1)
        self._add_last_row(column)
        self._tell("")
        self._enter(IDLE)
        self._fit_screen()

    @property
    def is_running(self):
        """Whether a folder is being classified."""
        return self._run.is_running

    def start(self):
        """Classify what is chosen."""
        settings = self._form.settings()
        try:
            profile = settings.check()
        except ThinPartError as error:
            self._tell(translated(error))
            return
        keep_settings(settings)
        self._kept = kept_settings()
        self._form.show_settings(settings)
        self._settings = settings
        self._results.begin(settings, profile)
        self._run_on(settings)

    def retry(self):
        """Classify the files again of which something failed, under the limits chosen now."""
        now = self._form.settings()
        settings = replace(self._settings, jobs=now.jobs, seconds=now.seconds, force=False)
        # A folder that could not be searched is a failure too, but no file to be tried again.
        files = {each: os.path.join(settings.folder, each)
                 for each in sorted(self._results.table.failed_files)}
        files = {each: path for each, path in files.items() if not os.path.isdir(path)}
        if not files:
            self._tell(translate(
                "ThinPart", "It is folders that could not be searched: see to them and start again."))
            return
        self._results.table.remove_files(set(files))
        self._run_on(settings, files.values())

    def pause_or_resume(self):
        """What the button says."""
        if self._state == PAUSED or self._state == PAUSING:
            self._run.resume()
            self._enter(RUNNING)
            return
        self._run.pause()
        self._enter(PAUSING)
        self._progress.show_waiting(translate("ThinPart", "pausing"))

    def cancel(self):
        """Stop; what was done is kept."""
        self._run.stop()
        self._enter(STOPPING)
        self._progress.show_waiting(translate("ThinPart", "stopping"))

    def end(self):
        """Stop at once and go, since there is no one left to ask."""
        self._run.end_now()
        self.hide()
        self.deleteLater()

    def reject(self):
        """Escape or the Close button: ask where something would be interrupted, then go."""
        if self.is_running and self._state != STOPPING:
            answer = self._ask_how_to_leave()
            if answer is None:
                return
            if answer == "stop" and self.is_running:
                self.cancel()
        super().reject()

    def showEvent(self, event):
        """The preferences may have changed since it was shown last."""
        super().showEvent(event)
        before, self._kept = self._kept, kept_settings()
        if before != self._kept and not self.is_running:
            self._form.follow(before, self._kept)

    def closeEvent(self, event):
        """The window's own button asks as well; FreeCAD, which closes all windows as it ends, not."""
        if event.spontaneous() and self.is_running:
            event.ignore()
            self.reject()
            return
        event.accept()

    def keyPressEvent(self, event):
        """Enter starts, but in the table it opens the part, and in the filter it does nothing."""
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
        self._progress = RunProgress(self)
        self._start = self._button("ThinPart_FolderStart", translate("ThinPart", "&Start"), self.start)
        self._start.setDefault(True)
        self._pause = self._button("ThinPart_FolderPause", "", self.pause_or_resume)
        self._cancel = self._button(
            "ThinPart_FolderCancel", translate("ThinPart", "&Cancel"), self.cancel)
        self._retry = self._button(
            "ThinPart_FolderRetry", translate("ThinPart", "&Retry failed"), self.retry)
        for button in (self._start, self._pause, self._cancel, self._retry):
            row.addWidget(button)
        row.addWidget(self._progress, 1)
        column.addLayout(row)

    def _add_last_row(self, column):
        row = QtWidgets.QHBoxLayout()
        for button in (self._results.open_button, self._results.info_button,
                       self._results.export_button):
            row.addWidget(button)
        row.addStretch(1)
        row.addWidget(self._button(
            "ThinPart_FolderClose", translate("ThinPart", "Close"), self.reject))
        column.addLayout(row)

    def _button(self, name, text, act):
        button = QtWidgets.QPushButton(text, self)
        button.setObjectName(name)
        button.clicked.connect(lambda *_: act())
        return button

    def _fit_screen(self):
        letter = self.fontMetrics().averageCharWidth()
        screen = Gui.getMainWindow().screen().availableGeometry()
        self.resize(min(165 * letter, screen.width()), min(105 * letter, screen.height()))

    def _run_on(self, settings, only=()):
        self._tell("")
        try:
            self._run.start(settings, only)
        except ThinPartError as error:
            self._tell(translated(error))
            return
        self._progress.show_searching()
        self._enter(SEARCHING)

    def _take(self, rows):
        self._results.add(rows)

    def _show_progress(self, progress):
        if self._state == SEARCHING:
            self._enter(RUNNING)
        self._progress.show_progress(progress)
        if self._state == PAUSED:
            self._progress.show_waiting(translate("ThinPart", "paused"))

    def _take_state(self, state):
        if state == "paused" and self._state == PAUSING:
            self._enter(PAUSED)
            self._progress.show_waiting(translate("ThinPart", "paused"))

    def _show_end(self, end):
        self._enter(IDLE)
        self._results.fit_columns()
        sentence = {
            DONE: "", STOPPED: translate(
                "ThinPart", "cancelled: what was done is kept, Start does the rest"),
        }.get(end.how, translate("ThinPart", "not finished"))
        self._progress.show_end(sentence)
        self._tell(end.sentence)
        if not self.isVisible():
            Gui.getMainWindow().statusBar().showMessage(
                translate("ThinPart", "Classifying the folder has ended: {}").format(
                    self._progress.text), 20000)

    def _enter(self, state):
        self._state = state
        at_work = state != IDLE
        self._form.setEnabled(not at_work)
        self._start.setEnabled(not at_work)
        self._pause.setEnabled(state in (RUNNING, PAUSING, PAUSED))
        self._pause.setText(translate("ThinPart", "Resu&me") if state in (PAUSING, PAUSED)
                            else translate("ThinPart", "&Pause"))
        self._cancel.setEnabled(at_work and state != STOPPING)
        self._retry.setEnabled(not at_work and bool(self._results.table.failed_files))

    def _tell(self, sentence):
        """Say what went wrong; nothing takes it away again."""
        show_text(self._message, "\u26a0 " + sentence if sentence else "")

    def _ask_how_to_leave(self):
        """``"go on"``, ``"stop"``, or None to stay."""
        box = QtWidgets.QMessageBox(self)
        box.setObjectName("ThinPart_FolderQuestion")
        box.setIcon(QtWidgets.QMessageBox.Question)
        box.setText(translate("ThinPart", "The folder is still being classified."))
        box.setInformativeText(translate(
            "ThinPart", "Continue in the background? 'Classify folder' shows it again. What "
            "is done so far is kept either way."))
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

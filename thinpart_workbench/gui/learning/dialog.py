# SPDX-License-Identifier: LGPL-2.1-or-later
"""The dialog that learns thresholds from labels."""

import os

from ...core.errors import ThinPartError
from ...core.kinds.file_marks import PROFILE
from ...freecad_adapter.additional_packages import has_package
from ...freecad_adapter.preferences import set_preference
from ..application import lifelong
from ..application.icons import icon
from ..application.qt import QtCore, QtWidgets, grouped, translate
from ..application.sentences import translated
from ..guide.command import help_button
from ..processes.request_queue import RequestQueue
from ..record.record_view import show_text, text_line
from ..widgets.buttons import add_button
from ..widgets.confirmation import may_overwrite
from ..widgets.file_dialogs import chosen_output
from .form import LearnForm
from .result_view import LearnedView

_PACKAGE, _MODULE = "scikit-learn", "sklearn"
"""Fits the probabilities of a profile; FreeCAD bundles do not include it."""

_LINES_WITH_RESULT = 50
"""Height of the dialog with a result, in lines of text."""



class LearnDialog(QtWidgets.QDialog):
    """Non-modal dialog: what is learned from, the progress, the result, and what becomes of it."""

    def __init__(self, parent):
        super().__init__(parent)
        self.setObjectName("ThinPart_LearnDialog")
        self.setWindowTitle(translate("ThinPart", "Learn thresholds"))
        self.setWindowIcon(icon("ThinPart_LearnThresholds"))
        self.setWindowFlags(QtCore.Qt.Window)
        self._learned = self._saved = None
        self._use_when_saved = False
        self._queue, self._request = RequestQueue("learning", parent=self), None
        self._queue.answered.connect(self._on_answered)
        self._queue.progressed.connect(lambda _, progress: self._show_progress(*progress))
        column = QtWidgets.QVBoxLayout(self)
        self._intro = text_line(self, column, "ThinPart_LearnIntro")
        self._intro.setText(translate(
            "ThinPart", "Chooses the thresholds that agree most often with what people say of parts: by 'Not right?' beside "
                        "a verdict, or in tables. Folders that were left out show how good they are."))
        self._form = LearnForm(self)
        column.addWidget(self._form)
        self._add_run_row(column)
        self._result = LearnedView(self)
        column.addWidget(self._result, 1)
        self._message = text_line(self, column, "ThinPart_LearnMessage")
        column.addStretch(0)
        self._add_last_row(column)
        self._result.hide()
        self._show_message("")
        self._show_state()
        letter = self.fontMetrics().averageCharWidth()
        # Room for a message of two lines.
        self.resize(120 * letter, self.sizeHint().height() + 4 * self.fontMetrics().height())

    @property
    def is_running(self):
        """Whether something is being learned or saved."""
        return self._queue.is_busy

    def start(self):
        """Learn from the chosen labels."""
        arguments = self._form.arguments()
        problem = "" if arguments["library"] else translate("ThinPart", "Choose the folder with the labelled parts.")
        problem = problem or _missing_package()
        if problem:
            self._show_message(problem)
            self._show_state()
            return
        self._learned = self._saved = None
        self._result.hide()
        self._wait_for(self._queue.ask("learning.learn", **arguments), translate("ThinPart", "Reading the labels\u2026"))

    def cancel(self):
        """Stop: nothing was written."""
        self._queue.cancel(self._request)
        self._show_message(translate("ThinPart", "Cancelled. Nothing was written."))
        self._show_state()

    def save(self):
        """Ask for a file and write the learned profile to it."""
        chosen = chosen_output(
            self, "ThinPart_LearnSaveDialog", translate("ThinPart", "Save the learned profile"),
            os.path.join(self._form.arguments()["library"], "house.json"), translate("ThinPart", "Thresholds (*.json)"))
        overwrite = self._may_overwrite(chosen) if chosen else None
        if overwrite is None:
            self._use_when_saved = False
        else:
            self.save_as(chosen, overwrite)

    def save_as(self, file, overwrite=False):
        """Write the learned profile to a file; `overwrite` says whether that may be no profile."""
        self._wait_for(self._queue.keep("learning.save_profile", content=self._learned["content"], output=file,
                                        overwrite=overwrite), translate("ThinPart", "Writing {}\u2026").format(file))

    def _may_overwrite(self, file):
        try:
            return may_overwrite(self, file, PROFILE)
        except ThinPartError as error:
            self._show_message("\u26a0 " + translated(error))
            return None
        except OSError:
            return False  # the attempt says what is wrong

    def use(self):
        """Make the learned profile the preferred one; it is saved before."""
        if self._saved is None:
            self._use_when_saved = True
            self.save()
            return
        set_preference("Profile", self._saved)
        self._show_message(translate(
            "ThinPart", "From now on parts are judged by {}. 'Reclassify' in the panel 'Find parts' judges stored parts by "
                        "it.").format(os.path.basename(self._saved)))
        self._show_state()

    def end(self):
        """Stop at once and delete the dialog, without asking the user."""
        self._queue.cancel(self._request)
        lifelong.running_jobs.end("learning")
        self.hide()
        self.deleteLater()

    def showEvent(self, event):
        """Offer libraries and profiles that were chosen meanwhile."""
        super().showEvent(event)
        if not self.is_running:
            self._form.show_preferences()

    def _wait_for(self, request, sentence):
        self._request = request
        self._bar.setRange(0, 0)
        self._show_message(sentence)
        self._show_state()

    def _on_answered(self, request):
        was_saved = not request.sentence and request.function == "learning.save_profile"
        if request.sentence:
            self._show_message("\u26a0 " + request.sentence)
        elif was_saved:
            self._saved = request.arguments["output"]
            self._show_message(translate("ThinPart", "The learned profile was written to {}.").format(self._saved))
        else:
            self._learned = request.answer
            self._result.show_learned(self._learned)
            self._result.show()
            self._make_room()
            self._show_message("")
        if was_saved and self._use_when_saved:
            self.use()
        self._use_when_saved = False
        self._show_state()

    def _make_room(self):
        """Make the dialog so high that the first page of the result fits, where the screen is."""
        line = self.fontMetrics().height()
        height = min(_LINES_WITH_RESULT * line, self.screen().availableGeometry().height() - 3 * line)
        if self.height() < height:
            top = max(self.screen().availableGeometry().top() + line, self.y() - (height - self.height()) // 2)
            self.resize(self.width(), height)
            self.move(self.x(), top)

    def _show_progress(self, stage, done, total):
        self._bar.setRange(0, max(total, 1) if done else 0)
        self._bar.setValue(done)
        if stage == "read":
            self._show_message(translate("ThinPart", "Reading info files: {} of {}").format(grouped(done), grouped(total)))
        else:
            self._show_message(translate("ThinPart", "Learning profile {} of {}").format(done + 1, total))

    def _show_message(self, text):
        show_text(self._message, text)

    def _show_state(self):
        running = self.is_running
        if running:
            lifelong.running_jobs.show("learning", translate("ThinPart", "Learning thresholds"), self)
        else:
            lifelong.running_jobs.end("learning")
        self._form.setEnabled(not running)
        self._start.setEnabled(not running)
        self._cancel.setEnabled(running)
        self._bar.setVisible(running)
        for button in (self._save, self._use):
            button.setEnabled(not running and self._learned is not None)

    def _add_run_row(self, column):
        row = QtWidgets.QHBoxLayout()
        self._start = add_button(row, self, "ThinPart_LearnStart", translate("ThinPart", "&Learn"), self.start)
        self._start.setDefault(True)
        self._cancel = add_button(row, self, "ThinPart_LearnCancel", translate("ThinPart", "&Cancel"), self.cancel)
        self._bar = QtWidgets.QProgressBar(self)
        self._bar.setObjectName("ThinPart_LearnProgress")
        row.addWidget(self._bar, 1)
        row.addStretch(0)
        column.addLayout(row)

    def _add_last_row(self, column):
        row = QtWidgets.QHBoxLayout()
        self._save = add_button(
            row, self, "ThinPart_LearnSave", translate("ThinPart", "&Save as\u2026"), self.save, is_for_enter=False)
        self._use = add_button(
            row, self, "ThinPart_LearnUse", translate("ThinPart", "&Use as my profile"), self.use, is_for_enter=False)
        row.addStretch(1)
        row.addWidget(help_button(self, "ThinPart_LearnThresholds"))
        add_button(row, self, "ThinPart_LearnClose", translate("ThinPart", "Close"), self.close, is_for_enter=False)
        column.addLayout(row)


def _missing_package():
    """Message about a missing package; empty if nothing is missing."""
    if has_package(_MODULE):
        return ""
    return translate("ThinPart", "Learning needs the Python package {}, which this FreeCAD does not have: FreeCAD's "
                                 "Addon Manager offers it when it installs ThinPart.").format(_PACKAGE)

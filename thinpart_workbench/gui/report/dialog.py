# SPDX-License-Identifier: LGPL-2.1-or-later
"""The dialog that writes a report about a document."""

import os
from pathlib import Path

import FreeCAD as App

from ...api.report.report_folder import LANGUAGES, OVERVIEW
from ...api.window.open_parts import content_of
from ...api.window.profiles import preferred_profile
from ...core.analysis_settings import RAY
from ...core.errors import ThinPartError
from ...freecad_adapter.preferences import preference, preferred_analysis
from ..application import lifelong
from ..application.icons import icon
from ..application.language import language_of
from ..application.length_unit import length_unit
from ..application.qt import QtCore, QtGui, QtWidgets, translate
from ..application.sentences import translated
from ..guide.command import help_button
from ..processes.document_analysis import DocumentAnalysis
from ..processes.snapshot_job import SnapshotJob
from ..record.kept_room import keep_room
from ..record.record_view import show_text, text_line
from ..widgets.buttons import add_button
from ..widgets.file_dialogs import choose_folder
from ..widgets.single_dialog import show_single_dialog, single_dialog


def proposed_folder(document):
    """Default folder of a report: beside the document, or among the user's documents where it has no file yet."""
    if document.FileName:
        return str(Path(document.FileName).with_suffix("")) + "-report"
    name = "".join(each if each.isalnum() or each in "-_ " else "-" for each in document.Label)
    return os.path.join(_user_documents(), f"{name}-report")


def _user_documents():
    return QtCore.QStandardPaths.writableLocation(QtCore.QStandardPaths.DocumentsLocation)


def show_report_dialog():
    """Bring the one dialog to the front; unless busy, it switches to the active document."""
    single_dialog(ReportDialog).show_document(App.ActiveDocument)
    show_single_dialog(ReportDialog)


class ReportDialog(QtWidgets.QDialog):
    """Non-modal dialog with the report folder, the progress, and whether to open the report."""

    def __init__(self, parent):
        super().__init__(parent)
        self.setObjectName("ThinPart_ReportDialog")
        self.setWindowTitle(translate("ThinPart", "Report"))
        self.setWindowIcon(icon("ThinPart_Report"))
        self._document = None
        self._output = ""
        self._job = self._analysis = None
        self._is_writing = False
        column = QtWidgets.QVBoxLayout(self)
        self._subject = text_line(self, column, "ThinPart_ReportSubject")
        self._add_folder(column)
        self._open_when_done = QtWidgets.QCheckBox(
            translate("ThinPart", "&Open it in the browser when it is ready"), self)
        self._open_when_done.setObjectName("ThinPart_ReportOpen")
        self._open_when_done.setChecked(True)
        column.addWidget(self._open_when_done)
        self._bar = QtWidgets.QProgressBar(self)
        self._bar.setObjectName("ThinPart_ReportProgress")
        self._bar.setRange(0, 1000)
        column.addWidget(self._bar)
        self._message = text_line(self, column, "ThinPart_ReportMessage")
        keep_room(self._bar)
        keep_room(self._message, 2)
        self._add_buttons(column)
        self._show_state()

    def show_document(self, document):
        """Switch to a document, unless a report is being written."""
        if self._is_writing or document is None:
            return
        self._document = document.Name
        show_text(self._subject, translate(
            "ThinPart", "Report about all parts of '{}'").format(document.Label))
        self._folder.setText(proposed_folder(document))
        self._show_message(self._problem())
        self._show_state()

    def start(self):
        """Write the report about the document as it is open now."""
        problem = self._problem()
        if problem:
            self._show_message(problem)
            self._show_state()
            return
        document = App.getDocument(self._document)
        output = self._folder.text().strip() or proposed_folder(document)
        self._folder.setText(output)
        self._output = os.path.abspath(os.path.join(os.path.dirname(document.FileName) or _user_documents(), output))
        try:
            self._write(document)
        except ThinPartError as error:
            self._show_message(translated(error))
        else:
            self._is_writing = True
            self._bar.setValue(0)
            self._show_message(translate("ThinPart", "Measuring and drawing\u2026"))
        self._show_state()

    def _write(self, document):
        content = content_of(document)
        file = os.path.abspath(document.FileName) if document.FileName else ""
        self._analysis = DocumentAnalysis(
            content.parts, content.parts[0], preferred_analysis(), preferred_profile().content,
            content.broken, maps=RAY)
        self._job = SnapshotJob(self._analysis, preference("MemoryMegabytes"), self, {
            "output": self._output, "document": file, "label": document.Label,
            "is_saved": bool(file) and os.path.exists(file) and not lifelong.observer.differs_from_file(document),
            "info_folder": preference("InfoFolder"), "checks": preference("Checks"),
            "failures": [part.failure() for part in content.broken], "language": language_of(LANGUAGES),
            "unit": length_unit(document).symbol})
        self._job.progressed.connect(self._show_progress)
        self._job.ended.connect(self._show_end)
        self._job.start()

    def cancel(self):
        """Stop; pages already written stay."""
        self._job.stop()
        self._is_writing = False
        self._show_message(translate("ThinPart", "Stopped on request before the end."))
        self._show_state()

    def open_report(self):
        """Open the report in the browser."""
        QtGui.QDesktopServices.openUrl(QtCore.QUrl.fromLocalFile(os.path.join(self._output, OVERVIEW)))

    def end(self):
        """Stop at once and delete the dialog, without asking the user."""
        if self._job is not None:
            self._job.stop()
        lifelong.running_jobs.end("report")
        self.hide()
        self.deleteLater()

    def _problem(self):
        """Message why no report can be written; empty if it can."""
        if self._document not in App.listDocuments():
            return translate("ThinPart", "The document is closed: open it again for a report about it.")
        return ""

    def _show_progress(self, progress):
        self._bar.setValue(int(1000 * self._analysis.share_done(progress)))

    def _show_end(self, sentence):
        self._is_writing = False
        self._show_state()
        if sentence:
            self._show_message(sentence)
            return
        self._show_message(self._summary())
        self._open_button.setEnabled(True)
        if self._open_when_done.isChecked():
            self.open_report()

    def _summary(self):
        ready = translate("ThinPart", "The report is in {}.").format(self._output)
        failures = [*self._analysis.failures.values(), *(part.failure() for part in self._analysis.broken)]
        if not failures:
            return ready
        failed = translate("ThinPart", "Not measured: {}").format(
            " ".join(translated(each["message"]) for each in failures[:3]))
        return f"{ready} {failed}"

    def _show_message(self, text):
        show_text(self._message, text)

    def _show_state(self):
        running = self._is_writing
        if running:
            lifelong.running_jobs.show("report", translate("ThinPart", "Writing a report"), self)
        else:
            lifelong.running_jobs.end("report")
        self._bar.setVisible(running)
        self._start.setEnabled(not running)
        self._cancel.setEnabled(running)
        for widget in (self._folder, self._browse):
            widget.setEnabled(not running)
        self._open_button.setEnabled(False)

    def _choose(self):
        choose_folder(self, os.path.dirname(self._folder.text()), self._folder.setText,
                      translate("ThinPart", "Folder of the report"))

    def _add_folder(self, column):
        row = QtWidgets.QHBoxLayout()
        label = QtWidgets.QLabel(translate("ThinPart", "&Folder:"), self)
        self._folder = QtWidgets.QLineEdit(self)
        self._folder.setObjectName("ThinPart_ReportFolder")
        self._folder.setMinimumWidth(380)
        label.setBuddy(self._folder)
        row.addWidget(label)
        row.addWidget(self._folder)
        self._browse = add_button(
            row, self, "ThinPart_ReportBrowse", translate("ThinPart", "&Browse\u2026"), self._choose)
        column.addLayout(row)

    def _add_buttons(self, column):
        row = QtWidgets.QHBoxLayout()

        def add(name, text, callback):
            return add_button(row, self, name, text, callback, is_for_enter=False)

        row.addStretch(1)
        self._start = add("ThinPart_ReportStart", translate("ThinPart", "&Write report"), self.start)
        self._start.setDefault(True)
        self._cancel = add("ThinPart_ReportCancel", translate("ThinPart", "&Cancel"), self.cancel)
        self._open_button = add("ThinPart_ReportLook", translate("ThinPart", "&Open report"), self.open_report)
        row.addWidget(help_button(self, "ThinPart_Report"))
        add("ThinPart_ReportClose", translate("ThinPart", "Close"), self.close)
        column.addLayout(row)

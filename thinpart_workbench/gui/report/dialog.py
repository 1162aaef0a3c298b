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
from ..application.language import language_of
from ..application.length_unit import length_unit
from ..application.qt import QtCore, translate
from ..application.sentences import translated
from ..processes.document_analysis import DocumentAnalysis
from ..processes.snapshot_job import SnapshotJob
from ..record.record_view import show_text
from ..widgets.single_dialog import show_single_dialog, single_dialog
from .report_form import ReportForm

_STEPS = 1000
"""Of the progress bar."""


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


class ReportDialog(ReportForm):
    """The dialog for the active document, as it is open."""

    def __init__(self, parent):
        super().__init__(parent, "ThinPart_Report", translate("ThinPart", "Report"), "ThinPart_Report",
                         translate("ThinPart", "Writing a report"))
        self._document, self._output = None, ""
        self._job = self._analysis = None

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
        self._output = self._chosen_folder(
            proposed_folder(document), os.path.dirname(document.FileName) or _user_documents())
        try:
            self._write(document)
        except ThinPartError as error:
            self._show_message(translated(error))
        else:
            self._show_begun(translate("ThinPart", "Measuring and drawing\u2026"), _STEPS)
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
        self._job.ended.connect(self._on_ended)
        self._job.start()

    def _stop(self):
        if self._job is not None:
            self._job.stop()

    def _problem(self):
        """Message why no report can be written; empty if it can."""
        if self._document not in App.listDocuments():
            return translate("ThinPart", "The document is closed: open it again for a report about it.")
        return ""

    def _show_progress(self, progress):
        self._bar.setValue(int(_STEPS * self._analysis.share_done(progress)))

    def _on_ended(self, sentence):
        self._show_end(sentence, os.path.join(self._output, OVERVIEW), self._summary())

    def _summary(self):
        ready = translate("ThinPart", "The report is in {}.").format(self._output)
        failures = [*self._analysis.failures.values(), *(part.failure() for part in self._analysis.broken)]
        if not failures:
            return ready
        failed = translate("ThinPart", "Not measured: {}").format(
            " ".join(translated(each["message"]) for each in failures[:3]))
        return f"{ready} {failed}"

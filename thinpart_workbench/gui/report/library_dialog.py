# SPDX-License-Identifier: LGPL-2.1-or-later
"""The dialog that writes a page about libraries, by another process."""

import os

from ...api.report.report_folder import LANGUAGES
from ..application.language import language_of
from ..application.length_unit import length_unit
from ..application.qt import grouped, translate
from ..application.sentences import translated
from ..processes.request_queue import RequestQueue
from ..record.record_view import show_text
from ..widgets.single_dialog import show_single_dialog, single_dialog
from .report_form import ReportForm

_WRITE = "report.library_report.library_report"

_MOST_PROBLEMS = 3


def show_library_report(roots):
    """Bring the one dialog to the front; unless busy, it switches to these folders, list of str."""
    single_dialog(LibraryReportDialog).show_libraries(roots)
    show_single_dialog(LibraryReportDialog)


class LibraryReportDialog(ReportForm):
    """The dialog for libraries."""

    def __init__(self, parent):
        super().__init__(parent, "ThinPart_LibraryReport", translate("ThinPart", "Report about libraries"),
                         "ThinPart_FindParts", translate("ThinPart", "Writing a report about libraries"))
        self._roots, self._request = [], None
        self._queue = RequestQueue("library_report", parent=self)
        self._queue.answered.connect(self._on_answered)
        self._queue.progressed.connect(self._on_progressed)

    def show_libraries(self, roots):
        """Switch to other folders, list of str, unless a report is being written."""
        if self._is_writing or roots == self._roots:
            return
        self._roots = list(roots)
        if len(roots) == 1:
            text = translate("ThinPart", "Report about the classified parts in '{}'").format(_name(roots[0]))
        else:
            text = translate("ThinPart", "Report about the classified parts in {} libraries").format(grouped(len(roots)))
        show_text(self._subject, text)
        self._subject.setToolTip("\n".join(roots))
        self._folder.setText(self._proposed_folder())
        self._show_message("")
        self._show_state()

    def start(self):
        """Write the page, from what info files have."""
        folder = self._chosen_folder(self._proposed_folder(), os.path.dirname(self._roots[0]))
        self._request = self._queue.ask(
            _WRITE, roots=self._roots, folder=folder, language=language_of(LANGUAGES), unit=length_unit().symbol)
        self._show_begun(translate("ThinPart", "Reading info files\u2026"), 0)
        self._show_state()

    def _proposed_folder(self):
        """Beside the library, or the first of several."""
        return self._roots[0].rstrip(os.sep) + "-report"

    def _stop(self):
        if self._request is not None:
            self._queue.cancel(self._request)
            self._request = None

    def _on_progressed(self, request, progress):
        if request is self._request:
            done, total = progress
            self._bar.setRange(0, max(1, total))
            self._bar.setValue(done)
            self._show_message(translate("ThinPart", "Comparing: {} of {}").format(grouped(done), grouped(total)))

    def _on_answered(self, request):
        if request is not self._request:
            return
        self._request = None
        if request.answer is None:
            self._show_end(request.sentence)
        else:
            self._show_end("", request.answer["page"], _summary(request.answer))


def _summary(written):
    """What is said of a page that was written, from the attributes of `WrittenLibrary`."""
    said = [translate("ThinPart", "The report is in {}.").format(os.path.dirname(written["page"]))]
    if written["unclassified"]:
        said.append(translate("ThinPart", "Documents that are not classified yet, and only listed in it: {}.").format(
            grouped(written["unclassified"])))
    said += ["\u26a0 " + translated(problem["message"]) for problem in written["problems"][:_MOST_PROBLEMS]]
    return " ".join(said)


def _name(folder):
    return os.path.basename(folder.rstrip(os.sep)) or folder

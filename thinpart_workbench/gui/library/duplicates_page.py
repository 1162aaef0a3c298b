# SPDX-License-Identifier: LGPL-2.1-or-later
"""The page of the dock that finds what the libraries have more than once, and their families."""

from types import SimpleNamespace

import FreeCAD as App

from ...api.window.open_parts import content_of
from ...core.errors import ThinPartError
from ...freecad_adapter.preferences import preference
from ..application.length_unit import length_unit
from ..application.qt import QtWidgets, Signal, grouped, translate
from ..application.sentences import translated
from ..classify.known_box import KnownBox
from ..classify.part_difference import PartDifference
from ..document.open_part import open_part, told_by
from ..processes.request_queue import RequestQueue
from ..record.record_view import show_text, text_line
from ..widgets.buttons import add_button
from ..widgets.flow_layout import add_flow
from .duplicates_view import DuplicateRows, DuplicatesView, evidence_text

_DUPLICATES, _FAMILIES = "window.library_duplicates.duplicate_rows", "window.library_duplicates.family_rows"

BY_RECORDS, BY_DOCUMENTS, FAMILIES = range(3)
"""Ways to search, in their order."""

_MOST_PROBLEMS = 3


class DuplicatesPage(QtWidgets.QWidget):
    """The choice of how to search, the button that starts it, and what was found.

    Parameters
    ----------
    pictures : Thumbnails
    parent : QWidget, optional

    Attributes
    ----------
    view : DuplicatesView

    Signals
    -------
    running_changed(bool)
        Whether a search is running.
    """

    running_changed = Signal(bool)

    def __init__(self, pictures, parent=None):
        super().__init__(parent)
        self._roots, self._request = [], None
        self._queue = RequestQueue("duplicates", parent=self)
        self._queue.answered.connect(self._on_answered)
        self._queue.progressed.connect(self._on_progressed)
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(4, 4, 4, 4)
        self._way = QtWidgets.QComboBox(self)
        self._way.setObjectName("ThinPart_DuplicatesWay")
        self._way.addItems([
            translate("ThinPart", "Duplicates, quickly: by what info files keep"),
            translate("ThinPart", "Duplicates, surely: the documents are read"),
            translate("ThinPart", "Families: parts that differ in dimensions")])
        self._way.setSizeAdjustPolicy(QtWidgets.QComboBox.AdjustToMinimumContentsLengthWithIcon)
        self._way.setMinimumContentsLength(12)
        column.addWidget(self._way)
        row = add_flow(column, self)
        self._search = add_button(row, self, "ThinPart_DuplicatesSearch", translate("ThinPart", "Search"), self.search,
                                  is_for_enter=False)
        self._cancel = add_button(row, self, "ThinPart_DuplicatesCancel", translate("ThinPart", "Cancel"), self.cancel,
                                  is_for_enter=False)
        self._bar = QtWidgets.QProgressBar(self)
        self._bar.setObjectName("ThinPart_DuplicatesBar")
        column.addWidget(self._bar)
        self._summary = text_line(self, column, "ThinPart_DuplicatesSummary")
        self.view = DuplicatesView(DuplicateRows(pictures, self), self)
        self.view.setMinimumHeight(8 * self.fontMetrics().height())
        column.addWidget(self.view, 1)
        self._known = KnownBox(self)
        self._known.difference_toggled.connect(self._toggle_difference)
        self._known.open_requested.connect(self._open_kept)
        column.addWidget(self._known)
        self._difference = PartDifference(self)
        self._difference.changed.connect(self._show_difference)
        self.view.current_changed.connect(self._show_current)
        self._problems = text_line(self, column, "ThinPart_DuplicatesProblems")
        self.view.message.connect(self._show_problem)
        self.view.failed.connect(self._show_problem)
        self.set_roots([])

    @property
    def is_running(self):
        """Whether a search is running."""
        return self._request is not None

    def set_roots(self, roots):
        """Set the libraries to search; what was found in others is shown no more."""
        if roots != self._roots or not roots:
            self._roots = list(roots)
            self.cancel()
            self.view.show_kind(False)
            self._say("" if roots else translate("ThinPart", "Add a folder with classified parts under 'Libraries'."))

    def search(self):
        """Search in the chosen way."""
        self.cancel()
        way = self._way.currentIndex()
        self.view.show_kind(way == FAMILIES)
        if way == FAMILIES:
            self._request = self._queue.ask(_FAMILIES, roots=self._roots)
        else:
            self._request = self._queue.ask(
                _DUPLICATES, roots=self._roots, reads_documents=way == BY_DOCUMENTS, jobs=preference("Jobs"),
                seconds=preference("Seconds"), megabytes=preference("MemoryMegabytes"))
        self._bar.setRange(0, 0)
        self._say(translate("ThinPart", "Searching\u2026"))

    def cancel(self):
        """Stop searching; a later search goes on with the documents that were compared."""
        if self._request is not None:
            self._queue.cancel(self._request)
            self._request = None
            self._say(translate("ThinPart", "Cancelled."))

    def show_unit(self, unit):
        """Show lengths in a LengthUnit."""
        self.view.model().show_unit(unit)

    def end(self):
        """Stop searching, and show no difference any more."""
        self.cancel()
        self._difference.end()

    def _show_current(self, row):
        """Show what differs between the selected part and the one to keep, and lead to that."""
        self._difference.end()
        kept = getattr(row, "kept", None)
        sentence = evidence_text(row, length_unit()) if hasattr(row, "says") else ""
        self._known.show_known(kept and {"kind": row.kind, **kept}, sentence)

    def _toggle_difference(self, is_wanted):
        """Open the selected part and show in its view what differs from the one to keep, or nothing of it any more."""
        if not is_wanted:
            self._difference.end()
            return
        row = self.view.current_part
        try:
            open_part(row.file, row.name)
            document = App.ActiveDocument
            parts = content_of(document).parts
            part = _part_of(parts, row)
            self._difference.start(document, part, part, [each for each in parts if each is not part],
                                   {"info_file": row.info_file, "name": row.name}, row.kept)
        except ThinPartError as error:
            self._show_difference(None, translated(error))

    def _show_difference(self, found, sentence):
        self._known.show_difference(self._difference.is_running, found, sentence, length_unit())

    def _open_kept(self):
        kept = self.view.current_part.kept
        self._known.show_problem(told_by(lambda: open_part(kept["file"], kept["name"])))

    def _on_progressed(self, request, progress):
        if request is self._request:
            done, total = progress
            self._bar.setRange(0, max(1, total))
            self._bar.setValue(done)
            show_text(self._summary, translate("ThinPart", "Comparing: {} of {}").format(grouped(done), grouped(total)))

    def _on_answered(self, request):
        if request is not self._request:
            return
        self._request = None
        answer = request.answer
        if answer is None:
            self._say(request.sentence)
            return
        self.view.show_rows([SimpleNamespace(**row) for row in answer["rows"]], length_unit())
        is_families = request.function == _FAMILIES
        self._say(_families_text(answer) if is_families else _duplicates_text(answer),
                  "\n".join("\u26a0 " + translated(problem) for problem in answer["problems"][:_MOST_PROBLEMS]))

    def _say(self, summary, problems=""):
        show_text(self._summary, summary)
        show_text(self._problems, problems)
        is_running = self._request is not None
        self._bar.setVisible(is_running)
        self._cancel.setVisible(is_running)
        self._search.setVisible(not is_running)
        self._search.setEnabled(bool(self._roots))
        self._way.setEnabled(not is_running)
        self.running_changed.emit(is_running)

    def _show_problem(self, sentence):
        show_text(self._problems, sentence)


def _part_of(parts, row):
    """The part of an open document that a row is about: importers of the window name parts otherwise than those without.

    Raises ThinPartError where it cannot be told.
    """
    found = [part for part in parts if part.name == row.name] or [part for part in parts if part.label == row.label]
    if len(found) != 1:
        found = parts
    if len(found) != 1:
        raise ThinPartError(translate("ThinPart", "{} has several parts, of which none is named {}.").format(
            row.place, row.label), "missing")
    return found[0]


def _duplicates_text(answer):
    more = sum(not row["is_kept"] for row in answer["rows"])
    groups = len({row["group"] for row in answer["rows"]})
    if not groups:
        text = translate("ThinPart", "Compared: {} parts. None of them is there twice, mirrored, in another size, or alike."
                         ).format(grouped(answer["compared"]))
    else:
        text = translate("ThinPart", "Compared: {} parts. Groups: {}. Parts besides those to keep: {}.").format(
            grouped(answer["compared"]), grouped(groups), grouped(more))
    if answer["without_form"]:
        text += " " + translate(
            "ThinPart", "Not compared, because an earlier version has measured them: {}. Classify them again.").format(
            grouped(answer["without_form"]))
    return text


def _families_text(answer):
    if not answer["rows"]:
        return translate("ThinPart", "There are no families.")
    return translate("ThinPart", "Families: {}. Parts in them: {}.").format(
        grouped(len({row["group"] for row in answer["rows"]})), grouped(len(answer["rows"])))

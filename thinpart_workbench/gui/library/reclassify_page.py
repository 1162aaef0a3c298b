"""Reclassifies the parts of the libraries by other thresholds, with a preview before writing."""

from ...core.errors import ThinPartError
from ...core.judging.criteria import load_profile, profile_from
from ..application import lifelong
from ..application.qt import QtCore, QtWidgets, Signal, grouped, translate
from ..application.sentences import translated
from ..processes.conversation import Conversation
from ..record.category_marks import colour_icon
from ..record.record_view import show_text, text_line
from ..record.verdict_text import category_colour, category_title
from ..widgets.confirmation import is_confirmed
from ..widgets.edit_profile_button import edit_profile_button
from ..widgets.flow_layout import FlowLayout
from ..widgets.profile_combo import ProfileCombo
from ..widgets.push_button import add_button

IDLE, PREVIEWING, PREVIEWED, WRITING = range(4)


class ReclassifyPage(QtWidgets.QWidget):
    """The choice of thresholds, a preview of their effect, and the button that writes it.

    Signals
    -------
    working_changed(bool)
        Whether it is working.
    written
        Info files were updated.
    """

    working_changed = Signal(bool)
    written = Signal()

    def __init__(self, profile_name, parent=None):
        super().__init__(parent)
        self._roots, self._state, self._content, self._tally = [], IDLE, None, None
        self._problems = []
        self._process = Conversation("reclassify_worker", self)
        self._process.received.connect(self._on_message)
        self._process.finished.connect(self._on_process_ended)
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(4, 4, 4, 4)
        row = QtWidgets.QHBoxLayout()
        self._profile = ProfileCombo(self)
        self._profile.setObjectName("ThinPart_ReclassifyProfile")
        self._profile.choose(profile_name)
        self._profile.currentIndexChanged.connect(lambda _: self._clear_preview())
        row.addWidget(self._profile, 1)
        self._file = add_button(
            row, self, "ThinPart_ReclassifyFile", translate("ThinPart", "From file\u2026"),
            self._profile.ask_for_file)
        row.addWidget(edit_profile_button(self, "ThinPart_ReclassifyEdit", self._profile.currentData))
        lifelong.profile_signals.saved.connect(self._on_profile_saved)
        column.addLayout(row)
        container = QtWidgets.QWidget(self)
        row = FlowLayout(container)
        self._preview = add_button(
            row, self, "ThinPart_ReclassifyPreview", translate("ThinPart", "Preview"), self.preview)
        self._write = add_button(
            row, self, "ThinPart_ReclassifyWrite", translate("ThinPart", "Write\u2026"), self.write)
        self._cancel = add_button(
            row, self, "ThinPart_ReclassifyCancel", translate("ThinPart", "Cancel"), self.cancel)
        column.addWidget(container)
        self._bar = QtWidgets.QProgressBar(self)
        self._bar.setObjectName("ThinPart_ReclassifyBar")
        column.addWidget(self._bar)
        self._message = text_line(self, column, "ThinPart_ReclassifyMessage")
        self._add_table(column)
        self._clear_preview()

    @property
    def is_running(self):
        """Whether the worker process is running."""
        return self._process.is_running

    def set_roots(self, roots):
        """Set the libraries to reclassify."""
        if roots != self._roots:
            self._roots = list(roots)
            if not self.is_running:
                self._clear_preview()

    def choose(self, name):
        """Choose a profile: name of a shipped one, or path of a file."""
        if not self.is_running:
            self._profile.choose(name)

    def preview(self):
        """Reclassify everything without writing."""
        try:
            self._content = load_profile(self._profile.currentData()).content
        except ThinPartError as error:
            self._show_message(translated(error))
            return
        self._run(PREVIEWING)

    def write(self):
        """Write the previewed changes after confirmation."""
        if self._ask_to_write():
            self._run(WRITING)

    def cancel(self):
        """Stop; files already written stay so."""
        self._process.send(ask="stop")
        self._cancel.setEnabled(False)

    def end(self):
        """Detach from the worker process and clear the preview."""
        self._process.detach()
        self._clear_preview()

    def _run(self, state):
        self._tally, self._problems = None, []
        sentence = self._process.ensure_started()
        if sentence:
            self._show_message(sentence)
            return
        self._process.send(roots=self._roots, profile=self._content, write=state == WRITING)
        self._set_state(state)
        self._bar.setRange(0, 0)
        self._show_message("")

    def _on_message(self, content):
        if "problem" in content:
            self._problems.append(translated(content["problem"]))
            return
        self._tally = content["judged"]
        self._bar.setRange(0, max(1, self._tally["total"]))
        self._bar.setValue(self._tally["done"])
        self._show_counts()
        if "ended" in content:
            self._show_end(content["ended"] == "stopped")

    def _show_end(self, stopped):
        tally, was_writing = self._tally, self._state == WRITING
        sentences = list(self._problems)
        if stopped and was_writing:
            sentences.append(translate("ThinPart", "Stopped: {} of {} info files are up to date.").format(
                grouped(tally["done"] - tally["failed"]), grouped(tally["total"])))
        elif stopped:
            sentences.append(translate("ThinPart", "Stopped after {} of {} info files.").format(
                grouped(tally["done"]), grouped(tally["total"])))
        elif was_writing:
            sentences.append(translate("ThinPart", "{} info files were updated.").format(
                grouped(tally["differing"])))
        else:
            sentences.append(translate(
                "ThinPart", "{} of {} parts change their category; {} info files would be updated.").format(
                grouped(tally["changed"]), grouped(sum(tally["after"].values())),
                grouped(tally["differing"])))
        if tally["failed"]:
            sentences.append(translate("ThinPart", "{} info files were not changed: {}").format(
                grouped(tally["failed"]), " ".join(map(translated, tally["errors"][:3]))))
        self._show_message("\n".join(sentences))
        self._set_state(PREVIEWED if not was_writing and not stopped else IDLE)
        if was_writing:
            self.written.emit()

    def _on_process_ended(self, sentence):
        if sentence:
            was_writing = self._state == WRITING
            self._set_state(IDLE)
            self._show_message(sentence)
            if was_writing:
                self.written.emit()
        else:
            self._set_state(self._state)

    def _on_profile_saved(self, name):
        if name == self._profile.currentData() and not self.is_running:
            self._clear_preview()

    def _ask_to_write(self):
        tally = self._tally
        return is_confirmed(
            self, "ThinPart_ReclassifyQuestion", QtWidgets.QMessageBox.Question,
            translate("ThinPart", "{} info files will be updated; {} parts change their category.").format(
                grouped(tally["differing"]), grouped(tally["changed"])),
            translate("ThinPart", "Measurements, notes, mesh settings and links stay unchanged. Write the info files "
                                  "now?"),
            QtWidgets.QMessageBox.Yes)

    def _clear_preview(self):
        """Discard the preview, because the choice has changed."""
        self._tally = None
        self._table.setRowCount(0)
        self._table.hide()
        self._show_message("")
        self._set_state(IDLE)

    def _set_state(self, state):
        self._state = state
        is_working = state in (PREVIEWING, WRITING)
        self.working_changed.emit(is_working)
        # The process may still run for a moment after its final message.
        ready = not is_working and not self.is_running
        for widget in (self._profile, self._file):
            widget.setEnabled(not is_working)
        self._preview.setEnabled(ready and bool(self._roots))
        self._write.setEnabled(ready and state == PREVIEWED and self._tally["differing"] > 0)
        self._cancel.setEnabled(is_working)
        self._bar.setVisible(is_working)

    def _add_table(self, column):
        self._table = QtWidgets.QTableWidget(0, 3, self)
        self._table.setObjectName("ThinPart_ReclassifyTable")
        self._table.setHorizontalHeaderLabels([
            translate("ThinPart", "Category"), translate("ThinPart", "Before"),
            translate("ThinPart", "After")])
        self._table.verticalHeader().hide()
        self._table.setEditTriggers(QtWidgets.QAbstractItemView.NoEditTriggers)
        self._table.setSelectionMode(QtWidgets.QAbstractItemView.NoSelection)
        self._table.setFocusPolicy(QtCore.Qt.NoFocus)
        self._table.setShowGrid(False)
        header = self._table.horizontalHeader()
        header.setSectionResizeMode(QtWidgets.QHeaderView.ResizeToContents)
        header.setSectionResizeMode(0, QtWidgets.QHeaderView.Stretch)
        column.addWidget(self._table, 10)
        column.addStretch(1)

    def _show_counts(self):
        before, after = self._tally["before"], self._tally["after"]
        names = sorted({*before, *after}, key=lambda name: (name == "unknown", name))
        profile = profile_from(self._content)
        self._table.show()
        self._table.setRowCount(len(names))
        for row, name in enumerate(names):
            title = QtWidgets.QTableWidgetItem(colour_icon(category_colour(name)),
                                               category_title(name, profile))
            self._table.setItem(row, 0, title)
            for column, counts in ((1, before), (2, after)):
                cell = QtWidgets.QTableWidgetItem(grouped(counts.get(name, 0)))
                cell.setTextAlignment(QtCore.Qt.AlignRight | QtCore.Qt.AlignVCenter)
                font = cell.font()
                font.setBold(before.get(name, 0) != after.get(name, 0))
                cell.setFont(font)
                self._table.setItem(row, column, cell)

    def _show_message(self, sentence):
        show_text(self._message, sentence)

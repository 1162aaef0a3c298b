"""Judging the parts of the libraries by other thresholds: first to look at it, then to keep it."""

from ..core.criteria import load_profile, profile_from
from ..core.errors import ThinPartError
from .flow_layout import FlowLayout
from .json_process import JsonProcess, started
from .profile_box import ProfileBox
from .push_button import add_button
from .qt import QtCore, QtWidgets, Signal, grouped, translate
from .question_box import is_confirmed
from .result_filter import colour_icon
from .result_view import show_text, text_line
from .sentences import translated
from .verdict_text import category_colour, category_title

IDLE, PREVIEWING, PREVIEWED, WRITING = range(4)


class ReclassifyPanel(QtWidgets.QWidget):
    """Thresholds, what they would change, and the button that writes it.

    Signals
    -------
    written
        Info files were updated.
    """

    written = Signal()

    def __init__(self, profile_name, parent=None):
        super().__init__(parent)
        self._roots, self._state, self._content, self._judged = [], IDLE, None, None
        self._notes = []
        self._process = JsonProcess("reclassify_worker", self)
        self._process.told.connect(self._take)
        self._process.ended.connect(self._lost)
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(4, 4, 4, 4)
        row = QtWidgets.QHBoxLayout()
        self._profile = ProfileBox(self)
        self._profile.setObjectName("ThinPart_ReclassifyProfile")
        self._profile.choose(profile_name)
        self._profile.currentIndexChanged.connect(lambda _: self._forget())
        row.addWidget(self._profile, 1)
        self._file = add_button(
            row, self, "ThinPart_ReclassifyFile", translate("ThinPart", "From file\u2026"),
            self._profile.ask_for_file)
        column.addLayout(row)
        place = QtWidgets.QWidget(self)
        row = FlowLayout(place)
        self._preview = add_button(
            row, self, "ThinPart_ReclassifyPreview", translate("ThinPart", "Preview"), self.preview)
        self._write = add_button(
            row, self, "ThinPart_ReclassifyWrite", translate("ThinPart", "Write\u2026"), self.write)
        self._cancel = add_button(
            row, self, "ThinPart_ReclassifyCancel", translate("ThinPart", "Cancel"), self.cancel)
        column.addWidget(place)
        self._bar = QtWidgets.QProgressBar(self)
        self._bar.setObjectName("ThinPart_ReclassifyBar")
        column.addWidget(self._bar)
        self._message = text_line(self, column, "ThinPart_ReclassifyMessage")
        self._add_table(column)
        self._forget()

    @property
    def is_running(self):
        """Whether libraries are being judged."""
        return self._process.is_running

    def set_roots(self, roots):
        """What is judged from now on."""
        if roots != self._roots:
            self._roots = list(roots)
            if not self.is_running:
                self._forget()

    def preview(self):
        """Judge everything and write nothing."""
        try:
            self._content = load_profile(self._profile.currentData()).content
        except ThinPartError as error:
            self._say(translated(error))
            return
        self._run(PREVIEWING)

    def write(self):
        """Write, once the user has agreed, what the preview showed."""
        if self._confirmed():
            self._run(WRITING)

    def cancel(self):
        """Stop; what was written stays."""
        self._process.say(ask="stop")
        self._cancel.setEnabled(False)

    def end(self):
        """Stop without a word."""
        self._process.end()
        self._forget()

    def _run(self, state):
        self._judged, self._notes = None, []
        sentence = started(self._process)
        if sentence:
            self._say(sentence)
            return
        self._process.say(roots=self._roots, profile=self._content, write=state == WRITING)
        self._enter(state)
        self._bar.setRange(0, 0)
        self._say("")

    def _take(self, content):
        if "problem" in content:
            self._notes.append(translated(content["problem"]))
            return
        self._judged = content["judged"]
        self._bar.setRange(0, max(1, self._judged["total"]))
        self._bar.setValue(self._judged["done"])
        self._show_counts()
        if "ended" in content:
            self._show_end(content["ended"] == "stopped")

    def _show_end(self, stopped):
        judged, was_writing = self._judged, self._state == WRITING
        sentences = list(self._notes)
        if stopped and was_writing:
            sentences.append(translate("ThinPart", "Stopped: {} of {} info files are up to date.").format(
                grouped(judged["done"] - judged["failed"]), grouped(judged["total"])))
        elif stopped:
            sentences.append(translate("ThinPart", "Stopped after {} of {} info files.").format(
                grouped(judged["done"]), grouped(judged["total"])))
        elif was_writing:
            sentences.append(translate("ThinPart", "{} info files were updated.").format(
                grouped(judged["differing"])))
        else:
            sentences.append(translate(
                "ThinPart", "{} of {} parts change their category; {} info files would be updated.").format(
                grouped(judged["changed"]), grouped(sum(judged["after"].values())),
                grouped(judged["differing"])))
        if judged["failed"]:
            sentences.append(translate("ThinPart", "{} info files were left as they are: {}").format(
                grouped(judged["failed"]), " ".join(map(translated, judged["errors"][:3]))))
        self._say("\n".join(sentences))
        self._enter(PREVIEWED if not was_writing and not stopped else IDLE)
        if was_writing:
            self.written.emit()

    def _lost(self, sentence):
        if sentence:
            was_writing = self._state == WRITING
            self._enter(IDLE)
            self._say(sentence)
            if was_writing:
                self.written.emit()
        else:
            self._enter(self._state)

    def _confirmed(self):
        judged = self._judged
        return is_confirmed(
            self, "ThinPart_ReclassifyQuestion", QtWidgets.QMessageBox.Question,
            translate("ThinPart", "{} info files will be updated; {} parts change their category.").format(
                grouped(judged["differing"]), grouped(judged["changed"])),
            translate("ThinPart", "What was measured, notes, mesh settings and links stay as they are. Write "
                      "them now?"),
            QtWidgets.QMessageBox.Yes)

    def _forget(self):
        """What was previewed is not what is chosen now."""
        self._judged = None
        self._table.setRowCount(0)
        self._table.hide()
        self._say("")
        self._enter(IDLE)

    def _enter(self, state):
        self._state = state
        at_work = state in (PREVIEWING, WRITING)
        # The process that has told its end may still be there for a moment.
        ready = not at_work and not self.is_running
        for each in (self._profile, self._file):
            each.setEnabled(not at_work)
        self._preview.setEnabled(ready and bool(self._roots))
        self._write.setEnabled(ready and state == PREVIEWED and self._judged["differing"] > 0)
        self._cancel.setEnabled(at_work)
        self._bar.setVisible(at_work)

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
        before, after = self._judged["before"], self._judged["after"]
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

    def _say(self, sentence):
        show_text(self._message, sentence)

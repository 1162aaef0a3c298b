# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reclassifies the parts of the libraries by another profile: what would change is shown before it is written."""

from ...core.errors import ThinPartError
from ...core.judging.criteria import load_profile
from ..application import lifelong
from ..application.qt import QtWidgets, Signal, grouped, translate
from ..application.sentences import translated
from ..record.kept_room import keep_room
from ..record.record_view import show_text, text_line
from ..widgets.buttons import add_button, small_button
from ..widgets.confirmation import is_confirmed
from ..widgets.edit_profile_button import edit_profile_button
from ..widgets.flow_layout import add_flow
from ..widgets.profile_combo import ProfileCombo
from .changes_view import ChangesView


class ReclassifyPage(QtWidgets.QWidget):
    """The choice of a profile, what it would change, and the button that writes it.

    Attributes
    ----------
    view : ChangesView

    Signals
    -------
    writing_changed(bool)
        Whether info files are being updated.
    written
        Info files were updated.
    """

    writing_changed = Signal(bool)
    written = Signal()

    def __init__(self, profile_name, parent=None):
        super().__init__(parent)
        self._roots, self._is_open, self._counted = [], False, None
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(4, 4, 4, 4)
        row = QtWidgets.QHBoxLayout()
        self._profile = ProfileCombo(self)
        self._profile.setObjectName("ThinPart_ReclassifyProfile")
        self._profile.choose(profile_name)
        self._profile.currentIndexChanged.connect(lambda _: self._judge())
        row.addWidget(self._profile, 1)
        self._file = add_button(
            row, self, "ThinPart_ReclassifyFile", translate("ThinPart", "From file\u2026"),
            self._profile.ask_for_file)
        row.addWidget(edit_profile_button(self, "ThinPart_ReclassifyEdit", self._profile.currentData))
        column.addLayout(row)
        row = add_flow(column, self)
        self._write = add_button(
            row, self, "ThinPart_ReclassifyWrite", translate("ThinPart", "Write\u2026"), self.write)
        self._cancel = add_button(
            row, self, "ThinPart_ReclassifyCancel", translate("ThinPart", "Cancel"), self.cancel)
        self._again = small_button(self, "ThinPart_ReclassifyReadAgain", "\u21bb", translate(
            "ThinPart", "Read the info files again, which may have changed"), self._open)
        row.addWidget(self._again)
        self._bar = QtWidgets.QProgressBar(self)
        self._bar.setObjectName("ThinPart_ReclassifyWriteBar")
        column.addWidget(self._bar)
        keep_room(self._bar)
        self.view = ChangesView("Reclassify", self)
        column.addWidget(self.view, 1)
        self._message = text_line(self, column, "ThinPart_ReclassifyMessage")
        self._client = self.view.client
        self._client.counted.connect(self._on_counted)
        self._client.written.connect(self._on_written)
        self._client.failed.connect(self._on_failed)
        lifelong.profile_signals.saved.connect(self._on_profile_saved)
        self._show_state()

    @property
    def is_waiting(self):
        """Whether something is counted or written."""
        return self._client.is_waiting

    def showEvent(self, event):
        """Count when the page is shown."""
        super().showEvent(event)
        if not self._is_open:
            self._open()

    def set_roots(self, roots):
        """Set the libraries to reclassify."""
        if roots != self._roots:
            self._roots = list(roots)
            if self.isVisible() and not self._client.is_writing:
                self._open()
            else:
                self._is_open = False

    def choose(self, name):
        """Choose a profile: name of a shipped one, or path of a file."""
        if not self._client.is_writing:
            self._profile.choose(name)

    def write(self):
        """Write what was counted after confirmation."""
        if self._ask_to_write():
            self._client.write()
            self._bar.setRange(0, 0)
            self._show_message("")
            self._show_state()

    def cancel(self):
        """Stop; files already written stay so."""
        self._client.stop_writing()
        self._cancel.setEnabled(False)

    def end(self):
        """Stop counting; an info file that is being written is finished."""
        self._client.end()
        self._is_open, self._counted = False, None
        self._show_state()

    def _open(self):
        self._is_open, self._counted = True, None
        self.view.open(self._roots, translate("ThinPart", "Add a folder with classified parts under 'Libraries'."))
        self._judge()

    def _judge(self):
        if not self._is_open:
            return
        self._counted = None
        self._show_message("")
        try:
            self.view.show_profile(load_profile(self._profile.currentData()))
        except ThinPartError as error:
            self.view.show_profile(None, translated(error))
        self._show_state()

    def _on_counted(self, counted):
        self._counted = counted if counted["read"] == counted["total"] else None
        self._show_state()

    def _on_written(self, written):
        self._bar.setRange(0, max(1, written["total"]))
        self._bar.setValue(written["done"])
        if written["ended"]:
            self._counted = None
            self._show_end(written)
            self._show_state()
            self.written.emit()

    def _show_end(self, written):
        if written["done"] < written["total"]:
            sentence = translate("ThinPart", "Stopped: {} of {} info files are up to date.").format(
                grouped(written["done"] - written["failed"]), grouped(written["total"]))
        else:
            sentence = translate("ThinPart", "{} info files were updated.").format(grouped(written["changed"]))
        problems = " ".join(map(translated, written["problems"][:3]))
        if written["failed"]:
            problems = translate("ThinPart", "{} info files were not changed: {}").format(
                grouped(written["failed"]), problems)
        self._show_message("\n".join(filter(None, (sentence, problems))))

    def _on_failed(self, sentence):
        was_writing = not self._cancel.isHidden()
        self._counted = None
        if was_writing:
            self._show_message(sentence)
        self._show_state()
        if was_writing:
            self.written.emit()

    def _on_profile_saved(self, name):
        if name == self._profile.currentData() and not self._client.is_writing:
            self._judge()

    def _ask_to_write(self):
        changed = sum(count for *_, count in self._counted["changes"])
        return is_confirmed(
            self, "ThinPart_ReclassifyQuestion", QtWidgets.QMessageBox.Question,
            translate("ThinPart", "{} info files will be updated; {} parts change their category.").format(
                grouped(self._counted["files"]), grouped(changed)),
            translate("ThinPart", "Measurements, notes, mesh settings and links stay unchanged. Write the info files "
                                  "now?"),
            QtWidgets.QMessageBox.Yes)

    def _show_state(self):
        is_writing = self._client.is_writing
        self.writing_changed.emit(is_writing)
        for widget in (self._profile, self._file, self._again):
            widget.setEnabled(not is_writing)
        self._write.setEnabled(not is_writing and bool(self._counted and self._counted["files"]))
        self._cancel.setVisible(is_writing)
        self._cancel.setEnabled(is_writing)
        self._bar.setVisible(is_writing)

    def _show_message(self, sentence):
        show_text(self._message, sentence)

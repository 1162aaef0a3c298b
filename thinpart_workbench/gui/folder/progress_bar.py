# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shows the progress of a folder classification."""

from ..application.numbers import duration
from ..application.qt import QtWidgets, translate
from ..record.record_view import text_line


class RunProgressBar(QtWidgets.QWidget):
    """A bar, and a text with the number of done, failed and unchanged files and the time."""

    def __init__(self, parent=None):
        super().__init__(parent)
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(2)
        self._bar = QtWidgets.QProgressBar(self)
        self._bar.setObjectName("ThinPart_FolderBar")
        self._bar.setTextVisible(False)
        column.addWidget(self._bar)
        self._label = text_line(self, column, "ThinPart_FolderProgress")
        self._progress = None

    @property
    def text(self):
        """The current text."""
        return self._label.text()

    def show_searching(self):
        """Show that the number of files is not known yet."""
        self._progress = None
        self._bar.setRange(0, 0)
        self._label.setText(translate("ThinPart", "Looking for parts in the folder\u2026"))

    def show_progress(self, progress):
        """Show a ``progress`` entry of the command line."""
        self._progress = progress
        self._bar.setRange(0, max(1, progress["total"]))
        self._bar.setValue(progress["done"])
        self._label.setText(", ".join(_counts(progress) + _time_left(progress)))

    def show_waiting(self, sentence):
        """Show that the run is paused, or about to pause or stop."""
        words = _counts(self._progress) if self._progress else []
        self._label.setText(", ".join([*words, sentence]))

    def show_end(self, sentence):
        """Show the number of files, the duration, and a final message."""
        if self._progress is None:
            self._bar.setRange(0, 1)
            self._label.setText(sentence)
            return
        taken = translate("ThinPart", "in {}").format(duration(self._progress["seconds"]))
        self._label.setText(", ".join([*_counts(self._progress), taken, *filter(None, [sentence])]))


def _counts(progress):
    words = [translate("ThinPart", "{} of {} files").format(progress["done"], progress["total"])]
    if progress["failed"]:
        words.append(translate("ThinPart", "{} failed").format(progress["failed"]))
    if progress["reused"]:
        words.append(translate("ThinPart", "{} unchanged").format(progress["reused"]))
    return words


def _time_left(progress):
    if progress["seconds_left"] is None or progress["done"] == progress["total"]:
        return []
    return [translate("ThinPart", "about {} left").format(duration(progress["seconds_left"]))]

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Progress of a document's measurement, with a button to cancel it."""

import time

from ..application.numbers import duration
from ..application.qt import QtWidgets, Signal, translate
from ..widgets.buttons import add_button
from ..widgets.controls import STOPS
from .record_view import show_text, text_line

_FIRST_ESTIMATE = 0.1
"""Fraction of the work from which on the time left is estimated by what the work before has taken."""


class MeasuringProgress(QtWidgets.QWidget):
    """A sentence, a bar and a button.

    Signals
    -------
    cancelled
        The button was clicked.
    """

    cancelled = Signal()

    def __init__(self, parent=None):
        super().__init__(parent)
        self.setObjectName("ThinPart_Progress")
        rows = QtWidgets.QVBoxLayout(self)
        rows.setContentsMargins(0, 0, 0, 0)
        self._begun, self._fraction, self._are_coarse = 0.0, 0.0, False
        self._stage = text_line(self, rows, "ThinPart_Stage")
        self._first_colours = text_line(self, rows, "ThinPart_FirstColours")
        row = QtWidgets.QHBoxLayout()
        self._bar = QtWidgets.QProgressBar(self)
        self._bar.setObjectName("ThinPart_ProgressBar")
        self._bar.setRange(0, 1000)
        row.addWidget(self._bar, 1)
        rows.addLayout(row)
        cancel = add_button(row, self, "ThinPart_CancelButton", translate("ThinPart", "Cancel"), self.cancelled.emit)
        cancel.setProperty(STOPS, True)

    def begin(self, label):
        """Show the widget at the start of a measurement."""
        self._begun, self._fraction, self._are_coarse = time.monotonic(), 0.0, False
        show_text(self._first_colours, "")
        self.show()
        self.show_progress(0.0, translate("ThinPart", "Starting to measure {}").format(label))

    def show_progress(self, fraction, stage):
        """Show the fraction done and a text about the current step."""
        # A part whose verdict is uncertain is measured again, which is no step back.
        self._fraction = max(self._fraction, fraction)
        self._bar.setValue(round(1000 * self._fraction))
        self._stage.setText(stage)
        if self._are_coarse:
            self._show_time_left()

    def show_first_colours(self, are_shown):
        """Say that the colours in the view are coarse, and when finer ones come; or no longer."""
        self._are_coarse = are_shown
        if are_shown:
            self._show_time_left()
        else:
            show_text(self._first_colours, "")

    def _show_time_left(self):
        if self._fraction < _FIRST_ESTIMATE:
            text = translate("ThinPart", "First, coarse colours; finer ones follow.")
        else:
            left = (time.monotonic() - self._begun) * (1.0 / self._fraction - 1.0)
            text = translate("ThinPart", "First, coarse colours; finer ones follow, about {} left.").format(duration(left))
        show_text(self._first_colours, text)

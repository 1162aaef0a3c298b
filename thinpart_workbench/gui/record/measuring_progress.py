"""Progress of a document's measurement, with a button to cancel it."""

from ..application.qt import QtWidgets, Signal, translate
from ..widgets.push_button import add_button
from .record_view import text_line


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
        self._stage = text_line(self, rows, "ThinPart_Stage")
        row = QtWidgets.QHBoxLayout()
        self._bar = QtWidgets.QProgressBar(self)
        self._bar.setObjectName("ThinPart_ProgressBar")
        self._bar.setRange(0, 1000)
        row.addWidget(self._bar, 1)
        rows.addLayout(row)
        add_button(row, self, "ThinPart_CancelButton", translate("ThinPart", "Cancel"), self.cancelled.emit)

    def begin(self, label):
        """Show the widget at the start of a measurement."""
        self.show()
        self.show_progress(0.0, translate("ThinPart", "Starting to measure {}").format(label))

    def show_progress(self, fraction, stage):
        """Show the fraction done and a text about the current step."""
        self._bar.setValue(round(1000 * fraction))
        self._stage.setText(stage)

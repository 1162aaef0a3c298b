"""How much of a document is measured, and the button that stops it."""

from .push_button import add_button
from .qt import QtWidgets, Signal, translate
from .result_view import text_line


class MeasuringProgress(QtWidgets.QWidget):
    """A sentence, a bar and a button.

    Signals
    -------
    cancelled
        The button was pressed.
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
        """Show that a part is going to be measured."""
        self.show()
        self.show_progress(0.0, translate("ThinPart", "Starting to measure {}").format(label))

    def show_progress(self, fraction, stage):
        """How much is done, and what is being done."""
        self._bar.setValue(round(1000 * fraction))
        self._stage.setText(stage)

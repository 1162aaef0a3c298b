"""The panel in FreeCAD's task view: progress, one result or one sentence, and the info file."""

from pathlib import Path

import FreeCADGui as Gui

from ..freecad_adapter.edge import guarded_methods
from .measuring_progress import MeasuringProgress
from .part_list import PartList
from .qt import QtCore, QtGui, QtWidgets, Signal, number_of, translate
from .result_view import ResultView, show_text, text_line

ICON = Path(__file__).resolve().parents[2] / "resources" / "icons" / "ThinPart_Classify.svg"


class PanelForm(QtWidgets.QWidget):
    """The widgets. They show what they are told, and tell which button was pressed.

    Signals
    -------
    cancelled, save_asked, again_asked
        The button of that name was pressed.
    """

    cancelled = Signal()
    save_asked = Signal()
    again_asked = Signal()

    def __init__(self):
        super().__init__()
        self.setObjectName("ThinPart_Panel")
        self.setWindowTitle(translate("ThinPart", "Classify part"))
        self.setWindowIcon(QtGui.QIcon(str(ICON)))
        column = QtWidgets.QVBoxLayout(self)
        # The task view has margins of its own, and not much room.
        column.setContentsMargins(6, 6, 6, 6)
        self.message = text_line(self, column, "ThinPart_Message")
        self._progress = MeasuringProgress(self)
        self._progress.cancelled.connect(self.cancelled)
        column.addWidget(self._progress)
        self.parts = PartList(self)
        column.addWidget(self.parts)
        self.result = ResultView(self)
        column.addWidget(self.result)
        self.info_text = text_line(self, column, "ThinPart_InfoText")
        self.save_button = self._button(
            column, "ThinPart_SaveButton", translate("ThinPart", "Save and write info file"),
            self.save_asked)
        self.again_button = self._button(
            column, "ThinPart_AgainButton", translate("ThinPart", "Classify again"),
            self.again_asked)
        column.addStretch(1)
        self.show_message("")

    def show_message(self, sentence):
        """Show one sentence and nothing else."""
        show_text(self.message, sentence)
        self._progress.hide()
        self.parts.hide()
        self.result.hide()
        self.show_info("")

    def show_running(self, label):
        """Show that a part is being measured."""
        self.show_message("")
        self._progress.begin(label)

    def show_progress(self, fraction, stage):
        """How much is done, and what is being done."""
        self._progress.show_progress(fraction, stage)

    def show_result(self, record, profile, unit):
        """Show a part record, lengths in a unit; progress stays while other parts are being measured."""
        show_text(self.message, "")
        self.result.show_record(record, profile, unit)
        self.result.show()

    def show_part(self, record, profile, failure, unit):
        """Show the record of a part, or why there is none; whatever else is going on goes on."""
        show_text(self.message, failure)
        self.result.setVisible(record is not None)
        if record is not None:
            self.result.show_record(record, profile, unit)

    def show_ended(self, sentence=""):
        """Measuring is over; a sentence where it ended otherwise than it should."""
        self._progress.hide()
        show_text(self.message, sentence)

    def show_info(self, sentence, can_save=False, can_repeat=False, tool_tip=""):
        """Say what became of the info file, and offer what can be done about it."""
        show_text(self.info_text, sentence)
        self.info_text.setToolTip(tool_tip)
        self.save_button.setVisible(can_save)
        self.again_button.setVisible(can_repeat)

    def _button(self, layout, name, text, signal):
        button = QtWidgets.QPushButton(text, self)
        button.setObjectName(name)
        button.clicked.connect(signal)
        layout.addWidget(button)
        return button


@guarded_methods(reject=True)
class TaskPanel(QtCore.QObject):
    """What FreeCAD's task view wants to hold.

    Parameters
    ----------
    form : QWidget or list of QWidget
        A box of the task view each.

    Signals
    -------
    closed
        The panel is gone, whoever took it away.

    Notes
    -----
    FreeCAD calls methods of some names itself, such as ``open``, ``accept`` and ``clicked``.
    """

    closed = Signal()

    def __init__(self, form):
        super().__init__()
        self.form = form
        self._is_open = False

    @property
    def is_open(self):
        """Whether the panel is in the task view."""
        return self._is_open

    def show(self):
        """Show the panel.

        Raises
        ------
        RuntimeError
            When another task is open.
        """
        Gui.Control.showDialog(self)
        self._is_open = True
        first = self.form[0] if isinstance(self.form, list) else self.form
        first.destroyed.connect(self._gone)

    def hide(self):
        """Take the panel away."""
        if self._is_open:
            self._gone()
            Gui.Control.closeDialog()

    def reject(self):
        """FreeCAD's Close button or Esc."""
        self.hide()
        return True

    def getStandardButtons(self):
        """There is nothing to accept: one button closes."""
        return number_of(QtWidgets.QDialogButtonBox.Close)

    def isAllowedAlterSelection(self):
        """The user goes on working while this is open."""
        return True

    def isAllowedAlterView(self):
        """See `isAllowedAlterSelection`."""
        return True

    def isAllowedAlterDocument(self):
        """See `isAllowedAlterSelection`."""
        return True

    def _gone(self, *_):
        if self._is_open:
            self._is_open = False
            self.closed.emit()

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel of a classification: progress, a result or a message, and the info file."""

from ..application.icons import icon
from ..application.qt import QtWidgets, Signal, translate
from ..record.kept_room import LeftRoom, keep_room
from ..record.measuring_progress import MeasuringProgress
from ..record.parts_table import PartsTable
from ..record.record_view import RecordView, show_text, text_line
from ..widgets.buttons import add_button
from .known_box import KnownBox


class ClassifyPanel(QtWidgets.QWidget):
    """The widgets of the panel, without logic: the controller fills them and handles their signals.

    Attributes
    ----------
    progress : MeasuringProgress
    known : KnownBox

    Signals
    -------
    cancelled, save_requested, repeat_requested
        The corresponding button was pressed.
    """

    cancelled = Signal()
    save_requested = Signal()
    repeat_requested = Signal()

    def __init__(self):
        super().__init__()
        self.setObjectName("ThinPart_Panel")
        self.setWindowTitle(translate("ThinPart", "Classify part"))
        self.setWindowIcon(icon("ThinPart_Classify"))
        column = QtWidgets.QVBoxLayout(self)
        # The task view is narrow and has its own margins.
        column.setContentsMargins(6, 6, 6, 6)
        self.progress = MeasuringProgress(self)
        self._room = LeftRoom(self.progress, self)
        self.progress.cancelled.connect(self.cancelled)
        column.addWidget(self.progress)
        self.parts = PartsTable(self)
        column.addWidget(self.parts)
        self.result = RecordView(self)
        column.addWidget(self.result)
        self.save_button = add_button(column, self, "ThinPart_SaveButton", translate(
            "ThinPart", "Save and write info file"), self.save_requested.emit)
        self.again_button = add_button(
            column, self, "ThinPart_AgainButton", translate("ThinPart", "Classify again"), self.repeat_requested.emit)
        # What is said comes when it comes: below all that is pressed.
        self.known = KnownBox(self)
        column.addWidget(self.known)
        self.message = text_line(self, column, "ThinPart_Message")
        self.info_text = text_line(self, column, "ThinPart_InfoText")
        column.addStretch(1)
        self.show_message("")

    def show_message(self, sentence):
        """Show only a message."""
        show_text(self.message, sentence)
        self.progress.hide()
        self.parts.hide()
        self.result.hide()
        self.known.show_known(None, "")
        self.show_info("")

    def show_running(self, label):
        """Show that a part is being measured."""
        self.show_message("")
        self._room.show()
        self.progress.begin(label)

    def show_result(self, record, profile, unit):
        """Show a part record, with lengths in a unit; progress stays visible while other parts are measured."""
        show_text(self.message, "")
        self.result.show_record(record, profile, unit)
        self.result.show()

    def show_part(self, record, profile, failure, unit):
        """Show the record of a part, or why there is none, without affecting the progress."""
        show_text(self.message, failure)
        self.result.setVisible(record is not None)
        if record is not None:
            self.result.show_record(record, profile, unit)

    def show_ended(self, sentence=""):
        """Hide the progress; show a message if measuring did not end normally."""
        self._room.hide()
        show_text(self.message, sentence)

    def show_info(self, sentence, can_save=False, can_repeat=False, tool_tip=""):
        """Show the state of the info file and the actions available for it."""
        show_text(self.info_text, sentence)
        self.info_text.setToolTip(tool_tip)
        if can_save:
            keep_room(self.save_button)  # the other one does not take its place
        self.save_button.setVisible(can_save)
        self.again_button.setVisible(can_repeat)

"""One press of 'Show thickness': from the click to the map in the window and its panel."""

from ..core.errors import ThinPartError
from .qt import QtCore, translate
from .sentences import translated
from .thickness_measuring import ThicknessMeasuring
from .thickness_panel import ThicknessPanel


class ThicknessSession(QtCore.QObject):
    """Measures parts and shows their map in a panel, or shows a map that there is.

    Parameters
    ----------
    document : FreeCAD.Document or None
    thickness : FreeCAD.DocumentObject, optional
        The map to show; without it, parts are measured.
    """

    def __init__(self, document, thickness=None):
        super().__init__()
        self._thickness = thickness
        self._measuring = ThicknessMeasuring(document, self)
        measured = self._measuring.measured
        measured.info_file_changed.connect(self._show_info_file)
        self._measuring.ended.connect(self._show_end)
        # The map has just come into the view: the window has its turn before the boxes are filled.
        self._soon = QtCore.QTimer(self, singleShot=True, interval=0)
        self._soon.timeout.connect(self._show_measured)
        # The same for the panel, before the part is written for the process that measures it.
        self._opened = QtCore.QTimer(self, singleShot=True, interval=0)
        self._opened.timeout.connect(self.measure)
        self._boxes = ThicknessPanel(self)
        self.panel = self._boxes.panel
        head = self._boxes.head
        measured.progressed.connect(head.show_progress)
        head.cancelled.connect(self._cancel)
        head.save_asked.connect(measured.save)
        head.again_asked.connect(self.measure)
        self.panel.closed.connect(self._leave)

    @property
    def measured(self):
        """The `MeasuredDocument`."""
        return self._measuring.measured

    @property
    def document_name(self):
        """Name of the document, None where there is none."""
        return self.measured.name

    @property
    def is_running(self):
        """Whether something is being measured."""
        return self.measured.is_running

    @property
    def shown(self):
        """The map that the panel is about, or None."""
        return self._boxes.thickness

    def start(self):
        """Open the panel, and start to measure soon if there is no map to show."""
        self._boxes.begin()
        if self._thickness is None:
            self._opened.start()
        else:
            self._boxes.show_map(self._thickness)

    def measure(self):
        """Measure what the map that is shown is made of, or else what is selected."""
        try:
            if self.shown is not None:
                self._measuring.start_again(self.shown)
            else:
                self._measuring.start_selected()
        except ThinPartError as error:
            self._boxes.head.show_message(translated(error), can_repeat=self.document_name is not None)
            return
        self._boxes.head.show_running(self._measuring.first_label)

    def close(self):
        """End everything and take the panel away."""
        self._leave()
        self.panel.hide()

    def _cancel(self):
        self._measuring.stop()
        self._boxes.head.show_message(translate("ThinPart", "Cancelled. Nothing was changed."),
                                      can_repeat=True)

    def _show_end(self, thickness, sentence):
        self._boxes.head.show_message(sentence, can_repeat=bool(sentence))
        if thickness is not None:
            self._thickness = thickness
            self._soon.start()

    def _show_measured(self):
        self._boxes.show_map(self._thickness)

    def _show_info_file(self, state):
        self._boxes.head.show_info_file(state.sentence, state.can_save, state.tool_tip)

    def _leave(self):
        self._opened.stop()
        self._soon.stop()
        self._measuring.leave()
        self._boxes.leave()

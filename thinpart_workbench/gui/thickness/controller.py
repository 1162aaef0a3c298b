# SPDX-License-Identifier: LGPL-2.1-or-later
"""Controls one session of 'Show thickness': from the command to the map and its panel."""

from ...core.errors import ThinPartError
from ...freecad_adapter.objects.thickness_object import thickness_objects
from ..application.qt import QtCore, translate
from ..application.sentences import translated
from ..document.active_task import THICKNESS, begin_session
from ..document.task_controller import MeasuringController
from ..view3d.shown_map import show_alone
from .measurement import ThicknessMeasurement, coarse_sentence
from .panel import ThicknessPanel


class ThicknessController(MeasuringController):
    """Measures parts and shows their map in a panel, or shows an existing map.

    Without a map to show, parts are measured.

    Parameters
    ----------
    document : FreeCAD.Document or None
    thickness : FreeCAD.DocumentObject, optional
        The map.
    is_asked_for : bool, optional
        Whether the user wants to see the map. Otherwise the views stay as they are, and the keyboard acts where it did.
    """

    def __init__(self, document, thickness=None, is_asked_for=True):
        super().__init__()
        self._thickness, self._is_asked_for = thickness, is_asked_for
        self._measuring = ThicknessMeasurement(document, self, with_first_colours=True)
        measured = self._measuring.measured
        measured.info_file_changed.connect(self._show_info_file)
        self._measuring.ended.connect(self._show_end)
        # Return to the event loop between showing the map and filling the boxes.
        self._show_timer = QtCore.QTimer(self, singleShot=True, interval=0)
        self._show_timer.timeout.connect(self._show_measured)
        # Likewise between opening the panel and writing the part for the worker process.
        self._measure_timer = QtCore.QTimer(self, singleShot=True, interval=0)
        self._measure_timer.timeout.connect(self.measure)
        self._boxes = ThicknessPanel(self)
        self.panel = self._boxes.panel
        head = self._boxes.head
        measured.progressed.connect(self._show_progress)
        measured.first_mapped.connect(lambda *_: head.progress.show_first_colours(self._measuring.shows_first_colours))
        head.cancelled.connect(self._cancel)
        head.save_requested.connect(measured.save)
        head.repeat_requested.connect(self.measure)
        head.measure_chosen.connect(self.measure)
        self.panel.closed.connect(self._leave)

    @property
    def measured(self):
        """The `DocumentMeasurement`."""
        return self._measuring.measured

    @property
    def shown(self):
        """The map shown in the panel, or None."""
        return self._boxes.thickness

    def start(self):
        """Open the panel; without a map to show, schedule a measurement."""
        self._boxes.begin(self._is_asked_for)
        if self._thickness is None:
            self._measure_timer.start()
        else:
            if self._is_asked_for:
                show_alone(self._thickness)
            self._boxes.show_map(self._thickness)

    def follow(self, document):
        """Show the map that is seen in another document; returns whether there is one."""
        seen = [each for each in thickness_objects(document) if each.ViewObject.Visibility]
        if seen:
            begin_session(THICKNESS, ThicknessController, document, seen[-1], False)
        return bool(seen)

    def measure(self, shown_measure=None):
        """Measure the sources of the shown map, or else the selected parts; by one of `SHOWN_MEASURES` if given."""
        try:
            if self.shown is not None:
                self._measuring.start_again(self.shown, shown_measure)
            else:
                self._measuring.start_selected()
        except ThinPartError as error:
            self._boxes.head.show_message(translated(error), can_repeat=self.document_name is not None)
            self._show_measure()
            return
        self._boxes.head.show_running(self._measuring.first_label)

    def _cancel(self):
        self._measuring.stop()
        sentences = [translate("ThinPart", "Cancelled. Nothing was changed.")]
        if self._measuring.shows_first_colours:
            sentences.append(coarse_sentence())
        self._boxes.head.show_message("\n".join(sentences), can_repeat=True)
        self._show_measure()

    def _show_progress(self, fraction, stage):
        progress = self._boxes.head.progress
        progress.show_first_colours(self._measuring.shows_first_colours)
        progress.show_progress(fraction, stage)

    def _show_measure(self):
        """Show how the shown map was measured, also where another measure was chosen and nothing came of it."""
        if self.shown is not None:
            self._boxes.head.show_measure(self.shown.Measure)

    def _show_end(self, thickness, sentence):
        self._boxes.head.show_message(sentence, can_repeat=bool(sentence))
        self._show_measure()
        if thickness is not None:
            self._thickness = thickness
            self._show_timer.start()

    def _show_measured(self):
        self._boxes.show_map(self._thickness)

    def _show_info_file(self, state):
        self._boxes.head.show_info_file(state.sentence, state.can_save, state.tool_tip)
        if self._measuring.measured.info_file:
            self._boxes.read_notes()

    def _leave(self):
        self._measure_timer.stop()
        self._show_timer.stop()
        self._measuring.leave()
        self._boxes.leave()

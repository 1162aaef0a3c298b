"""One classification in the window: from the click to the colours and the info file."""

import FreeCADGui as Gui

from ..core.errors import ThinPartError
from ..freecad_adapter.active_part import parts_meant
from ..freecad_adapter.face_owners import face_owners
from ..freecad_adapter.thin_colours import preferred_colours
from .chosen_in_window import active_place, selected_places
from .face_colours import FACE_COLOURS
from .length_unit import length_unit
from .measured_document import MeasuredDocument
from .part_dialog import ask_for_part
from .part_list import part_rows
from .qt import QtCore, translate
from .sentences import translated
from .task_panel import PanelForm, TaskPanel
from .unit_watch import UNITS


class ClassificationSession(QtCore.QObject):
    """Measures a document's parts, the chosen one first, and shows what came out in a panel.

    Parameters
    ----------
    document : FreeCAD.Document or None

    Attributes
    ----------
    measured : MeasuredDocument
    """

    def __init__(self, document):
        super().__init__()
        self.measured = MeasuredDocument(document, self)
        self.measured.progressed.connect(self._show_progress)
        self.measured.measured.connect(self._show_measured)
        self.measured.ended.connect(self._show_end)
        self.measured.info_file_changed.connect(self._show_info_file)
        self._is_left = self._has_legend = False
        self._shown = None  # name of the part whose result is to be seen
        self._form = PanelForm()
        self.panel = TaskPanel(self._form)
        self._form.cancelled.connect(self.cancel)
        self._form.save_asked.connect(self.measured.save)
        self._form.again_asked.connect(self._again)
        self._form.parts.part_chosen.connect(self._show_part)
        self.panel.closed.connect(self._leave)
        UNITS.changed.connect(self._show_unit)

    @property
    def document_name(self):
        """Name of the document, None where there is none."""
        return self.measured.name

    @property
    def is_running(self):
        """Whether something is being measured."""
        return self.measured.is_running

    def record_of(self, document_name, part_name):
        """The record of a part of the document, None where it is another document or not measured."""
        if self._analysis is None or document_name != self.document_name:
            return None
        return self._analysis.records.get(part_name)

    def start(self):
        """Find out which part is meant, open the panel and start to measure.

        Returns
        -------
        bool
            False where the user was asked for a part and named none.
        """
        try:
            analysis = self._new_analysis()
        except ThinPartError as error:
            self.panel.show()
            self._form.show_message(translated(error))
            return True
        if analysis is None:
            return False
        self.panel.show()
        self._measure(analysis)
        return True

    def cancel(self):
        """Stop measuring, as asked; what is there already stays."""
        self.measured.stop()
        if self._shown_record is None:
            self._form.show_message(translate("ThinPart", "Cancelled. Nothing was changed."))
            self._form.show_info("", can_repeat=True)
            return
        self._colour_all()
        self._form.show_ended()
        self._form.show_info(translate(
            "ThinPart", "Cancelled: no info file was written, since other parts of the document "
            "are not measured."), can_repeat=True)

    def close(self):
        """End everything and take the panel away."""
        self._leave()
        self.panel.hide()

    def _leave(self):
        if not self._is_left:
            self._is_left = True
            UNITS.changed.disconnect(self._show_unit)
        self.measured.leave()

    @property
    def _unit(self):
        return length_unit(self.measured.document)

    @property
    def _analysis(self):
        return self.measured.analysis

    @property
    def _shown_record(self):
        return self._analysis and self._analysis.shown.get(self._shown)

    def _new_analysis(self):
        document, content = self.measured.document, self.measured.content()
        selected, active = selected_places(document), active_place(document)
        candidates = parts_meant(document, content.parts, selected, active)
        chosen = candidates[0]
        if len(candidates) > 1 and selected:
            chosen = ask_for_part(candidates, Gui.getMainWindow())
        if chosen is None:
            return None
        return self.measured.analysis_of(content.parts, chosen, content.broken)

    def _measure(self, analysis):
        self._shown = analysis.chosen.name
        self._form.show_running(analysis.chosen.label)
        try:
            self.measured.measure(analysis)
        except ThinPartError as error:
            self._form.show_message(translated(error))
            return
        self._show_list()

    def _show_progress(self, fraction, stage):
        self._form.show_progress(fraction, stage)

    def _show_measured(self, name):
        self._show_list()
        if name != self._shown or self._shown_record is None:
            return  # a failure is told at the end
        self._form.show_result(self._shown_record, self._analysis.profile, self._unit)
        self._show_legend(self._colour([name]))

    def _show_part(self, name):
        """Show another part of the list; one that is not measured yet is shown when it is."""
        self._shown = name
        failure = self._analysis.failures.get(name)
        self._form.show_part(self._shown_record, self._analysis.profile,
                             translated(failure["message"]) if failure else "", self._unit)
        if self._shown_record is not None:
            self._show_legend(self._is_coloured(name))

    def _show_unit(self):
        """Lengths are written in another unit."""
        if self._analysis is not None:
            self._show_list()
            if self._shown_record is not None:
                self._form.result.show_record(self._shown_record, self._analysis.profile, self._unit)
                self._show_legend(self._has_legend)

    def _show_legend(self, is_coloured):
        self._has_legend = is_coloured
        own_limit = None if self._analysis.thin_limit is None else self._shown_record["thin_limit_mm"]
        self._form.result.show_legend(is_coloured, own_limit)

    def _show_list(self):
        self._form.parts.show_parts(part_rows(self._analysis), self._analysis.profile, self._unit)
        self._form.parts.select_part(self._shown)

    def _show_end(self, sentence):
        failure = self._analysis.failures.get(self._shown)
        if failure is not None and not sentence:
            sentence = translated(failure["message"])
        if not self._analysis.records:
            self._form.show_message(sentence)
            self._form.show_info("", can_repeat=True)
            return
        self._form.show_ended(sentence)
        self._colour_all()
        self.measured.write_info_file()

    def _show_info_file(self, state):
        self._form.show_info(state.sentence, state.can_save, state.can_repeat, state.tool_tip)

    def _colour_all(self):
        """Colour what is not coloured yet: the chosen part is, since it was measured."""
        if len(self._analysis.parts) > 1:
            self._colour(list(self._analysis.records))
            if self._shown_record is not None:
                self._show_legend(self._is_coloured(self._shown))

    def _colour(self, names):
        """Colour the thin faces of parts; whether there are any."""
        if not self.measured.is_as_measured():
            return False
        document, owners = self.measured.document, {}
        for name in names:
            colours = preferred_colours(self._analysis.shown[name])
            for owner, indices in face_owners(document, self._part(name)):
                # One object may draw several parts, such as a compound.
                known = owners.setdefault(owner.Name, (owner, {}))[1]
                known.update({indices[face]: rgb for face, rgb in colours.items()})
        FACE_COLOURS.show(document, list(owners.values()))
        return any(self._is_coloured(name) for name in names)

    def _is_coloured(self, name):
        return bool(preferred_colours(self._analysis.shown[name])) and any(
            FACE_COLOURS.is_coloured(owner)
            for owner, _ in face_owners(self.measured.document, self._part(name)))

    def _part(self, name):
        return next(part for part in self._analysis.parts if part.name == name)

    def _again(self):
        try:
            analysis = self._new_analysis()
        except ThinPartError as error:
            self._form.show_message(translated(error))
            return
        if analysis is not None:
            self._measure(analysis)

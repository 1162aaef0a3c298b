# SPDX-License-Identifier: LGPL-2.1-or-later
"""Controls one classification in the window: from the command to the colours and the info file."""

import os

import FreeCADGui as Gui

from ...api.window.open_parts import colours_of_thin_faces, parts_selected
from ...core.errors import ThinPartError
from ...freecad_adapter.objects.thickness_object import thickness_objects
from ...freecad_adapter.occurrences.face_owners import face_owners
from ...freecad_adapter.preferences import preference, preference_list
from ...storage.info.info_location import info_location
from ..application import lifelong
from ..application.length_unit import length_unit
from ..application.qt import translate
from ..application.sentences import translated
from ..document.document_measurement import DocumentMeasurement
from ..document.open_part import open_part, told_by
from ..document.part_chooser import ask_for_part
from ..document.selection import active_path, select_faces, select_part, selected_paths
from ..document.task_controller import MeasuringController
from ..document.task_dialog import TaskDialog
from ..processes.request_queue import KNOWN, LABEL
from ..record.label_button import with_own_label
from ..record.parts_table import part_rows
from ..view3d.wall_flight import PlacedWall, WallFlight, hidden_sentence
from .panel import ClassifyPanel
from .part_difference import PartDifference


class ClassificationController(MeasuringController):
    """Measures a document's parts, the chosen one first, and shows the results in a panel."""

    def __init__(self, document):
        super().__init__()
        self.measured = DocumentMeasurement(document, self)
        self.measured.measured.connect(self._show_measured)
        self.measured.ended.connect(self._show_end)
        self.measured.info_file_changed.connect(self._show_info_file)
        self._has_left = self._has_legend = False
        self._flight = WallFlight()
        self._shown_name = None  # name of the part whose result is shown
        self._form = ClassifyPanel()
        self.panel = TaskDialog(self._form, "ThinPart_Classify")
        self._form.cancelled.connect(self.cancel)
        self.measured.progressed.connect(self._form.progress.show_progress)
        self._form.save_requested.connect(self.measured.save)
        self._form.repeat_requested.connect(self._repeat)
        self._form.parts.part_chosen.connect(self._show_part)
        self._form.result.faces_chosen.connect(self._select_faces)
        self._form.result.labelled.connect(self._label)
        self._unkept_labels = {}  # by part: category, and whether the user is sure
        lifelong.requests.answered.connect(self._show_kept_label)
        self._asked_known = self._known = None  # the request whether libraries have the shown part, and the answer
        lifelong.requests.answered.connect(self._show_known)
        self._difference = PartDifference(self)
        self._difference.changed.connect(self._show_difference)
        self._form.known.difference_toggled.connect(self._toggle_difference)
        self._form.known.open_requested.connect(self._open_known)
        self._form.result.visited.connect(self._fly)
        self.panel.closed.connect(self._leave)
        lifelong.units.changed.connect(self._show_unit)

    def record_of(self, document_name, part_name):
        """The record of a part; None for another document or an unmeasured part."""
        if self._analysis is None or document_name != self.document_name:
            return None
        return self._analysis.records.get(part_name)

    def start(self):
        """Determine which part to classify, open the panel and start to measure."""
        try:
            analysis = self._new_analysis()
        except ThinPartError as error:
            self.panel.show()
            self._form.show_message(translated(error))
            return
        if analysis is not None:
            self.panel.show()
            self._measure(analysis)

    def cancel(self):
        """Stop measuring on request; existing results stay."""
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

    def _leave(self):
        if not self._has_left:
            self._has_left = True
            self._flight.clear()
            lifelong.units.changed.disconnect(self._show_unit)
            lifelong.requests.answered.disconnect(self._show_kept_label)
            lifelong.requests.answered.disconnect(self._show_known)
            self._difference.leave()
        self.measured.leave()

    @property
    def _unit(self):
        return length_unit(self.measured.document)

    @property
    def _analysis(self):
        return self.measured.analysis

    @property
    def _shown_record(self):
        return self._analysis and self._analysis.shown_records.get(self._shown_name)

    def _new_analysis(self):
        document, content = self.measured.document, self.measured.content()
        selected, active = selected_paths(document), active_path(document)
        candidates = parts_selected(document, selected, active, content.parts)
        chosen = candidates[0]
        if len(candidates) > 1 and selected:
            chosen = ask_for_part(candidates, Gui.getMainWindow())
        if chosen is None:
            return None
        return self.measured.analysis_of(content.parts, chosen, content.broken)

    def _measure(self, analysis):
        self._flight.clear()
        self._difference.end()
        self._shown_name = analysis.first_part.name
        self._form.show_running(analysis.first_part.label)
        try:
            self.measured.measure(analysis)
        except ThinPartError as error:
            self._form.show_message(translated(error))
            return
        self._show_list()

    def _show_measured(self, name):
        self._show_list()
        if name != self._shown_name or self._shown_record is None:
            return  # failures are reported at the end
        self._form.show_result(self._shown_record, self._analysis.profile, self._unit)
        self._ask_for_known()
        self._show_labels()
        self._show_legend(self._colour([name]))

    def _show_part(self, name):
        """Show another part of the list, at once or as soon as it is measured."""
        self._flight.clear()
        self._shown_name = name
        if self.measured.is_unchanged():
            select_part(self.measured.document, self._part(name))
        failure = self._analysis.failures.get(name)
        self._form.result.file = self.measured.document.FileName
        self._form.show_part(self._shown_record, self._analysis.profile,
                             translated(failure["message"]) if failure else "", self._unit)
        self._ask_for_known()
        if self._shown_record is not None:
            self._show_labels()
            self._show_legend(self._is_coloured(name))

    def _show_unit(self):
        """Update the panel after a change of the length unit."""
        self._flight.clear()
        if self._analysis is not None:
            self._show_list()
            if self._shown_record is not None:
                self._form.result.show_record(self._shown_record, self._analysis.profile, self._unit)
                self._show_labels()
                self._show_legend(self._has_legend)

    def _show_legend(self, is_coloured):
        self._has_legend = is_coloured
        own_limit = None if self._analysis.thin_limit is None else self._shown_record["thin_limit_mm"]
        self._form.result.show_legend(is_coloured, own_limit)

    def _show_list(self):
        self._form.parts.show_parts(
            part_rows(self._analysis), self._analysis.profile, self._unit, self.measured.document.FileName)
        self._form.parts.select_part(self._shown_name)

    def _show_end(self, sentence):
        failure = self._analysis.failures.get(self._shown_name)
        if failure is not None and not sentence:
            sentence = translated(failure["message"])
        if not self._analysis.records:
            self._form.show_message(sentence)
            self._form.show_info("", can_repeat=True)
            return
        self._form.show_ended(sentence)
        self._colour_all()
        self.measured.write_info_file()

    def _ask_for_known(self):
        """Ask whether the libraries have the shown part already; the answer comes when it comes."""
        self._difference.end()
        self._known = None
        self._form.known.show_known(None, "")
        if self._asked_known is not None:
            lifelong.requests.cancel(self._asked_known)
            self._asked_known = None
        record = self._analysis.records.get(self._shown_name)
        if record is None or not preference("KnownParts") or not preference_list("Libraries"):
            return
        own = self.measured.document.FileName
        info_file = os.fspath(info_location(own, preference("InfoFolder"))) if own else None
        self._asked_known = lifelong.requests.ask(KNOWN, record=record, info_file=info_file)

    def _show_known(self, request):
        if request is self._asked_known:
            self._asked_known = None
            if request.answer is not None:
                self._known = request.answer
                self._form.known.show_known(self._known, translated(self._known["sentence"], self._unit))

    def _toggle_difference(self, is_wanted):
        """Show what differs from the part of the libraries, or nothing of it any more."""
        current = self.measured.current_parts() if is_wanted else None
        if not is_wanted:
            self._difference.end()
        elif current is None:
            self._show_difference(None, translate(
                "ThinPart", "The document has changed since it was measured: classify it again."))
        else:
            part = next(part for part in current if part.name == self._shown_name)
            others = [each for each in current if each is not part]
            try:
                self._difference.start(self.measured.document, part, self._part(self._shown_name), others,
                                       self._analysis.records[self._shown_name], self._known)
            except ThinPartError as error:
                self._show_difference(None, translated(error))

    def _show_difference(self, found, sentence):
        self._form.known.show_difference(self._difference.is_running, found, sentence, self._unit)

    def _open_known(self):
        known = self._known
        self._form.known.show_problem(told_by(lambda: open_part(known["file"], known["name"])))

    def _show_info_file(self, state):
        self._form.show_info(state.sentence, state.can_save, state.can_repeat, state.tool_tip)
        if self.measured.info_file is not None:
            for name, (category, is_sure) in self._unkept_labels.items():
                self._keep_label(name, category, is_sure)
            self._show_labels()

    def _label(self, category, is_sure):
        if self.measured.info_file is None:
            self._unkept_labels[self._shown_name] = category, is_sure
            self._show_labels()
        else:
            self._keep_label(self._shown_name, category, is_sure)

    def _keep_label(self, part, category, is_sure):
        lifelong.requests.keep(LABEL, path=self.measured.info_file, part=part, category=category, is_sure=is_sure)

    def _show_kept_label(self, request):
        if request.function != LABEL or request.arguments["path"] != self.measured.info_file:
            return
        part = request.arguments["part"]
        if not request.sentence:
            self._unkept_labels.pop(part, None)
            self._analysis.set_labels(part, request.answer)
        if part == self._shown_name:
            self._show_labels("\u26a0 " + request.sentence if request.sentence else "")

    def _show_labels(self, sentence=""):
        """Show what people say of the shown part, and what the user says that cannot be kept yet."""
        if self._shown_record is None:
            return
        labels = self._shown_record.get("labels", [])
        if self._shown_name in self._unkept_labels:
            category, is_sure = self._unkept_labels[self._shown_name]
            labels = with_own_label(labels, category, is_sure)
            if self.measured.info_file is None:
                sentence = translate(
                    "ThinPart", "Your label is kept once the document is saved and its info file is written.")
        self._form.result.show_labels(labels, sentence)

    def _colour_all(self):
        """Colour all other parts too; the chosen part was coloured when it was measured."""
        if len(self._analysis.parts) > 1:
            self._colour(self._analysis.records)
            if self._shown_record is not None:
                self._show_legend(self._is_coloured(self._shown_name))

    def _colour(self, names):
        """Colour the thin faces of parts; return whether there are any."""
        if not self.measured.is_unchanged():
            return False
        document, owners, others = self.measured.document, {}, {}
        for part in self._analysis.parts:
            if part.name not in names:
                others.update({owner.Name: owner for owner, _ in face_owners(document, part)})
                continue
            colours = self._colours_of(part.name)
            for owner, indices in face_owners(document, part):
                # One object may draw several parts, such as a compound.
                owner_colours = owners.setdefault(owner.Name, (owner, {}))[1]
                owner_colours.update({indices[face]: rgb for face, rgb in colours.items()})
        lifelong.face_colours.show(
            document, list(owners.values()), [each for name, each in others.items() if name not in owners])
        self._hide_maps({owner for owner, (_, colours) in owners.items() if colours})
        return any(self._is_coloured(name) for name in names)

    def _hide_maps(self, coloured):
        """Hide thickness maps that cover coloured objects, and say so: a map would be all that is seen of them."""
        hidden = [each for each in thickness_objects(self.measured.document) if each.ViewObject.Visibility
                  and coloured & {source.Name for source in each.Sources if source is not None}]
        for each in hidden:
            each.ViewObject.Visibility = False
        if hidden:
            lifelong.notifications.show_message(translate(
                "ThinPart", "The thickness map is hidden, to show the thin faces. Space shows it again."))

    def _colours_of(self, name):
        return colours_of_thin_faces(self._analysis.shown_records[name], self._part(name))

    def _is_coloured(self, name):
        return bool(self._colours_of(name)) and any(
            lifelong.face_colours.is_coloured(owner)
            for owner, _ in face_owners(self.measured.document, self._part(name)))

    def _select_faces(self, faces):
        if self.measured.is_unchanged():
            select_faces(self.measured.document, self._part(self._shown_name), faces)

    def _fly(self, wall):
        if self.measured.is_unchanged():
            value, points = wall
            is_seen = self._flight.fly(self.measured.document, PlacedWall(value, [points]),
                                       self._shown_record["descriptors"]["diagonal_mm"], self._unit)
            self._form.result.show_flight("" if is_seen else hidden_sentence())

    def _part(self, name):
        return next(part for part in self._analysis.parts if part.name == name)

    def _repeat(self):
        try:
            analysis = self._new_analysis()
        except ThinPartError as error:
            self._form.show_message(translated(error))
            return
        if analysis is not None:
            self._measure(analysis)

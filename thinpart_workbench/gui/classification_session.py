"""One classification in the window: from the click to the colours and the info file."""

import FreeCAD as App
import FreeCADGui as Gui

from ..core.analysis_settings import AnalysisSettings
from ..core.criteria import load_profile
from ..core.errors import ThinPartError
from ..freecad_adapter.active_part import parts_meant
from ..freecad_adapter.document_parts import document_content, document_parts
from ..freecad_adapter.face_owners import face_owners
from ..freecad_adapter.same_parts import same_parts
from ..freecad_adapter.settings import preference
from ..freecad_adapter.thin_colours import preferred_colours
from ..workflow.document_analysis import DocumentAnalysis
from .chosen_in_window import active_place, selected_places
from .document_observer import OBSERVER
from .document_run import DocumentRun
from .face_colours import FACE_COLOURS
from .part_dialog import ask_for_part
from .qt import QtCore, translate
from .sentences import translated
from .task_panel import TaskPanel


class ClassificationSession(QtCore.QObject):
    """Measures a document's parts, the chosen one first, and shows what came out in a panel.

    Parameters
    ----------
    document : FreeCAD.Document or None
    """

    def __init__(self, document):
        super().__init__()
        self._name = document.Name if document is not None else None
        self._analysis = None
        self._run = None
        self.panel = TaskPanel()
        self._form = self.panel.form
        self._form.cancelled.connect(self.cancel)
        self._form.save_asked.connect(self._save)
        self._form.again_asked.connect(self._again)
        self.panel.closed.connect(self._stop)

    @property
    def document_name(self):
        """Name of the document, None where there is none."""
        return self._name

    @property
    def is_running(self):
        """Whether something is being measured."""
        return self._run is not None and self._run.is_running

    def record_of(self, document_name, part_name):
        """The record of a part of the document, None where it is another document or not measured."""
        if self._analysis is None or document_name != self._name:
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
        self._stop()
        if self._chosen_record is None:
            self._form.show_message(translate("ThinPart", "Cancelled. Nothing was changed."))
            self._form.show_info("", can_repeat=True)
            return
        self._form.show_ended()
        self._form.show_info(translate(
            "ThinPart", "Cancelled: no info file was written, since other parts of the document "
            "are not measured."), can_repeat=True)

    def close(self):
        """End everything and take the panel away."""
        self._stop()
        self.panel.hide()

    @property
    def _document(self):
        if self._name is None:
            raise ThinPartError(translate(
                "ThinPart", "There is no document: open or create one first."), "empty")
        return App.getDocument(self._name)

    @property
    def _chosen_record(self):
        return self._analysis and self._analysis.records.get(self._analysis.chosen.name)

    def _new_analysis(self):
        document = self._document
        content = document_content(document)
        parts = content.parts
        candidates = parts_meant(document, parts, selected_places(document),
                                 active_place(document))
        chosen = candidates[0]
        if len(candidates) > 1:
            chosen = ask_for_part(candidates, Gui.getMainWindow())
        if chosen is None:
            return None
        profile = load_profile(preference("Profile"))
        return DocumentAnalysis(parts, chosen, AnalysisSettings(), profile.content,
                                content.broken)

    def _measure(self, analysis):
        self._analysis = analysis
        self._form.show_running(analysis.chosen.label)
        self._run = DocumentRun(analysis, preference("MemoryMegabytes"), self)
        self._run.progressed.connect(self._show_progress)
        self._run.measured.connect(self._show_measured)
        self._run.ended.connect(self._show_end)
        try:
            self._run.start()
        except ThinPartError as error:
            self._form.show_message(translated(error))

    def _show_progress(self, progress):
        labels = {part.name: part.label for part in self._analysis.parts}
        label = labels[progress["part"]]
        stage = translate("ThinPart", "Making the surface mesh of {}").format(label)
        if progress["stage"] == "measure":
            stage = translate("ThinPart", "Measuring the walls of {}").format(label)
        if progress["part"] != self._analysis.chosen.name:
            stage = translate("ThinPart", "For the info file: {}").format(stage)
        self._form.show_progress(self._analysis.share_done(progress), stage)

    def _show_measured(self, name):
        if name != self._analysis.chosen.name:
            return
        record = self._chosen_record
        if record is None:
            return  # its failure is told at the end
        self._form.show_result(record, self._analysis.profile)
        self._form.result.show_legend(self._colour(record))

    def _show_end(self, sentence):
        failure = self._analysis.failures.get(self._analysis.chosen.name)
        if failure is not None and not sentence:
            sentence = translated(failure["message"])
        if self._chosen_record is None:
            self._form.show_message(sentence)
            self._form.show_info("", can_repeat=True)
            return
        self._form.show_ended(sentence)
        if self._analysis.is_complete:
            self._write_info()
        else:
            self._form.show_info(translate(
                "ThinPart", "No info file was written, since not every part was measured."),
                can_repeat=True)

    def _colour(self, record):
        """Colour the thin faces; whether there are any."""
        if not self._is_as_measured():
            return False
        document, colours = self._document, preferred_colours(record)
        FACE_COLOURS.show(document, [
            (owner, {indices[face]: rgb for face, rgb in colours.items()})
            for owner, indices in face_owners(document, self._analysis.chosen)
        ])
        return bool(colours) and FACE_COLOURS.is_shown(document)

    def _is_as_measured(self):
        return same_parts(self._analysis.parts, document_parts(self._document))

    def _write_info(self):
        document = self._document
        if not self._is_as_measured():
            self._form.show_info(translate(
                "ThinPart", "The document has changed since it was measured: no info file was "
                "written. Classify it again."), can_repeat=True)
            return
        if OBSERVER.differs_from_file(document):
            self._form.show_info(translate(
                "ThinPart", "No info file was written, because the document is not saved."),
                can_save=True)
            return
        try:
            path = self._analysis.write_info_file(document.FileName)
        except ThinPartError as error:
            self._form.show_info(translate("ThinPart", "No info file: {}").format(translated(error)))
            return
        self._form.show_info(translate(
            "ThinPart", "Info file, beside the document: {}").format(path.name), tool_tip=str(path))

    def _save(self):
        document = self._document
        # FreeCAD saves what its active view shows, and asks for a name where there is none yet.
        App.setActiveDocument(document.Name)
        Gui.runCommand("Std_Save")
        if not OBSERVER.differs_from_file(document):
            self._write_info()

    def _again(self):
        try:
            analysis = self._new_analysis()
        except ThinPartError as error:
            self._form.show_message(translated(error))
            return
        if analysis is not None:
            self._measure(analysis)

    def _stop(self):
        if self._run is not None:
            self._run.stop()

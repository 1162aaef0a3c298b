"""A document that is measured in the background, and what becomes of its info file."""

import os
from dataclasses import dataclass

import FreeCAD as App
import FreeCADGui as Gui

from ..core.criteria import load_profile
from ..core.errors import ThinPartError
from ..freecad_adapter.document_parts import document_content, document_parts
from ..freecad_adapter.same_parts import same_parts
from ..freecad_adapter.settings import preference, preferred_analysis, preferred_thin_limit
from ..workflow.document_analysis import DocumentAnalysis
from ..workflow.info_file_worker import file_stamp
from .asked_process import AskedProcess
from .automatic_classification import AUTOMATIC
from .document_observer import OBSERVER
from .document_run import DocumentRun
from .qt import QtCore, Signal, translate
from .sentences import translated


@dataclass(frozen=True)
class InfoFileState:
    """What became of an info file.

    Attributes
    ----------
    sentence : str
    tool_tip : str
    can_save, can_repeat : bool
        Whether saving the document, or measuring it again, would help.
    """

    sentence: str
    tool_tip: str = ""
    can_save: bool = False
    can_repeat: bool = False


class MeasuredDocument(QtCore.QObject):
    """Measures parts of a document and writes its info file.

    Parameters
    ----------
    document : FreeCAD.Document or None

    Attributes
    ----------
    analysis : DocumentAnalysis or None
        The last one that was started.

    Signals
    -------
    progressed(float, str)
        Fraction done, and what is being done.
    measured(str)
        Name of a part of which the analysis now holds the record or the failure.
    mapped(str, str)
        See `DocumentRun`.
    ended(str)
        See `DocumentRun`.
    info_file_changed(object)
        An `InfoFileState`.
    """

    progressed = Signal(float, str)
    measured = Signal(str)
    mapped = Signal(str, str)
    ended = Signal(str)
    info_file_changed = Signal(object)

    def __init__(self, document, parent=None):
        super().__init__(parent)
        self.name = document.Name if document is not None else None
        self.analysis = None
        self._is_whole = True
        self._run = self._revision = self._stamp = None
        self._writing = AskedProcess("info_file_worker", self)
        self._writing.answered.connect(self._tell_written)

    @property
    def document(self):
        """The document.

        Raises
        ------
        ThinPartError
            Where there is none.
        """
        if self.name is None:
            raise ThinPartError(translate(
                "ThinPart", "There is no document: open or create one first."), "empty")
        return App.getDocument(self.name)

    @property
    def is_running(self):
        """Whether something is being measured."""
        return self._run is not None and self._run.is_running

    @property
    def is_up_to_date(self):
        """Whether what is measured, or was measured completely, is the whole document as it is now."""
        return (self.analysis is not None and self._is_whole
                and self._revision == OBSERVER.revision(self.name)
                and (self.is_running or self.analysis.is_complete))

    def content(self):
        """What the document holds now, DocumentContent; raises as `document` does."""
        return document_content(self.document)

    def analysis_of(self, parts, chosen, broken=(), maps=False):
        """A `DocumentAnalysis` by the preferences; see there.

        Raises
        ------
        ThinPartError
            When the profile cannot be read.
        """
        profile = load_profile(preference("Profile"))
        return DocumentAnalysis(parts, chosen, preferred_analysis(), profile.content, broken,
                                preferred_thin_limit(), maps)

    def measure(self, analysis, is_whole=True):
        """Start to measure.

        Parameters
        ----------
        analysis : DocumentAnalysis
        is_whole : bool
            Whether its parts are all parts of the document; otherwise there is no info file.

        Raises
        ------
        ThinPartError
            As `DocumentRun.start`.
        """
        self._stop_run()
        self._writing.end()
        self.analysis, self._is_whole = analysis, is_whole
        self._revision = OBSERVER.revision(self.name)
        self._run = DocumentRun(analysis, preference("MemoryMegabytes"), self)
        self._run.progressed.connect(self._tell_progress)
        self._run.measured.connect(self.measured)
        self._run.mapped.connect(self.mapped)
        self._run.ended.connect(self._end)
        self._run.start()
        if is_whole:
            AUTOMATIC.leave_to_panel(self.name)

    def stop(self):
        """Stop measuring; what is there already stays."""
        self._stop_run()
        self.give_up()

    def leave(self):
        """The panel is gone: nothing is measured for nobody, but an info file is written to its end."""
        self._stop_run()
        self._writing.end()
        self.give_up()

    def give_up(self):
        """There will be no info file from here: what was left to the panel is classified by itself."""
        AUTOMATIC.take_over(self.name)

    def keep(self):
        """Write the info file of a document that was just saved, if everything is measured by now."""
        if not self.is_running and not (self._writing.is_waiting and self._is_stamp_of_file()):
            self.write_info_file()

    def parts_now(self):
        """The parts that were measured as they stand in the document now, None where others are there."""
        now = document_parts(self.document)
        if not self._is_whole:
            names = {part.name for part in self.analysis.parts}
            now = [part for part in now if part.name in names]
        return now if same_parts(self.analysis.parts, now) else None

    def is_as_measured(self):
        """Whether the parts of the document are still those that were measured."""
        return self.parts_now() is not None

    def write_info_file(self, now=None):
        """Write the info file if what was measured is what is in the document's file, and tell.

        Parameters
        ----------
        now : list, optional
            `parts_now`, where that is known already.
        """
        if not self._is_whole:
            return
        refused = self._refusal(now)
        if refused is not None:
            self.info_file_changed.emit(refused)
            self.give_up()
            return
        try:
            job = self.analysis.info_job(self.document.FileName, preference("InfoFolder"))
        except ThinPartError as error:
            self._tell_written({"failure": translated(error)})
            return
        self.info_file_changed.emit(InfoFileState(translate("ThinPart", "Writing the info file\u2026")))
        self._writing.end()
        self._stamp = job["stamp"]
        # In a process: the folder may be on another computer, and the document as large as it likes.
        self._writing.ask(**job)

    def save(self):
        """Save the document as FreeCAD's button does, and write the info file."""
        document = self.document
        # FreeCAD saves what its active view shows, and asks for a name where there is none yet.
        App.setActiveDocument(document.Name)
        Gui.runCommand("Std_Save")
        if not OBSERVER.differs_from_file(document):
            self.write_info_file()

    def _refusal(self, now):
        """Why there can be no info file, an `InfoFileState`, or None."""
        if not self.analysis.is_complete:
            return InfoFileState(translate(
                "ThinPart", "No info file was written, since not every part was measured."), can_repeat=True)
        if now is None and not self.is_as_measured():
            return InfoFileState(translate(
                "ThinPart", "The document has changed since it was measured: no info file was "
                "written. Classify it again."), can_repeat=True)
        if OBSERVER.differs_from_file(self.document):
            return InfoFileState(translate(
                "ThinPart", "No info file was written, because the document is not saved."), can_save=True)
        return None

    def _tell_written(self, answer):
        if "failure" in answer:
            self.info_file_changed.emit(InfoFileState(
                translate("ThinPart", "No info file: {}").format(translated(answer["failure"]))))
            AUTOMATIC.take_failure(self.name, answer["failure"])
            return
        path = answer["written"]
        text = translate("ThinPart", "Info file, beside the document: {}")
        if os.path.dirname(path) != os.path.dirname(self.document.FileName):
            text = translate("ThinPart", "Info file, in the preferred folder: {}")
        self.info_file_changed.emit(InfoFileState(text.format(os.path.basename(path)), tool_tip=path))
        AUTOMATIC.take_from_panel(self.name, answer["before"], answer["now"])

    def _end(self, sentence):
        if not self.analysis.records:
            self.give_up()
        self.ended.emit(sentence)

    def _is_stamp_of_file(self):
        try:
            return self._stamp == file_stamp(self.document.FileName)
        except OSError:
            return False

    def _stop_run(self):
        if self._run is not None:
            self._run.stop()

    def _tell_progress(self, progress):
        label = next(part.label for part in self.analysis.parts if part.name == progress["part"])
        stage = translate("ThinPart", "Making the surface mesh of {}").format(label)
        if progress["stage"] in ("measure", "map"):
            stage = translate("ThinPart", "Measuring the walls of {}").format(label)
        if not self.analysis.maps and progress["part"] != self.analysis.chosen.name:
            stage = translate("ThinPart", "For the info file: {}").format(stage)
        self.progressed.emit(self.analysis.share_done(progress), stage)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measures a document in the background and writes its info file."""

import os
from dataclasses import dataclass

import FreeCAD as App
import FreeCADGui as Gui

from ...api.document_info import file_stamp
from ...api.window.open_parts import content_of, parts_as_measured
from ...api.window.profiles import preferred_profile
from ...core.errors import ThinPartError
from ...freecad_adapter.preferences import preference, preferred_analysis, preferred_thin_limit
from ..application import lifelong
from ..application.qt import QtCore, Signal, translate
from ..application.sentences import translated
from ..processes.document_analysis import DocumentAnalysis
from ..processes.snapshot_job import SnapshotJob


@dataclass(frozen=True)
class InfoFileState:
    """State of an info file, as the panel shows it.

    Attributes
    ----------
    sentence : str
    tool_tip : str
    can_save, can_repeat : bool
        Whether saving the document, or measuring it again, would lead to an info file.
    """

    sentence: str
    tool_tip: str = ""
    can_save: bool = False
    can_repeat: bool = False


class DocumentMeasurement(QtCore.QObject):
    """Measures parts of a document, if there is one, and writes its info file.

    Attributes
    ----------
    analysis : DocumentAnalysis or None
        The one started last.
    info_file : str or None
        Path of the info file with its results, once it is written.

    Signals
    -------
    progressed(float, str)
        Fraction done, and a text about the current step.
    measured(str)
        Name of a part whose record or failure is now in the analysis.
    mapped(str, str), first_mapped(str, str)
        See `SnapshotJob`.
    ended(str)
        See `SnapshotJob`.
    info_file_changed(object)
        InfoFileState.
    """

    progressed = Signal(float, str)
    measured = Signal(str)
    mapped = Signal(str, str)
    first_mapped = Signal(str, str)
    ended = Signal(str)
    info_file_changed = Signal(object)

    def __init__(self, document, parent=None):
        super().__init__(parent)
        self.name = document.Name if document is not None else None
        self.analysis = self.info_file = None
        self._is_whole_document = True
        self._job = self._revision = self._info_request = None
        lifelong.requests.answered.connect(self._on_answered)

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
        """Whether a measurement is running."""
        return self._job is not None and self._job.is_running

    @property
    def is_up_to_date(self):
        """Whether the current document, with all its parts, is being measured or was measured completely."""
        return (self.analysis is not None and self._is_whole_document
                and self._revision == lifelong.observer.revision(self.name)
                and (self.is_running or self.analysis.is_complete))

    def content(self):
        """The document's current content, DocumentContent; raises like `document`."""
        return content_of(self.document)

    def analysis_of(self, parts, chosen, broken=(), maps=None, first_maps=False):
        """A `DocumentAnalysis` with the settings of the preferences; raises a ThinPartError if the profile is unreadable."""
        profile = preferred_profile()
        return DocumentAnalysis(parts, chosen, preferred_analysis(), profile.content, broken,
                                preferred_thin_limit(), maps, first_maps)

    def measure(self, analysis, is_whole=True):
        """Start measuring; raises like `SnapshotJob.start`.

        Parameters
        ----------
        is_whole : bool
            Whether it covers all parts of the document; otherwise no info file is written.
        """
        self._stop_job()
        self._info_request = None
        self.analysis, self._is_whole_document, self.info_file = analysis, is_whole, None
        self._revision = lifelong.observer.revision(self.name)
        self._job = SnapshotJob(analysis, preference("MemoryMegabytes"), self)
        self._job.progressed.connect(self._on_progress)
        self._job.measured.connect(self.measured)
        self._job.mapped.connect(self.mapped)
        self._job.first_mapped.connect(self.first_mapped)
        self._job.ended.connect(self._on_ended)
        self._job.start()
        if is_whole:
            lifelong.measurement_signals.begun.emit(self.name)

    def stop(self):
        """Stop measuring; the results so far are kept."""
        self._stop_job()
        self.abandon_info_file()

    def leave(self):
        """Stop measuring because the panel is closed, but finish writing an info file."""
        self._stop_job()
        self._info_request = None
        self.abandon_info_file()

    def abandon_info_file(self):
        """Announce that no info file will be written here, so that the `AutoClassifier` classifies the document."""
        lifelong.measurement_signals.info_file_abandoned.emit(self.name)

    def write_info_file_if_measured(self):
        """Write the info file of a document that was just saved, unless the measurement is still running."""
        if not self.is_running and not (self._info_request is not None and self._file_has_stamp()):
            self.write_info_file()

    def current_parts(self):
        """The measured parts as they are in the document now, or None where they have changed."""
        return parts_as_measured(self.document, self.analysis.parts, self._is_whole_document)

    def is_unchanged(self):
        """Whether the parts of the document are still the measured ones."""
        return self.current_parts() is not None

    def write_info_file(self, current_parts=None):
        """Write the info file if the document's file holds what was measured; `info_file_changed` reports the result.

        Parameters
        ----------
        current_parts : list, optional
            Result of `current_parts`, where it is known already.
        """
        if not self._is_whole_document:
            return
        refusal = self._refusal(current_parts)
        if refusal is not None:
            self.info_file_changed.emit(refusal)
            self.abandon_info_file()
            return
        try:
            content = self.analysis.info_file_content(self.document.FileName)
        except ThinPartError as error:
            self._show_not_written(translated(error))
            return
        self.info_file_changed.emit(InfoFileState(translate("ThinPart", "Writing the info file\u2026")))
        # In another process: the folder may be on another computer, and the document may be large.
        self._info_request = lifelong.requests.keep("document_info.write_document_info", **content)

    def save(self):
        """Save the document with FreeCAD's own command, and write the info file."""
        document = self.document
        # The command saves the active document, and asks for a file name where there is none yet.
        App.setActiveDocument(document.Name)
        Gui.runCommand("Std_Save")
        if not lifelong.observer.differs_from_file(document):
            self.write_info_file()

    def _refusal(self, current_parts):
        """InfoFileState with the reason why no info file can be written, or None."""
        if not self.analysis.is_complete:
            return InfoFileState(translate(
                "ThinPart", "No info file was written, since not every part was measured."), can_repeat=True)
        if current_parts is None and not self.is_unchanged():
            return InfoFileState(translate(
                "ThinPart", "The document has changed since it was measured: no info file was "
                "written. Classify it again."), can_repeat=True)
        if lifelong.observer.differs_from_file(self.document):
            return InfoFileState(translate(
                "ThinPart", "No info file was written, because the document is not saved."), can_save=True)
        return None

    def _show_not_written(self, sentence):
        self.info_file_changed.emit(InfoFileState(translate("ThinPart", "No info file: {}").format(sentence)))
        lifelong.measurement_signals.not_written.emit(self.name, sentence)

    def _on_answered(self, request):
        if request is not self._info_request:
            return
        self._info_request, answer = None, request.answer
        if request.sentence:
            self._show_not_written(request.sentence)
            return
        path = self.info_file = answer["path"]
        for name, labels in answer["labels"].items():
            self.analysis.set_labels(name, labels)
        text = translate("ThinPart", "Info file, beside the document: {}")
        if os.path.dirname(path) != os.path.dirname(self.document.FileName):
            text = translate("ThinPart", "Info file, in the preferred folder: {}")
        self.info_file_changed.emit(InfoFileState(text.format(os.path.basename(path)), tool_tip=path))
        lifelong.measurement_signals.written.emit(self.name, answer["before"], answer["now"])

    def _on_ended(self, sentence):
        if not self.analysis.records:
            self.abandon_info_file()
        self.ended.emit(sentence)

    def _file_has_stamp(self):
        try:
            return self._info_request.arguments["stamp"] == file_stamp(self.document.FileName)
        except OSError:
            return False

    def _stop_job(self):
        if self._job is not None:
            self._job.stop()

    def _on_progress(self, progress):
        label = next(part.label for part in self.analysis.parts if part.name == progress["part"])
        stage = translate("ThinPart", "Making the surface mesh of {}").format(label)
        if progress["stage"] in ("measure", "map"):
            stage = translate("ThinPart", "Measuring the walls of {}").format(label)
        if not self.analysis.maps and progress["part"] != self.analysis.first_part.name:
            stage = translate("ThinPart", "For the info file: {}").format(stage)
        self.progressed.emit(self.analysis.share_done(progress), stage)

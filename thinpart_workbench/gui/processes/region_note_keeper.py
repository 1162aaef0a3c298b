"""Reads and keeps what the user says of wall regions in info files, in another process."""

from collections import deque

from ...freecad_adapter.preferences import preference, preferred_person
from ..application.qt import QtCore, Signal
from ..application.sentences import translated
from .one_shot_job import OneShotJob


class RegionNoteKeeper(QtCore.QObject):
    """Does one job after the other; a panel may be closed meanwhile.

    Signals
    -------
    answered(object)
        dict: ``document``, its path; ``notes``, a dict of lists by part name, None where there is no info file or on
        failure; and a ``sentence`` on failure, else empty.
    """

    answered = Signal(object)

    def __init__(self, parent=None):
        super().__init__(parent)
        self._waiting = deque()
        self._known = {}  # the last answer, by path of the document
        self._job = OneShotJob("region_note_worker", self)
        self._job.answered.connect(self._on_answered)

    @property
    def is_busy(self):
        """Whether jobs are still to be done."""
        return bool(self._waiting)

    def known(self, document):
        """What was read last, until it is read again: as ``notes`` of `answered`."""
        return self._known.get(document)

    def read(self, document):
        """Read what is kept with a document: its path."""
        self._add(document)

    def keep(self, document, part, regions, **said):
        """Keep what the user says of regions.

        Parameters
        ----------
        document : str
            Path of the document.
        part : str
            Name of the part.
        regions : list of dict
            As in a part record.
        said
            ``excluded`` or ``mesh_size_mm``, as of `note_regions`.
        """
        places = [{key: region[key] for key in ("place", "faces", "length_mm", "median")} for region in regions]
        self._add(document, part=part, regions=places, person=preferred_person(), **said)

    def _add(self, document, **job):
        self._waiting.append({"document": str(document), "folder": preference("InfoFolder"), **job})
        if len(self._waiting) == 1:
            self._job.ask(**self._waiting[0])

    def _on_answered(self, answer):
        job = self._waiting.popleft()
        if self._waiting:
            self._job.ask(**self._waiting[0])
        if "failure" not in answer:
            self._known[job["document"]] = answer["notes"]
        self.answered.emit({"document": job["document"], "notes": answer.get("notes"),
                            "sentence": translated(answer["failure"]) if "failure" in answer else ""})

"""Keeps the user's labels of parts in info files, in another process."""

from collections import deque

from ...freecad_adapter.preferences import preferred_person
from ..application.qt import QtCore, Signal
from ..application.sentences import translated
from .one_shot_job import OneShotJob


class LabelKeeper(QtCore.QObject):
    """Writes one label after the other; a panel may be closed meanwhile.

    Signals
    -------
    kept(object)
        dict: ``path`` of the info file, ``part``, ``labels`` of that part, and a ``sentence`` on failure, else empty.
    """

    kept = Signal(object)

    def __init__(self, parent=None):
        super().__init__(parent)
        self._waiting = deque()
        self._job = OneShotJob("label_worker", self)
        self._job.answered.connect(self._on_answered)

    @property
    def is_busy(self):
        """Whether labels are still to be written."""
        return bool(self._waiting)

    def keep(self, path, part, category, is_sure):
        """Keep what the user says a part is.

        Parameters
        ----------
        path : str or Path
            The info file.
        part : str
        category : str
            Empty removes the user's label.
        is_sure : bool
        """
        self._waiting.append({"path": str(path), "part": part, "category": category, "is_sure": is_sure,
                              "person": preferred_person()})
        if len(self._waiting) == 1:
            self._job.ask(**self._waiting[0])

    def _on_answered(self, answer):
        job = self._waiting.popleft()
        if self._waiting:
            self._job.ask(**self._waiting[0])
        self.kept.emit({"path": job["path"], "part": job["part"], "labels": answer.get("labels", []),
                        "sentence": _sentence(answer)})


def _sentence(answer):
    return translated(answer["failure"]) if "failure" in answer else ""

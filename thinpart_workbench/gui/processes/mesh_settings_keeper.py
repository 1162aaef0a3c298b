"""Keeps mesh settings that worked, and finds them for a part, in another process."""

from collections import deque

import FreeCAD as App

from ...freecad_adapter.preferences import preference, preference_list
from ..application.qt import QtCore, Signal
from ..application.sentences import translated
from .one_shot_job import OneShotJob


class MeshSettingsKeeper(QtCore.QObject):
    """Does one job after the other; a panel may be closed meanwhile.

    Signals
    -------
    found(object, object)
        Who asked, as given to `look_for`; and what `settings_that_worked` found, a dict or None.
    """

    found = Signal(object, object)

    def __init__(self, parent=None):
        super().__init__(parent)
        self._waiting = deque()
        self._job = OneShotJob("mesh_settings_worker", self)
        self._job.answered.connect(self._on_answered)

    @property
    def is_busy(self):
        """Whether jobs are still to be done."""
        return bool(self._waiting)

    def keep(self, document, **worked):
        """Keep the settings of a part of a document, if it has an info file: its path, and the arguments of
        `keep_mesh_settings`."""
        self._add(None, document, keep=worked)

    def look_for(self, asker, document, record):
        """Look for settings for a part: the path of its document, empty where it has none, and its record."""
        roots = preference_list("Libraries")
        if document or roots:  # else there is nothing to look at
            self._add(asker, document, record=record, roots=roots)

    def _add(self, asker, document, **job):
        self._waiting.append((asker, {"document": str(document), "folder": preference("InfoFolder"), **job}))
        if len(self._waiting) == 1:
            self._job.ask(**self._waiting[0][1])

    def _on_answered(self, answer):
        asker, _ = self._waiting.popleft()
        if self._waiting:
            self._job.ask(**self._waiting[0][1])
        if "failure" in answer:
            App.Console.PrintWarning(translated(answer["failure"]) + "\n")
        if asker is not None:
            self.found.emit(asker, answer.get("offer"))

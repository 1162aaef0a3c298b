# SPDX-License-Identifier: LGPL-2.1-or-later
"""A worker process that loads everything needed for measuring in advance."""

import tempfile

import FreeCAD as App

from ...core.errors import ThinPartError
from ...freecad_adapter.python_beside_freecad import python_environment
from ...system.exit_cause import ExitCause
from ..application.qt import QtCore, QtWidgets, translate
from ..application.sentences import translated
from .conversation import Conversation
from .freecad_python import python_program

_DELAY = 300
"""Milliseconds from the last job to starting the next process, which leaves the GUI time to update."""


class MeasuringProcess(Conversation):
    """A process that measures a snapshot.

    Attributes
    ----------
    megabytes : int
        Limit of its address space, for the sentence about a lack of memory.
    """

    megabytes = 0

    def __init__(self):
        super().__init__("snapshot_worker", QtWidgets.QApplication.instance(), patience=0.0)

    def not_started(self):
        """The sentence for a process that cannot be started."""
        return translate("ThinPart", "The measuring process could not be started.")

    def _sentence(self, end):
        App.Console.PrintLog(end.text + "\n")
        failure = self.failure or {}
        if failure.get("kind") == "memory" or end.cause(is_done=False) is ExitCause.OUT_OF_MEMORY:
            return translate("ThinPart", "Measuring needs more than {} MB of memory: raise the limit in the "
                                         "preferences.").format(self.megabytes)
        if failure:
            return translated(failure["message"])
        return translate("ThinPart", "The measuring process ended unexpectedly; the document is unharmed. Check the part "
                                     "with 'Check geometry' of the Part workbench.")


class StandbyWorker:
    """Keeps one such process ready: loading FreeCAD and scipy takes longer than measuring a small part.

    The process ends by itself when FreeCAD ends, even by a crash, and after some minutes without a job.
    """

    def __init__(self):
        self._process = self._environment = self._delay = None

    @property
    def process_id(self):
        """Id of the waiting process; None where there is none."""
        return self._process.process_id if self._process is not None else None

    def take(self):
        """Hand over a MeasuringProcess that waits for a job on its standard input, with no signals connected.

        The caller becomes its owner. Raises a ThinPartError where there is no Python.
        """
        if self._delay is not None:
            self._delay.stop()
        # A process started with another Python or other environment variables cannot be used any more.
        if self.process_id is None or self._environment != _current_environment():
            self.end()
            self._start_process()
        process, self._process = self._process, None
        return process

    def prepare_next(self):
        """Start the next process after a short delay."""
        if self._delay is None:
            self._delay = QtCore.QTimer(QtWidgets.QApplication.instance(), singleShot=True, interval=_DELAY)
            self._delay.timeout.connect(self._start_if_needed)
        self._delay.start()

    def end(self):
        """End the waiting process, if there is one."""
        if self._delay is not None:
            self._delay.stop()
        process, self._process = self._process, None
        if process is not None:
            process.end_now()  # Qt warns if a running QProcess is deleted
            process.deleteLater()

    def _start_if_needed(self):
        if self.process_id is not None:
            return
        self.end()  # clean up a process that has ended by itself
        try:
            self._start_process()
        except ThinPartError:
            return  # reported when a process is needed

    def _start_process(self):
        self._environment = _current_environment()
        self._process = MeasuringProcess()
        self._process.start(folder=tempfile.gettempdir())


def _current_environment():
    return python_program(), python_environment()

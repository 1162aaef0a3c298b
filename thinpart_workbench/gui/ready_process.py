"""A process that has loaded all that measuring takes before anybody asks for it."""

import tempfile

from ..core.errors import ThinPartError
from .qt import QtCore, QtWidgets
from .worker_python import new_process, python_environment, python_program, start_module

WORKER = "thinpart_workbench.workflow.snapshot_worker"

_QUIET = 300
"""Milliseconds after the last run until the next process is made: first the window has its turn."""


class ReadyProcess:
    """Keeps one such process; loading FreeCAD and scipy takes longer than measuring a small part.

    It ends by itself with FreeCAD, however that ends, and after some minutes in which nobody needs it.
    """

    def __init__(self):
        self._process = self._made_with = self._soon = None

    @property
    def number(self):
        """Number of the process that waits; None where there is none."""
        return self._process.processId() if self._is_there() else None

    def take(self):
        """A process that waits for a job on its standard input.

        Returns
        -------
        QProcess
            Started; its signals are connected to nothing. Whoever takes it owns it.

        Raises
        ------
        ThinPartError
            Where there is no Python.
        """
        if self._soon is not None:
            self._soon.stop()
        # A process that was made in other surroundings would answer for those.
        if not self._is_there() or self._made_with != _surroundings():
            self.end()
            self._make()
        process, self._process = self._process, None
        return process

    def make_soon(self):
        """Have the next one made once the window has nothing else to do."""
        if self._soon is None:
            self._soon = QtCore.QTimer(QtWidgets.QApplication.instance(), singleShot=True, interval=_QUIET)
            self._soon.timeout.connect(self._make_next)
            QtWidgets.QApplication.instance().aboutToQuit.connect(self.end)
        self._soon.start()

    def end(self):
        """End the process that waits, if there is one."""
        if self._soon is not None:
            self._soon.stop()
        process, self._process = self._process, None
        if process is not None:
            process.kill()
            process.waitForFinished(3000)  # Qt warns of one that is deleted while it runs
            process.deleteLater()

    def _is_there(self):
        return self._process is not None and self._process.state() != QtCore.QProcess.NotRunning

    def _make_next(self):
        if self._is_there():
            return
        self.end()  # one that has ended by itself
        try:
            self._make()
        except ThinPartError:
            return  # said when it is needed

    def _make(self):
        self._made_with = _surroundings()
        self._process = new_process(QtWidgets.QApplication.instance())
        self._process.setWorkingDirectory(tempfile.gettempdir())
        start_module(self._process, self._made_with[0], WORKER)


def _surroundings():
    return python_program(), python_environment()


READY = ReadyProcess()

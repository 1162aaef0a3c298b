"""A process beside FreeCAD with which JSON lines are exchanged."""

import json
import time

from ..core.errors import ThinPartError
from .notices import NOTICES
from .qt import QtCore, QtWidgets, Signal, translate
from .sentences import translated
from .worker_python import hand_over, listen, new_process, python_program, start_module

SLICE_SECONDS = 0.015
"""After reading for this long the window has its turn."""

_PATIENCE = 3000
"""Milliseconds in which a process has to end when FreeCAD does."""


class JsonProcess(QtCore.QObject):
    """A module of `workflow` at work in another process.

    Parameters
    ----------
    module : str
        Such as ``library_worker``.

    Signals
    -------
    told(object)
        A dict that it has printed.
    ended(str)
        It has ended by itself: empty when all went well, else one sentence. Not sent after `end`.
    """

    told = Signal(object)
    ended = Signal(str)

    def __init__(self, module, parent=None):
        super().__init__(parent)
        self._module = module
        self._process = None
        self._errors = b""
        self._slice = QtCore.QTimer(self, singleShot=True, interval=0)
        self._slice.timeout.connect(self._take_slice)

    @property
    def is_running(self):
        """Whether the process is at work, or some of what it printed is not yet read."""
        return self._process is not None

    def start(self):
        """Start the process.

        Raises
        ------
        ThinPartError
            When there is no Python.
        """
        program = python_program()
        self._errors = b""
        self._process = new_process(self)
        listen(self._process, self._slice.start, self._keep_errors, lambda *_: self._slice.start(),
               self._failed_to_start)
        QtWidgets.QApplication.instance().aboutToQuit.connect(self.end_now)
        start_module(self._process, program, f"thinpart_workbench.workflow.{self._module}")

    def say(self, **content):
        """Send it an object; nothing happens where it does not run."""
        if self._process is not None:
            self._process.write(json.dumps(content).encode() + b"\n")

    def end(self):
        """Have it end; it finishes what it is writing first, and nobody waits for that."""
        process = self._clear()
        if process is None:
            return
        hand_over(process)
        quitting = QtWidgets.QApplication.instance().aboutToQuit

        def wait():
            _wait_for(process)

        def forget(*_):
            quitting.disconnect(wait)
            process.deleteLater()

        quitting.connect(wait)
        process.finished.connect(forget)
        process.closeWriteChannel()

    def end_now(self):
        """End it and wait for that, since FreeCAD itself ends."""
        process = self._clear()
        if process is not None:
            process.closeWriteChannel()
            _wait_for(process)

    def _take_slice(self):
        end = time.monotonic() + SLICE_SECONDS
        while self._process is not None and self._process.canReadLine():
            if time.monotonic() > end:
                self._slice.start()
                return
            line = bytes(self._process.readLine())
            try:
                content = json.loads(line)
            except ValueError:
                continue  # half a line, from a process that was killed: the end tells
            self.told.emit(content)
        if self._process is not None and self._process.state() == QtCore.QProcess.NotRunning:
            self._finished()

    def _keep_errors(self):
        if self._process is not None:
            self._errors = (self._errors + bytes(self._process.readAllStandardError()))[-8000:]

    def _finished(self):
        self._keep_errors()
        process = self._clear()
        crashed = process.exitStatus() == QtCore.QProcess.CrashExit or process.exitCode() != 0
        process.deleteLater()
        if crashed:
            NOTICES.quote(self._errors.decode("utf-8", "replace"))
        self.ended.emit(translate(
            "ThinPart", "The process that does this ended unexpectedly; the report view has its last "
            "words. Refresh the libraries to go on.") if crashed else "")

    def _failed_to_start(self, error):
        if error == QtCore.QProcess.FailedToStart and self._process is not None:
            self._clear().deleteLater()
            self.ended.emit(translate("ThinPart", "The process that does this could not be started."))

    def _clear(self):
        process, self._process = self._process, None
        self._slice.stop()
        if process is not None:
            QtWidgets.QApplication.instance().aboutToQuit.disconnect(self.end_now)
        return process


def _wait_for(process):
    process.blockSignals(True)
    if not process.waitForFinished(_PATIENCE):
        process.kill()
        process.waitForFinished(_PATIENCE)


def started(process):
    """Start a process where it does not run; a sentence where that fails, else empty."""
    if not process.is_running:
        try:
            process.start()
        except ThinPartError as error:
            return translated(error)
    return ""

# SPDX-License-Identifier: LGPL-2.1-or-later
"""A child process of FreeCAD: starting it, reading its output, ending it and detaching it."""

import sys
import time

from ...freecad_adapter.python_beside_freecad import python_environment
from ...system.exit_cause import ProcessEnd
from ...system.priority import lower_priority
from ...system.python_process import module_command
from ..application.qt import QtCore, QtWidgets, Signal, disconnect
from .freecad_python import python_program

SLICE_SECONDS = 0.015
"""Longest time spent reading before control returns to the event loop."""

LAST_WORDS = 1 << 16
"""Bytes kept from the end of standard error: the cause of death, and the traces that faulthandler writes after it."""

_KILLED_SECONDS = 3.0
"""How long to wait for the end of a killed process."""


class ChildProcess(QtCore.QObject):
    """Runs a Python module in another process. It can be started again after it has ended.

    Parameters
    ----------
    parent : QObject, optional
    patience : float, optional
        When FreeCAD quits, seconds that the process may take to end after its standard input was closed; 0 kills it
        at once.
    read_delay : int, optional
        Milliseconds between the first available line and reading; the process fills its pipe meanwhile.

    Signals
    -------
    line(object), error_line(object)
        One line of standard output or standard error, bytes without the line end.
    slice_read()
        A slice of the output was read and emitted.
    ended(object)
        ProcessEnd: the process has ended by itself, and all its output was emitted.
    failed_to_start()
        The program does not exist, or the system could not start it.
    released()
        The process no longer works for this object, for whatever reason. Emitted before `ended` and
        `failed_to_start`. After `end_now`, `detach`, and when FreeCAD quits, it is the last signal.

    Notes
    -----
    No other module uses ``QProcess``. On computers with few processors, the process runs at a lower priority than
    the GUI.
    """

    line = Signal(object)
    error_line = Signal(object)
    slice_read = Signal()
    ended = Signal(object)
    failed_to_start = Signal()
    released = Signal()

    def __init__(self, parent=None, patience=0.0, read_delay=0):
        super().__init__(parent)
        self._patience = patience
        self._process = None
        self._read_delay = read_delay
        self._slice_timer = QtCore.QTimer(self, singleShot=True)
        self._slice_timer.timeout.connect(self._read_slice)
        self._deadline = QtCore.QTimer(self, singleShot=True)
        self._deadline.timeout.connect(self._kill)

    @property
    def is_running(self):
        """Whether the process is running, or some of its output is not emitted yet."""
        return self._process is not None

    @property
    def process_id(self):
        """Id of the process; None where none is running."""
        if self._process is None or self._process.state() == QtCore.QProcess.NotRunning:
            return None
        return self._process.processId() or None

    def start(self, module, arguments=(), folder=None):
        """Start a module with FreeCAD's Python.

        Parameters
        ----------
        module : str
            Its full name.
        arguments : iterable of str, optional
        folder : str, optional
            Working directory; by default FreeCAD's own.

        Raises
        ------
        ThinPartError
            When there is no Python.
        """
        (program, *program_arguments), variables = module_command(module, arguments, python_program())
        environment = QtCore.QProcessEnvironment()
        for name, value in {**python_environment(), **variables}.items():
            environment.insert(name, value)
        process = QtCore.QProcess(self)
        process.setProcessEnvironment(environment)
        if folder is not None:
            process.setWorkingDirectory(folder)
        self._has_ended, self._rest = False, b""
        self._last_words = b""
        # Set this first: `errorOccurred` may be emitted before `QProcess.start` returns.
        self._process = process
        process.started.connect(lambda: _step_back(process))
        process.readyReadStandardOutput.connect(self._schedule_read)
        process.readyReadStandardError.connect(self._schedule_read)
        process.finished.connect(self._on_finished)
        process.errorOccurred.connect(self._on_error)
        QtWidgets.QApplication.instance().aboutToQuit.connect(self._on_about_to_quit)
        process.start(program, program_arguments)

    def write(self, content):
        """Write bytes to standard input; does nothing where no process is running."""
        if self._process is not None:
            self._process.write(content)

    def close_input(self):
        """Close standard input after the process has read everything written so far."""
        if self._process is not None:
            self._process.closeWriteChannel()

    def kill_after(self, seconds):
        """Kill the process unless it ends within this time; its end is reported like any other."""
        if self._process is not None:
            self._deadline.start(int(seconds * 1000))

    def end_now(self, patience=0.0):
        """End the process and wait for that; only `released` is emitted.

        Parameters
        ----------
        patience : float, optional
            Seconds that the process may take to end after its standard input was closed; 0 kills it at once.
        """
        process = self._release()
        if process is not None:
            process.closeWriteChannel()
            _wait_for(process, patience)
            process.deleteLater()
            self.released.emit()

    def detach(self, kill=False):
        """Let the process finish on its own, without waiting for it while FreeCAD runs.

        Parameters
        ----------
        kill : bool, optional
            Kill it instead, where it has nothing left to finish; the system may take long to free its memory.
        """
        process = self._release()
        if process is None:
            return
        if process.state() == QtCore.QProcess.NotRunning:
            process.deleteLater()
        else:
            _detach(process, 0.0 if kill else self._patience)
            if kill:
                process.kill()
            else:
                process.closeWriteChannel()
        self.released.emit()

    def _on_about_to_quit(self):
        self.end_now(self._patience)

    def _kill(self):
        if self._process is not None:
            self._process.kill()

    def _schedule_read(self):
        if not self._slice_timer.isActive():
            self._slice_timer.start(self._read_delay)

    def _read_slice(self):
        """Read for at most `SLICE_SECONDS`, then let the event loop run before reading the rest."""
        process = self._process
        if process is None:
            return
        end = time.monotonic() + SLICE_SECONDS
        # A slot may end the process, or start the next one.
        while self._process is process and process.canReadLine() and time.monotonic() < end:
            self.line.emit(_without_line_end(bytes(process.readLine())))
        if self._process is process:
            self._read_errors(process)
        if self._process is not process:
            return
        is_all = not process.canReadLine()
        if is_all and self._has_ended:
            self._read_rest(process)
        if self._process is process:
            self.slice_read.emit()
        if self._process is not process:
            return
        if not is_all:
            self._slice_timer.start(0)
        elif self._has_ended:
            self._end(process)

    def _read_errors(self, process):
        output = bytes(process.readAllStandardError())
        self._last_words = (self._last_words + output)[-LAST_WORDS:]
        *lines, self._rest = (self._rest + output).split(b"\n")
        for line in lines:
            if self._process is process:
                self.error_line.emit(_without_line_end(line))

    def _read_rest(self, process):
        """Emit a last line that has no line end."""
        for signal, rest in ((self.line, bytes(process.readAllStandardOutput())), (self.error_line, self._rest)):
            if rest and self._process is process:
                signal.emit(rest)
        self._rest = b""

    def _on_finished(self, *_):
        self._has_ended = True
        self._slice_timer.start(0)

    def _end(self, process):
        self._release()
        end = ProcessEnd(_exit_code(process), self._last_words)
        process.deleteLater()
        self.released.emit()
        self.ended.emit(end)

    def _on_error(self, error):
        if error == QtCore.QProcess.FailedToStart and self._process is not None:
            self._release().deleteLater()
            self.released.emit()
            self.failed_to_start.emit()

    def _release(self):
        """Disconnect from the process and return it; None where there is none."""
        process, self._process = self._process, None
        self._slice_timer.stop()
        self._deadline.stop()
        if process is not None:
            QtWidgets.QApplication.instance().aboutToQuit.disconnect(self._on_about_to_quit)
            for signal in (process.readyReadStandardOutput, process.readyReadStandardError, process.finished,
                           process.errorOccurred):
                disconnect(signal)
        return process


def _exit_code(process):
    """Exit code as in `subprocess`, negative for a signal: Qt reports the signal's number as the code of a crash."""
    code = process.exitCode()
    if process.exitStatus() == QtCore.QProcess.CrashExit and sys.platform != "win32":
        return -code
    return code


def _without_line_end(line):
    return line.rstrip(b"\r\n")


def _detach(process, patience):
    """Reparent a released process to the application, so that it outlives its owner but not FreeCAD."""
    process.setParent(QtWidgets.QApplication.instance())
    quitting = QtWidgets.QApplication.instance().aboutToQuit

    def wait():
        _wait_for(process, patience)

    def forget(*_):
        disconnect(quitting, wait)
        process.deleteLater()

    quitting.connect(wait)
    process.finished.connect(forget)


def _wait_for(process, patience):
    if not patience or not process.waitForFinished(int(patience * 1000)):
        process.kill()
        process.waitForFinished(int(_KILLED_SECONDS * 1000))


def _step_back(process):
    """Give the GUI priority over the process where there are few processors."""
    process_id = process.processId()
    if process_id:  # 0 where it has ended already; that would lower the priority of FreeCAD itself
        try:
            lower_priority(process_id)
        except OSError:
            return  # it has ended meanwhile, which is reported elsewhere

"""Files that are being measured: the command line at work in another process."""

import json
import os
import time
from collections import deque, namedtuple
from contextlib import ExitStack

import FreeCAD as App

from ..core.errors import ThinPartError
from ..storage.part_table import failed_row, measured_row
from ..workflow.temporary_folder import temporary_folder
from .notices import NOTICES
from .qt import QtCore, QtWidgets, Signal, translate
from .sentences import translated
from .worker_python import listen, new_process, python_program, start_module

DONE, STOPPED, REFUSED, LOST = "done", "stopped", "refused", "lost"
"""How a run ended: to its end; as asked; it would not begin; unexpectedly."""

RunEnd = namedtuple("RunEnd", ("how", "sentence"))
"""The end of a run; `sentence` is empty where there is nothing to explain."""

_SLICE_SECONDS = 0.015
"""A record is 10 to 100 KB of JSON: after this long the window has its turn."""

_GATHERED_SECONDS = 0.1
"""Rows are told of together: each time, the table is painted anew, which takes as long as a slice."""

_GATHER = 30
"""Milliseconds from the first line of some to reading them; the process fills its pipe meanwhile."""

_PATIENCE = 20000
"""Milliseconds that a process has to stop in after it was asked to."""

_LAST_LINES = 40
_PROGRAM = "thinpart: "


class FolderRun(QtCore.QObject):
    """Runs a command for files and turns what it prints into rows.

    Parameters
    ----------
    command : str
        ``classify``, or another one that tells the same.

    Signals
    -------
    found(object)
        list of PartRow, files named by their places below the folder.
    progressed(object)
        The ``progress`` entry of the command line.
    state_changed(str)
        ``searching``, ``running`` or ``paused``.
    ended(object)
        RunEnd. Nothing follows it.
    """

    found = Signal(object)
    progressed = Signal(object)
    state_changed = Signal(str)
    ended = Signal(object)

    def __init__(self, parent=None, command="classify"):
        super().__init__(parent)
        self._command = command
        self._process = None
        self._slice = QtCore.QTimer(self, singleShot=True)
        self._slice.timeout.connect(self._take_slice)
        self._deadline = QtCore.QTimer(self, singleShot=True, interval=_PATIENCE)
        self._deadline.timeout.connect(self._force)

    @property
    def is_running(self):
        """Whether the process is at work, or some of what it printed is not yet read."""
        return self._process is not None

    def start(self, settings, only=()):
        """Start the process.

        Parameters
        ----------
        settings : FolderSettings or ReportSettings
        only : iterable of str, optional
            Absolute paths; nothing else in the folder is classified.

        Raises
        ------
        ThinPartError
            When there is no Python, or no room for the list of files.
        """
        program = python_program()
        self._folder = settings.folder
        self._stack = ExitStack()
        arguments = [self._command, "--json", "--control", *settings.arguments()]
        try:
            if only:
                arguments += ["--only", self._list(only)]
        except OSError as error:
            self._stack.close()
            raise ThinPartError(translate(
                "ThinPart", "There is no room for temporary files ({}): nothing was classified."
            ).format(error.strerror), "failed") from None
        self._total = self._last_progress = None
        self._stopping = self._has_ended = False
        self._rest, self._last_lines = b"", deque(maxlen=_LAST_LINES)
        self._rows, self._told = [], 0.0
        self._process = new_process(self)
        listen(self._process, self._gather, self._gather, self._finished, self._failed_to_start)
        QtWidgets.QApplication.instance().aboutToQuit.connect(self.end_now)
        start_module(self._process, program, "thinpart_workbench", arguments)

    def pause(self):
        """Begin no further file until `resume`."""
        self._say("pause")

    def resume(self):
        """Go on."""
        self._say("resume")

    def stop(self):
        """End soon; what was done is kept."""
        self._stopping = True
        self._say("stop")
        self._deadline.start()

    def end_now(self):
        """End and wait for it, since FreeCAD itself ends; what was done is kept."""
        process = self._process
        if process is None:
            return
        process.blockSignals(True)
        # The end of its input tells it to stop, and its own workers as well.
        process.closeWriteChannel()
        if not process.waitForFinished(_PATIENCE // 2):
            process.kill()
            process.waitForFinished(3000)
        self._clear()

    def _list(self, files):
        path = os.path.join(self._stack.enter_context(temporary_folder()), "only")
        with open(path, "wb") as file:
            file.write(b"\0".join(map(os.fsencode, files)))
        return path

    def _say(self, command):
        if self._process is not None:
            self._process.write(command.encode() + b"\n")

    def _force(self):
        if self._process is not None:
            self._process.kill()

    def _gather(self):
        if not self._slice.isActive():
            self._slice.start(_GATHER)

    def _take_slice(self):
        """Read for a moment; the rest has to wait until the window had its turn."""
        if self._process is None:
            return
        end = time.monotonic() + _SLICE_SECONDS
        while self._process.canReadLine() and time.monotonic() < end:
            row = self._row(self._process.readLine().data())
            if row is not None:
                self._rows.append(row)
        is_all = not self._process.canReadLine()
        if self._rows and (is_all or time.monotonic() > self._told + _GATHERED_SECONDS):
            rows, self._rows, self._told = self._rows, [], time.monotonic()
            self.found.emit(rows)
            if self._process is None:
                return  # whoever was told of the rows has ended the run
        self._take_messages()
        if not is_all:
            self._slice.start(0)
        elif self._has_ended:
            self._end()

    def _row(self, line):
        try:
            content = json.loads(line)
        except ValueError:
            return None  # half a line, from a process that was killed: the end tells
        place = os.path.relpath(content["file"], self._folder)
        if "error" in content:
            return failed_row(place, content.get("name"), content.get("label"), content["error"])
        return measured_row(place, content)

    def _take_messages(self):
        *lines, self._rest = (
            self._rest + self._process.readAllStandardError().data()).split(b"\n")
        progress = None
        for line in lines:
            content = _content(line)
            if "state" in content:
                self.state_changed.emit(content["state"])
            elif "progress" in content:
                progress = content["progress"]
            else:
                self._last_lines.append(line.decode("utf-8", "replace"))
        if progress is not None:
            self._last_progress = progress
            self.progressed.emit(progress)

    def _finished(self, *_):
        self._has_ended = True
        self._slice.start(0)

    def _failed_to_start(self, error):
        if error == QtCore.QProcess.FailedToStart:
            self._clear()
            self.ended.emit(RunEnd(LOST, translate(
                "ThinPart", "The process that classifies could not be started.")))

    def _end(self):
        """The process has ended and all that it printed is read."""
        crashed = self._process.exitStatus() == QtCore.QProcess.CrashExit
        code = None if crashed else self._process.exitCode()
        if self._rest:
            self._last_lines.append(self._rest.decode("utf-8", "replace"))
        stopping = self._stopping
        self._clear()
        self.ended.emit(self._how_it_ended(code, stopping))

    def _how_it_ended(self, code, stopping):
        progress = self._last_progress or {"done": 0, "total": None}
        if code in (0, 1) and progress["done"] == progress["total"]:
            return RunEnd(DONE, "")
        if stopping or code == 130:
            return RunEnd(STOPPED, "")
        told = [each for each in self._last_lines if each.startswith(_PROGRAM)]
        if code in (1, 2) and told and self._last_lines[-1] == told[-1]:
            return RunEnd(REFUSED, translated(told[-1][len(_PROGRAM):]))
        NOTICES.quote("\n".join(self._last_lines))
        return RunEnd(LOST, translate(
            "ThinPart", "The process that classifies ended unexpectedly; what was done is kept. "
            "Start again for the rest; the report view has its last words."))

    def _clear(self):
        process, self._process = self._process, None
        QtWidgets.QApplication.instance().aboutToQuit.disconnect(self.end_now)
        self._slice.stop()
        self._deadline.stop()
        process.deleteLater()
        self._stack.close()


def _content(line):
    """What a line of progress says; empty where it is a sentence for people."""
    if line.startswith(b"{"):
        try:
            content = json.loads(line)
        except ValueError:
            return {}
        return content if isinstance(content, dict) else {}
    return {}

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs a ThinPart command over files in another process."""

import json
import os
import time
from collections import deque, namedtuple
from contextlib import ExitStack

from ...core.errors import ThinPartError
from ...core.message import restored
from ...storage.part_table import checked_row, failed_row
from ...storage.temporary_folder import temporary_folder
from ..application import lifelong
from ..application.qt import QtCore, Signal, translate
from ..application.sentences import translated
from .child_process import ChildProcess

DONE, STOPPED, REFUSED, LOST = "done", "stopped", "refused", "lost"
"""Outcome of a run: complete; stopped on request; refused to start; ended unexpectedly."""

RunEnd = namedtuple("RunEnd", ("outcome", "sentence"))
"""The end of a run; `sentence` is empty where there is nothing to explain."""

_BATCH_SECONDS = 0.25
"""Rows are emitted in batches, this long apart: each batch repaints the table, which takes as long as reading a slice."""

_READ_DELAY = 30
"""Milliseconds between the first available line and reading; the process fills its pipe meanwhile."""

_PATIENCE = 20.0
"""Seconds that the process may take to stop after it was asked to."""

_LAST_LINES = 40
_PROGRAM = "thinpart: "


class CommandLineRun(QtCore.QObject):
    """Runs a command over files and turns its output into rows.

    Parameters
    ----------
    command : str
        ``classify``, or another one with the same output.

    Signals
    -------
    found(object)
        list of PartRow, with paths relative to the folder.
    progressed(object)
        The ``progress`` entry of the command line.
    state_changed(str)
        ``searching``, ``running`` or ``paused``.
    ended(object)
        RunEnd. The last signal of a run.
    """

    found = Signal(object)
    progressed = Signal(object)
    state_changed = Signal(str)
    ended = Signal(object)

    def __init__(self, parent=None, command="classify"):
        super().__init__(parent)
        self._command = command
        # When its standard input closes, it stops, and so do its workers; finished results are kept.
        self._process = ChildProcess(self, patience=_PATIENCE / 2, read_delay=_READ_DELAY)
        self._process.line.connect(self._on_line)
        self._process.error_line.connect(self._on_error_line)
        self._process.slice_read.connect(self._emit_batch)
        self._batch_timer = QtCore.QTimer(self, singleShot=True)
        self._batch_timer.timeout.connect(self._emit_rows)
        self._process.ended.connect(self._on_ended)
        self._process.failed_to_start.connect(self._on_failed_to_start)
        self._process.released.connect(self._on_released)

    @property
    def is_running(self):
        """Whether the process is running, or some of its output is not read yet."""
        return self._process.is_running

    def start(self, settings, only=()):
        """Start the process.

        Parameters
        ----------
        settings : FolderSettings or ReportSettings
        only : iterable of str, optional
            Absolute paths; the other files of the folder are skipped.

        Raises
        ------
        ThinPartError
            When there is no Python, or no disk space for the list of files.
        """
        self._folder = settings.folder
        self._stack = ExitStack()
        arguments = [self._command, "--json", "--control", *settings.arguments()]
        try:
            if only:
                arguments += ["--only", self._write_list(only)]
        except OSError as error:
            self._stack.close()
            raise ThinPartError(translate(
                "ThinPart", "Temporary files cannot be written ({}): free some disk space. Nothing was classified."
            ).format(error.strerror), "failed") from None
        self._last_progress = self._refusal = None
        self._stopping = False
        self._last_lines = deque(maxlen=_LAST_LINES)
        self._rows, self._messages, self._last_batch = [], [], 0.0
        try:
            self._process.start("thinpart_workbench", arguments)
        except ThinPartError:
            self._stack.close()
            raise

    def pause(self):
        """Start no further file until `resume`."""
        self._send("pause")

    def resume(self):
        """Continue after `pause`."""
        self._send("resume")

    def stop(self):
        """Ask the process to stop, and kill it if it does not; finished results are kept."""
        self._stopping = True
        self._send("stop")
        self._process.kill_after(_PATIENCE)

    def end_now(self):
        """End the process and wait for it, because FreeCAD quits; finished results are kept."""
        self._process.end_now(_PATIENCE / 2)

    def _write_list(self, files):
        path = os.path.join(self._stack.enter_context(temporary_folder()), "only")
        with open(path, "wb") as file:
            file.write(b"\0".join(map(os.fsencode, files)))
        return path

    def _send(self, command):
        self._process.write(command.encode() + b"\n")

    def _on_line(self, line):
        row = self._row(line)
        if row is not None:
            self._rows.append(row)

    def _on_error_line(self, line):
        self._messages.append(line)

    def _emit_batch(self):
        """Emit the rows read so far, unless more can be emitted together with them."""
        left = self._last_batch + _BATCH_SECONDS - time.monotonic()
        if left <= 0.0:
            self._emit_rows()
        elif self._rows and not self._batch_timer.isActive():
            self._batch_timer.start(int(1000.0 * left) + 1)
        if self.is_running:  # a slot of `found` may have ended the run
            self._emit_messages()

    def _emit_rows(self):
        if self._rows:
            rows, self._rows, self._last_batch = self._rows, [], time.monotonic()
            self.found.emit(rows)

    def _row(self, line):
        try:
            content = restored(json.loads(line))
        except ValueError:
            return None  # half a line, from a process that was killed; `ended` follows
        path = os.path.relpath(content["file"], self._folder)
        if "error" in content:
            return failed_row(path, content.get("name"), content.get("label"), content["error"])
        return checked_row(path, content)

    def _emit_messages(self):
        lines, self._messages = self._messages, []
        progress = None
        for line in lines:
            content = _content(line)
            if "state" in content:
                self._emit_rows()  # paused: nothing comes after that but what is at work
                self.state_changed.emit(content["state"])
            elif "progress" in content:
                progress = content["progress"]
            elif "failure" in content:
                self._refusal = content["failure"]["message"]
            else:
                self._last_lines.append(line.decode("utf-8", "replace"))
        if progress is not None:
            self._last_progress = progress
            self.progressed.emit(progress)

    def _on_failed_to_start(self):
        self.ended.emit(RunEnd(LOST, translate("ThinPart", "The classification process could not be started.")))

    def _on_ended(self, end):
        self._emit_rows()
        self.ended.emit(self._run_end(end.code, self._stopping))

    def _run_end(self, code, stopping):
        progress = self._last_progress or {"done": 0, "total": None}
        if code in (0, 1, 3) and progress["done"] == progress["total"]:
            return RunEnd(DONE, "")
        if stopping or code == 130:
            return RunEnd(STOPPED, "")
        errors = [line for line in self._last_lines if line.startswith(_PROGRAM)]
        if code in (1, 2) and errors and self._last_lines[-1] == errors[-1]:
            return RunEnd(REFUSED, translated(self._refusal or errors[-1][len(_PROGRAM):]))
        lifelong.notifications.report_output("\n".join(self._last_lines))
        return RunEnd(LOST, translate(
            "ThinPart", "The classification process ended unexpectedly; finished results are saved. Start again for "
                        "the rest; the report view shows its last output."))

    def _on_released(self):
        """Remove the list of files, which the process no longer needs."""
        self._batch_timer.stop()
        self._stack.close()


def _content(line):
    """The JSON object of a line on standard error; empty where the line is plain text."""
    if line.startswith(b"{"):
        try:
            content = restored(json.loads(line))
        except ValueError:
            return {}
        return content if isinstance(content, dict) else {}
    return {}

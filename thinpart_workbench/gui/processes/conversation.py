# SPDX-License-Identifier: LGPL-2.1-or-later
"""A child process that exchanges JSON lines with the window, and reports its end as a sentence."""

import json

import FreeCAD as App

from ...core.errors import NO_MEMORY, ThinPartError
from ...core.message import restored, with_messages
from ...system.exit_cause import ExitCause
from ..application import lifelong
from ..application.qt import Signal, translate
from ..application.sentences import translated
from .child_process import ChildProcess

PATIENCE = 3.0
"""Seconds that such a process may take to end when FreeCAD quits."""


class Conversation(ChildProcess):
    """Runs a module of `window_processes` in another process.

    Parameters
    ----------
    module : str
        Such as ``library_worker``.
    parent : QObject, optional
    patience : float, optional
        See `ChildProcess`.
    arguments : iterable of str, optional
        Of its command line.

    Attributes
    ----------
    failure : dict or None
        ``kind`` and ``message``: why the process could not do its job, if it has reported that.

    Signals
    -------
    received(object)
        A dict that the process has printed. A failure of the process itself is stored in `failure` instead.
    finished(str)
        The process has ended by itself, or could not be started: empty on success, else one sentence.
    """

    received = Signal(object)
    finished = Signal(str)

    def __init__(self, module, parent=None, patience=PATIENCE, arguments=()):
        super().__init__(parent, patience)
        self._module = f"thinpart_workbench.window_processes.{module}"
        self._arguments = arguments
        self.failure = None
        self.line.connect(self._on_line)
        self.ended.connect(lambda end: self.finished.emit(self._sentence(end)))
        self.failed_to_start.connect(lambda: self.finished.emit(self.not_started()))

    def start(self, folder=None):
        """Start the process; see `ChildProcess.start`."""
        self.failure = None
        super().start(self._module, self._arguments, folder)

    def ensure_started(self):
        """Start the process if it is not running; returns an error sentence, empty on success."""
        if not self.is_running:
            try:
                self.start()
            except ThinPartError as error:
                return translated(error)
        return ""

    def send(self, **content):
        """Send a JSON object; does nothing where the process is not running."""
        self.write(json.dumps(with_messages(content)).encode() + b"\n")

    def _on_line(self, line):
        try:
            content = restored(json.loads(line))
        except ValueError:
            return  # half a line, from a process that was killed; `ended` follows
        failure = content.get("failure")
        # A failure that names a part concerns only that part.
        if failure is not None and "part" not in failure:
            self.failure = failure
        else:
            self.received.emit(content)

    def not_started(self):
        """The sentence for a process that cannot be started."""
        return translate("ThinPart", "The worker process could not be started.")

    def _sentence(self, end):
        cause = end.cause()
        if self.failure is None and cause is ExitCause.WELL:
            return ""
        if self.failure is not None:
            App.Console.PrintLog(end.text + "\n")  # the traceback of an unexpected exception
            return translated(self.failure["message"])
        lifelong.notifications.report_output(end.text)
        if cause is ExitCause.OUT_OF_MEMORY:
            return translated(NO_MEMORY)
        return translate(
            "ThinPart", "The worker process ended unexpectedly; the report view shows its last output.")

"""A child process that exchanges JSON lines with the GUI."""

import json

from ...core.message import restored, with_messages
from ..application.qt import Signal
from .child_process import ChildProcess

PATIENCE = 3.0
"""Seconds that such a process may take to end when FreeCAD quits."""


class JsonClient(ChildProcess):
    """Runs a module of `window_processes` in another process.

    Parameters
    ----------
    module : str
        Such as ``library_worker``.
    parent : QObject, optional
    patience : float, optional
        See `ChildProcess`.

    Attributes
    ----------
    failure : dict or None
        ``kind`` and ``message``: why the process could not do its job, if it has reported that.

    Signals
    -------
    received(object)
        A dict that the process has printed. A failure of the process itself is stored in `failure` instead.
    """

    received = Signal(object)

    def __init__(self, module, parent=None, patience=PATIENCE):
        super().__init__(parent, patience)
        self._module = f"thinpart_workbench.window_processes.{module}"
        self.failure = None
        self.line.connect(self._on_line)

    def start(self, folder=None):
        """Start the process; see `ChildProcess.start`."""
        self.failure = None
        super().start(self._module, folder=folder)

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

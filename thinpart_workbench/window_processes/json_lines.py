# SPDX-License-Identifier: LGPL-2.1-or-later
"""Communication with the parent process: one JSON object per line on stdin and stdout."""

import json
import os
import queue
import sys
import threading
from contextlib import contextmanager

from ..api.classified_parts import PartFailure
from ..core.message import restored, with_messages
from ..system.pipe_input import is_readable


class JsonLines:
    """The messages from and to the parent process.

    Parameters
    ----------
    in_thread : bool, optional
        Whether a thread reads them. A process must not have one that is confined later: threads that there are stay free.

    Attributes
    ----------
    incoming : queue.Queue
        Messages (dict) that the thread has received, and None when the parent has closed the pipe or has ended.
    ended : threading.Event
        Set at that time, while there may still be messages to be handled.
    """

    def __init__(self, in_thread=True):
        self.incoming: queue.Queue = queue.Queue()
        self.ended = threading.Event()
        # Output that other code prints to stdout must not mix with the lines.
        pipe = os.dup(1)
        os.dup2(2, 1)
        self._out = os.fdopen(pipe, "w", encoding="utf-8")
        self._lock = threading.Lock()
        if in_thread:
            threading.Thread(target=self._read_lines, daemon=True).start()

    def send(self, **content):
        """Send a message to the parent, with the templates and fields of its `Message` texts; thread-safe.

        JSON escapes preserve file names that are not valid text.
        """
        line = json.dumps(with_messages(content)) + "\n"
        with self._lock:
            self._out.write(line)
            self._out.flush()

    def receive(self, patience=None):
        """The next message where no thread reads them; None at the end of the input, or after some seconds without any."""
        line = b""
        while not line.endswith(b"\n"):
            # Not buffered: what a buffer holds is not in the pipe, on which the next call waits.
            byte = os.read(0, 1) if is_readable(0, patience) else b""
            if not byte:
                return None
            line += byte
        return restored(json.loads(line))

    @contextmanager
    def reporting_failures(self):
        """For a ``with`` block: send an exception as ``failure`` and end the process."""
        try:
            yield
        except Exception as error:  # the parent is waiting for an answer
            failure = PartFailure.of_exception(error)
            self.send(failure={"kind": failure.kind, "message": failure.message})
            self.end(1)

    def end(self, status=0):
        """End the process at once, without waiting for its other threads."""
        with self._lock:
            self._out.flush()
        sys.stderr.flush()
        os._exit(status)

    def _read_lines(self):
        # Not sys.stdin: a forked child closes it, and would wait for the lock that this thread holds on it.
        with os.fdopen(os.dup(0), "rb") as lines:
            for line in lines:
                self.incoming.put(restored(json.loads(line)))
        self.incoming.put(None)
        self.ended.set()

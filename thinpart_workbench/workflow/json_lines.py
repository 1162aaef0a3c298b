"""Conversations with a parent process: a JSON object a line on stdin and stdout."""

import json
import os
import queue
import sys
import threading


class JsonLines:
    """What the parent says and is told.

    Attributes
    ----------
    incoming : queue.Queue
        dict objects, and None where the parent has closed its end or is gone.
    """

    def __init__(self):
        self.incoming = queue.Queue()
        # Whatever else prints to stdout must not come between the lines.
        private = os.dup(1)
        os.dup2(2, 1)
        self._out = os.fdopen(private, "w", encoding="utf-8")
        self._lock = threading.Lock()
        threading.Thread(target=self._listen, daemon=True).start()

    def say(self, **content):
        """Tell the parent; from any thread. Escapes keep names that are no text as they are."""
        line = json.dumps(content) + "\n"
        with self._lock:
            self._out.write(line)
            self._out.flush()

    def end(self):
        """End the process at once: threads that still listen or work have nobody to tell."""
        with self._lock:
            self._out.flush()
        sys.stderr.flush()
        os._exit(0)

    def _listen(self):
        # Not sys.stdin: a process forked meanwhile closes that, and would wait for this thread's lock on it.
        with os.fdopen(os.dup(0), "rb") as lines:
            for line in lines:
                self.incoming.put(json.loads(line))
        self.incoming.put(None)

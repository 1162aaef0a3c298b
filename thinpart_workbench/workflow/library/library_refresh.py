# SPDX-License-Identifier: LGPL-2.1-or-later
"""Refreshing the indexes of libraries in a background thread."""

import os
import threading
import time

from ...core.errors import Cancelled, ThinPartError
from ...core.message import message
from ...core.run_control import RunControl
from ...storage.index.library_index import LibraryIndex

PROGRESS_INTERVAL = 0.1
"""Seconds between two ``progress`` messages."""

GROWN_INTERVAL = 4.0
"""Seconds between two ``grown`` messages."""


class LibraryRefresh:
    """A thread that refreshes the indexes of libraries, one after the other.

    Parameters
    ----------
    on_message : callable
        Called in the thread with a dict: ``{"ask": "progress", "root", "done", "total"}``,
        ``{"ask": "grown", "root"}`` when the index contains more than before, and at the end
        ``{"ask": "refreshed", "root", "index", "problems", "stopped"}``.
    """

    def __init__(self, on_message):
        self._on_message = on_message
        self._pending, self._changed = [], threading.Condition()
        self._control = RunControl()
        self._current = None
        threading.Thread(target=self._run, daemon=True).start()

    def add(self, root):
        """Queue a library; one that is being refreshed is refreshed once more."""
        with self._changed:
            if root not in self._pending:
                self._pending.append(root)
                self._changed.notify()

    def stop(self):
        """Stop the current refresh and cancel the queued ones."""
        with self._changed:
            for root in self._pending:
                self._on_message({"ask": "refreshed", "root": root, "index": None, "problems": [], "stopped": True})
            self._pending.clear()
            if self._current is not None:
                self._control.stop()

    def _run(self):
        while True:
            with self._changed:
                self._changed.wait_for(lambda: self._pending)
                self._current = self._pending.pop(0)
                self._control = RunControl()
            result = self._refresh(self._current)
            with self._changed:
                self._current = None
            self._on_message({"ask": "refreshed", **result})

    def _refresh(self, root):
        index, problems, stopped = LibraryIndex(root), [], False
        self._on_message({"ask": "progress", "root": root, "done": 0, "total": 0})
        try:
            if not os.path.isdir(root):
                problems.append(
                    message("The folder {folder} no longer exists: restore it, or remove it from the list.",
                            folder=root))
            else:
                refreshed = index.refresh(self._reporter(root))
                problems += refreshed.unreachable
        except Cancelled:
            stopped = True
        except ThinPartError as error:
            problems.append(str(error))
        except OSError as error:
            problems.append(message("The library {folder} cannot be read ({problem}).",
                                    folder=root, problem=error.strerror))
        if index.warning:
            problems.append(index.warning)
        else:
            index.close()
        return {"root": root, "index": index, "problems": problems, "stopped": stopped}

    def _reporter(self, root):
        last_progress = last_grown = time.monotonic()

        def report(done, total):
            nonlocal last_progress, last_grown
            self._control.check()
            now = time.monotonic()
            if now - last_progress >= PROGRESS_INTERVAL:
                last_progress = now
                self._on_message({"ask": "progress", "root": root, "done": done, "total": total})
            if done and now - last_grown >= GROWN_INTERVAL:
                last_grown = now
                self._on_message({"ask": "grown", "root": root})

        return report

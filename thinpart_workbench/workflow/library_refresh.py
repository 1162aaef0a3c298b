"""Bringing the indexes of libraries up to date beside other work."""

import os
import threading
import time

from ..core.errors import ThinPartError
from ..storage.library_index import LibraryIndex

TOLD_EVERY = 0.1
"""Seconds between two reports of progress."""

SHOWN_EVERY = 4.0
"""Seconds after which what was read so far is worth looking at."""


class _Stopped(Exception):
    """Somebody asked to stop."""


class LibraryRefresh:
    """A thread that refreshes the indexes that it is given, one after the other.

    Parameters
    ----------
    tell : callable
        Called in the thread with dict objects: ``{"ask": "progress", "root", "done", "total"}``,
        ``{"ask": "grown", "root"}`` where more can be read from the index than before, and at the end
        ``{"ask": "refreshed", "root", "index", "problems", "stopped"}``.
    """

    def __init__(self, tell):
        self._tell = tell
        self._waiting, self._changed = [], threading.Condition()
        self._stop = threading.Event()
        self._now = None
        threading.Thread(target=self._work, daemon=True).start()

    def add(self, root):
        """Refresh a library as soon as the others are done; once more where it is at work."""
        with self._changed:
            if root not in self._waiting:
                self._waiting.append(root)
                self._changed.notify()

    def stop(self):
        """Leave off what is going on, and what is waiting."""
        with self._changed:
            for root in self._waiting:
                self._tell({"ask": "refreshed", "root": root, "index": None, "problems": [], "stopped": True})
            self._waiting.clear()
            if self._now is not None:
                self._stop.set()

    def _work(self):
        while True:
            with self._changed:
                self._changed.wait_for(lambda: self._waiting)
                self._now = self._waiting.pop(0)
                self._stop.clear()
            told = self._refresh(self._now)
            with self._changed:
                self._now = None
            self._tell({"ask": "refreshed", **told})

    def _refresh(self, root):
        index, problems, stopped = LibraryIndex(root), [], False
        self._tell({"ask": "progress", "root": root, "done": 0, "total": 0})
        try:
            if not os.path.isdir(root):
                problems.append(
                    f"There is no folder {root} any more: bring it back, or remove it from the list.")
            else:
                refreshed = index.refresh(self._reporter(root))
                problems += refreshed.unreachable
        except _Stopped:
            stopped = True
        except ThinPartError as error:
            problems.append(str(error))
        except OSError as error:
            problems.append(f"The library {root} cannot be read ({error.strerror}).")
        if index.warning:
            problems.append(index.warning)
        else:
            index.close()
        return {"root": root, "index": index, "problems": problems, "stopped": stopped}

    def _reporter(self, root):
        told = shown = time.monotonic()

        def report(done, total):
            nonlocal told, shown
            if self._stop.is_set():
                raise _Stopped
            now = time.monotonic()
            if now - told >= TOLD_EVERY:
                told = now
                self._tell({"ask": "progress", "root": root, "done": done, "total": total})
            if done and now - shown >= SHOWN_EVERY:
                shown = now
                self._tell({"ask": "grown", "root": root})

        return report

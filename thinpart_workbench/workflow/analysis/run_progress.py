# SPDX-License-Identifier: LGPL-2.1-or-later
"""The progress of a run over many files, and its remaining time."""

import math
import time
from collections import defaultdict

_FILE_COST = 40_000
"""Fixed cost of a file (opening, box, writing), in bytes that take as long to measure."""

_LONGEST_GAP = 1.0
"""Seconds; a longer gap between two reused files was a pause."""

_MIN_REUSED_FILES = 20
"""Reused files from which on their pace is known; the first ones wait for a worker to start."""


_SIMILAR = 2.0
"""Files are similar whose costs differ by less than a factor of about this: they vote on each other's time."""


class RunProgress:
    """Counts of files, and the time left.

    Reused files take milliseconds and say nothing about the others. So the time left is that of the bytes
    still to be measured, at the pace of the files of similar size measured so far. It is None until every worker has
    measured a file (its first one includes loading FreeCAD) or a tenth is done.

    Files that are quick to measure end first, so that the first paces are too fast. What workers have spent on files
    that are not done yet counts too, as with lifetimes of which some have not ended: the pace is at least all time
    spent over all that is done.

    Parameters
    ----------
    files : dict
        Path to (bytes, whether the info file will probably be reused).
    jobs : int
        Number of workers; may be changed while a cluster grows and shrinks.
    control : RunControl, optional
        Knows for how long the run was paused.
    """

    def __init__(self, files, jobs, control=None):
        self._files = dict(files)
        self.jobs = jobs
        self._started = self._last_time = time.monotonic()
        self.total = len(self._files)
        self.done = self.failed = self.reused = 0
        self._remaining: dict[bool, list[float]] = {True: [0, 0], False: [0, 0]}  # whether unchanged: files, cost
        for size, unchanged in self._files.values():
            self._remaining[unchanged][0] += 1
            self._remaining[unchanged][1] += size + _FILE_COST
        self._total_cost = self._remaining[False][1]
        # By size: number and cost of the files to measure, cost and seconds of the measured ones.
        self._classes: defaultdict[int, list[float]] = defaultdict(lambda: [0, 0.0, 0.0, 0.0])
        for size, unchanged in self._files.values():
            if not unchanged:
                self._count(size + _FILE_COST, 1)
        self._control = control
        self._measured, self._measured_cost, self._measured_seconds = 0, 0, 0.0
        self._reused_seconds = 0.0
        self._unchanged_done, self._unchanged_measured = 0, 0  # of the unchanged files

    def add(self, outcome):
        """Count the outcome of a file."""
        size, unchanged = self._files.pop(outcome["file"])
        cost = size + _FILE_COST
        self._remaining[unchanged][0] -= 1
        self._remaining[unchanged][1] -= cost
        if not unchanged:
            self._count(cost, -1)
        now = time.monotonic()
        gap = 0.0 if self.done < self.jobs else min(now - self._last_time, _LONGEST_GAP)
        self._last_time = now
        reused = bool(outcome.get("reused"))
        self.done += 1
        self.failed += bool("error" in outcome or outcome["failures"])
        self.reused += reused
        if unchanged:
            self._unchanged_done += 1
            self._unchanged_measured += not reused
        if reused:
            self._reused_seconds += gap
        elif outcome.get("seconds") is not None:
            self._measured += 1
            self._measured_cost += cost
            self._measured_seconds += outcome["seconds"]
            similar = self._classes[_size_class(cost)]
            similar[2] += cost
            similar[3] += outcome["seconds"]

    def seconds_left(self):
        """Seconds until the last file is done; None as long as they cannot be estimated."""
        files, cost = self._remaining[False]
        unchanged_files, unchanged_cost = self._remaining[True]
        # The info files of unchanged files may have other settings: then these files are measured too.
        share = self._unchanged_measured / self._unchanged_done if self._unchanged_done else 0.0
        cost += share * unchanged_cost
        files += share * unchanged_files
        seconds = 0.0
        if unchanged_files:
            if self._unchanged_done < min(_MIN_REUSED_FILES, self._unchanged_done + unchanged_files - 1):
                return None
            if self.reused:
                seconds += (1 - share) * unchanged_files * self._reused_seconds / self.reused
        if files > 0:
            enough = self._measured >= self.jobs or 10 * self._measured_cost >= self._total_cost > 0
            if not self._measured or not enough:
                return None
            seconds += self._work_left(cost) / max(1.0, min(self.jobs, files))
        return seconds

    def _count(self, cost, files):
        similar = self._classes[_size_class(cost)]
        similar[0] += files
        similar[1] += files * cost

    def _work_left(self, cost):
        """Seconds of one worker that files of some cost take, most of them those of `_classes`."""
        pace = self._measured_seconds / self._measured_cost
        left = waiting = 0.0
        measured = [(size, *entry[2:]) for size, entry in self._classes.items() if entry[2]]
        for size, (files, class_cost, _, _) in self._classes.items():
            if files <= 0:
                continue
            # One file at the common pace votes with those of similar size, each by how similar it is.
            votes_cost = class_cost / files
            votes_seconds = votes_cost * pace
            for other, other_cost, other_seconds in measured:
                weight = math.exp(-0.5 * (size - other) ** 2)
                votes_cost += weight * other_cost
                votes_seconds += weight * other_seconds
            left += class_cost * votes_seconds / votes_cost
            waiting += class_cost
        left += max(0.0, cost - waiting) * pace
        return left * max(1.0, self._seconds_at_work() / self._measured_seconds) if self._measured_seconds else left

    def _seconds_at_work(self):
        """Seconds that all workers together have spent, those on files that are not done yet included."""
        elapsed = time.monotonic() - self._started
        if self._control is not None:
            elapsed -= self._control.paused_seconds
        return min(self.jobs, self.total - self.reused) * elapsed - self._reused_seconds

    def content(self, file=None):
        """The content of a ``progress`` message; `file` is the one that has just finished."""
        left = self.seconds_left()
        return {
            "done": self.done, "total": self.total, "failed": self.failed, "reused": self.reused,
            "seconds": round(time.monotonic() - self._started, 1),
            "seconds_left": None if left is None else round(left, 1), "file": file,
        }


def _size_class(cost):
    """Logarithm of a cost, rounded: classes of `_SIMILAR` files."""
    return round(math.log(cost, _SIMILAR))

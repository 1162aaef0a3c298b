"""How far a run over many files is, and how long the rest takes."""

import time

_FILE_COST = 40_000
"""Bytes that take as long as what every file costs however small it is (opening, box, writing)."""

_LONGEST_GAP = 1.0
"""Seconds; what lies longer between two files that were only looked up was a pause."""

_LOOKED_UP_AT_LEAST = 20
"""Files that were only looked up, from which their pace is known; the first ones wait for a worker."""


class RunProgress:
    """Counts of files, and the time left.

    Parameters
    ----------
    files : dict
        Path to (bytes, whether the file will likely be taken from its info file).
    jobs : int
        Files at once; may be set anew while a cluster grows and shrinks.

    Notes
    -----
    Files that are looked up take milliseconds and say nothing about the others. So the time left is
    that of the bytes still to be measured, at the pace of those that were measured. It is None until
    every worker has measured a file (its first one includes loading FreeCAD) or a tenth is done.
    """

    def __init__(self, files, jobs):
        self._files = dict(files)
        self.jobs = jobs
        self._started = self._last = time.monotonic()
        self.total = len(self._files)
        self.done = self.failed = self.reused = 0
        self._left = {True: [0, 0], False: [0, 0]}  # likely reused: files, cost
        for size, unchanged in self._files.values():
            self._left[unchanged][0] += 1
            self._left[unchanged][1] += size + _FILE_COST
        self._all = self._left[False][1]
        self._measured, self._measured_cost, self._measured_seconds = 0, 0, 0.0
        self._reused_seconds = 0.0
        self._seen, self._changed = 0, 0  # of those that were likely reused

    def add(self, outcome):
        """One file has ended."""
        size, unchanged = self._files.pop(outcome["file"])
        cost = size + _FILE_COST
        self._left[unchanged][0] -= 1
        self._left[unchanged][1] -= cost
        now = time.monotonic()
        gap = 0.0 if self.done < self.jobs else min(now - self._last, _LONGEST_GAP)
        self._last = now
        reused = bool(outcome.get("reused"))
        self.done += 1
        self.failed += bool("error" in outcome or outcome["failures"])
        self.reused += reused
        if unchanged:
            self._seen += 1
            self._changed += not reused
        if reused:
            self._reused_seconds += gap
        elif outcome.get("seconds") is not None:
            self._measured += 1
            self._measured_cost += cost
            self._measured_seconds += outcome["seconds"]

    def seconds_left(self):
        """Seconds until the last file has ended; None while there is no basis for it."""
        files, cost = self._left[False]
        looked_up, looked_up_cost = self._left[True]
        # Info files may turn out to be of other settings: then these files are measured too.
        share = self._changed / self._seen if self._seen else 0.0
        cost += share * looked_up_cost
        files += share * looked_up
        seconds = 0.0
        if looked_up:
            if self._seen < min(_LOOKED_UP_AT_LEAST, self._seen + looked_up - 1):
                return None
            if self.reused:
                seconds += (1 - share) * looked_up * self._reused_seconds / self.reused
        if files > 0:
            enough = self._measured >= self.jobs or 10 * self._measured_cost >= self._all > 0
            if not self._measured or not enough:
                return None
            pace = self._measured_seconds / self._measured_cost
            seconds += cost * pace / max(1.0, min(self.jobs, files))
        return seconds

    def content(self, file=None):
        """The ``progress`` that programs are told; `file` is the one that has just ended."""
        left = self.seconds_left()
        return {
            "done": self.done, "total": self.total, "failed": self.failed, "reused": self.reused,
            "seconds": round(time.monotonic() - self._started, 1),
            "seconds_left": None if left is None else round(left, 1), "file": file,
        }

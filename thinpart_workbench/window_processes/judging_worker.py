# SPDX-License-Identifier: LGPL-2.1-or-later
"""The process that judges libraries again for the window: it counts what a profile would change, and writes it.

Requests, each a JSON object with the key ``ask``. One that comes meanwhile ends the one before:

``open``
    ``roots``: the folders; what was read of others is forgotten.
``judge``
    ``serial`` and ``profile``, its content. Sends ``counted``, again and again while info files are being read: the
    ``serial``, the fields of `ChangeCounts`, and ``read``, ``total``, ``failed`` and ``problems`` of `VerdictChanges`.
``parts``
    ``serial``, ``before`` and ``after``. Sends ``parts``: these, and ``rows``, dicts of `ChangedPart`. Nothing for a profile
    that is no longer the last one counted.
``write``
    ``profile``. Sends ``written``, again and again: ``done`` of ``total`` info files, ``changed`` and ``failed`` of them,
    ``problems``, and ``ended``: whether that was all there is to be said. Then the folders are read anew.
``stop``
    Only ends what is being done.
"""

import os
import queue
import time

from ..api.reclassification import reclassify_folders, verdict_changes
from ..core.errors import Cancelled, ThinPartError
from ..core.judging.criteria import usable_profile
from ..core.run_control import RunControl
from .json_lines import JsonLines

MOST_PARTS = 1000
"""Parts of a change that are sent."""

MOST_PROBLEMS = 20
"""Sentences about info files that could not be written; further ones are only counted."""

_READING_SECONDS = 0.2
"""Time of reading between two looks for requests."""

_REPORT_INTERVAL = 0.1
"""Seconds between two ``written`` messages."""


class UntilAsked(RunControl):
    """Ends what is being done when something comes in, or the input ends."""

    def __init__(self, incoming):
        super().__init__()
        self._incoming = incoming

    def check(self):
        if not self._incoming.empty():
            raise Cancelled


class JudgingWorker:
    """Answers the requests.

    Parameters
    ----------
    parent : JsonLines
    """

    def __init__(self, parent):
        self._parent, self._control = parent, UntilAsked(parent.incoming)
        self._roots, self._changes = [], verdict_changes([])
        self._serial, self._profile, self._counted, self._is_due = None, None, None, False

    @property
    def is_busy(self):
        """Whether there is something to do before the next request."""
        return self._is_due or not self._changes.is_complete

    def open(self, roots):
        """Read the info files of other folders."""
        self._roots, self._changes, self._counted = roots, verdict_changes(roots), None
        self._is_due = self._profile is not None

    def judge(self, serial, profile):
        """Judge by another profile."""
        self._serial, self._profile, self._is_due = serial, usable_profile(profile), True

    def parts(self, serial, before, after):
        """Send the parts of a change."""
        if serial == self._counted:
            rows = [part._asdict() for part in self._changes.parts(before, after, MOST_PARTS)]
            self._parent.send(parts={"serial": serial, "before": before, "after": after, "rows": rows})

    def write(self, profile):
        """Write the verdicts by a profile into the info files."""
        run = reclassify_folders(self._roots, profile, write=True, jobs=os.cpu_count() or 1, control=self._control)
        told = {"done": 0, "total": len(run), "changed": 0, "failed": 0, "problems": run.problems[:MOST_PROBLEMS],
                "ended": False}
        last = 0.0
        try:
            for file in run:
                told["done"] += 1
                told["changed"] += file.differs
                if file.error:
                    told["failed"] += 1
                    told["problems"] += [file.error][:MOST_PROBLEMS - len(told["problems"])]
                if time.monotonic() - last > _REPORT_INTERVAL:
                    last = time.monotonic()
                    self._parent.send(written=told)
        except Cancelled:
            pass  # what is done is told
        except ThinPartError as error:
            told["problems"].append(str(error))
        self._parent.send(written={**told, "ended": True})
        self.open(self._roots)

    def stop(self):
        """Nothing more is to be done."""

    def go_on(self):
        """Count, or read some more."""
        if not self._is_due:
            self._changes.read_for(_READING_SECONDS)
            self._is_due = self._profile is not None
        if self._is_due:
            try:
                self._count()
            except Cancelled:
                return  # what was asked is answered first

    def _count(self):
        counts = self._changes.count(self._profile, self._control.check)
        self._is_due, self._counted = False, self._serial
        changes = self._changes
        self._parent.send(counted={
            "serial": self._serial, **counts._asdict(), "read": changes.read, "total": changes.total,
            "failed": changes.failed, "problems": changes.problems})


def main():
    """Handle requests until the parent closes the pipe."""
    parent = JsonLines()
    with parent.reporting_failures():
        _serve(parent)


def _serve(parent):
    worker = JudgingWorker(parent)
    while True:
        try:
            request = parent.incoming.get(block=not worker.is_busy)
        except queue.Empty:
            worker.go_on()
            continue
        if request is None:
            parent.end()
        ask = request.pop("ask")
        if ask not in ("open", "judge", "parts", "write", "stop"):
            raise KeyError(ask)
        getattr(worker, ask)(**request)


if __name__ == "__main__":
    main()

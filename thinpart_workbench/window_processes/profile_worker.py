"""The process that counts, while a profile is edited, what it would change in libraries.

Requests, each a JSON object with the key ``ask``:

``open``
    ``roots``: the folders; what was read of others is forgotten. Sends ``opened``: ``total``, the number of info files.
``judge``
    ``serial`` and ``profile``, its content. Sends ``counted``, again and again while info files are being read: the
    ``serial``, the fields of `ChangeCounts`, and ``read``, ``total``, ``failed`` and ``problems`` of `VerdictChanges`. A
    request that comes meanwhile ends the one before.
``parts``
    ``serial``, ``before`` and ``after``. Sends ``parts``: these, and ``rows``, dicts of `ChangedPart`. Nothing for a profile
    that is no longer the last one counted.
"""

import queue

from ..api.reclassification import verdict_changes
from ..core.judging.criteria import usable_profile
from .json_lines import JsonLines

MOST_PARTS = 1000
"""Parts of a change that are sent."""

_READING_SECONDS = 0.2
"""Time of reading between two looks for requests."""


class _NewRequest(Exception):
    """Something was asked while parts are judged."""


class ProfileWorker:
    """Answers the requests.

    Parameters
    ----------
    parent : JsonLines
    """

    def __init__(self, parent):
        self._parent = parent
        self._changes = verdict_changes([])
        self._serial, self._profile, self._counted, self._is_due = None, None, None, False

    @property
    def is_busy(self):
        """Whether there is something to do before the next request."""
        return self._is_due or not self._changes.is_complete

    def open(self, roots):
        """Read the info files of other folders."""
        self._changes, self._counted = verdict_changes(roots), None
        self._is_due = self._profile is not None
        self._parent.send(opened={"total": self._changes.total})

    def judge(self, serial, profile):
        """Judge by another profile."""
        self._serial, self._profile, self._is_due = serial, usable_profile(profile), True

    def parts(self, serial, before, after):
        """Send the parts of a change."""
        if serial == self._counted:
            rows = [part._asdict() for part in self._changes.parts(before, after, MOST_PARTS)]
            self._parent.send(parts={"serial": serial, "before": before, "after": after, "rows": rows})

    def go_on(self):
        """Count, or read some more."""
        if not self._is_due:
            self._changes.read_for(_READING_SECONDS)
            self._is_due = self._profile is not None
        if self._is_due:
            try:
                self._count()
            except _NewRequest:
                return  # which is answered first

    def _count(self):
        counts = self._changes.count(self._profile, self._check)
        self._is_due, self._counted = False, self._serial
        changes = self._changes
        self._parent.send(counted={
            "serial": self._serial, **counts._asdict(), "read": changes.read, "total": changes.total,
            "failed": changes.failed, "problems": changes.problems})

    def _check(self):
        if not self._parent.incoming.empty():
            raise _NewRequest


def main():
    """Handle requests until the parent closes the pipe."""
    parent = JsonLines()
    with parent.reporting_failures():
        _serve(parent)


def _serve(parent):
    worker = ProfileWorker(parent)
    while True:
        try:
            request = parent.incoming.get(block=not worker.is_busy)
        except queue.Empty:
            worker.go_on()
            continue
        if request is None:
            parent.end()
        ask = request.pop("ask")
        if ask not in ("open", "judge", "parts"):
            raise KeyError(ask)
        getattr(worker, ask)(**request)


if __name__ == "__main__":
    main()

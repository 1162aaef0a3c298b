"""The process that reclassifies libraries for the window.

It receives one request, ``{"roots", "profile", "write"}``, and repeatedly sends ``judged``: the attributes of
`ReclassificationCounts` so far. Any further message, or the end of its input, stops it.
"""

import os
import time

from ..api.reclassification import ReclassificationCounts, reclassify_folders
from ..core.errors import ThinPartError
from ..core.run_control import RunControl
from .json_lines import JsonLines

REPORT_INTERVAL = 0.1
"""Seconds between two ``judged`` messages."""


def main():
    """Process the one request."""
    parent = JsonLines()
    request = parent.incoming.get()
    if request is None:
        parent.end()
    with parent.reporting_failures():
        _reclassify(request, parent)
    parent.end()


def _reclassify(request, parent):
    run = reclassify_folders(request["roots"], request["profile"], write=request["write"], jobs=os.cpu_count() or 1,
                             control=_InputControl(parent.incoming))
    for sentence in run.problems:
        parent.send(problem=sentence)
    counts, last_report, ended = ReclassificationCounts(len(run)), 0.0, "done"
    try:
        for file in run:
            counts.add(file)
            if time.monotonic() - last_report > REPORT_INTERVAL:
                last_report = time.monotonic()
                parent.send(judged=vars(counts))
    except KeyboardInterrupt:
        ended = "stopped"
    except ThinPartError as error:
        parent.send(problem=str(error))
        ended = "stopped"
    parent.send(judged=vars(counts), ended=ended)


class _InputControl(RunControl):
    """Stops the run when the parent sends anything more, or has ended."""

    def __init__(self, incoming):
        super().__init__()
        self._incoming = incoming

    def check(self):
        if not self._incoming.empty():
            raise KeyboardInterrupt


if __name__ == "__main__":
    main()

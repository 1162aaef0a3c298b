"""The process behind a window that judges libraries again.

It is sent one request, ``{"roots", "profile", "write"}``, and tells ``judged`` again and again: numbers of
files and parts so far. Anything else that it is sent, and the end of its input, stops it.
"""

import os
import time
from collections import Counter

from ..storage.info_tree import scan
from .json_lines import JsonLines
from .reclassify import reclassify_files

TOLD_EVERY = 0.1
"""Seconds between two reports."""

MOST_ERRORS = 20
"""Sentences that are told; further failures are only counted."""


class Tally:
    """What came out so far."""

    def __init__(self, total):
        self.total, self.done, self.differing, self.failed = total, 0, 0, 0
        self.before, self.after, self.changed = Counter(), Counter(), 0
        self.errors = []

    def add(self, file):
        """Count a `ReclassifiedFile`."""
        self.done += 1
        self.differing += file.differs
        if file.error:
            self.failed += 1
            if len(self.errors) < MOST_ERRORS:
                self.errors.append(file.error)
        for part in file.parts:
            before, after = part.before["category"], part.after["category"]
            self.before[before] += 1
            self.after[after] += 1
            self.changed += before != after


def main():
    """Judge what is asked for."""
    lines = JsonLines()
    request = lines.incoming.get()
    if request is None:
        lines.end()
    files = list(_info_files(request["roots"], lines))
    tally, told, stopped = Tally(len(files)), 0.0, False
    for file in reclassify_files(files, request["profile"], request["write"], os.cpu_count() or 1):
        tally.add(file)
        if not lines.incoming.empty():
            stopped = True
            break
        if time.monotonic() - told > TOLD_EVERY:
            told = time.monotonic()
            lines.say(judged=vars(tally))
    lines.say(judged=vars(tally), ended="stopped" if stopped else "done")
    lines.end()


def _info_files(roots, lines):
    for root in roots:
        found, unreachable = scan(root)
        for folder, error in unreachable.items():
            lines.say(problem=f"The folder {os.path.join(root, os.fsdecode(folder))} cannot be listed "
                              f"({error.strerror}): what lies in it is left as it is.")
        for each in sorted(found):
            yield os.path.join(root, os.fsdecode(each))


if __name__ == "__main__":
    main()

# SPDX-License-Identifier: LGPL-2.1-or-later
"""What workers do at the moment: each notes it in a small file in its own folder, since a mesh may take minutes."""

import json
import os
import tempfile
import time
from contextlib import suppress

from ...core.kinds.compound_kinds import Record
from ...core.kinds.json_file import UnreadableJson, read_json
from ...core.kinds.value_kinds import OneOf, Text, Whole

READ, MEASURE, ONE_SIZE, SIZES, SHELL = "read", "measure", "mesh_at_one_size", "mesh", "shell"
"""Steps of a part. `SIZES` is tried up to `mesh_check.ATTEMPTS` times."""

_NAME = "step.json"
_LARGEST = 1 << 16
_PAUSE = 0.05
"""Seconds in which a run that has nothing else to do does not look again."""

_NOTE = Record({"file": Text(), "part": Text(), "number": Whole(0), "parts": Whole(0),
                "step": OneOf((READ, MEASURE, ONE_SIZE, SIZES, SHELL)), "attempt": Whole(1, 1000)})


class StepNote:
    """The note of one worker, about one document."""

    def __init__(self, file):
        self._note = {"file": file, "part": "", "number": 0, "parts": 0}
        self._path = os.path.join(tempfile.gettempdir(), _NAME)
        self.begin(READ)

    def part(self, label, number, parts):
        """From now on it is about a part: its number, from 1, of all parts of the document."""
        self._note.update(part=label, number=number, parts=parts)

    def begin(self, step, attempt=1):
        """Note that a step begins; on a full disk, it is not told."""
        with suppress(OSError):
            with open(self._path + ".new", "w", encoding="utf-8") as file:
                json.dump({**self._note, "step": step, "attempt": attempt}, file)
            os.replace(self._path + ".new", self._path)

    def end(self):
        """Remove the note."""
        with suppress(OSError):
            os.unlink(self._path)


def watched_steps(folder, files, tell):
    """Tell of steps of workers as long as anybody iterates, once for each item.

    Parameters
    ----------
    folder : str
        Where each worker has its folder.
    files : set of str
        The documents of the run.
    tell : callable
        Called with a dict for each step that has begun: ``file``, ``part``, its label, ``number`` and ``parts``, ``step``
        and ``attempt``.
    """
    told: dict = {}
    while True:
        for worker in _folders(folder):
            note = _read_note(os.path.join(worker, _NAME))
            if note is not None and note["file"] in files and told.get(worker) != note:
                told[worker] = note
                tell(note)
        time.sleep(_PAUSE)
        yield


def _folders(folder):
    with suppress(OSError), os.scandir(folder) as entries:
        return [entry.path for entry in entries if entry.is_dir(follow_symlinks=False)]
    return []


def _read_note(path):
    """The note of a worker, which a malicious file may control; None where there is none."""
    try:
        note = read_json(path, _LARGEST)
    except (FileNotFoundError, UnreadableJson):
        return None
    return note if _NOTE.holds(note) else None

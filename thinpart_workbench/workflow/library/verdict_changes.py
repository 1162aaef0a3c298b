# SPDX-License-Identifier: LGPL-2.1-or-later
"""What one profile after another would change in a library; its info files are read once."""

import json
import os
import sys
import time
from collections import Counter
from typing import NamedTuple

import numpy as np

from ...core.categories import MEASURE_AGAIN, UNKNOWN
from ...core.errors import ThinPartError
from ...core.judging.older_record import lacking
from ...core.judging.verdict_table import VerdictTable
from ...core.message import message
from ...core.record.part_record import descriptors_of
from ...storage.info.info_file import read_info
from .reclassify import described_document

MOST_ERRORS = 20
"""Sentences about info files that are kept; further ones are only counted."""

_FILES_AT_ONCE = 20


class ChangedPart(NamedTuple):
    """A part of an info file: paths of that and of the document, the part's name and label."""

    info_file: str
    file: str
    name: str
    label: str


class ChangeCounts(NamedTuple):
    """What a profile would change.

    Attributes
    ----------
    parts : int
        Judged so far.
    changes : list of (str, str, int)
        The category in the record, the new one or `MEASURE_AGAIN`, and the number of parts; those that differ, most parts
        first.
    files : int
        Info files that differ: another profile has judged them, or one of their parts changes its category.
    """

    parts: int
    changes: list
    files: int


class VerdictChanges:
    """The parts of info files with their recorded categories and descriptors.

    Parameters
    ----------
    info_files : list of str
    problems : list of str
        Sentences about folders that could not be listed.

    Attributes
    ----------
    total, read, failed : int
        Info files: all, those read so far, and those of them that cannot be read.
    problems : list of str
        The sentences given, and the first `MOST_ERRORS` about info files.
    """

    def __init__(self, info_files, problems=()):
        self._info_files, self.problems = list(info_files), list(problems)
        self.total, self.read, self.failed = len(self._info_files), 0, 0
        self._table = VerdictTable()
        self._parts: list[ChangedPart] = []
        self._profiles: dict[str, str] = {}  # by info file
        self._before: list[str] = []
        self._lacking: list[frozenset] = []
        self._judged: tuple = [], np.zeros(0, int)

    @property
    def is_complete(self):
        """Whether all info files were read."""
        return self.read == self.total

    def read_for(self, seconds):
        """Read info files for about some seconds, float."""
        end = time.monotonic() + seconds
        while not self.is_complete and time.monotonic() < end:
            for info_file in self._info_files[self.read:self.read + _FILES_AT_ONCE]:
                self._read(info_file)
                self.read += 1

    def count(self, profile, check=lambda: None):
        """Judge all parts read so far. Returns ChangeCounts.

        Parameters
        ----------
        profile : Profile
        check : callable, optional
            Called every few milliseconds; may raise to stop.
        """
        names, numbers, undecided = self._table.categories(profile, check)
        names = [*names, MEASURE_AGAIN]
        again = np.zeros(len(numbers), bool)
        for condition, parts in undecided.items():
            key = condition.quantity.record_key
            again |= parts & np.fromiter((key in each for each in self._lacking), bool, len(self._lacking))
        numbers = np.where(again & (numbers == names.index(UNKNOWN)), names.index(MEASURE_AGAIN), numbers)
        self._judged = names, numbers
        pairs = Counter(zip(self._before, numbers.tolist()))
        changes = [(before, names[number], count) for (before, number), count in pairs.most_common()
                   if before != names[number]]
        content = _told(profile.content)
        files = {info_file for info_file, judged_by in self._profiles.items() if judged_by != content}
        files.update(part.info_file for part, before, number in zip(self._parts, self._before, numbers)
                     if before != names[number])
        return ChangeCounts(len(numbers), changes, len(files))

    def parts(self, before, after, most):
        """The first parts of a change that was counted last: list of ChangedPart.

        Parameters
        ----------
        before, after : str
        most : int
        """
        names, numbers = self._judged
        if after not in names:
            return []
        places = (place for place in np.flatnonzero(numbers == names.index(after)) if self._before[place] == before)
        return [self._parts[place] for place, _ in zip(places, range(most))]

    def _read(self, info_file):
        try:
            content = read_info(info_file)
        except ThinPartError as error:
            self._fail(str(error))
            return
        except MemoryError:
            self._fail(message("The info file {info_file} needs more memory than the limit allows.",
                               info_file=os.path.basename(info_file)))
            return
        document = described_document(info_file, content)
        self._profiles[info_file] = _told(content["profile"])
        for part in content["parts"]:
            self._table.add([descriptors_of(part)])
            self._parts.append(ChangedPart(info_file, document, part["name"], part["label"]))
            self._before.append(part["category"])
            self._lacking.append(lacking(part))

    def _fail(self, sentence):
        self.failed += 1
        if self.failed <= MOST_ERRORS:
            self.problems.append(sentence)


def _told(profile):
    """The content of a profile as one text, of which all info files that have it share one."""
    return sys.intern(json.dumps(profile, sort_keys=True))

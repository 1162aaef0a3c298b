# SPDX-License-Identifier: LGPL-2.1-or-later
"""What commands share that search libraries: opening and refreshing them, printing their problems, and a count."""

import argparse
import sys
from contextlib import contextmanager
from itertools import groupby

from ...api.libraries import Libraries
from ...core.foreign_text import printable

PROGRESS_THRESHOLD = 2000
"""Number of info files to read from which progress is printed on a terminal."""

NOTHING_STORED = "There are no results below these folders: 'thinpart classify FOLDER' makes them."
"""Said where nothing was found because nothing is there."""

MOST_MESSAGES = 5
"""Most unusable info files that are listed one by one."""


@contextmanager
def libraries(roots):
    """Open and refresh the indexes of some folders.

    Yields
    ------
    opened : Libraries
    status : int
        The exit status so far: 1 if folders cannot be reached. Problems are printed on stderr.
    """
    with Libraries(roots, _print_progress) as opened:
        for _, problems in groupby(opened.problems, lambda problem: problem.root):
            _print_problems(list(problems))
        yield opened, int(any(problem.kind == "folder" for problem in opened.problems))


def count_from_one(text):
    """A whole number from 1 on, as the value of an option."""
    if not text.isdecimal() or int(text) < 1:
        raise argparse.ArgumentTypeError(f"'{text}' is not a whole number from 1 on")
    return int(text)


def _print_problems(problems):
    """Print the problems of one library."""
    sentences = [problem.message for problem in problems if problem.kind != "info_file"]
    # The parts in unusable info files are missing from every search, so the user has to know.
    messages = [problem.message for problem in problems if problem.kind == "info_file"]
    sentences += messages[:MOST_MESSAGES]
    if len(messages) > MOST_MESSAGES:
        sentences.append(f"{len(messages) - MOST_MESSAGES} more info files cannot be used: "
                         "'thinpart find --failed' names them.")
    for sentence in sentences:
        print(f"thinpart: {printable(sentence)}", file=sys.stderr)


def _print_progress(done, total):
    if total >= PROGRESS_THRESHOLD and sys.stderr.isatty():
        print(f"\rreading info files: {done} of {total}", end="\n" if done == total else "", file=sys.stderr)

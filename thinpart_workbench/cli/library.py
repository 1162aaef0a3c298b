"""The libraries that a command names: opened, refreshed, and what went wrong said."""

import os
import sys
from collections import namedtuple
from contextlib import ExitStack, contextmanager

from ..core.errors import ThinPartError
from ..workflow.find_documents import common_folder
from ..workflow.find_parts import open_library

WORTH_TELLING = 2000
"""Info files to be read from which on a terminal is told how far it is."""

MOST_SENTENCES = 5
"""Info files that cannot be used, which are named one by one."""

Libraries = namedtuple("Libraries", "indexes folder status")
"""Open `LibraryIndex` objects, the folder that holds them all, and the exit status so far."""


@contextmanager
def libraries(roots):
    """Open the indexes of some folders, refreshed.

    Parameters
    ----------
    roots : list of str

    Yields
    ------
    Libraries
        Folders that cannot be reached are told on stderr, and the exit status is then 1.
    """
    status, indexes = 0, []
    with ExitStack() as stack:
        for root in roots:
            try:
                _check(root)
                index, refreshed = open_library(root, _tell_progress)
            except ThinPartError as error:
                print(f"thinpart: {error}", file=sys.stderr)
                status = 1
                continue
            stack.callback(index.close)
            indexes.append(index)
            for sentence in refreshed.unreachable:
                print(f"thinpart: {sentence}", file=sys.stderr)
                status = 1
            if refreshed.warning:
                print(f"thinpart: {refreshed.warning}", file=sys.stderr)
            _tell_unreadable(index)
        yield Libraries(indexes, common_folder(roots), status)


def _tell_unreadable(index):
    """Info files that cannot be used hold parts that no search finds: that is said, not hidden."""
    messages = [text for text, in index.query(
        "SELECT error_message FROM parts WHERE error_kind = 'info_file'")]
    for text in messages[:MOST_SENTENCES]:
        print(f"thinpart: {text}", file=sys.stderr)
    if len(messages) > MOST_SENTENCES:
        print(f"thinpart: {len(messages) - MOST_SENTENCES} more info files cannot be used: "
              "'thinpart find --failed' names them.", file=sys.stderr)


def _check(root):
    if os.path.isfile(root):
        raise ThinPartError(f"{root} is a file: name the folder of a library.", "usage")
    if not os.path.isdir(root):
        raise ThinPartError(f"There is no folder {root}.", "missing")


def _tell_progress(done, total):
    if total >= WORTH_TELLING and sys.stderr.isatty():
        print(f"\rreading info files: {done} of {total}", end="\n" if done == total else "", file=sys.stderr)

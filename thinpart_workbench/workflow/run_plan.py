"""What a run is going to do: which files, in which order, where their info files lie."""

import os
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

from ..core.errors import ThinPartError
from ..storage.info_file import SUFFIX, info_path
from .analyse_file import FileTask

_SHORTEST_LIMIT = 143
"""No file system in use allows a name of fewer bytes (encrypted home folders have this one)."""


@dataclass(frozen=True)
class PlannedFile:
    """A task, and what is known of its file before it is read.

    Attributes
    ----------
    task : FileTask
    bytes : int
    unchanged : bool
        Whether it will likely be taken from its info file, which is newer.
    problem : ThinPartError or None
        Why nothing can be kept of it.
    """

    task: FileTask
    bytes: int
    unchanged: bool
    problem: ThinPartError = None


def plan_run(documents, new_task, info_for, jobs):
    """Tasks in the order in which they are best begun.

    What is only looked up comes first: it is over at once, and then it is known what there is to do.
    Of the rest the largest come first where several are at work: a long file that begins last would
    leave the other workers idle.

    Parameters
    ----------
    documents : list of Document
    new_task : callable
        From path and info file (or None) to a `FileTask`.
    info_for : callable
        From path to the path of its info file, or None.
    jobs : int
        Files at once.

    Returns
    -------
    list of PlannedFile
    """
    planned = [_planned(document, new_task, info_for(document.path)) for document in documents]
    if jobs > 1:
        planned.sort(key=lambda each: 0 if each.unchanged else -each.bytes)
    planned.sort(key=lambda each: not each.unchanged)
    return planned


def _planned(document, new_task, info):
    problem = _name_problem(document, info)
    if problem is not None:
        info = None
    task = new_task(document.path, info)
    return PlannedFile(task, document.bytes, not task.force and _is_newer(info, document), problem)


def _is_newer(info, document):
    if info is None:
        return False
    try:
        return os.stat(info).st_mtime >= document.modified
    except OSError:
        return False


def info_place(folder=None, tree=None):
    """How the place of an info file follows from that of a document; see `info_path`.

    Returns
    -------
    callable
        From path to path. Documents of one folder, of which there may be many thousands, share the
        work.
    """
    @lru_cache(maxsize=1024)
    def beside(parent):
        return os.path.join(info_path(os.path.join(parent, "x"), folder, tree).parent, "")

    def place(document):
        parent, name = os.path.split(document)
        return beside(parent) + name + SUFFIX

    return place


def _name_problem(document, info):
    if info is None:
        return None
    length = len(os.fsencode(os.path.basename(info)))
    if length <= _SHORTEST_LIMIT:
        return None
    limit = _name_limit(os.path.dirname(info))
    if length <= limit:
        return None
    return ThinPartError(
        f"The name is too long for an info file, which is called the same and {SUFFIX}: it may have "
        f"{limit - len(SUFFIX)} bytes and has {length - len(SUFFIX)}; rename it, or use --no-info.",
        "info_write",
    )


@lru_cache(maxsize=1024)
def _name_limit(folder):
    folder = Path(folder).absolute()
    existing = next((each for each in [folder, *folder.parents] if each.is_dir()), Path("/"))
    try:
        return os.pathconf(existing, "PC_NAME_MAX")
    except (OSError, ValueError):
        return 255

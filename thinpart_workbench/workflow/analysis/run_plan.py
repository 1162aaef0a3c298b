# SPDX-License-Identifier: LGPL-2.1-or-later
"""The plan of a run: its files, their order, and the paths of their info files."""

import os
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import Optional

from ...core.errors import ThinPartError
from ...core.message import message
from ...storage.info.info_file import SUFFIX
from .analyse_file import FileTask

_SHORTEST_LIMIT = 143
"""Bytes of the shortest limit for file names among file systems in use (that of encrypted home folders)."""


@dataclass(frozen=True)
class PlannedFile:
    """A task, and what is known about its file before reading it.

    Attributes
    ----------
    task : FileTask
    bytes : int
    unchanged : bool
        Whether its info file is newer, so that it will probably be reused.
    problem : ThinPartError or None
        Why no info file can be written for it.
    """

    task: FileTask
    bytes: int
    unchanged: bool
    problem: Optional[ThinPartError] = None


def plan_run(documents, new_task, info_for, jobs):
    """Plan the tasks in the best order: list of PlannedFile.

    Unchanged files come first: they are done at once, and then the remaining work is known. With several
    workers the largest of the other files come first: a large file started last would leave the other
    workers idle.

    Parameters
    ----------
    documents : list of Document
    new_task : callable
        Maps path and info file (or None) to a `FileTask`.
    info_for : callable
        Maps a path to the path of its info file, or None.
    jobs : int
        Number of workers.
    """
    planned = [_plan(document, new_task, info_for(document.path)) for document in documents]
    if jobs > 1:
        planned.sort(key=lambda file: 0 if file.unchanged else -file.bytes)
    planned.sort(key=lambda file: not file.unchanged)
    return planned


def _plan(document, new_task, info_file):
    problem = _name_problem(document, info_file)
    if problem is not None:
        info_file = None
    task = new_task(document.path, info_file)
    return PlannedFile(task, document.bytes, not task.force and _is_newer(info_file, document), problem)


def _is_newer(info_file, document):
    if info_file is None:
        return False
    try:
        return os.stat(info_file).st_mtime >= document.modified
    except OSError:
        return False


def _name_problem(document, info_file):
    if info_file is None:
        return None
    length = len(os.fsencode(os.path.basename(info_file)))
    if length <= _SHORTEST_LIMIT:
        return None
    limit = _name_limit(os.path.dirname(info_file))
    if length <= limit:
        return None
    return ThinPartError(
        message("The name is too long for an info file, which adds {ending} to it: it has {bytes} bytes, at most "
                "{most} are possible; rename it, or use --no-info.",
                ending=SUFFIX, most=limit - len(SUFFIX), bytes=length - len(SUFFIX)),
        "info_write",
    )


@lru_cache(maxsize=1024)
def _name_limit(folder):
    folder = Path(folder).absolute()
    existing = next((parent for parent in [folder, *folder.parents] if os.path.isdir(parent)), Path("/"))
    try:
        return os.pathconf(existing, "PC_NAME_MAX")
    except (OSError, ValueError):
        return 255

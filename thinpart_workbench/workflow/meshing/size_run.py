# SPDX-License-Identifier: LGPL-2.1-or-later
"""Propose element sizes for many documents, each in a worker process, several at the same time."""

import json
import os
from dataclasses import asdict, replace

from ...system.process_limits import WALL_FACTOR
from ..analysis.measured_source import check_source, source_of
from ..workers.preparation import require_preparation
from ..workers.result_cache import ResultCache
from ..workers.task_run import run_tasks
from .gmsh_program import INCOMPLETE
from .mesh_check import ATTEMPTS
from .size_result import known_values, sizes_fault
from .size_steps import StepNote, watched_steps
from .size_task import propose_for_document

_VERSION = 11
"""Changes when proposals do."""

_LARGEST = 1 << 30
"""Bytes of a result that is kept."""

_MESHED_PARTS = 20
"""Parts of a document that may all take the whole time of their meshes."""


def propose_for_documents(tasks, limits, version="", force=False, control=None, tell=None):
    """Propose sizes for documents.

    Yields a dict: as they finish: ``file``, and ``parts`` and ``failures`` of `propose_for_document`; or ``error`` with
    ``kind`` and ``message``. Raises ThinPartError if no worker can be started. Raises Cancelled when `control` was asked to
    stop; what is done is kept for the next run.

    Parameters
    ----------
    tasks : list of SizeTask
    limits : Limits
        Of time for measuring a document, of memory, and the number of workers.
    version : str, optional
        Of Gmsh, where it is to mesh the parts.
    force : bool, optional
        Whether not to take results of an earlier run.
    control : RunControl, optional
    tell : callable, optional
        Called with each step that a worker begins; see `size_steps.watched_steps`.
    """
    cache = ResultCache("sizes", _key(version, limits), _LARGEST, _is_complete, renew=force)
    is_meshed = any(task.program for task in tasks)
    if is_meshed:
        for_meshes = _MESHED_PARTS * (ATTEMPTS + 1) * (WALL_FACTOR + 1.0) * max(task.seconds for task in tasks)
        limits = replace(limits, seconds=limits.seconds + for_meshes)
    watched = tell and (lambda folder: watched_steps(folder, {task.file for task in tasks}, tell))
    for done in run_tasks(tasks, _proposed, _sizes, limits, cache=cache, control=control, with_programs=is_meshed,
                          meanwhile=watched):
        yield {"file": done.task.file, **(done.result or {"error": done.failure["error"]})}


def _key(version, limits):
    """What results depend on: limits too, since what took too long might not with others."""
    def key(task):
        content = asdict(replace(task, file=os.path.abspath(task.file), program=bool(task.program)))
        return json.dumps([[_VERSION, version, float(limits.seconds), limits.megabytes], content], sort_keys=True)

    return key


def _is_complete(result):
    """Whether no mesh was cut short, as on a full disk: there may be room another time."""
    made = [each for part in result["parts"] for each in (*(part["check"] or {}).values(), part.get("shell"))]
    return not any(each and str(INCOMPLETE) in each["reason"] for each in made)


def _sizes(task, answer):
    """The sizes that an answer holds."""
    fault = sizes_fault(answer, task)
    if fault is not None:
        raise ValueError(fault)
    check_source(answer["source"], task.file)
    return known_values(answer)


def _proposed(task):
    """Runs in a worker."""
    require_preparation()
    note = StepNote(task.file)
    try:
        return {"source": source_of(task.file), **propose_for_document(task, note)}
    finally:
        note.end()

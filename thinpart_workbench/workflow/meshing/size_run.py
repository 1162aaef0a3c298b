"""Propose element sizes for many documents, each in a worker process, several at the same time."""

from collections import deque
from contextlib import suppress
from pathlib import Path

from ...core.message import message
from ...core.run_control import RunControl
from ...system.process_limits import WALL_FACTOR
from ..analysis.analysis_outcome import failure, told_failure
from ..analysis.measured_source import source_failure, source_of
from ..workers.pool_supervisor import PoolSupervisor
from ..workers.preparation import require_preparation
from ..workers.reading import close_documents, start_reader
from ..workers.reported_failure import reported_failure
from ..workers.worker_pool import answer_of, worker_folder
from .gmsh_program import INCOMPLETE
from .mesh_check import ATTEMPTS
from .size_cache import SizeCache
from .size_result import known_values, sizes_fault
from .size_steps import StepNote, watched_steps
from .size_task import propose_for_document

_MESHED_PARTS = 20
"""Parts of a document that may all take the whole time of their meshes."""


def propose_for_documents(tasks, limits, version="", force=False, control=None, tell=None):
    """Propose sizes for documents.

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

    Yields
    ------
    dict
        As they finish: ``file``, and ``parts`` and ``failures`` of `propose_for_document`; or ``error`` with ``kind`` and
        ``message``.

    Raises
    ------
    ThinPartError
        If no worker can be started.
    KeyboardInterrupt
        When `control` was asked to stop; what is done is kept for the next run.
    """
    control, kept = control or RunControl(), SizeCache(version, limits)
    waiting: deque = deque()
    for task in tasks:
        control.check()
        result = None if force else kept.result(task)
        if result is None:
            waiting.append(task)
        else:
            yield {"file": task.file, **result}
    if not waiting:
        return
    seconds, is_meshed = limits.seconds, any(task.program for task in waiting)
    if is_meshed:
        seconds += _MESHED_PARTS * (ATTEMPTS + 1) * (WALL_FACTOR + 1.0) * max(task.seconds for task in waiting)
    with worker_folder() as folder:
        workers = PoolSupervisor(max(1, min(limits.jobs, len(waiting))), seconds, folder, _propose, start_reader,
                                 (limits.megabytes,), confine=True, with_programs=is_meshed)
        try:
            steps = watched_steps(folder, {task.file for task in waiting}, tell) if tell else ()
            for future, task in workers.run(waiting, control, meanwhile=steps):
                result = _result(future, task, seconds, limits)
                if "error" not in result and not _is_incomplete(result):
                    kept.keep(task, result)
                yield {"file": task.file, **result}
        finally:
            workers.stop()


def _is_incomplete(result):
    """Whether a mesh was cut short, as on a full disk: there may be room another time."""
    made = [each for part in result["parts"] for each in (*(part["check"] or {}).values(), part.get("shell"))]
    return any(each and str(INCOMPLETE) in each["reason"] for each in made)


def _result(future, task, seconds, limits):
    result, failed = answer_of(future, task.file, seconds, limits.megabytes)
    if failed is not None:
        return failed
    told = told_failure(task.file, result)
    if told is not None:
        return told
    fault = sizes_fault(result, task)
    if fault is not None:
        return failure(task.file, "failed", message("{file} failed: its result cannot be used ({problem}).",
                                                    file=Path(task.file).name, problem=fault))
    return source_failure(result["source"], task.file) or known_values(result)


def _propose(task):
    """Runs in a worker."""
    require_preparation()
    note = StepNote(task.file)
    try:
        source = source_of(task.file)
        return {"source": source, **propose_for_document(task, note)}
    except Exception as error:  # a failed row instead of a traceback
        return failure(task.file, **reported_failure(error, Path(task.file).name))
    finally:
        note.end()
        with suppress(Exception):  # what cannot be closed does not lose the results
            close_documents()

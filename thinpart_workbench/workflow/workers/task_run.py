# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run tasks in worker processes: answers are checked, and what keeps a worker from answering is a failure of its task."""

from collections import deque
from concurrent.futures import TimeoutError as TaskTimeout
from contextlib import ExitStack, closing, contextmanager
from functools import partial
from itertools import chain
from pathlib import Path
from typing import Any, NamedTuple, Optional

from ...core.errors import ThinPartError
from ...core.message import message
from ...core.problem import UNEXPECTED
from ...core.run_control import RunControl
from ...storage.temporary_folder import temporary_folder
from ...system.exit_cause import ExitCause
from ..analysis.analysis_outcome import failure, told_failure
from .compiled_modules import compiled_modules
from .process_pool import ProcessPool
from .reading import answer, start_reader
from .worker_thread import WorkerDied, WorkerFault


class Done(NamedTuple):
    """A task that is done.

    Attributes
    ----------
    task : object
    result : object
        What `check` made of the answer; None where it failed.
    failure : dict or None
        See `failure`.
    confinement : dict or None
        Of its worker, see `confinement.confine`; None where no worker was needed.
    """

    task: Any
    result: Any = None
    failure: Optional[dict] = None
    confinement: Optional[dict] = None


def run_tasks(tasks, work, check, limits, *, cache=None, control=None, with_programs=False, meanwhile=None):
    """Do tasks, each in a worker process with limits.

    Yields a Done: as they finish. Raises ThinPartError if no worker can be started, or there is no space for temporary
    files; Cancelled when `control` was asked to stop.

    A damaged file may kill the process that reads it, or make it run for ever; then its worker is replaced and the run goes
    on with the next task.

    Parameters
    ----------
    tasks : sequence
        Each has the path of the document that it is about as ``file``, and can be pickled.
    work : callable
        ``work(task)`` runs in a worker, which that document may take over; its answer must be JSON values. It calls
        `require_preparation` before it reads the document.
    check : callable
        ``check(task, answer)`` gives the result. It raises a ValueError whose text is a reason in a few words where that is
        no answer to the task, and a ThinPartError where it cannot be used, as of a file that has changed meanwhile.
    limits : Limits
        Of seconds for each task, of memory, and the number of workers.
    cache : ResultCache, optional
        Tasks are answered from it where it can, and it keeps the results of the others.
    control : RunControl, optional
        Pauses and stops the run.
    with_programs : bool, optional
        Whether workers may run programs.
    meanwhile : callable, optional
        ``meanwhile(folder)`` gives an iterable, whose items are taken while the workers are busy. The folder has one for
        each worker.
    """
    control = control or RunControl()

    def run(waiting):
        with task_workers(min(limits.jobs, len(waiting)), work, check, limits, with_programs) as run_waiting:
            yield from run_waiting(waiting, control, meanwhile)

    yield from run_with_cache(tasks, run, check, cache, control)


def run_with_cache(tasks, run, check, cache, control):
    """Do tasks, of which a cache may have the results. Yields a Done: as they finish.

    Raises what `run` raises; Cancelled when `control` was asked to stop.

    Parameters
    ----------
    tasks : sequence
    run : callable
        ``run(tasks)`` gives the Done of the tasks that the cache has not.
    check : callable
        As of `run_tasks`: for what the cache has.
    cache : ResultCache or None
    control : RunControl
    """
    waiting = []
    for task in tasks:
        control.check()
        result = None if cache is None else _cached(cache, task, check)
        if result is None:
            waiting.append(task)
        else:
            yield Done(task, result)
    if waiting:
        with closing(run(waiting)) as finished:
            for done in finished:
                if cache is not None and done.failure is None:
                    cache.keep(done.task, done.result)
                yield done


@contextmanager
def task_workers(count, work, check, limits, with_programs=False):
    """For a ``with`` block: workers that do tasks, as `run_tasks`, and wait for more.

    Yields a callable: ``run(tasks, control, meanwhile)``, which yields as `run_tasks`.
    """
    with worker_folder() as folder, ExitStack() as stack:
        workers = ProcessPool(max(1, count), limits.seconds, folder, partial(answer, work), start_reader,
                                 (limits.megabytes, work), confine=True, with_programs=with_programs)
        stack.callback(workers.stop)

        def run(tasks, control, meanwhile=None):
            more = chain(meanwhile(folder) if meanwhile else (), compiled_modules())
            for future, task in workers.run(deque(tasks), control, meanwhile=more):
                result, failed = _outcome(future, task, check, limits)
                yield Done(task, result, failed, workers.confinement)

        yield run


def _cached(cache, task, check):
    try:
        kept = cache.result(task)
        return None if kept is None else check(task, kept)
    except (ValueError, ThinPartError):
        return None


@contextmanager
def worker_folder():
    """A temporary folder for a ``with`` block; ThinPartError if it cannot be created."""
    with ExitStack() as stack:
        try:
            folder = stack.enter_context(temporary_folder())
        except OSError as error:
            raise ThinPartError(
                message("Temporary files cannot be written ({problem}): free some disk space, or name another folder "
                        "in TMPDIR.", problem=error.strerror), "failed",
            ) from None
        yield folder


def _outcome(future, task, check, limits):
    """The result of a task and None, or None and its failure."""
    name = Path(task.file).name
    try:
        told = future.result()
    except TaskTimeout:
        sentence = message("{file} took longer than {seconds:g} s, the limit for one file.", file=name,
                           seconds=limits.seconds)
        return None, {**failure(task.file, "timeout", sentence), "seconds": limits.seconds}
    except WorkerDied as died:
        if died.end.cause(is_done=False) is ExitCause.OUT_OF_MEMORY:
            return None, failure(task.file, "memory", message("{file} needs more memory than {megabytes} MB.",
                                                              file=name, megabytes=limits.megabytes))
        return None, failure(task.file, "crash", message(
            "{file} crashed the process that read it: the file is probably damaged.", file=name))
    except WorkerFault:  # an exception outside what reports failures
        return None, failure(task.file, "failed", message("{file} failed ({problem}).", file=name, problem=UNEXPECTED))
    failed = told_failure(task, told)
    if failed is not None:
        return None, failed
    try:
        return check(task, told), None
    except ThinPartError as error:
        return None, failure(task.file, error.kind, str(error))
    except ValueError as fault:
        return None, failure(task.file, "failed", message("{file} failed: its result cannot be used ({problem}).",
                                                          file=name, problem=str(fault)))

"""Analyse files in worker processes, so that a file which kills its reader is one failed row."""

import faulthandler
import os
import signal
import tempfile
import time
from collections import deque
from concurrent.futures import TimeoutError as TaskTimeout
from contextlib import ExitStack, contextmanager
from itertools import chain
from pathlib import Path

from ...core.errors import ThinPartError
from ...core.message import message
from ...core.run_control import RunControl
from ...freecad_adapter.bootstrap import has_home
from ...storage.temporary_folder import temporary_folder
from ...system.exit_cause import ExitCause
from ...system.process_limits import crash_quietly, limit_files, limit_memory
from ..analysis.analysis_outcome import checked_outcome, failure
from ..analysis.result_files import write_results
from .compiled_modules import compiled_modules
from .pool_supervisor import PoolSupervisor
from .process_pool import WorkerDied, WorkerFault
from .reported_failure import reported_failure

LARGEST_FILE = 4 << 30
"""Maximum bytes of a file that a worker writes: FreeCAD unpacks documents into the worker's folder."""

MOST_OPEN_FILES = 512
"""Files that a worker may have open: FreeCAD opens some 60, and one per linked document."""


def analyse_files(tasks, limits, control=None, meanwhile=()):
    """Analyse files, each in a worker process with time and memory limits.

    Parameters
    ----------
    tasks : list of FileTask
    limits : Limits
    control : RunControl, optional
        Pauses and stops the run.
    meanwhile : iterable of callable, optional
        Each is called once, while the workers are busy.

    Yields
    ------
    dict
        Per file, as they finish: the outcome of `analyse_file`, after its files were written, and
        ``confinement`` (see `confinement.confine`); or ``{"file", "error": {"kind", "message"}}``, with
        ``seconds`` if they are known.

    Raises
    ------
    ThinPartError
        If no worker can be started, or there is no space for temporary files.
    KeyboardInterrupt
        When `control` was asked to stop.

    Notes
    -----
    A damaged STEP file may kill the process that reads it, or make it run forever; then its worker is
    replaced and the run goes on with the next file. Only a few tasks per worker are submitted at a time:
    the pool checks all of them ten times a second.
    """
    if not tasks:
        return
    with _workers(min(limits.jobs, len(tasks)), limits) as workers:
        todo = chain((call() for call in meanwhile), compiled_modules())
        yield from _outcomes(tasks, workers, limits, control or RunControl(), todo)


@contextmanager
def file_analyser(limits):
    """For a ``with`` block: a function that analyses one file after the other.

    Parameters
    ----------
    limits : Limits
        `jobs` is ignored: there is one worker process.

    Yields
    ------
    callable
        ``analyse(task, control)``, which returns an outcome as from `analyse_files`.
    """
    with _workers(1, limits) as workers:
        def analyse(task, control):
            outcome, = _outcomes([task], workers, limits, control)
            return outcome

        yield analyse


@contextmanager
def _workers(count, limits):
    with worker_folder() as folder:
        workers = PoolSupervisor(
            max(1, count), limits.seconds, folder, _process_task, start_reader, (limits.megabytes,), confine=True)
        try:
            yield workers
        finally:
            workers.stop()


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


def _outcomes(tasks, workers, limits, control, meanwhile=()):
    """Yield the outcome of each task after writing its files."""
    for future, task in workers.run(deque(tasks), control, meanwhile=meanwhile):
        outcome = _outcome(future, task, limits)
        control.check()
        yield write_results(task, {**outcome, "confinement": workers.confinement})


def start_reader(megabytes):
    """Initialize a worker: ignore Ctrl-C, which the parent handles, and limit memory and files."""
    if not has_home():
        os.environ.update(dict.fromkeys(("FREECAD_USER_HOME", "HOME"), tempfile.gettempdir()))
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    limit_memory(megabytes * 1024 * 1024)
    limit_files(LARGEST_FILE, MOST_OPEN_FILES)
    crash_quietly()  # the parent reports the crash as a row
    _reserve_for_linear_algebra()


def _reserve_for_linear_algebra():
    # OpenBLAS allocates its buffer on first use, and retries forever if there is no memory for it. It keeps
    # the buffer.
    import numpy as np

    np.linalg.eigh(np.eye(64) @ np.eye(64))


def _process_task(task):
    """Analyse one file; if FreeCAD crashes, the parent reads what it has printed."""
    started = time.perf_counter()
    faulthandler.enable()
    outcome = _analyse(task)
    outcome.setdefault("seconds", round(time.perf_counter() - started, 4))
    return outcome


def _analyse(task):
    from ..analysis.analyse_file import analyse_file

    try:
        return analyse_file(task)
    except Exception as error:  # a failed row instead of a traceback
        return failure(task.file, **reported_failure(error, Path(task.file).name))
    finally:
        close_documents()


def close_documents():
    """Close what a task has opened; for the end of a task."""
    import sys

    freecad = sys.modules.get("FreeCAD")
    if freecad is not None:
        for name in list(freecad.listDocuments()):
            freecad.closeDocument(name)


def _outcome(future, task, limits):
    result, failed = answer_of(future, task.file, limits.seconds, limits.megabytes)
    if failed is None:
        return checked_outcome(task, result)
    return {**failed, "seconds": limits.seconds} if failed["error"]["kind"] == "timeout" else failed


def answer_of(future, file, seconds, megabytes):
    """What a worker answered about a file, and None; or None, and the failure of the worker.

    Parameters
    ----------
    future : Future
    file : str
    seconds : float
        Limit of time that the worker had.
    megabytes : int
        Limit of memory.
    """
    name = Path(file).name
    try:
        return future.result(), None
    except TaskTimeout:
        return None, failure(file, "timeout", message("{file} took longer than {seconds:g} s, the limit for one file.",
                                                      file=name, seconds=seconds))
    except WorkerDied as died:
        if died.end.cause(is_done=False) is ExitCause.OUT_OF_MEMORY:
            return None, failure(file, "memory", message("{file} needs more memory than {megabytes} MB.",
                                                         file=name, megabytes=megabytes))
        return None, failure(file, "crash", message("{file} crashed the process that read it: the file is probably damaged.",
                                                    file=name))
    except WorkerFault as fault:  # an exception outside what reports failures
        return None, failure(file, "failed", message("{file} failed ({problem}).", file=name, problem=fault))

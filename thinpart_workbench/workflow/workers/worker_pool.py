"""Analyse files in worker processes, so that a file which kills its reader is one failed row."""

from collections import deque
from concurrent.futures import TimeoutError as TaskTimeout
from contextlib import ExitStack, contextmanager
from itertools import chain
from pathlib import Path

from ...core.errors import ThinPartError
from ...core.message import message
from ...core.problem import UNEXPECTED
from ...core.run_control import RunControl
from ...storage.temporary_folder import temporary_folder
from ...system.exit_cause import ExitCause
from ..analysis.analysis_outcome import checked_outcome, failure
from ..analysis.result_files import write_results
from .compiled_modules import compiled_modules
from .pool_supervisor import PoolSupervisor
from .process_pool import WorkerDied, WorkerFault
from .reading import process_task, start_reader


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
            max(1, count), limits.seconds, folder, process_task, start_reader, (limits.megabytes,), confine=True)
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
    except WorkerFault:  # an exception outside what reports failures
        return None, failure(file, "failed", message("{file} failed ({problem}).", file=name, problem=UNEXPECTED))

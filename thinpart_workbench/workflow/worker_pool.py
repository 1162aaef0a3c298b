"""Files analysed in worker processes, so that a file which kills its reader is one failed row."""

import faulthandler
import os
import signal
import tempfile
import time
from collections import deque
from concurrent.futures import TimeoutError as TaskTimeout
from contextlib import ExitStack, contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path

from ..core.errors import ThinPartError
from ..freecad_adapter.bootstrap import has_home
from ..system.parent_death import end_with_parent
from ..system.process_limits import crash_quietly, limit_memory
from .process_pool import WorkerDied
from .run_control import RunControl
from .temporary_folder import temporary_folder
from .workers import Workers

_OUT_OF_MEMORY = (b"bad_alloc", b"bad allocation", b"MemoryError", b"Unable to allocate", b"OutOfMemory",
                  b"out of memory", b"length_error", b"failed to map segment", b"pthread_create failed")


LEAST_MEGABYTES = 700
"""What FreeCAD and numpy need before they have read anything."""


@dataclass(frozen=True)
class Limits:
    """What one file may cost.

    Attributes
    ----------
    seconds : float
    megabytes : int
        Address space of a worker; not held where `MEMORY_CAN_BE_LIMITED` is not.
    jobs : int
        Workers at once.
    """

    seconds: float = 600.0
    megabytes: int = 6144
    jobs: int = 1


def analyse_files(tasks, limits, control=None):
    """Analyse files, each in a worker process with time and memory limits.

    Parameters
    ----------
    tasks : list of FileTask
    limits : Limits
    control : RunControl, optional
        Pauses and stops the run.

    Yields
    ------
    dict
        Per file, as they end: the outcome of `analyse_file`, or ``{"file", "error": {"kind",
        "message"}}``, with ``seconds`` where they are known.

    Raises
    ------
    ThinPartError
        When no worker can be started, or there is no place for temporary files.
    KeyboardInterrupt
        When `control` was asked to stop.

    Notes
    -----
    A damaged STEP file ends the process that reads it, and some run for ever; one worker is then
    lost and replaced, and the next file goes on. Tasks are handed over a few per worker at a time:
    the pool looks at all that it has ten times a second.
    """
    if not tasks:
        return
    with _workers(min(limits.jobs, len(tasks)), limits) as workers:
        yield from _outcomes(deque(tasks), workers, limits, control or RunControl())


@contextmanager
def file_analyser(limits):
    """For a ``with`` block: a function that analyses the files of one request after the other.

    Parameters
    ----------
    limits : Limits
        `jobs` does not count: there is one worker process.

    Yields
    ------
    callable
        ``analyse(task, control)``, with the outcome that `analyse_files` has.
    """
    with _workers(1, limits) as workers:
        def analyse(task, control):
            outcome, = _outcomes(deque([task]), workers, limits, control)
            return outcome

        yield analyse


@contextmanager
def _workers(count, limits):
    with _folder_for_logs() as folder:
        workers = Workers(max(1, count), limits.seconds, folder, _work, _start_worker,
                          (limits.megabytes, folder, os.getpid()))
        try:
            yield workers
        finally:
            workers.stop()


@contextmanager
def _folder_for_logs():
    with ExitStack() as stack:
        try:
            folder = stack.enter_context(temporary_folder())
        except OSError as error:
            raise ThinPartError(
                f"There is no place for temporary files ({error.strerror}): make room, or name "
                "another folder in TMPDIR.", "failed",
            ) from None
        yield folder


def _outcomes(waiting, workers, limits, control):
    """Hand over tasks and take results until nothing is left."""
    while waiting or workers.busy:
        control.check()
        workers.hold(control.paused)
        control.enter("paused" if control.paused else "running")
        while waiting and not control.paused and workers.has_room:
            workers.begin(waiting.popleft())
        ended = workers.next_ended()
        if ended is None:
            waiting.extendleft(reversed(workers.lost_tasks()))
            continue
        future, task, log = ended
        outcome = _outcome(future, task, log, limits)
        if outcome is None:  # taken by a worker after the run was paused
            waiting.appendleft(task)
            continue
        control.check()
        yield outcome
        with suppress(FileNotFoundError, PermissionError):  # Windows keeps what a worker has open
            os.unlink(log)


def _start_worker(megabytes, folder, parent):
    """Once per worker: it ends with its parent, Ctrl-C is the parent's business, memory is limited."""
    end_with_parent(parent)
    tempfile.tempdir = folder  # what a killed worker leaves behind goes with the run's own folder
    if not has_home():
        os.environ["FREECAD_USER_HOME"] = folder
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    # Files are the unit of work; threads of the linear algebra would fight over the processors.
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    limit_memory(megabytes * 1024 * 1024)
    crash_quietly()  # it is reported as a row
    _reserve_for_linear_algebra()


def _reserve_for_linear_algebra():
    # OpenBLAS takes its buffer when it is first used, and tries without end where there is no memory
    # left for it. It keeps what it has taken.
    import numpy as np

    np.linalg.eigh(np.eye(64) @ np.eye(64))


def _work(task, log, hold):
    """Analyse one file; what FreeCAD prints goes to the log, where the parent looks on a crash."""
    if os.path.exists(hold):
        return None  # the run was paused after the task was handed over
    started = time.perf_counter()
    handle = os.open(log, os.O_WRONLY | os.O_CREAT | os.O_TRUNC, 0o600)
    os.dup2(handle, 1)
    os.dup2(handle, 2)
    os.close(handle)
    faulthandler.enable()
    outcome = _analysed(task)
    outcome.setdefault("seconds", round(time.perf_counter() - started, 4))
    return outcome


def _analysed(task):
    from .analyse_file import analyse_file

    try:
        return analyse_file(task)
    except ThinPartError as error:
        return failure(task.file, error.kind, str(error))
    except MemoryError:
        return failure(task.file, "memory", _memory_message(task))
    except Exception as error:  # a row for the user instead of a traceback; the kind says so
        text = f"{type(error).__name__}: {error}"
        if any(sign.decode() in text for sign in _OUT_OF_MEMORY):
            return failure(task.file, "memory", _memory_message(task))
        return failure(task.file, "failed", f"{Path(task.file).name} failed ({text}).")
    finally:
        _close_documents()


def _close_documents():
    import sys

    freecad = sys.modules.get("FreeCAD")
    if freecad is not None:
        for name in list(freecad.listDocuments()):
            freecad.closeDocument(name)


def failure(file, kind, message):
    """The outcome of a file of which nothing could be analysed."""
    return {"file": file, "error": {"kind": kind, "message": message}}


def _outcome(future, task, log, limits):
    name = Path(task.file).name
    try:
        return future.result()
    except TaskTimeout:
        message = f"{name} took longer than {limits.seconds:g} s, the limit for one file."
        return {**failure(task.file, "timeout", message), "seconds": limits.seconds}
    except WorkerDied:
        if any(sign in _tail(log) for sign in _OUT_OF_MEMORY):
            return failure(task.file, "memory", _memory_message(task, limits))
        return failure(task.file, "crash",
                       f"{name} ended the process that read it: the file is likely damaged.")
    except Exception as error:  # of the worker around the analysis: no room for its log, for one
        return failure(task.file, "failed", f"{name} failed ({type(error).__name__}: {error}).")


def _memory_message(task, limits=None):
    name = Path(task.file).name
    if limits is None:
        return f"{name} needs more memory than it may have."
    return f"{name} needs more memory than {limits.megabytes} MB."


def _tail(log):
    try:
        with open(log, "rb") as file:
            return file.read(1 << 20)
    except OSError:
        return b""

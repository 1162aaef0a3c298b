"""Files analysed in worker processes, so that a file which kills its reader is one failed row."""

import faulthandler
import multiprocessing
import os
import resource
import signal
from concurrent.futures import as_completed
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

from ..core.errors import ThinPartError
from ..freecad_adapter.bootstrap import has_home
from .temporary_folder import temporary_folder

_OUT_OF_MEMORY = (b"bad_alloc", b"MemoryError", b"Unable to allocate", b"OutOfMemory",
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
        Address space of a worker.
    jobs : int
        Workers at once.
    """

    seconds: float = 600.0
    megabytes: int = 6144
    jobs: int = 1


def analyse_files(tasks, limits):
    """Analyse files, each in a worker process with time and memory limits.

    Parameters
    ----------
    tasks : list of FileTask
    limits : Limits

    Yields
    ------
    dict
        Per file, as they end: the outcome of `analyse_file`, or ``{"file", "error": {"kind",
        "message"}}``.

    Notes
    -----
    A damaged STEP file ends the process that reads it, and some run for ever; one worker is then
    lost and replaced, and the next file goes on.
    """
    from pebble import ProcessPool

    if not tasks:
        return
    with temporary_folder() as logs:
        pool = ProcessPool(
            max_workers=max(1, min(limits.jobs, len(tasks))),
            context=multiprocessing.get_context("spawn"),
            initializer=_start_worker, initargs=(limits.megabytes, logs),
        )
        try:
            futures = {}
            for number, task in enumerate(tasks):
                log = os.path.join(logs, f"{number}.log")
                future = pool.schedule(_work, args=(task, log), timeout=limits.seconds)
                futures[future] = task, log
            for future in as_completed(futures):
                task, log = futures.pop(future)
                yield _outcome(future, task, log, limits)
                with suppress(FileNotFoundError):
                    os.unlink(log)
            pool.stop()
        except BaseException:
            pool.stop()
            raise
        finally:
            pool.join()


def _start_worker(megabytes, folder):
    """Once per worker: Ctrl-C is the parent's business, memory is limited, there is a home."""
    if not has_home():
        os.environ["FREECAD_USER_HOME"] = folder
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    # Files are the unit of work; threads of the linear algebra would fight over the processors.
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    limit = megabytes * 1024 * 1024
    hard = resource.getrlimit(resource.RLIMIT_AS)[1]
    resource.setrlimit(resource.RLIMIT_AS, (limit, hard))
    # A crash is reported as a row; a core file of several GB in the user's folder helps nobody.
    resource.setrlimit(resource.RLIMIT_CORE, (0, resource.getrlimit(resource.RLIMIT_CORE)[1]))
    _reserve_for_linear_algebra()


def _reserve_for_linear_algebra():
    # OpenBLAS takes its buffer when it is first used, and tries without end where there is no memory
    # left for it. It keeps what it has taken.
    import numpy as np

    np.linalg.eigh(np.eye(64) @ np.eye(64))


def _work(task, log):
    """Analyse one file; what FreeCAD prints goes to the log, where the parent looks on a crash."""
    handle = os.open(log, os.O_WRONLY | os.O_CREAT | os.O_TRUNC, 0o600)
    os.dup2(handle, 1)
    os.dup2(handle, 2)
    os.close(handle)
    faulthandler.enable()
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
    from pebble import ProcessExpired

    name = Path(task.file).name
    try:
        return future.result()
    except TimeoutError:
        return failure(task.file, "timeout",
                       f"{name} took longer than {limits.seconds:g} s, the limit for one file.")
    except ProcessExpired:
        if any(sign in _tail(log) for sign in _OUT_OF_MEMORY):
            return failure(task.file, "memory", _memory_message(task, limits))
        return failure(task.file, "crash",
                       f"{name} ended the process that read it: the file is likely damaged.")


def _memory_message(task, limits=None):
    allowed = f" than {limits.megabytes} MB" if limits else " than it may have"
    return f"{Path(task.file).name} needs more memory{allowed}."


def _tail(log):
    try:
        with open(log, "rb") as file:
            return file.read(1 << 20)
    except OSError:
        return b""

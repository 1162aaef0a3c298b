# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a worker does with files. It imports little, since every worker does so before its first file."""

import faulthandler
import os
import signal
import sys
import tempfile
import time
from contextlib import suppress
from pathlib import Path

from ...freecad_adapter.bootstrap import has_home
from ...system.process_limits import crash_quietly, limit_files, limit_memory
from ..analysis.analysis_outcome import failure
from .preparation import require_preparation
from .reported_failure import reported_failure

LARGEST_FILE = 4 << 30
"""Maximum bytes of a file that a worker writes: FreeCAD unpacks documents into the worker's folder."""

MOST_OPEN_FILES = 512
"""Files that a worker may have open: FreeCAD opens some 60, and one per linked document."""


def start_reader(megabytes, work=None):
    """Initialize a worker: ignore Ctrl-C, which the parent handles, and limit memory and files.

    Parameters
    ----------
    megabytes : int
    work : callable, optional
        What the worker is for. Nothing is done with it here: it is loaded before a reader is forked.
    """
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


def answer(work, task):
    """Do a task; what fails is an answer too. If FreeCAD crashes, the parent reads what it has printed.

    Returns an object: what `work` returns; or as `failure`, with ``seconds``.

    Parameters
    ----------
    work : callable
        ``work(task)``
    task : object
        With the path of its document as ``file``.
    """
    started = time.perf_counter()
    faulthandler.enable()
    try:
        return work(task)
    except Exception as error:  # a failed row instead of a traceback
        return {**failure(task.file, **reported_failure(error, Path(task.file).name)),
                "seconds": round(time.perf_counter() - started, 4)}


def analysed(task):
    """Analyse one file: the outcome of `analyse_file`."""
    from ..analysis.analyse_file import analyse_file

    return analyse_file(task, before_reading=require_preparation)


def close_documents():
    """Close what FreeCAD has opened for a task, in a process that goes on with the next one."""
    freecad = sys.modules.get("FreeCAD")
    if freecad is not None:
        for name in list(freecad.listDocuments()):
            with suppress(Exception):  # what cannot be closed does not lose the results
                freecad.closeDocument(name)

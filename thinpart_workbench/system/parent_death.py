"""A process that ends when its parent ends, however that ends and whatever it is busy with itself."""

import ctypes
import os
import select
import signal
import sys
import threading
import time

from . import windows

_PR_SET_PDEATHSIG = 1

_TICK = 1.0
"""Seconds between two looks at the parent, where the system tells nothing."""


def end_with_parent(parent):
    """Have the system end this process when the one that started it ends.

    A reader of CAD files may hold Python's lock for minutes, so nothing in this process could look
    whether its parent is still there. Linux and Windows end it nevertheless. On macOS, and where the
    system has no such service, a thread waits for the parent's end, and a process that is in the middle of
    such foreign code goes on until that returns.

    Parameters
    ----------
    parent : int
        Number of the parent's process, which may have ended before this call.

    Notes
    -----
    On Linux the signal comes when the parent's *thread* ends (prctl(2)). pebble starts its first workers
    from the thread that hands over the first task, which waits for the results, and replaces lost ones
    from a thread that ends when the pool is stopped, so with all its workers. `process_pool` has a thread
    per worker, which lasts as long as that.

    On Windows the process joins a job that ends with its last handle, which only the parent has.
    """
    if sys.platform == "win32":
        _end_with_job(parent)
        return
    if not _asked_linux():
        threading.Thread(target=_wait_for_end, args=(parent,), name="thinpart-parent", daemon=True).start()
    if os.getppid() != parent:
        os._exit(1)


def _asked_linux():
    if not sys.platform.startswith("linux"):
        return False
    try:
        prctl = ctypes.CDLL(None).prctl
    except (OSError, AttributeError):
        return False
    return prctl(_PR_SET_PDEATHSIG, signal.SIGKILL, 0, 0, 0) == 0


def _end_with_job(parent):
    job = windows.join_new_job(windows.KILL_WITH_JOB)
    try:
        windows.give_handle(job, parent)
    except OSError:
        os._exit(1)  # it has ended already


def _wait_for_end(parent):
    if hasattr(select, "kqueue"):
        queue = select.kqueue()
        end = select.kevent(parent, select.KQ_FILTER_PROC, select.KQ_EV_ADD, select.KQ_NOTE_EXIT)
        try:
            queue.control([end], 1)
        except OSError:
            pass  # it has ended already
    else:
        while os.getppid() == parent:
            time.sleep(_TICK)
    os._exit(1)

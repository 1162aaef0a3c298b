# SPDX-License-Identifier: LGPL-2.1-or-later
"""End a process when its parent ends, even if the parent crashes and whatever the process is doing."""

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
"""Seconds between two checks of the parent, on systems without a notification."""


def end_with_parent(parent):
    """Make the system end this process when its parent, by process id, ends, or now if it has ended already.

    A reader of CAD files may hold Python's lock for minutes, so code in this process could not check whether the
    parent still runs. Linux and Windows end the process nevertheless. On macOS, and on systems without such a
    service, a thread waits for the parent's end, and a process inside such foreign code goes on until that returns.

    On Linux the signal is sent when the parent's *thread* ends (prctl(2)). `process_pool` has one thread per worker,
    which lives as long as the worker.

    On Windows the process joins a job that ends when its last handle is closed, and only the parent has a handle.
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

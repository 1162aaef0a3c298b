"""A process that ends when its parent ends, however that ends and whatever it is busy with itself."""

import ctypes
import os
import signal

_PR_SET_PDEATHSIG = 1


def end_with_parent(parent):
    """Have the system kill this process when the thread that started it ends.

    A reader of CAD files may hold Python's lock for minutes, so nothing in this process could look
    whether its parent is still there. Where the system has no such service (it is Linux's), nothing
    happens, and a process whose parent was killed goes on until its file is done.

    Parameters
    ----------
    parent : int
        Number of the parent's process, which may have ended before this call.

    Notes
    -----
    The signal comes when the parent's *thread* ends (prctl(2)). pebble starts its first workers from
    the thread that hands over the first task, which waits for the results, and replaces lost ones
    from a thread that ends when the pool is stopped, so with all its workers.
    """
    try:
        prctl = ctypes.CDLL(None).prctl
    except (OSError, AttributeError):
        return
    prctl(_PR_SET_PDEATHSIG, signal.SIGKILL, 0, 0, 0)
    if os.getppid() != parent:
        os._exit(1)

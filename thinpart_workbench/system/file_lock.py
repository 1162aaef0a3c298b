# SPDX-License-Identifier: LGPL-2.1-or-later
"""File locks that the system releases when a process ends, even by a crash."""

import errno
import os
import sys
import time

try:
    import fcntl
except ModuleNotFoundError:  # Windows
    fcntl = None
    import msvcrt

_TICK = 0.02
"""Seconds between two attempts. A blocking call would not end after a time, nor at a Ctrl-C that only sets a flag."""

FOLDERS_CAN_BE_LOCKED = fcntl is not None
"""Whether a folder can be locked. Windows cannot open a folder, so a file in it has to be locked instead."""

OPEN_FILES_CAN_BE_MOVED = sys.platform != "win32"
"""Whether a file can be renamed and removed while it is open."""


def lock(handle, seconds=0.0):
    """Lock an open file, or a folder if `FOLDERS_CAN_BE_LOCKED`, until it is closed.

    Raises BlockingIOError if another process still holds it then; OSError if the file system has no locks.

    Parameters
    ----------
    handle : int
        File descriptor.
    seconds : float
        How long to wait for another process that holds the lock.
    """
    end = time.monotonic() + seconds
    while True:
        try:
            _try_to_lock(handle)
            return
        except BlockingIOError:
            if time.monotonic() >= end:
                raise
        time.sleep(_TICK)


def _try_to_lock(handle):
    if fcntl is not None:
        fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
        return
    os.lseek(handle, 0, os.SEEK_SET)  # locking starts at the current position
    try:
        msvcrt.locking(handle, msvcrt.LK_NBLCK, 1)
    except PermissionError as error:  # what Windows says where another process holds it
        raise BlockingIOError(errno.EAGAIN, error.strerror) from None

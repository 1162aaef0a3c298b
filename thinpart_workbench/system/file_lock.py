"""File locks that the system releases when a process ends, even by a crash."""

import os
import sys
import time

try:
    import fcntl
except ModuleNotFoundError:  # Windows
    fcntl = None
    import msvcrt

_TICK = 0.05
"""Seconds between two attempts, on systems without a blocking lock."""

FOLDERS_CAN_BE_LOCKED = fcntl is not None
"""Whether a folder can be locked. Windows cannot open a folder, so a file in it has to be locked instead."""

OPEN_FILES_CAN_BE_MOVED = sys.platform != "win32"
"""Whether a file can be renamed and removed while it is open."""


def lock(handle, wait=True):
    """Lock an open file, or a folder if `FOLDERS_CAN_BE_LOCKED`, until it is closed.

    Parameters
    ----------
    handle : int
        File descriptor.
    wait : bool
        Whether to wait for another process that holds the lock.

    Raises
    ------
    OSError
        If the lock cannot be acquired: another process holds it, or the file system has no locks.
    """
    if fcntl is not None:
        fcntl.flock(handle, fcntl.LOCK_EX if wait else fcntl.LOCK_EX | fcntl.LOCK_NB)
        return
    while True:
        os.lseek(handle, 0, os.SEEK_SET)  # locking starts at the current position
        try:
            msvcrt.locking(handle, msvcrt.LK_NBLCK, 1)
            return
        except PermissionError:  # another process holds it; LK_LOCK would give up after ten seconds
            if not wait:
                raise
        time.sleep(_TICK)

"""Locks that the system takes away from a process that ends, however it ends."""

import os
import sys
import time

try:
    import fcntl
except ModuleNotFoundError:  # Windows
    fcntl = None
    import msvcrt

_TICK = 0.05
"""Seconds between two attempts, where the system does not wait by itself."""

FOLDERS_CAN_BE_LOCKED = fcntl is not None
"""On Windows a folder cannot be opened, so that it takes a file to lock."""

OPEN_FILES_CAN_BE_MOVED = sys.platform != "win32"
"""Whether a file can be renamed and removed while it is open."""


def lock(handle, wait=True):
    """Lock an open file, or a folder where that can be, until it is closed.

    Parameters
    ----------
    handle : int
    wait : bool
        Whether to wait for another process that has the lock.

    Raises
    ------
    OSError
        Where there is no such lock: another process has it, or the file system has none.
    """
    if fcntl is not None:
        fcntl.flock(handle, fcntl.LOCK_EX if wait else fcntl.LOCK_EX | fcntl.LOCK_NB)
        return
    while True:
        os.lseek(handle, 0, os.SEEK_SET)  # bytes are locked from where the file stands
        try:
            msvcrt.locking(handle, msvcrt.LK_NBLCK, 1)
            return
        except PermissionError:  # somebody has it; LK_LOCK would give up after ten seconds
            if not wait:
                raise
        time.sleep(_TICK)

"""One writer at a time where what is written depends on what was there."""

import fcntl
import os
from contextlib import contextmanager


@contextmanager
def folder_lock(folder):
    """Keep other programs that use this lock out of a folder until the block ends.

    Parameters
    ----------
    folder : str or Path

    Notes
    -----
    Nothing is written for it, and a program that is killed leaves no lock behind. Some network shares
    lock no folders; there the block runs without.
    """
    try:
        handle = os.open(folder, os.O_RDONLY)
    except OSError:
        yield  # whoever goes on to write there gets the reason
        return
    try:
        try:
            fcntl.flock(handle, fcntl.LOCK_EX)
        except OSError:
            pass  # a share without locks
        yield
    finally:
        os.close(handle)

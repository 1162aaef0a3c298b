"""Temporary folders that outlive only a process which was killed, and go with the next one."""

import fcntl
import os
import shutil
import stat
import tempfile
from contextlib import contextmanager

PREFIX = "thinpart-run-"
LOCK = "lock"


@contextmanager
def temporary_folder():
    """A folder for the time of a ``with`` block; those that killed processes left go first.

    Yields
    ------
    str
        Path of the new folder.

    Notes
    -----
    A lock file says that the folder is in use: the system takes the lock away from a process that
    ends, however it ends, and a number of a process may have been given to another one meanwhile.
    """
    remove_left_folders(tempfile.gettempdir())
    with tempfile.TemporaryDirectory(prefix=PREFIX, ignore_cleanup_errors=True) as folder:
        lock = os.path.join(folder, LOCK)
        handle = os.open(lock + ".new", os.O_RDWR | os.O_CREAT | os.O_EXCL, 0o600)
        try:
            try:
                fcntl.flock(handle, fcntl.LOCK_EX)
                # Under its name it is locked from the start; a folder without lock is left alone.
                os.rename(lock + ".new", lock)
            except OSError:
                os.unlink(lock + ".new")  # a file system without locks: nobody clears up after us
            yield folder
        finally:
            os.close(handle)


def remove_left_folders(parent):
    """Remove this user's folders under `parent` whose process has ended without doing so."""
    try:
        names = [name for name in os.listdir(parent) if name.startswith(PREFIX)]
    except OSError:
        return
    for name in names:
        folder = os.path.join(parent, name)
        if _is_own(folder, stat.S_ISDIR):
            _remove_unused(folder)


def _remove_unused(folder):
    lock = os.path.join(folder, LOCK)
    if not _is_own(lock, stat.S_ISREG):
        return
    try:
        handle = os.open(lock, os.O_RDWR | os.O_NOFOLLOW | os.O_NONBLOCK)
    except OSError:
        return
    try:
        fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
        shutil.rmtree(folder, ignore_errors=True)
    except OSError:
        return  # in use
    finally:
        os.close(handle)


def _is_own(path, is_kind):
    """Whether it is this user's, and a folder or file itself and no link to one."""
    try:
        status = os.lstat(path)
    except OSError:
        return False
    return status.st_uid == os.geteuid() and is_kind(status.st_mode)

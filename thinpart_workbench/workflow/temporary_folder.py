"""Temporary folders that outlive only a process which was killed, and go with the next one."""

import os
import shutil
import stat
import tempfile
from contextlib import contextmanager

from ..system.file_lock import OPEN_FILES_CAN_BE_MOVED, lock
from ..system.user import is_own

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
        handle = _locked(os.path.join(folder, LOCK))
        try:
            yield folder
        finally:
            os.close(handle)


def _locked(path):
    """Handle of a new file that this process has locked."""
    # Under its name it is locked from the start, since a folder without lock is left alone. Where an open file
    # keeps its name it also stays in its folder, so that nobody else can clear that away meanwhile.
    made = path + ".new" if OPEN_FILES_CAN_BE_MOVED else path
    handle = os.open(made, os.O_RDWR | os.O_CREAT | os.O_EXCL, 0o600)
    try:
        lock(handle)
        if made != path:
            os.rename(made, path)
    except OSError:  # a file system without locks: nobody clears up after us
        if OPEN_FILES_CAN_BE_MOVED:
            os.unlink(made)
    return handle


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
    path = os.path.join(folder, LOCK)
    if not _is_own(path, stat.S_ISREG):
        return
    try:
        # Between the look and this it may have become a link, or something that does not open at once.
        handle = os.open(path, os.O_RDWR | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_NONBLOCK", 0))
    except OSError:
        return
    try:
        lock(handle, wait=False)
        if OPEN_FILES_CAN_BE_MOVED:
            shutil.rmtree(folder, ignore_errors=True)
    except OSError:
        return  # in use
    finally:
        os.close(handle)
    if not OPEN_FILES_CAN_BE_MOVED:
        shutil.rmtree(folder, ignore_errors=True)  # the lock was in the way


def _is_own(path, is_kind):
    """Whether it is this user's, and a folder or file itself and no link to one."""
    try:
        status = os.lstat(path)
    except OSError:
        return False
    return is_own(status) and is_kind(status.st_mode)

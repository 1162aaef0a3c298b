# SPDX-License-Identifier: LGPL-2.1-or-later
"""Temporary folders that the next run removes if their own process was killed."""

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
    """A folder for a ``with`` block; leftover folders of killed processes are removed first.

    Yields a str: path of the new folder.

    A lock on a file in the folder marks it as in use. The system releases the lock whenever its process
    ends. A process id would not do: the system may assign it to another process.
    """
    remove_leftover_folders(tempfile.gettempdir())
    with tempfile.TemporaryDirectory(prefix=PREFIX, ignore_cleanup_errors=True) as folder:
        handle = _create_locked(os.path.join(folder, LOCK))
        try:
            yield folder
        finally:
            os.close(handle)


def _create_locked(path):
    """Create and lock a file; returns its handle."""
    # The file gets its name only once it is locked: another process does not touch a folder without lock file.
    # Where open files cannot be renamed (Windows), they cannot be deleted either, so no other process can remove
    # the folder before the file is locked.
    new_path = path + ".new" if OPEN_FILES_CAN_BE_MOVED else path
    handle = os.open(new_path, os.O_RDWR | os.O_CREAT | os.O_EXCL, 0o600)
    try:
        lock(handle)
        if new_path != path:
            os.rename(new_path, path)
    except OSError:  # a file system without locks: a later run will not remove this folder
        if OPEN_FILES_CAN_BE_MOVED:
            os.unlink(new_path)
    return handle


def remove_leftover_folders(parent):
    """Remove this user's folders in `parent` whose process has ended without removing them."""
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
        # Since `lstat` the file may have become a link, or something whose opening blocks.
        handle = os.open(path, os.O_RDWR | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_NONBLOCK", 0))
    except OSError:
        return
    try:
        lock(handle)
        if OPEN_FILES_CAN_BE_MOVED:
            shutil.rmtree(folder, ignore_errors=True)
    except OSError:
        return  # in use
    finally:
        os.close(handle)
    if not OPEN_FILES_CAN_BE_MOVED:
        shutil.rmtree(folder, ignore_errors=True)  # Windows cannot remove the folder while the lock file is open


def _is_own(path, is_kind):
    """Whether a path belongs to this user and is itself of a kind (folder or file), not a link to one."""
    try:
        status = os.lstat(path)
    except OSError:
        return False
    return is_own(status) and is_kind(status.st_mode)

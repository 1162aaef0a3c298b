# SPDX-License-Identifier: LGPL-2.1-or-later
"""A lock on a folder, for read-modify-write: one writer at a time."""

import errno
import hashlib
import os
import tempfile
from contextlib import contextmanager

from ..core.message import message
from ..system.file_lock import FOLDERS_CAN_BE_LOCKED, lock

PATIENCE = 10.0
"""Seconds to wait for a folder. Who writes there holds the lock for milliseconds, but whoever can read a folder can lock it,
and need not let it go."""

_held: set[str] = set()  # folders that were waited for in vain: not once more for each of 100,000 files


class FolderIsLocked(OSError):
    """Another program has kept a folder locked for too long."""


@contextmanager
def folder_lock(folder):
    """Keep other programs that use this lock out of a folder until the block ends.

    Raises FolderIsLocked if another program does not let go of it within `PATIENCE`.

    The lock writes nothing into the folder, and a killed program leaves no lock behind. Some network shares
    cannot lock folders; there the block runs without a lock. Windows cannot lock folders at all: there an
    empty file in this user's temporary folder is locked instead, which programs on other machines do not see.
    """
    try:
        handle = os.open(folder, os.O_RDONLY) if FOLDERS_CAN_BE_LOCKED else _open_lock_file(folder)
    except OSError:
        yield  # the caller gets the error when it writes there
        return
    try:
        _wait_for(handle, os.path.abspath(folder))
        yield
    finally:
        os.close(handle)


def _wait_for(handle, folder):
    try:
        lock(handle, 0.0 if folder in _held else PATIENCE)
    except BlockingIOError:
        _held.add(folder)
        raise FolderIsLocked(errno.EAGAIN, message("another program keeps the folder locked"), folder) from None
    except OSError:
        pass  # a share without locks
    _held.discard(folder)


def _open_lock_file(folder):
    real_path = os.path.normcase(os.path.realpath(folder))
    name = "thinpart-lock-" + hashlib.sha256(os.fsencode(real_path)).hexdigest()[:20]
    return os.open(os.path.join(tempfile.gettempdir(), name), os.O_RDWR | os.O_CREAT, 0o600)

"""A lock on a folder, for read-modify-write: one writer at a time."""

import hashlib
import os
import tempfile
from contextlib import contextmanager

from ..system.file_lock import FOLDERS_CAN_BE_LOCKED, lock


@contextmanager
def folder_lock(folder):
    """Keep other programs that use this lock out of a folder until the block ends.

    Parameters
    ----------
    folder : str or Path

    Notes
    -----
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
        try:
            lock(handle)
        except OSError:
            pass  # a share without locks
        yield
    finally:
        os.close(handle)


def _open_lock_file(folder):
    real_path = os.path.normcase(os.path.realpath(folder))
    name = "thinpart-lock-" + hashlib.sha256(os.fsencode(real_path)).hexdigest()[:20]
    return os.open(os.path.join(tempfile.gettempdir(), name), os.O_RDWR | os.O_CREAT, 0o600)

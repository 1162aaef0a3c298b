"""One writer at a time where what is written depends on what was there."""

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
    Nothing is written into the folder for it, and a program that is killed leaves no lock behind. Some
    network shares lock no folders; there the block runs without. Windows locks no folders at all: there an
    empty file among this user's temporary ones stands for each, which programs on other machines do not see.
    """
    try:
        handle = os.open(folder, os.O_RDONLY) if FOLDERS_CAN_BE_LOCKED else _stand_in(folder)
    except OSError:
        yield  # whoever goes on to write there gets the reason
        return
    try:
        try:
            lock(handle)
        except OSError:
            pass  # a share without locks
        yield
    finally:
        os.close(handle)


def _stand_in(folder):
    place = os.path.normcase(os.path.realpath(folder))
    name = "thinpart-lock-" + hashlib.sha256(os.fsencode(place)).hexdigest()[:20]
    return os.open(os.path.join(tempfile.gettempdir(), name), os.O_RDWR | os.O_CREAT, 0o600)

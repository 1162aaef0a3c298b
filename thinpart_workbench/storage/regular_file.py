"""Opening untrusted files such that none of them can block the program."""

import errno
import os
import stat

from ..core.message import message


def open_regular(path):
    """Open a regular file for reading: opening a pipe would block, and reading a device may never end.

    Parameters
    ----------
    path : str or Path

    Returns
    -------
    binary file

    Raises
    ------
    OSError
        Also if it is a folder, a pipe, a socket or a device.
    """
    # Checked before opening, since opening a pipe blocks until somebody writes to it. O_NONBLOCK is no way out: it
    # would fail for a file on which another client of a server holds a lease.
    _check(os.stat(path), path)
    file = open(path, "rb")
    try:
        _check(os.fstat(file.fileno()), path)
    except OSError:
        file.close()
        raise
    return file


def _check(status, path):
    if stat.S_ISDIR(status.st_mode):
        raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR), os.fspath(path))
    if not stat.S_ISREG(status.st_mode):
        raise OSError(errno.EINVAL, message("it is not a regular file"), os.fspath(path))

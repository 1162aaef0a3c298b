# SPDX-License-Identifier: LGPL-2.1-or-later
"""Opening untrusted files such that none of them can block the program."""

import errno
import os
import stat

from .message import message


def open_regular(path):
    """Open a regular file for reading: opening a pipe would block, and reading a device may never end.

    Raises OSError: also if it is a folder, a pipe, a socket or a device.
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


def read_regular(path, most):
    """The bytes of a regular file. Raises OSError: as `open_regular`; also if the file is larger.

    Parameters
    ----------
    path : str or Path
    most : int
        Greatest number of bytes that are read, whatever size the system says the file has.
    """
    with open_regular(path) as file:
        content = file.read(most + 1)
    if len(content) > most:
        raise OSError(errno.EFBIG, message("it is larger than {megabytes} MB", megabytes=most >> 20), os.fspath(path))
    return content


def is_special(path):
    """Whether a path leads to a pipe, a socket or a device, which opening may never end: bool."""
    try:
        mode = os.stat(path).st_mode
    except (OSError, ValueError):
        return False  # nothing can be opened there
    return not (stat.S_ISREG(mode) or stat.S_ISDIR(mode))


def _check(status, path):
    if stat.S_ISDIR(status.st_mode):
        raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR), os.fspath(path))
    if not stat.S_ISREG(status.st_mode):
        raise OSError(errno.EINVAL, message("it is not a regular file"), os.fspath(path))

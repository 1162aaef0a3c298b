"""Files of other people, opened so that none of them can hold the program up."""

import errno
import os
import stat


def open_regular(path):
    """Open a file for reading, if it is one: a pipe would be waited for, and a device never ends.

    Parameters
    ----------
    path : str or Path

    Returns
    -------
    binary file

    Raises
    ------
    OSError
        Also where it is a folder, a pipe, a socket or a device.
    """
    # Looked at first: opening a pipe waits for whoever writes into it. To open it without waiting would fail for a
    # file that a server has lent to somebody.
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
        raise OSError(errno.EINVAL, "it is no regular file", os.fspath(path))

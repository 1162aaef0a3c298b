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
    # Without waiting for whoever might write into a pipe; regular files know no such thing.
    handle = os.open(path, os.O_RDONLY | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_CLOEXEC", 0)
                     | getattr(os, "O_BINARY", 0))
    if not stat.S_ISREG(os.fstat(handle).st_mode):
        os.close(handle)
        raise OSError(errno.EINVAL, "it is no regular file", os.fspath(path))
    return os.fdopen(handle, "rb")

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files under names that are free: nothing is ever replaced."""

import os
from itertools import count

from ..core.regular_file import open_regular


def write_new(folder, stem, ending, content, mode=0o666, companion=None):
    """Write bytes to a file that is not there yet, and get its name; an earlier one with the same content is taken as it is.

    Raises OSError: nothing is left of the file then.

    Parameters
    ----------
    folder : str
    stem, ending : str
        Of its name; where that is taken, ``-2``, ``-3`` and so on come between.
    content : bytes
    mode : int, optional
        Permissions, as far as the system's mask for new files allows.
    companion : str, optional
        A name counts as taken too where there is a file with this ending behind it.
    """
    for number in count(1):
        name = f"{stem}{'' if number == 1 else f'-{number}'}{ending}"
        path = os.path.join(folder, name)
        if companion is not None and os.path.lexists(path + companion):
            continue
        try:
            handle = os.open(path, os.O_WRONLY | os.O_CREAT | os.O_EXCL | getattr(os, "O_BINARY", 0), mode)
        except FileExistsError:
            if _holds(path, content):
                return name
            continue
        try:
            with os.fdopen(handle, "wb") as file:
                file.write(content)
                file.flush()
                os.fsync(file.fileno())
        except BaseException:
            os.unlink(path)
            raise
        return name


def _holds(path, content):
    """Whether a regular file has this content."""
    try:
        with open_regular(path) as file:
            return os.fstat(file.fileno()).st_size == len(content) and file.read() == content
    except OSError:
        return False

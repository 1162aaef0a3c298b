"""Writing a file so that a reader sees the old or the new one, never half of it."""

import os
import tempfile


def write_atomically(path, content, lasting=True):
    """Write bytes to a temporary file beside `path`, flush them to disk, and rename it.

    Parameters
    ----------
    path : str or Path
    content : bytes
    lasting : bool
        Whether it has to outlast a power failure. What can be made again need not, and is written
        without waiting for the disk.

    Raises
    ------
    OSError
        The old file is then still whole and the temporary one removed.
    """
    path = os.path.abspath(path)
    folder = os.path.dirname(path)
    handle, temporary = tempfile.mkstemp(prefix=".thinpart-", suffix=".tmp", dir=folder)
    try:
        with os.fdopen(handle, "wb") as file:
            file.write(content)
            file.flush()
            if lasting:
                os.fsync(file.fileno())
        os.chmod(temporary, _mode(path))
        os.replace(temporary, path)
    except BaseException:
        _remove(temporary)
        raise
    if lasting:
        _sync_folder(folder)


def _mode(path):
    """Permissions of the file that is replaced, else what a new file would have."""
    try:
        return os.stat(path).st_mode & 0o777
    except OSError:
        mask = os.umask(0)
        os.umask(mask)
        return 0o666 & ~mask


def _remove(path):
    try:
        os.unlink(path)
    except OSError:
        return  # it is the first error that is reported


def _sync_folder(folder):
    """Make the rename itself outlast a power failure, where the file system can."""
    try:
        handle = os.open(folder, os.O_RDONLY)
    except OSError:
        return  # folders cannot be opened on every system
    try:
        os.fsync(handle)
    except OSError:
        return  # nor flushed on every network share
    finally:
        os.close(handle)

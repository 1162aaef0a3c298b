# SPDX-License-Identifier: LGPL-2.1-or-later
"""Atomic writing: a reader sees the old file or the new one, never half of it."""

import errno
import os
import secrets
import stat
from contextlib import suppress
from typing import NamedTuple, Optional

from ..core.message import message
from ..core.regular_file import is_special
from ..system.file_lock import lock
from ..system.user import is_own

_PREFIX, _SUFFIX = ".thinpart-", ".tmp"

_LEFTOVER_SECONDS = 60.0
"""Age from which an unlocked temporary file counts as a leftover of a killed process."""

_cleaned_folders: set[str] = set()  # each folder is listed once: it may hold 100,000 info files


class FileAccess(NamedTuple):
    """Who may read a file at most.

    Attributes
    ----------
    mode : int
        Permission bits; its owner can always read and write it.
    group : int or None
        The group that the bits are for; None for any.
    """

    mode: int
    group: Optional[int] = None

    @classmethod
    def of(cls, paths):
        """The access that all of these files have: of what is made of them. None where none of them is there."""
        found = []
        for path in paths:
            with suppress(OSError):
                found.append(os.stat(path))
        if not found:
            return None
        mode = 0o666
        for status in found:
            mode &= status.st_mode
        groups = {status.st_gid for status in found}
        return cls(mode | 0o600, *groups) if len(groups) == 1 else cls(_for_no_group(mode | 0o600))


OWNER_ONLY = FileAccess(0o600)
"""For what is made of the parts of many folders, such as the search index."""


def _for_no_group(mode):
    """Permission bits whose group may no more than everybody."""
    return mode & ~0o070 | mode & (mode << 3) & 0o070


def write_atomically(path, content, durable=True, beside=None, access=None, place=os.replace):
    """Write bytes to a temporary file beside `path`, flush them to disk, and rename it.

    Raises OSError: the old file is then still intact and the temporary one removed. Also where the name is that of a pipe, a
    device or a socket, or of a link to one.

    A killed process leaves its temporary file behind. The next process that writes into the folder removes it.

    Parameters
    ----------
    path : str or Path
    content : bytes
    durable : bool
        Whether the file has to survive a power failure. A file that can be regenerated need not, and is
        written without waiting for the disk.
    beside : str, optional
        A file in the same folder without which nothing is written. If the share of the folder was unmounted, the new file
        would be in the empty mount point: either this file is missing there, or the temporary one cannot be renamed.
    access : FileAccess, optional
        Who may read it at most. Otherwise as the file that it replaces, or as any new file.
    place : callable, optional
        Gives the temporary file its name: called with both paths.
    """
    path = os.path.abspath(path)
    if is_special(path):  # the system would let root rename a file over /dev/null
        raise OSError(errno.EINVAL, message("it is not a regular file"), path)
    folder = os.path.dirname(path)
    mode = _mode(path)
    handle, temporary = _new_temporary(folder, mode if access is None else mode & 0o600)
    try:
        with os.fdopen(handle, "wb") as file:
            with suppress(OSError):  # a file system without locks
                lock(file.fileno())
            if folder not in _cleaned_folders:
                _cleaned_folders.add(folder)
                _remove_leftovers(folder, os.fstat(file.fileno()).st_mtime)
            file.write(content)
            file.flush()
            if durable:
                os.fsync(file.fileno())
        if access is not None:
            mode &= _limit(temporary, access)
        if stat.S_IMODE(os.stat(temporary).st_mode) != mode:  # a confined process may not change it
            os.chmod(temporary, mode)
        if beside is not None:
            os.lstat(beside)
        place(temporary, path)
    except BaseException:
        _remove(temporary)
        raise
    if durable:
        _sync_folder(folder)


def _new_temporary(folder, mode):
    """Create a file with this mode, as far as the system's mask for new files allows: its descriptor and path."""
    flags = os.O_RDWR | os.O_CREAT | os.O_EXCL | getattr(os, "O_BINARY", 0) | getattr(os, "O_NOINHERIT", 0)
    path = os.path.join(folder, f"{_PREFIX}{secrets.token_hex(8)}{_SUFFIX}")
    return os.open(path, flags, mode), path


def _remove_leftovers(folder, now):
    """Remove temporary files that killed processes of this user left; `now` is by the clock of the file system."""
    with suppress(OSError):
        for name in os.listdir(folder):
            if name.startswith(_PREFIX) and name.endswith(_SUFFIX):
                with suppress(OSError):
                    _remove_unused(os.path.join(folder, name), now)


def _remove_unused(path, now):
    status = os.lstat(path)
    if not (stat.S_ISREG(status.st_mode) and is_own(status)) or now - status.st_mtime < _LEFTOVER_SECONDS:
        return
    # Since `lstat` the file may have become a link, or something whose opening blocks.
    handle = os.open(path, os.O_RDWR | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_NONBLOCK", 0))
    try:
        lock(handle)  # refused where another process is still writing
    finally:
        os.close(handle)
    os.unlink(path)


def _mode(path):
    """Permissions of the file that is replaced, else those of a new file."""
    try:
        return os.stat(path).st_mode & 0o777
    except OSError:
        mask = os.umask(0)
        os.umask(mask)
        return 0o666 & ~mask


def _limit(path, access):
    """The permission bits that a file of ours may have, once its group is the one that they are for, if that is possible."""
    own_group = os.stat(path).st_gid
    if access.group in (None, own_group) or access.mode == _for_no_group(access.mode):
        return access.mode
    try:
        os.chown(path, -1, access.group)
    except OSError:  # this user is not in that group
        return _for_no_group(access.mode)
    return access.mode


def place_new(temporary, path):
    """Give a temporary file a name that no file has, for `write_atomically`.

    Raises FileExistsError: the file that has the name stays as it is.
    """
    try:
        os.link(temporary, path)
    except FileExistsError:
        raise
    except OSError:  # a file system without hard links: the name is taken by an empty file first
        os.close(os.open(path, os.O_WRONLY | os.O_CREAT | os.O_EXCL))
        try:
            os.replace(temporary, path)
        except OSError:
            os.unlink(path)
            raise
    else:
        os.unlink(temporary)


def _remove(path):
    try:
        os.unlink(path)
    except OSError:
        return  # only the first error is reported


def _sync_folder(folder):
    """Make the rename itself survive a power failure, where the file system supports that."""
    try:
        handle = os.open(folder, os.O_RDONLY)
    except OSError:
        return  # some systems cannot open folders
    try:
        os.fsync(handle)
    except OSError:
        return  # some network shares cannot flush folders
    finally:
        os.close(handle)

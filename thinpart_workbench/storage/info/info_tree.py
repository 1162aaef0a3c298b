# SPDX-License-Identifier: LGPL-2.1-or-later
"""All info files under a folder."""

import os
from collections import namedtuple

from ...system.file_number import file_number
from .info_file import SUFFIX

Stamp = namedtuple("Stamp", "bytes modified inode")
"""Size, time in ns and inode number: at least one changes when a file does."""

_SUFFIX = os.fsencode(SUFFIX)


def scan(root, report=None):
    """Find the info files below a folder; links to folders are followed, each folder is listed once.

    Returns `found` (dict of bytes to Stamp; by path below the root) and `unreachable` (dict of bytes to OSError; folders
    below the root, ``b""`` for the root itself, that could not be listed).

    Parameters
    ----------
    root : str or bytes
    report : callable, optional
        Called with the number of files found so far; may raise to stop.
    """
    root = os.fsencode(root)
    found: dict[bytes, Stamp] = {}
    unreachable: dict[bytes, OSError] = {}
    seen, pending = set(), [b""]
    while pending:
        folder = pending.pop()
        path = os.path.join(root, folder) if folder else root
        try:
            status = os.stat(path)
            if (status.st_dev, status.st_ino) in seen:
                continue
            seen.add((status.st_dev, status.st_ino))
            with os.scandir(path) as entries:
                _list_entries(folder, entries, found, pending)
        except OSError as error:
            unreachable[folder] = error
        if report is not None:
            report(len(found))
    return found, unreachable


def _list_entries(folder, entries, found, pending):
    for entry in entries:
        name = entry.name
        entry_path = os.path.join(folder, name)
        if name.endswith(_SUFFIX):
            stamp = _stamp(entry)
            if stamp is not None:
                found[entry_path] = stamp
        elif not name.startswith(b".") and _is_folder(entry):
            pending.append(entry_path)


def _is_folder(entry):
    try:
        return entry.is_dir()
    except OSError:
        return False  # such as a link to itself: no other entry is affected


def _stamp(entry):
    try:
        status = entry.stat()
    except OSError:
        return None  # removed since the folder was listed, or a broken link
    return stamp_of(status)


def stamp_of(status):
    """The Stamp of a file's `os.stat_result`."""
    return Stamp(status.st_size, status.st_mtime_ns, file_number(status))

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Paths as ThinPart's files store them: Windows has drives and another path separator."""

import os

_path = os.path


def relative_path(path, start):
    """A path relative to a folder, with ``/`` as separator, which every system reads: str.

    The unchanged path if there is no relative one, because the drives differ.
    """
    try:
        relative = _path.relpath(path, start)
    except ValueError:
        relative = os.fspath(path)
    return relative if _path.sep == "/" else relative.replace(_path.sep, "/")


def path_in_tree(folder, top):
    """The path of a folder in the tree below another one, str; a folder on another drive is below that drive's letter."""
    folder = _path.abspath(folder)
    try:
        return _path.relpath(folder, _path.abspath(top))
    except ValueError:
        drive, rest = _path.splitdrive(folder)
        return drive.replace(":", "").strip("\\/").replace("\\", "-") + rest


def is_below(folder, top):
    """Whether an absolute folder equals another one, or lies in it; all drives lie below `os.sep`, which names no drive."""
    if top == _path.sep:
        return True
    top = _path.abspath(top)
    try:
        return _path.commonpath([top, folder]) == top
    except ValueError:
        return False

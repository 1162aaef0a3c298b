"""Paths as files of ThinPart keep them: Windows has drives, and another sign between folders."""

import os

_path = os.path


def relative_path(path, start):
    """A path as seen from a folder, with ``/`` between folders, which every system reads.

    Parameters
    ----------
    path, start : str or Path

    Returns
    -------
    str
        The whole path where no way leads there, from one drive to another.
    """
    try:
        found = _path.relpath(path, start)
    except ValueError:
        found = os.fspath(path)
    return found if _path.sep == "/" else found.replace(_path.sep, "/")


def place_in_tree(folder, top):
    """Where a folder lies in the tree below another one; what lies on another drive, below that drive's letter.

    Parameters
    ----------
    folder, top : str or Path

    Returns
    -------
    str
    """
    folder = _path.abspath(folder)
    try:
        return _path.relpath(folder, _path.abspath(top))
    except ValueError:
        drive, rest = _path.splitdrive(folder)
        return drive.replace(":", "").strip("\\/").replace("\\", "-") + rest


def is_below(folder, top):
    """Whether a folder is another one, or lies in it; all drives lie below the one sign that is no drive's.

    Parameters
    ----------
    folder, top : str
        Absolute paths, but for `os.sep`.
    """
    if top == _path.sep:
        return True
    top = _path.abspath(top)
    try:
        return _path.commonpath([top, folder]) == top
    except ValueError:
        return False

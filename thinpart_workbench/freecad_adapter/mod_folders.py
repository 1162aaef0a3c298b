"""The folders in which the versions of FreeCAD look for their user's add-ons.

Up to 1.0 that is ``Mod`` in the user's folder for FreeCAD. From 1.1 on each version has a folder of its own in
that one, ``v1-1/Mod``. Until it has, it reads what it finds of the version before; then, at its first start
with a window, it offers to copy all of that, links as links.
"""

import os
import re
from collections import namedtuple
from pathlib import Path

from .bootstrap import load_freecad

_FIRST_VERSIONED = (1, 1)
_VERSIONED = re.compile(r"v(\d+)-(\d+)")

ModFolder = namedtuple("ModFolder", "path version borrower")
"""A folder for add-ons, which need not be there yet.

``version`` is the one that it belongs to, (1, 1), or None for all up to 1.0; ``borrower`` the newer one that reads
it as long as it has none of its own, or None.
"""


def mod_folders():
    """The folders of all versions of FreeCAD that this user has started, and that of the FreeCAD used here.

    Returns
    -------
    list of ModFolder
        The one that the FreeCAD used here reads comes first. A version's folder that is not there is not in it,
        and must not be made: FreeCAD would take its settings for copied already.

    Raises
    ------
    ThinPartError
        See `load_freecad`.
    """
    freecad = load_freecad()
    version = tuple(int(part) for part in freecad.Version()[:2])
    return folders_below(Path(freecad.getUserAppDataDir()), version)


def folders_below(read, version):
    """The same for a FreeCAD of which is known what it reads.

    Parameters
    ----------
    read : Path
        What its ``getUserAppDataDir`` says.
    version : tuple of int
        Its own version: (1, 1).
    """
    top = read.parent if _version_of(read) else read
    inside = sorted(top.iterdir()) if top.is_dir() else []
    versioned = sorted(filter(_version_of, inside), key=_version_of)
    others = [top] if any(not _version_of(each) for each in inside) else []
    folders = [read, *(each for each in others + versioned if each != read)]
    return [ModFolder(each / "Mod", _version_of(each), _borrower(each, read, version)) for each in folders]


def _borrower(folder, read, version):
    return version if folder == read and version >= _FIRST_VERSIONED and version != _version_of(folder) else None


def _version_of(folder):
    """(1, 1) of ``v1-1``; None of another name, or where it is no folder that is or could be there."""
    name = _VERSIONED.fullmatch(os.path.basename(folder))
    return tuple(map(int, name.groups())) if name and (folder.is_dir() or not folder.exists()) else None

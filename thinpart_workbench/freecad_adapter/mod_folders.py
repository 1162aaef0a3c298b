# SPDX-License-Identifier: LGPL-2.1-or-later
"""The folders in which each version of FreeCAD looks for the user's add-ons.

Up to 1.0 this is ``Mod`` in the user's FreeCAD folder. From 1.1 on each version has its own folder in there, such as
``v1-1/Mod``. Until that exists, the version reads the folder of the version before; at its first start with a window
it offers to copy that folder, and copies links as links.
"""

import os
import re
from collections import namedtuple
from pathlib import Path

from .bootstrap import load_freecad

_FIRST_VERSIONED = (1, 1)
_VERSIONED = re.compile(r"v(\d+)-(\d+)")

ModFolder = namedtuple("ModFolder", "path version borrower")
"""A folder for add-ons, which need not exist yet.

``version`` is the FreeCAD version that it belongs to, such as (1, 1), or None for all versions up to 1.0. ``borrower``
is the newer version that reads it as long as it has no folder of its own, or None.
"""


def mod_folders():
    """The folders of all versions of FreeCAD that this user has started, and of the present one.

    Returns a list of ModFolder: the folder that the present FreeCAD reads comes first. A version folder that does not exist
    is not listed and must not be made: FreeCAD would assume that its settings have been copied already. Raises
    ThinPartError: see `load_freecad`.
    """
    freecad = load_freecad()
    version = tuple(int(part) for part in freecad.Version()[:2])
    return folders_below(Path(freecad.getUserAppDataDir()), version)


def folders_below(user_folder, version):
    """The same as `mod_folders` for a FreeCAD with a given user folder and version.

    Parameters
    ----------
    user_folder : Path
        The result of its ``getUserAppDataDir``.
    version : tuple of int
        Its own version, such as (1, 1).
    """
    top = user_folder.parent if _version_of(user_folder) else user_folder
    inside = sorted(top.iterdir()) if top.is_dir() else []
    versioned = sorted(filter(_version_of, inside), key=_version_of)
    others = [top] if any(not _version_of(folder) for folder in inside) else []
    folders = [user_folder, *(folder for folder in others + versioned if folder != user_folder)]
    return [ModFolder(folder / "Mod", _version_of(folder), _borrower(folder, user_folder, version))
            for folder in folders]


def _borrower(folder, user_folder, version):
    return version if folder == user_folder and version >= _FIRST_VERSIONED and version != _version_of(folder) else None


def _version_of(folder):
    """(1, 1) for ``v1-1``; None for any other name, and for an existing file that is not a folder."""
    name = _VERSIONED.fullmatch(os.path.basename(folder))
    return tuple(map(int, name.groups())) if name and (folder.is_dir() or not folder.exists()) else None

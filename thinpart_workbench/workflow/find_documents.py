"""The documents that a list of files and folders names."""

import os
from pathlib import Path

ENDINGS = (".fcstd", ".step", ".stp", ".iges", ".igs", ".brep", ".brp",
           ".stl", ".obj", ".ply", ".off", ".3mf")
"""Endings that are taken from folders; a test holds them equal to those that can be read."""


def find_documents(paths):
    """Documents named or lying under folders, sorted, each real file once.

    Parameters
    ----------
    paths : list of str or Path
        Files are taken as they are, whatever their ending; folders are searched, links included,
        loops of links once.

    Returns
    -------
    list of Path
        Of several ways to a file, the one without links if it is among them, else the first.
    """
    found = {}
    for path in map(Path, paths):
        for file in _under(path) if path.is_dir() else [path]:
            real = os.path.realpath(file)
            if real not in found or os.path.abspath(file) == real:
                found[real] = file
    return sorted(found.values(), key=os.path.abspath)


def common_folder(paths):
    """The innermost folder that holds all of these files and folders: the top of their tree.

    Two documents of one name in different folders have different places below it.
    """
    folders = [path if path.is_dir() else path.parent for path in map(Path, paths)]
    return Path(os.path.commonpath([os.path.abspath(folder) for folder in folders]))


def _under(folder):
    seen = set()
    for current, folders, files in os.walk(folder, followlinks=True):
        status = os.stat(current)
        if (status.st_dev, status.st_ino) in seen:
            folders.clear()
            continue
        seen.add((status.st_dev, status.st_ino))
        folders[:] = sorted(name for name in folders if not name.startswith("."))
        for name in sorted(files):
            if name.lower().endswith(ENDINGS) and not name.startswith("."):
                yield Path(current, name)

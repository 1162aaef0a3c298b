"""The documents that a list of files and folders names."""

import os
from dataclasses import dataclass
from pathlib import Path

ENDINGS = (".fcstd", ".step", ".stp", ".iges", ".igs", ".brep", ".brp",
           ".stl", ".obj", ".ply", ".off", ".3mf")
"""Endings that are taken from folders; a test holds them equal to those that can be read."""


@dataclass(frozen=True)
class FoundDocument:
    """A document and the top of the tree in which it was found.

    Attributes
    ----------
    file : Path
    root : Path
    """

    file: Path
    root: Path


def find_documents(paths):
    """Documents named or lying under folders, sorted, each once.

    Parameters
    ----------
    paths : list of str or Path
        Files are taken as they are, whatever their ending; folders are searched, links included,
        loops of links once.

    Returns
    -------
    list of FoundDocument
    """
    found = {}
    for path in map(Path, paths):
        if path.is_dir():
            for file in _under(path):
                found.setdefault(os.path.abspath(file), FoundDocument(file, path))
        else:
            found.setdefault(os.path.abspath(path), FoundDocument(path, path.parent))
    return [found[key] for key in sorted(found)]


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

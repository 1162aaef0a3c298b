"""The documents that a list of files and folders names."""

import errno
import os
from collections import deque, namedtuple
from dataclasses import dataclass, field
from fnmatch import fnmatchcase
from pathlib import Path

from ..core.errors import ThinPartError
from ..storage.info_file import SUFFIX

ENDINGS = (".fcstd", ".step", ".stp", ".iges", ".igs", ".brep", ".brp",
           ".stl", ".obj", ".ply", ".off", ".3mf")
"""Endings that are taken from folders; a test holds them equal to those that can be read."""

_REPORTED = 1000
"""Entries of a folder after which a search says again how far it is."""

Document = namedtuple("Document", "path bytes modified")
Document.__doc__ = """A file to be read: path (str), size, and time of its last change in seconds.

Size and time are 0 where the file cannot be examined: whoever reads it finds out why.
"""


@dataclass(frozen=True)
class NameFilter:
    """Which files of a folder are taken, by globs that do not care about upper and lower case.

    A glob without a slash is for the name of a file. One with a slash is for its path below the
    folder that is searched; there ``*`` stands for slashes too.

    Attributes
    ----------
    include : tuple of str
        Only what one of them matches; everything when there is none.
    exclude : tuple of str
        Never what one of them matches.
    """

    include: tuple = ()
    exclude: tuple = ()

    def takes(self, place):
        """Whether the file at this path below the searched folder is taken."""
        if self.include and not _matches(place, self.include):
            return False
        return not _matches(place, self.exclude)

    def enters(self, place):
        """Whether anything below the folder at this path could be taken."""
        return not _matches(place + "/", [glob for glob in self.exclude if glob.endswith("/*")])


def _matches(place, globs):
    place = place.lower()
    name = place.rpartition("/")[2]
    return any(fnmatchcase(place if "/" in glob else name, glob.lower().removeprefix("./"))
               for glob in globs)


@dataclass
class FoundDocuments:
    """What a search has found.

    Attributes
    ----------
    documents : list of Document
        Sorted by absolute path, each real file once. Of several ways to a file it is the one without
        links if that is among them, else the first.
    failures : list of (str, ThinPartError)
        Folders that could not be searched, and links that lead nowhere.
    """

    documents: list = field(default_factory=list)
    failures: list = field(default_factory=list)


def find_documents(paths, names=NameFilter(), report=None):
    """Documents named or lying under folders.

    Parameters
    ----------
    paths : list of str or Path
        Files are taken as they are, whatever their ending, but for info files, which a shell's
        ``folder/*`` names too; folders are searched, links included, loops of links once.
    names : NameFilter, optional
        Which files of the folders are taken.
    report : callable, optional
        ``report(count)``, called often with the number of documents so far; what it raises ends the
        search.

    Returns
    -------
    FoundDocuments
    """
    search = _Search(names, report or (lambda count: None))
    for path in map(os.fspath, paths):
        if os.path.isdir(path):
            search.folder(path)
        elif not path.endswith(SUFFIX):
            search.named(path)
    documents = sorted(search.found.values(), key=lambda document: os.path.abspath(document.path))
    return FoundDocuments(documents, sorted(search.failures, key=lambda failure: failure[0]))


def common_folder(paths):
    """The innermost folder that holds all of these files and folders: the top of their tree.

    Two documents of one name in different folders have different places below it.

    Raises
    ------
    ThinPartError
        kind ``usage`` where there is none, on Windows.
    """
    folders = [path if os.path.isdir(path) else path.parent for path in map(Path, paths)]
    try:
        return Path(os.path.commonpath([os.path.abspath(folder) for folder in folders]))
    except ValueError:
        raise ThinPartError("The parts lie on several drives: name those of one drive at a time.", "usage") from None


class _Search:
    """A search under way: documents by their real path, and what could not be searched."""

    def __init__(self, names, report):
        self.names = names
        self.report = report
        self.found = {}
        self.failures = []

    def named(self, path):
        self._add(path, os.path.realpath(path), os.path.islink(path), os.stat)

    def folder(self, top):
        # Links are followed last, so that a file that is reached without one is named without it.
        folders, links, seen = [(top, "")], deque(), set()
        while folders or links:
            folder, place = folders.pop() if folders else links.popleft()
            if self._is_new(folder, seen):
                inner, linked = self._entries(folder, place)
                folders += reversed(inner)
                links += linked

    def _is_new(self, folder, seen):
        try:
            status = os.stat(folder)
        except OSError as error:
            self._failed(folder, error)
            return False
        key = status.st_dev, status.st_ino
        new = key not in seen
        seen.add(key)
        return new

    def _entries(self, folder, place):
        """Take the files of a folder; return the folders in it, and those that are links."""
        real = os.path.realpath(folder)
        folders, links = [], []
        for number, entry in enumerate(self._listed(folder)):
            if number % _REPORTED == 0:
                self.report(len(self.found))
            inner = place + entry.name
            is_part = entry.name.lower().endswith(ENDINGS)
            try:
                is_link, is_folder = entry.is_symlink(), entry.is_dir()
            except OSError as error:
                if is_part:
                    self._add(entry.path, entry.path, True, os.stat)
                elif error.errno != errno.ELOOP:
                    self._failed(entry.path, error)
                continue
            if is_folder:
                if self.names.enters(inner):
                    (links if is_link else folders).append((entry.path, inner + "/"))
            elif is_part and self.names.takes(inner):
                # Only where a link is involved is there more than one way to a file.
                path = os.path.realpath(entry.path) if is_link else os.path.join(real, entry.name)
                self._add(entry.path, path, is_link, lambda _, entry=entry: entry.stat())
        return folders, links

    def _listed(self, folder):
        """Entries of a folder by name, without hidden ones; up to the failure where there is one."""
        entries = []
        try:
            with os.scandir(folder) as listing:
                for entry in listing:
                    if not entry.name.startswith("."):
                        entries.append(entry)
        except OSError as error:
            self._failed(folder, error)
        entries.sort(key=lambda entry: entry.name)
        return entries

    def _add(self, path, real, is_link, stat):
        if real in self.found and os.path.abspath(path) != real:
            return
        try:
            status = stat(path)
        except OSError as error:
            if is_link and error.errno in (errno.ENOENT, errno.ELOOP):
                self.failures.append((path, ThinPartError(_dead_link(path, error), "missing")))
                return
            self.found[real] = Document(path, 0, 0.0)
        else:
            self.found[real] = Document(path, status.st_size, status.st_mtime)

    def _failed(self, folder, error):
        if isinstance(error, FileNotFoundError):
            return  # removed while the rest was searched
        name = os.path.basename(os.path.abspath(folder))
        if isinstance(error, PermissionError):
            message, kind = f"The folder {name} may not be searched: check its permissions.", "permission"
        else:
            message, kind = (f"The folder {name} could not be searched to its end ({error.strerror}): "
                             "classify it again when it can be reached.", "unreadable")
        self.failures.append((folder, ThinPartError(message, kind)))


def _dead_link(path, error):
    name = os.path.basename(path)
    if error.errno == errno.ELOOP:
        return f"{name} is a link that leads back to itself: remove it or link it to a part."
    return f"{name} is a link that leads nowhere: remove it or link it to a part."

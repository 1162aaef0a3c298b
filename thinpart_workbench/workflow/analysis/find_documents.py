# SPDX-License-Identifier: LGPL-2.1-or-later
"""Find the documents in a list of files and folders."""

import errno
import os
from collections import deque, namedtuple
from dataclasses import dataclass, field
from fnmatch import fnmatchcase

from ...core.errors import ThinPartError
from ...core.file_formats import ENDINGS
from ...core.message import message
from ...storage.info.info_file import SUFFIX

_REPORT_INTERVAL = 1000
"""Entries of a folder between two progress reports of a search."""

Document = namedtuple("Document", "path bytes modified")
Document.__doc__ = """A file to be read: path (str), size, and time of its last change in seconds.

Size and time are 0 if `os.stat` fails: reading the file reports why.
"""


@dataclass(frozen=True)
class NameFilter:
    """Selects files of a folder by globs that ignore case.

    A glob without a slash is matched against the name of a file. A glob with a slash is matched against
    its path below the searched folder; there ``*`` matches slashes too.

    Attributes
    ----------
    include : tuple of str
        Only files that match one of them; all files if it is empty.
    exclude : tuple of str
        No files that match one of them.
    """

    include: tuple = ()
    exclude: tuple = ()

    def accepts_file(self, path_below):
        """Whether to include the file at this path below the searched folder."""
        if self.include and not _matches(path_below, self.include):
            return False
        return not _matches(path_below, self.exclude)

    def accepts_folder(self, path_below):
        """Whether the folder at this path may contain files to include."""
        return not _matches(path_below + "/", [glob for glob in self.exclude if glob.endswith("/*")])


def _matches(path_below, globs):
    path_below = path_below.lower()
    name = path_below.rpartition("/")[2]
    return any(fnmatchcase(path_below if "/" in glob else name, glob.lower().removeprefix("./"))
               for glob in globs)


@dataclass
class FoundDocuments:
    """The result of a search.

    Attributes
    ----------
    documents : list of Document
        Sorted by absolute path, each real file once. If several paths lead to a file, it has the path without
        links if that was found, else the first.
    failures : list of (str, ThinPartError)
        Folders that could not be searched, and broken links.
    """

    documents: list = field(default_factory=list)
    failures: list = field(default_factory=list)


def find_documents(paths, names=NameFilter(), report=None):
    """The documents among and below some files and folders: FoundDocuments.

    Parameters
    ----------
    paths : list of str or Path
        Files are included whatever their ending, except info files, which a shell's ``folder/*`` also
        contains; folders are searched, links included, each folder once.
    names : NameFilter, optional
        Which files of the folders to include.
    report : callable, optional
        ``report(count)``, called often with the number of documents so far; may raise `Cancelled` to stop.
    """
    search = _Search(names, report or (lambda count: None))
    for path in map(os.fspath, paths):
        if not path:  # as from a variable of a shell that is not set
            search.failures.append((os.curdir, ThinPartError(_EMPTY, "missing")))
        elif os.path.isdir(path):
            search.search_folder(path)
        elif not path.endswith(SUFFIX):
            search.add_file(path)
    documents = sorted(search.found.values(), key=lambda document: os.path.abspath(document.path))
    return FoundDocuments(documents, sorted(search.failures, key=lambda failure: failure[0]))


_EMPTY = message("One of the given paths is empty: name a file or a folder.")


class _Search:
    """The state of a search: documents by their real path, and failures."""

    def __init__(self, names, report):
        self.names = names
        self.report = report
        self.found = {}
        self.failures = []

    def add_file(self, path):
        self._add(path, os.path.realpath(path), os.path.islink(path), os.stat)

    def search_folder(self, top):
        # Links are followed last, so that a file found without a link gets the path without it.
        folders = [(top, "")]
        links: deque[tuple[str, str]] = deque()
        seen: set[tuple[int, int]] = set()
        while folders or links:
            folder, path_below = folders.pop() if folders else links.popleft()
            if self._is_new(folder, seen):
                subfolders, linked = self._scan_folder(folder, path_below)
                folders += reversed(subfolders)
                links += linked

    def _is_new(self, folder, seen):
        try:
            status = os.stat(folder)
        except OSError as error:
            self._add_failure(folder, error)
            return False
        key = status.st_dev, status.st_ino
        is_new = key not in seen
        seen.add(key)
        return is_new

    def _scan_folder(self, folder, path_below):
        """Add the files of a folder; returns its subfolders and its links to folders."""
        real = os.path.realpath(folder)
        folders: list[tuple[str, str]] = []
        links: list[tuple[str, str]] = []
        for number, entry in enumerate(self._list_folder(folder)):
            if number % _REPORT_INTERVAL == 0:
                self.report(len(self.found))
            entry_path = path_below + entry.name
            is_part = entry.name.lower().endswith(ENDINGS)
            try:
                is_link, is_folder = entry.is_symlink(), entry.is_dir()
            except OSError as error:
                if is_part:
                    self._add(entry.path, entry.path, True, os.stat)
                elif error.errno != errno.ELOOP:
                    self._add_failure(entry.path, error)
                continue
            if is_folder:
                if self.names.accepts_folder(entry_path):
                    (links if is_link else folders).append((entry.path, entry_path + "/"))
            elif is_part and self.names.accepts_file(entry_path):
                # Only links create several paths to a file.
                path = os.path.realpath(entry.path) if is_link else os.path.join(real, entry.name)
                self._add(entry.path, path, is_link, lambda _, entry=entry: entry.stat())
        return folders, links

    def _list_folder(self, folder):
        """Entries of a folder sorted by name, without hidden ones; those before an error if there is one."""
        entries = []
        try:
            with os.scandir(folder) as listing:
                for entry in listing:
                    if not entry.name.startswith("."):
                        entries.append(entry)
        except OSError as error:
            self._add_failure(folder, error)
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

    def _add_failure(self, folder, error):
        if isinstance(error, FileNotFoundError):
            return  # removed while the rest was searched
        name = os.path.basename(os.path.abspath(folder))
        if isinstance(error, PermissionError):
            sentence, kind = message("There is no permission to search the folder {folder}: check its permissions.",
                                     folder=name), "permission"
        else:
            sentence, kind = message("The folder {folder} could not be searched to its end ({problem}): classify it "
                                     "again when it can be reached.",
                                     folder=name, problem=error.strerror), "unreadable"
        self.failures.append((folder, ThinPartError(sentence, kind)))


def _dead_link(path, error):
    name = os.path.basename(path)
    if error.errno == errno.ELOOP:
        return message("{file} is a link that leads back to itself: remove it or link it to a part.", file=name)
    return message("{file} is a link that leads nowhere: remove it or link it to a part.", file=name)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Search folders of info files for parts."""

import os
from contextlib import ExitStack

from ..core.analysis_limits import Limits
from ..core.errors import ThinPartError
from ..core.record.record_types import PART, PartRecord
from ..storage.common_folder import common_folder
from ..storage.index.library_index import LibraryIndex
from ..storage.index.written_query import part_query
from ..storage.info.stored_records import info_file_of, select_record, single_record
from ..workflow.library.judged_otherwise import judged_otherwise
from ..workflow.library.library_search import LibrarySearch
from ..workflow.library.similar_parts import similar_parts
from ..workflow.reuse.duplicates import find_duplicates
from ..workflow.reuse.families import find_families
from .classified_parts import ClassifiedPart
from .found_parts import DuplicateGroups, FamilyList, FoundPart, LibraryProblem, SearchResult


class Libraries:
    """Folders with info files and their refreshed indexes; a context manager.

    Parameters
    ----------
    roots : list of str or Path
    report : callable, optional
        Called with the number of info files read and the total; may raise `Cancelled` to stop.

    Attributes
    ----------
    indexes : list of LibraryIndex
        Indexes of the folders that could be reached.
    folder : Path
        The folder that holds all roots.
    problems : tuple of LibraryProblem
    """

    def __init__(self, roots, report=None):
        self.folder = common_folder(roots)
        self.indexes, self._stack = [], ExitStack()
        problems = []
        try:
            for root in roots:
                problems += self._open(os.fspath(root), report)
        except BaseException:
            self.close()
            raise
        self.problems = tuple(problems)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def close(self):
        """Close the indexes."""
        self._stack.close()

    @property
    def has_parts(self):
        """Whether there is any part, or failure, in one of them."""
        return any(index.query("SELECT 1 FROM parts LIMIT 1") for index in self.indexes)

    def categories(self):
        """Names of the categories that stored parts have: list of str."""
        rows = (row for index in self.indexes for row in index.query("SELECT DISTINCT category FROM parts"))
        return sorted({name for name, in rows if name})

    def judged_otherwise(self):
        """Info files that a shipped profile has judged by other thresholds than it has now: dict of int, by its name."""
        files: dict[str, int] = {}
        for index in self.indexes:
            for each in judged_otherwise(index):
                files[each["profile"]] = files.get(each["profile"], 0) + each["files"]
        return files

    def find(self, query, sort="file", descending=False, limit=None):
        """Find the parts that match a `PartQuery`; see `LibrarySearch.find`. Returns a SearchResult."""
        found = LibrarySearch(self.indexes).find(query, sort, descending)
        parts = [FoundPart(part) for part in found.parts(0, limit) if part is not None]
        return SearchResult(parts, len(found), self.problems)

    def similar(self, record: PartRecord, count=10, same_size=None, excluding=None):
        """Find the parts most similar to a record, best first; see `similar_parts`. Returns a SearchResult."""
        found = similar_parts(self.indexes, record, count, same_size, excluding)
        return SearchResult([FoundPart(*match) for match in found], len(found), self.problems)

    def _open(self, root, report):
        """Open a library; returns its problems as a list of LibraryProblem."""
        try:
            _check(root)
            index = LibraryIndex(root)
            refreshed = index.refresh(report)
        except ThinPartError as error:
            return [LibraryProblem(root, "folder", str(error))]
        self._stack.callback(index.close)
        self.indexes.append(index)
        problems = [LibraryProblem(root, "folder", sentence) for sentence in refreshed.unreachable]
        if refreshed.warning:
            problems.append(LibraryProblem(root, "index", refreshed.warning))
        messages = index.query("SELECT error_message FROM parts WHERE error_kind = 'info_file'")
        return problems + [LibraryProblem(root, "info_file", text) for text, in messages]


def find(roots, category=(), criterion=(), where=(), text="", thickness=(None, None), size=(None, None), *,
         ratio=(None, None), has_notes=None, said=(), labelled=None, disputed=None, borderline=None, failed=False,
         changed_since=None, sort="file", descending=False, limit=None, report=None):
    """Search folders of info files for parts. FreeCAD is not needed.

    Parameters
    ----------
    roots : str, Path, or list of them
        Folders, searched recursively. An index of each is stored in the user's cache.
    category, criterion : str, or sequence of str, optional
        Only parts of one of these categories, or for which one of these criteria holds.
    where : str, or sequence of str, optional
        Conditions over any quantity of docs/info-file.md, such as ``D2/D3 > 6 and F[0;0.05] >= 0.5``.
    text : str, optional
        Words to search for in path, name, label, notes, mesh settings and link.
    thickness, size : (float or None, float or None), optional
        Least and greatest thickness of the thinnest wall, and of the longest side of the box, mm.
    ratio : (float or None, float or None), optional
        Least and greatest V/VBB.
    has_notes, borderline : bool, optional
        True for only parts with annotations, or near another category; False for only the others.
    said : str, or sequence of str, optional
        Only parts that somebody has labelled as one of these categories.
    labelled, disputed : bool, optional
        True for only parts that somebody has labelled, or labelled otherwise than the verdict; False for only the others.
    failed : bool or None, optional
        True for failures instead of parts, None for both.
    changed_since : str or datetime, optional
        Only documents changed since a date or within an age: ``2026-03-31``, ``12h``, ``7d``, ``4w``, ``1y``.
    sort : str, optional
        ``file``, ``label`` or a numeric column of the index, such as ``thinnest_mm`` or ``volume_ratio``.
    descending : bool, optional
    limit : int, optional
    report : callable, optional
        Called with the number of info files read and the total; may raise `Cancelled` to stop.

    Returns
    -------
    SearchResult
        A sequence of `FoundPart`; folders and files that could not be searched are in ``problems``.

    Raises
    ------
    ThinPartError
        kind ``usage`` if an argument is invalid, ``missing`` if none of the folders exists.

    Examples
    --------
    >>> [part.label for part in find(samples, category="thin")]
    ['plate']
    """
    # Build the query first, so that invalid arguments are rejected before folders are read.
    query = part_query(
        categories=_texts(category), criteria=tuple(map(str, _texts(criterion))), conditions=where, words=text,
        ranges={"thinnest_mm": thickness, "d1_mm": size, "volume_ratio": ratio}, has_notes=has_notes, said=_texts(said),
        labelled=labelled, disputed=disputed, borderline=borderline, failed=failed, changed_since=changed_since)
    with _opened(roots, report) as libraries:
        return libraries.find(query, sort, descending, limit)


def similar(part, roots, count=10, *, same_size=None, name=None, report=None):
    """Search folders of info files for parts similar to one, by their walls, fill and box.

    Parameters
    ----------
    part : ClassifiedPart, FoundPart, PartRecord, str or Path
        A file is measured if it has no info file beside it.
    roots : str, Path, or list of them
        See `find`.
    count : int, optional
        Greatest number of results.
    same_size : float, optional
        Factor, 1 or more, by which diagonals may differ; by default any size.
    name : str, optional
        Name or label of the part, if a file has several.
    report : callable, optional
        See `find`.

    Returns
    -------
    SearchResult
        Best first, each with its ``score`` and ``reasons``.

    Raises
    ------
    ThinPartError
        If the file cannot be read, the part is ambiguous, or none of the folders exists.

    Examples
    --------
    >>> [part.label for part in similar(record, samples, count=1)]
    ['plate']
    """
    record, own_key = reference_part(part, name)
    with _opened(roots, report) as libraries:
        return libraries.similar(record, count, same_size, own_key)


def duplicates(roots, *, reads_documents=True, jobs=None, timeout=600.0, memory=6144, control=None, report=None,
               cluster=None):
    """Find the parts that libraries have more than once: identical, mirrored, scaled, or alike but for something.

    Parameters
    ----------
    roots : str, Path, or list of them
        Folders with info files; see `find`.
    reads_documents : bool, optional
        Whether documents are read again, so that their geometry is the evidence; otherwise what their records keep of it.
    jobs : int, optional
        Number of worker processes; one per processor by default.
    timeout : float, optional
        Seconds for one document.
    memory : int, optional
        Megabytes of a worker.
    control : RunControl, optional
    report : callable, optional
        Called with the numbers of steps done and of all; may raise to stop.
    cluster : str, optional
        Address of a Dask scheduler, ``tcp://HOST:PORT``, whose workers read and compare the documents instead of processes
        on this machine; see docs/cluster.md.

    Returns
    -------
    DuplicateGroups
        The first part of each group is the one to keep: the most used, with notes, in a document that can be edited, with a
        name that somebody chose, the latest.

    Raises
    ------
    ThinPartError
        kind ``missing`` if none of the folders exists; ``usage`` or ``cluster`` if the cluster cannot be used.

    Examples
    --------
    >>> duplicates(samples, reads_documents=False).compared
    2
    """
    if cluster is not None:
        from .classification import cluster_address  # late: it imports what analyses files

        cluster = cluster_address(cluster)
    with _opened(roots, None) as libraries:
        limits = Limits(timeout, memory, jobs or os.cpu_count() or 1)
        return DuplicateGroups(find_duplicates(libraries.indexes, limits, reads_documents, control, report, cluster),
                               libraries.problems)


def families(roots, *, report=None):
    """Find the families of libraries: parts whose faces are of the same kinds and lie beside each other in the same way.

    Parameters
    ----------
    roots : str, Path, or list of them
        Folders with info files; see `find`.
    report : callable, optional
        See `find`.

    Returns
    -------
    FamilyList

    Raises
    ------
    ThinPartError
        kind ``missing`` if none of the folders exists.

    Examples
    --------
    >>> len(families(samples))
    0
    """
    with _opened(roots, report) as libraries:
        return FamilyList(find_families(libraries.indexes), libraries.problems)


def reference_part(part, name=None):
    """The record of the part that others are compared with.

    Parameters
    ----------
    part, name
        See `similar`.

    Returns
    -------
    record : PartRecord
    own_key : tuple of (str, str) or None
        Info file and name of the part itself, which the search leaves out.

    Examples
    --------
    >>> reference_part(plate)[0]["label"]
    'plate'
    """
    if isinstance(part, ClassifiedPart):
        return part.record, None
    if isinstance(part, FoundPart):
        return part.record(), (os.path.realpath(part.info_file), part.name)
    if isinstance(part, dict):
        fault = PART.fault(part, "the part")
        if fault:
            raise ThinPartError(f"This is not a part record: {fault}.", "usage")
        return part, None
    try:
        info_file = info_file_of(part)
    except ThinPartError:
        return select_record(_measured(part), name, part), None
    record = single_record(info_file, name)
    return record, (os.path.realpath(info_file), record["name"])


def _measured(path):
    from .classification import classify

    found = classify(path)
    if not found:
        raise found.failures[0].error()
    return [part.record for part in found]


def _opened(roots, report):
    roots = [roots] if isinstance(roots, (str, os.PathLike)) else list(roots)
    libraries = Libraries(roots, report)
    if not libraries.indexes and libraries.problems:
        libraries.close()
        raise ThinPartError(libraries.problems[0].message, "missing")
    return libraries


def _check(root):
    if os.path.isfile(root):
        raise ThinPartError(f"{root} is a file: name the folder of a library.", "usage")
    if not os.path.isdir(root):
        raise ThinPartError(f"There is no folder {root}.", "missing")


def _texts(values):
    return (values,) if isinstance(values, (str, int)) else tuple(values)

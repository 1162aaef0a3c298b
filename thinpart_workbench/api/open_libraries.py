"""Libraries that stay open: searched again and again without reading them, and refreshed in the background."""

import os
import time
from dataclasses import dataclass, field
from typing import Optional

import numpy as np

from ..storage.index.library_index import LibraryIndex
from ..storage.index.written_query import part_query
from ..workflow.library.library_refresh import LibraryRefresh
from ..workflow.library.part_columns import PartColumns
from ..workflow.library.similar_parts import similar_parts
from .found_parts import FoundPart

MOST_SIMILAR = 200
"""Parts that a search for similar ones finds at most."""


@dataclass
class LibraryState:
    """The state of an open library.

    Attributes
    ----------
    root : str
    problems : list of str
        Sentences of the last refresh.
    busy : bool
        Whether it is being refreshed, or waits for that.
    stopped : bool
        Whether the last refresh was stopped before its end.
    parts : int
        Parts and failures that are found at the moment.
    """

    root: str
    problems: list[str] = field(default_factory=list)
    busy: bool = True
    stopped: bool = False
    parts: int = 0


@dataclass(frozen=True)
class LibraryMatches:
    """What a search has found, and what it would find by another choice.

    Attributes
    ----------
    count : int
        Parts found; `OpenLibraries.rows` has them.
    matching : int
        Parts that match the query; more than `count` in a search for similar parts.
    total : int
        Parts and failures in all libraries.
    categories, criteria, flags : dict of str to int
        Parts by category, criterion and flag. Each count ignores the query's own filter on it, as do histograms.
    histograms : dict of str to list of int
        Parts by thickness, size and ratio, in logarithmic bins over `scales`.
    scales : dict of str to (float, float)
    """

    count: int
    matching: int
    total: int
    categories: dict[str, int]
    criteria: dict[str, int]
    flags: dict[str, int]
    histograms: dict[str, list[int]]
    scales: dict[str, tuple[float, float]]


class OpenLibraries:
    """Folders of info files whose indexes stay open, with the columns of all parts in memory.

    A library of 100,000 parts answers within milliseconds. Opening reads what its index had last time; a thread refreshes
    it meanwhile.

    Parameters
    ----------
    post : callable
        Called in that thread with a dict: ``ask`` is the name of a method (``progress``, ``grown`` or ``refreshed``), the
        rest its arguments. The owner calls `grown` and `refreshed` with them, in the thread in which it searches;
        ``progress`` (``root``, ``done``, ``total``) is for itself alone.
    """

    def __init__(self, post):
        self._refresh = LibraryRefresh(post)
        self._indexes: dict[str, LibraryIndex] = {}
        self._states: dict[str, LibraryState] = {}
        self._columns = PartColumns([])
        self._rows, self._similar = np.empty(0, np.int64), {}
        self._loaded, self._load_seconds = 0.0, 0.0

    def __contains__(self, root):
        return root in self._indexes

    @property
    def states(self):
        """list of LibraryState: a state per library."""
        return list(self._states.values())

    def open(self, roots):
        """Search these libraries from now on; those that are new are refreshed, others than these are closed.

        Parameters
        ----------
        roots : list of str
        """
        for root in roots:
            if root not in self._indexes:
                self._indexes[root] = LibraryIndex(root)
                self._states[root] = LibraryState(root)
                self._refresh.add(root)
        for root in set(self._indexes) - set(roots):
            self._indexes.pop(root).close()
            self._states.pop(root)
        self._indexes = {root: self._indexes[root] for root in roots}
        self._load()

    def refresh(self, roots=None):
        """Refresh libraries in the background, all of them by default."""
        for root in roots or self._indexes:
            self._states[root].busy = True
            self._refresh.add(root)

    def stop(self):
        """Stop refreshing; what was read so far is kept."""
        self._refresh.stop()

    def grown(self, root):
        """Take over what a refresh has added to the index so far.

        Returns
        -------
        bool
            Whether it was taken over: not if that would leave the refresh too little time.
        """
        # Loading takes longer the larger the library is; this leaves most of the time to the refresh.
        if root not in self._indexes or time.monotonic() - self._loaded <= 10.0 * self._load_seconds:
            return False
        self._load()
        return True

    def refreshed(self, root, index, problems, stopped):
        """Take over the result of a refresh.

        Parameters
        ----------
        root, index, problems, stopped
            As they were posted.

        Returns
        -------
        bool
            Whether it was taken over: not if the library was closed meanwhile.
        """
        if root not in self._indexes:
            return False
        if index is not None and index.warning:
            self._indexes[root] = index  # the index is in memory: only this object has its content
        self._states[root] = LibraryState(root, problems, False, stopped)
        self._load()
        return True

    def find(self, conditions=(), *, sort="file", descending=False, like=None, excluding=None, same_size=None,
             failed=None, **fields):
        """Find the parts that match a query; `rows` has them.

        Parameters
        ----------
        conditions : str, or iterable of str or SearchCondition, optional
            As ``where`` of `find`.
        sort : str, optional
            One of `part_columns.SORTABLE`, or ``score`` for the most similar first.
        descending : bool, optional
        like : PartRecord, optional
            Only the parts most similar to this one, `MOST_SIMILAR` of those that match.
        excluding : tuple of (str, str), optional
            Info file and name of that part itself, which is left out.
        same_size : float, optional
            Factor, 1 or more, by which its diagonal may differ.
        failed : bool or None, optional
            True for only failures, False for only parts.
        fields
            Other fields of a `PartQuery`.

        Returns
        -------
        LibraryMatches

        Raises
        ------
        ThinPartError
            kind ``usage`` if a condition or a date cannot be parsed.
        """
        selection = self._columns.select(part_query(conditions, failed=failed, **fields))
        rows, self._similar = selection.rows, {}
        if like is not None:
            rows = self._most_similar(rows, like, excluding, same_size)
        if sort != "score":
            rows = self._columns.sorted(rows, sort, descending)
        self._rows = rows
        return LibraryMatches(
            len(rows), len(selection.rows), len(self._columns), selection.categories, selection.criteria, selection.flags,
            selection.histograms, self._columns.scales)

    def rows(self, start, end):
        """Parts of the last search in their order, list of FoundPart; None for those that are gone since."""
        rows = self._rows[start:end]
        return [self._found_part(part, self._similar.get(row))
                for part, row in zip(self._columns.parts(rows), rows.tolist())]

    def position_of(self, root, info_file, name):
        """Where a part is in the last search.

        Parameters
        ----------
        root, info_file, name : str

        Returns
        -------
        int or None
            None if it is not there.
        """
        index = self._indexes.get(root)
        if index is None:
            return None
        ids = index.query(
            "SELECT parts.id FROM parts JOIN files ON files.id = parts.file WHERE path = ? AND name IS ?",
            (os.fsencode(os.path.relpath(info_file, index.root)), name))
        rows = self._columns.rows_of(list(self._indexes).index(root), [number for number, in ids])
        positions = np.flatnonzero(np.isin(self._rows, rows))
        return int(positions[0]) if len(positions) else None

    def root_of(self, part: FoundPart):
        """str: the library of a part, as it was opened."""
        return {index.root: root for root, index in self._indexes.items()}[part.stored.root]

    def _load(self):
        started = time.monotonic()
        self._columns = PartColumns(self._indexes.values())
        self._rows, self._similar = np.empty(0, np.int64), {}
        counts = dict(zip(self._indexes, self._columns.counts))
        for root, state in self._states.items():
            state.parts = counts.get(root, 0)
        self._loaded = time.monotonic()
        self._load_seconds = self._loaded - started

    def _most_similar(self, rows, record, excluding, same_size):
        indexes = list(self._indexes.values())
        found = similar_parts(indexes, record, MOST_SIMILAR, same_size, excluding, self._columns.ids_by_index(rows))
        positions = {index.root: position for position, index in enumerate(indexes)}
        rows = [int(self._columns.rows_of(positions[match.part.root], [match.part.id])[0]) for match in found]
        self._similar = {row: match for row, match in zip(rows, found) if row >= 0}
        return np.array(list(self._similar), dtype=np.int64)

    @staticmethod
    def _found_part(part, similar) -> Optional[FoundPart]:
        if part is None:
            return None
        return FoundPart(part) if similar is None else FoundPart(*similar)

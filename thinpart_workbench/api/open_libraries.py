# SPDX-License-Identifier: LGPL-2.1-or-later
"""Libraries that stay open: searched again and again without reading them, and refreshed in the background."""

import os
from dataclasses import dataclass, field
from typing import Optional

from ..storage.index.library_index import LibraryIndex
from ..storage.index.written_query import part_query
from ..workflow.library.judged_otherwise import JudgedOtherwise, judged_otherwise
from ..workflow.library.library_refresh import LibraryRefresh
from ..workflow.library.library_search import ChoiceCounts, LibrarySearch
from ..workflow.library.similar_parts import SimilarPart, similar_parts
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
    judged_otherwise : list of JudgedOtherwise
        Shipped profiles that had other thresholds when they judged info files of it.
    """

    root: str
    problems: list[str] = field(default_factory=list)
    busy: bool = True
    stopped: bool = False
    parts: int = 0
    judged_otherwise: list[JudgedOtherwise] = field(default_factory=list)


@dataclass(frozen=True)
class LibraryMatches:
    """What a search has found, and what it would find by another choice.

    Attributes
    ----------
    count : int
        Parts found; `OpenLibraries.rows` has them. Fewer than match the query in a search for similar parts.
    total : int
        Parts and failures in all libraries.
    choices : ChoiceCounts
    """

    count: int
    total: int
    choices: ChoiceCounts


class OpenLibraries:
    """Folders of info files whose indexes stay open.

    A library of 100,000 parts answers in a fifth of a second. At first it has what its index had last time; a thread
    refreshes it meanwhile.

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
        self._similar: dict[tuple[str, int], SimilarPart] = {}
        self._load()

    def __contains__(self, root):
        return root in self._indexes

    @property
    def states(self):
        """list of LibraryState: a state per library."""
        return list(self._states.values())

    def open(self, roots):
        """Search these libraries from now on, a list of str; new ones are refreshed, others than these are closed."""
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
        """Take over what a refresh has added to the index so far: whether the library is still open."""
        if root in self._indexes:
            self._load()
        return root in self._indexes

    def refreshed(self, root, index, problems, stopped):
        """Take over the result of a refresh, as it was posted: whether the library is still open."""
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
            One of `written_query.SORTABLE`, or ``score`` for the most similar first.
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
        query = part_query(conditions, failed=failed, **fields)
        choices = self._search.counts(query)
        by_score, self._similar, among = sort == "score", {}, None
        if like is not None:
            among = self._most_similar(query, like, excluding, same_size)
        self._found = self._search.find(query, "file" if by_score else sort, descending, among)
        self._by_score = by_score and like is not None
        count = choices.count if like is None else len(self._similar)
        return LibraryMatches(count, sum(state.parts for state in self._states.values()), choices)

    def rows(self, start, end):
        """Parts of the last search in their order, list of FoundPart; None for those that are gone since."""
        if self._by_score:
            return [FoundPart(*match) for match in list(self._similar.values())[start:end]]
        return [self._found_part(part) for part in self._found.parts(start, end)]

    def position_of(self, root, info_file, name):
        """Where a part is in the last search: int; None if it is not there."""
        index = self._indexes.get(root)
        if index is None:
            return None
        ids = [number for number, in index.query(
            "SELECT parts.id FROM parts JOIN files ON files.id = parts.file WHERE path = ? AND name IS ?",
            (os.fsencode(os.path.relpath(info_file, index.root)), name))]
        if self._by_score:
            return next((row for row, key in enumerate(self._similar) if key[0] == index.root and key[1] in ids), None)
        return self._found.row_of(index, ids)

    def root_of(self, part: FoundPart):
        """str: the library of a part, as it was opened."""
        return {index.root: root for root, index in self._indexes.items()}[part.stored.root]

    def _load(self):
        self._search = LibrarySearch(self._indexes.values())
        self._found, self._similar, self._by_score = self._search.find(part_query()), {}, False
        for root, state in self._states.items():
            state.parts = self._search.total(self._indexes[root])
            state.judged_otherwise = judged_otherwise(self._indexes[root])

    def _most_similar(self, query, record, excluding, same_size):
        """Find the parts most similar to a record; returns their ids by index."""
        indexes = self._search.indexes
        found = similar_parts(indexes, record, MOST_SIMILAR, same_size, excluding, self._search.find(query).ids_by_index())
        self._similar = {(match.part.root, match.part.id): match for match in found}
        return [[number for root, number in self._similar if root == index.root] for index in indexes]

    def _found_part(self, part) -> Optional[FoundPart]:
        if part is None:
            return None
        return FoundPart(*self._similar.get((part.root, part.id), (part,)))

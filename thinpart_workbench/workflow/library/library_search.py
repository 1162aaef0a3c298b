# SPDX-License-Identifier: LGPL-2.1-or-later
"""Search in several libraries: their parts in one common order, and how many there are for each choice of a filter."""

import os
from collections import Counter
from dataclasses import dataclass

import numpy as np

from ...core.categories import NORMAL
from ...core.errors import ThinPartError
from ...storage.index.part_query import FAILED, FLAGS, joined_terms
from ...storage.index.stored_part import StoredPart
from ...storage.index.written_query import SORTABLE
from .find_parts import stored_parts

HISTOGRAM_BINS = 48

SHOWN_RANGES = ("thinnest_mm", "d1_mm", "volume_ratio")
"""Columns that always have a histogram; others have one where a query names them."""

_FIRST = ("thin", "thin_features", NORMAL)
_ORDERS = {
    "file": "files.words", "label": "lower(label)",
    "category": "CASE WHEN category IN ('thin') THEN '0' WHEN category IN ('thin_features') THEN '1' "
                "WHEN category IN ('normal') THEN '2' ELSE '3' || category END",
}
"""SQL by which some columns are sorted; the others are sorted by their value."""

_SLOW = ("words", "conditions", "passes", "fails")
"""Filters of which the matching parts are kept for the next query: they read texts or distributions."""

_ALONE, _MORE = 1000, 2000
"""Codes of the parts that fail the first filter alone, and several; 0 is for those that match."""

_MOST_VERDICTS = 0xD000
"""Codes of verdicts below those that are no characters."""


@dataclass(frozen=True)
class ChoiceCounts:
    """How many parts there are for each choice; each count ignores the query's own filter on that column.

    Attributes
    ----------
    count : int
        Parts that match the query.
    categories, criteria, flags : dict of str to int
        Parts by category, criterion and flag.
    histograms : dict of str to list of int
        By column, in `HISTOGRAM_BINS` over its scale.
    scales : dict of str to (float, float)
        Least and greatest positive value of each of these columns, over all parts; (1, 1) if there is none.
    """

    count: int
    categories: dict[str, int]
    criteria: dict[str, int]
    flags: dict[str, int]
    histograms: dict[str, list[int]]
    scales: dict[str, tuple[float, float]]


class LibrarySearch:
    """Searches refreshed indexes; a part that two of them have is found in the innermost.

    One scan of a table answers for all choices. It takes about a microsecond per part; so no counts or orders are kept,
    except which parts match the filters that read texts and distributions.

    Parameters
    ----------
    indexes : iterable of LibraryIndex
        They stay open, and are not refreshed meanwhile by themselves; another process or thread may do so.

    Attributes
    ----------
    indexes : list of LibraryIndex
    """

    def __init__(self, indexes):
        self.indexes = list({index.root: index for index in indexes}.values())
        self._slow: dict = {}
        self._scales: dict = {}

    def total(self, index):
        """Number of parts and failures of an index."""
        (count,), = index.query("SELECT count(*) FROM parts")
        return count

    def find(self, query, sort="file", descending=False, among=None):
        """The parts that match a query: OrderedParts.

        Raises ThinPartError, kind ``usage`` if parts cannot be sorted by `sort`, or not be searched so.

        Parameters
        ----------
        query : PartQuery
        sort : str
            One of `SORTABLE`; parts without a value come last in both directions.
        descending : bool
        among : list of list of int, optional
            Ids by index: only these parts.
        """
        if sort not in SORTABLE:
            raise ThinPartError(f"Parts are not sorted by {sort!r}: there are {', '.join(SORTABLE)}.", "usage")
        terms = [list(self._terms(index, query).values()) for index in self.indexes]
        for own, ids in zip(terms, among or ()):
            own.append((f"parts.id IN ({', '.join('?' * len(ids))})", list(ids)))
        return OrderedParts(self.indexes, [joined_terms(own) for own in terms], _ORDERS.get(sort, sort), descending)

    def counts(self, query):
        """Count the parts for each choice: ChoiceCounts.

        Parameters
        ----------
        query : PartQuery
            Columns of its ``ranges`` have a histogram too, also without bounds.
        """
        columns = tuple(dict.fromkeys((*SHOWN_RANGES, *(column for column, *_ in query.ranges))))
        scales = {column: self._scale(column) for column in columns}
        categories: Counter[str] = Counter(dict.fromkeys(_FIRST, 0))
        criteria: Counter[str] = Counter()
        flags: Counter[str] = Counter(dict.fromkeys(FLAGS, 0))
        histograms = {column: np.zeros(HISTOGRAM_BINS + 1, np.int64) for column in columns}
        count = 0
        for index in self.indexes:
            terms = self._terms(index, query)
            own = {name: terms.pop(name) for name in ("categories", "criteria", *FLAGS, *columns) if name in terms}
            codes = _codes(index, own, terms, {column: _bin(column, *scales[column]) for column in columns})
            matches = codes[:, 0] == 0
            # The rows that match without the filter of a name.
            rows = {name: codes[matches | (codes[:, 0] == _ALONE + position)] for position, name in enumerate(own)}
            rows = {name: rows.get(name, codes[matches]) for name in ("categories", "criteria", *FLAGS, *columns)}
            count += int(np.count_nonzero(matches))
            verdicts = {code: names for code, *names in index.query("SELECT id, category, criteria FROM verdicts")}
            by_category, by_criterion = (np.bincount(rows[name][:, 1], minlength=max(verdicts, default=0) + 1)
                                         for name in ("categories", "criteria"))
            categories[FAILED] += int(by_category[0])
            for code, (category, held) in verdicts.items():
                if code < _MOST_VERDICTS:
                    categories[category] += int(by_category[code])
                    for name in filter(None, held.split(",")):
                        criteria[name] += int(by_criterion[code])
            for bit, name in enumerate(FLAGS):
                flags[name] += int(np.count_nonzero(rows[name][:, 2] & 1 << bit))
            for place, column in enumerate(columns, 3):
                histograms[column] += np.bincount(rows[column][:, place], minlength=HISTOGRAM_BINS + 1)
        others = sorted(set(categories) - {*_FIRST, FAILED})
        return ChoiceCounts(
            count, {name: categories[name] for name in (*_FIRST, *others, FAILED)},
            {name: criteria[name] for name in sorted(criteria, key=lambda name: (len(name), name))}, dict(flags),
            {column: counts[1:].tolist() for column, counts in histograms.items()}, scales)

    def _terms(self, index, query):
        """Terms of a query for an index, with its slow ones as one that only looks up what they have found."""
        terms = query.terms()
        slow = {name: terms.pop(name) for name in _SLOW if name in terms}
        for number, other in enumerate(self.indexes):
            if other.root.startswith(index.root.rstrip("/") + "/"):
                inner = other.relative_to(index)
                terms[f"outside {number}"] = "NOT (files.path >= ? AND files.path < ?)", [inner + b"/", inner + b"0"]
        if slow:
            condition, values = joined_terms(slow.values())
            if self._slow.get(index) != (condition, values):
                index.keep_ids(f"SELECT parts.id FROM {_tables(condition)} WHERE {condition}", values)
                self._slow[index] = condition, values
            terms["kept"] = "parts.id IN kept_ids", []
        return terms

    def _scale(self, column):
        if column not in self._scales:
            positive = f"CASE WHEN {column} > 0 AND {column} <= 1e300 THEN {column} END"
            found = [bound for index in self.indexes
                     for bound in index.query(f"SELECT min({positive}), max({positive}) FROM parts")[0] if bound is not None]
            self._scales[column] = (min(found), max(found)) if found else (1.0, 1.0)
        return self._scales[column]


class OrderedParts:
    """Found parts in one order; only those that are looked at are read.

    Parameters
    ----------
    indexes : list of LibraryIndex
    conditions : list of (str, list)
        For each index in SQL, with its values.
    key : str
        SQL by which they are ordered, before their paths.
    descending : bool
    """

    def __init__(self, indexes, conditions, key, descending):
        self._indexes, self._conditions = indexes, conditions
        self._key, self._descending = key, descending
        self._all = None

    def __len__(self):
        return len(self._places())

    def parts(self, start, end):
        """Parts in a range of rows, None for those that are gone since: list of StoredPart or None."""
        places = self._places(end)[start:end]
        found: dict[tuple[int, int], StoredPart] = {}
        for position, index in enumerate(self._indexes):
            ids = [number for place, number in places if place == position]
            found.update(((position, part.id), part) for part in stored_parts(index, ids))
        return [found.get(place) for place in places]

    def row_of(self, index, ids):
        """The first row with one of some ids of an index; None if there is none."""
        if index not in self._indexes:
            return None
        position = self._indexes.index(index)
        condition, values = self._conditions[position]
        marks = ", ".join("?" * len(ids))
        if not index.query(f"SELECT 1 FROM {_tables(condition)} WHERE {condition} AND parts.id IN ({marks})",
                           [*values, *ids]):
            return None
        wanted = {(position, number) for number in ids}
        return next((row for row, place in enumerate(self._places()) if place in wanted), None)

    def ids_by_index(self):
        """Ids of all of them, a list for each index."""
        ids: list[list[int]] = [[] for _ in self._indexes]
        for position, number in self._places():
            ids[position].append(number)
        return ids

    def _places(self, most=None):
        """Position of the index and id of the first rows, or of all."""
        if self._all is not None:
            return self._all
        direction = " DESC" if self._descending else ""
        rows = []
        for position, (index, (condition, values)) in enumerate(zip(self._indexes, self._conditions)):
            limit = "" if most is None else f" LIMIT {int(most)}"
            rows += [(position, *row) for row in index.query(
                f"SELECT parts.id, {self._key} AS sorted, files.path FROM parts JOIN files ON files.id = parts.file "
                f"WHERE {condition} ORDER BY sorted IS NULL, sorted{direction}, files.path, parts.id{limit}", values)]
        if len(self._indexes) > 1:
            roots = [index.root for index in self._indexes]
            rows.sort(key=lambda row: os.path.join(os.fsencode(roots[row[0]]), row[3]))
            rows.sort(key=lambda row: ((row[2] is None) != self._descending, 0 if row[2] is None else
                                       os.path.join(roots[row[0]].casefold(), row[2]) if self._key == "files.words" else
                                       row[2]), reverse=self._descending)
        places = [row[:2] for row in rows]
        if most is None:
            self._all = places
        return places


def _tables(condition):
    return "parts JOIN files ON files.id = parts.file" if "files." in condition else "parts"


def _codes(index, own, others, bins):
    """What a scan finds, as a row of whole numbers for each part: ndarray of uint32, shape (n, 3 + histograms).

    Which of `own` the part fails, its verdict, its flags, its bins; 0 where it has none.

    Parameters
    ----------
    index : LibraryIndex
    own, others : dict of str to (str, list)
        Terms of a query: those that parts may fail alone, and those that all must meet.
    bins : dict of str to str
        SQL for the bin of a part in the histogram of each column.
    """
    fails = " + ".join(f"({sql} IS NOT TRUE) * {_ALONE + position}" for position, (sql, _) in enumerate(own.values())) or "0"
    flags = " + ".join(f"(({sql}) IS TRUE) * {1 << bit}" for bit, sql in enumerate(FLAGS.values()))
    columns = [f"min({_MORE}, {fails})", f"min({_MOST_VERDICTS}, verdict)", flags, *bins.values()]
    condition, values = joined_terms(others.values())
    # One text of all codes: a row in Python for each part would take most of the time.
    (text,), = index.query(f"SELECT group_concat(char({', '.join(columns)}), '') FROM {_tables(fails + condition)} "
                           f"WHERE {condition}", [value for _, each in own.values() for value in each] + values)
    return np.frombuffer((text or "").encode("utf-32-le"), np.uint32).reshape(-1, len(columns))


def _bin(column, low, high):
    """SQL for the bin of a value on a logarithmic scale, from 1 on; 0 if there is none."""
    edges = [low * (high / low) ** (number / HISTOGRAM_BINS) for number in range(HISTOGRAM_BINS)]

    def between(first, last):
        if last - first == 1:
            return str(first + 1)
        middle = (first + last) // 2
        return f"CASE WHEN {column} < {edges[middle]!r} THEN {between(first, middle)} ELSE {between(middle, last)} END"

    return f"CASE WHEN {column} <= 1e300 THEN {between(0, HISTOGRAM_BINS)} ELSE 0 END"

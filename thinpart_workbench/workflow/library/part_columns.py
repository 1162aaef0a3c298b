"""Arrays in memory with the columns of all parts of some libraries, for filtering, counting and sorting."""

import os
from collections import namedtuple

import numpy as np

from ...storage.index.part_query import DISPUTED, FAILED, LABELLED, PartQuery
from ...storage.index.stored_part import StoredPart
from .find_parts import FoundParts, find_parts

HISTOGRAM_BINS = 48

RANGES = {"thinnest_mm": ("least_thickness", "most_thickness"), "d1_mm": ("least_size", "most_size"),
          "volume_ratio": ("least_ratio", "most_ratio")}
"""Columns with a range filter, and the fields of a query with its bounds."""

_OF_INDEX = ("words", "conditions", "passes", "fails", "said")
"""Fields of a query that only the index can answer."""

FLAGS = ("borderline", "has_notes", "labelled", "disputed")
TEXTS = ("label", "file")
SORTABLE = (*TEXTS, "category", *RANGES)

_FIRST = ("thin", "thin_features", "normal")
_SELECT = (f"SELECT parts.id, files.path, label, category, criteria, borderline, "
           f"notes != '' OR mesh IS NOT NULL OR link IS NOT NULL, {LABELLED}, {DISPUTED}, files.modified, "
           f"{', '.join(RANGES)} FROM parts JOIN files ON files.id = parts.file "
           "ORDER BY files.path, parts.id")

Selection = namedtuple("Selection", "rows categories criteria flags histograms")
"""Numbers of the rows that match a query, ndarray of int64; and counts of parts by category, by criterion, by flag,
and in `HISTOGRAM_BINS` over the `scales` of each range. Each count ignores the query's own filter on that column."""


class PartColumns:
    """Columns of all parts and failures of some libraries.

    Parameters
    ----------
    indexes : list of LibraryIndex

    Attributes
    ----------
    indexes : list of LibraryIndex
    scales : dict of str to (float, float)
        Least and greatest positive value of each of `RANGES`; (1, 1) if there is none.

    Notes
    -----
    `select` finds the same parts as `find_parts`, faster if only a part of the query has changed. Conditions
    on texts and distributions are evaluated by the index and cached for the next query.
    """

    def __init__(self, indexes):
        self.indexes = list(indexes)
        found = [index.query(_SELECT) for index in self.indexes]
        self._starts = np.cumsum([0, *map(len, found)])
        rows = [row for table in found for row in table]
        ids, paths, labels, categories, criteria, borderline, annotated, labelled, disputed, modified, *numbers = (
            zip(*rows) if rows else [()] * (10 + len(RANGES)))
        self._ids = np.array(ids, dtype=np.int64)
        self._texts = {"label": [label or "" for label in labels], "file": list(map(os.fsdecode, paths))}
        self._ranks = {}
        self._set_categories([category or FAILED for category in categories])
        self._set_criteria(criteria)
        self._flags = {name: np.array([bool(flag) for flag in flags], dtype=bool)
                       for name, flags in zip(FLAGS, (borderline, annotated, labelled, disputed))}
        self._modified = np.array([time or "" for time in modified], dtype="U32")
        self._numbers = {name: np.array(values, dtype=float) for name, values in zip(RANGES, numbers)}
        self.scales = {name: _scale(values) for name, values in self._numbers.items()}
        self._bins = {name: _bins(values, self.scales[name]) for name, values in self._numbers.items()}
        self._cached_index_mask: tuple = (None, None)

    def __len__(self):
        return len(self._ids)

    @property
    def counts(self):
        """list of int: number of rows of each of `indexes`."""
        return np.diff(self._starts).tolist()

    def select(self, query):
        """Rows that match a query, and counts.

        Parameters
        ----------
        query : PartQuery

        Returns
        -------
        Selection
        """
        masks = self._masks(query)
        failing = np.zeros(len(self), dtype=np.int16)
        for mask in masks.values():
            failing += ~mask

        def without(name):
            """Mask of the rows that match the query without its filter `name`."""
            if name not in masks:
                return failing == 0
            return failing == ~masks[name]

        categories = np.bincount(self._category[without("categories")], minlength=len(self.categories))
        sets = np.bincount(self._criteria_set[without("criteria")], minlength=len(self._criteria_sets))
        return Selection(
            np.flatnonzero(failing == 0),
            dict(zip(self.categories, categories.tolist())),
            dict(zip(self.criteria, (sets @ self._criteria_sets).tolist())),
            {name: int(np.count_nonzero(flag & without(name))) for name, flag in self._flags.items()},
            {name: self._histogram(name, without(name)) for name in RANGES},
        )

    def sorted(self, rows, column, descending=False):
        """Sorted row numbers; rows without a value come last in both directions.

        Parameters
        ----------
        rows : ndarray of int64
        column : str
            One of `SORTABLE`.
        descending : bool

        Returns
        -------
        ndarray of int64
        """
        keys = self._keys(column)[rows]
        return rows[np.argsort(-keys if descending else keys, kind="stable")]

    def ids_by_index(self, rows):
        """Ids of rows, an ndarray for each of `indexes`."""
        libraries = np.searchsorted(self._starts, rows, side="right") - 1
        return [self._ids[rows[libraries == position]] for position in range(len(self.indexes))]

    def rows_of(self, position, ids):
        """Row numbers of ids of an index, -1 for ids without a row.

        Parameters
        ----------
        position : int
            Position of the index in `indexes`.
        ids : array of int64

        Returns
        -------
        ndarray of int64
        """
        start, end = self._starts[position:position + 2]
        own = self._ids[start:end]
        if not len(own):
            return np.full(len(ids), -1, dtype=np.int64)
        order = np.argsort(own)
        rows = order[np.minimum(np.searchsorted(own, ids, sorter=order), len(own) - 1)]
        return np.where(own[rows] == ids, rows + start, -1)

    def parts(self, rows):
        """Parts of rows, None for parts that have been removed from the index since.

        Parameters
        ----------
        rows : ndarray of int64

        Returns
        -------
        list of StoredPart or None
        """
        found: dict[tuple[int, int], StoredPart] = {}
        for position, (index, ids) in enumerate(zip(self.indexes, self.ids_by_index(rows))):
            found.update(((position, part.id), part) for part in FoundParts(index, ids.tolist()))
        libraries = np.searchsorted(self._starts, rows, side="right") - 1
        return [found.get(key) for key in zip(libraries.tolist(), self._ids[rows].tolist())]

    def _masks(self, query):
        """Masks of the filters of a query that are set, ndarrays of bool by name."""
        masks = {}
        if query.categories:
            selected = np.array([name in query.categories for name in self.categories], dtype=bool)
            masks["categories"] = selected[self._category]
        if query.criteria:
            selected = np.array([name in query.criteria for name in self.criteria], dtype=bool)
            masks["criteria"] = (self._criteria_sets & selected).any(axis=1)[self._criteria_set]
        failed = self._category == self.categories.index(FAILED)
        for name in FLAGS:
            selected = getattr(query, name)
            if selected is not None:
                # The flags of a failure are unknown.
                masks[name] = (self._flags[name] == selected) & ~failed
        if query.failed is not None:
            masks["failed"] = failed == query.failed
        for name, (least, most) in RANGES.items():
            least, most = getattr(query, least), getattr(query, most)
            if least is not None or most is not None:
                values = self._numbers[name]
                masks[name] = (values >= (-np.inf if least is None else least)) & (
                    values <= (np.inf if most is None else most))
        if query.changed_since is not None:
            masks["changed_since"] = self._modified >= query.changed_since.isoformat()
        of_index = {name: getattr(query, name) for name in _OF_INDEX}
        if query.words.split() or any(value for name, value in of_index.items() if name != "words"):
            masks["index"] = self._index_mask(of_index)
        return masks

    def _index_mask(self, of_index):
        if self._cached_index_mask[0] != of_index:
            mask = np.zeros(len(self), dtype=bool)
            query = PartQuery(failed=None, **of_index)
            for position, index in enumerate(self.indexes):
                rows = self.rows_of(position, np.array(find_parts(index, query, "").ids, dtype=np.int64))
                mask[rows[rows >= 0]] = True
            self._cached_index_mask = of_index, mask
        return self._cached_index_mask[1]

    def _histogram(self, name, mask):
        return np.bincount(self._bins[name][mask] + 1, minlength=HISTOGRAM_BINS + 1)[1:].tolist()

    def _keys(self, column):
        if column == "category":
            return self._category
        if column in self._numbers:
            return self._numbers[column]
        if column not in self._ranks:
            texts = [text.casefold() for text in self._texts[column]]
            ranks = {text: position for position, text in enumerate(sorted(set(texts)))}
            self._ranks[column] = np.array([ranks[text] for text in texts], dtype=np.int64)
        return self._ranks[column]

    def _set_categories(self, names):
        others = sorted(set(names) - {*_FIRST, FAILED})
        self.categories = (*_FIRST, *others, FAILED)
        codes = {name: code for code, name in enumerate(self.categories)}
        self._category = np.array([codes[name] for name in names], dtype=np.int16)

    def _set_criteria(self, texts):
        distinct = {text: code for code, text in enumerate(dict.fromkeys(texts))}
        sets = [set((text or "").strip(",").split(",")) - {""} for text in distinct]
        self.criteria = tuple(sorted(set().union(*sets), key=lambda name: (len(name), name)))
        self._criteria_sets = np.array(
            [[name in names for name in self.criteria] for names in sets], dtype=bool,
        ).reshape(len(sets), len(self.criteria))
        self._criteria_set = np.array([distinct[text] for text in texts], dtype=np.int64)


def _scale(values):
    positive = values[values > 0.0]
    return (float(positive.min()), float(positive.max())) if len(positive) else (1.0, 1.0)


def _bins(values, scale):
    """Bin of each value on a logarithmic scale, -1 if there is no value."""
    low, high = scale
    known = np.isfinite(values)
    span = np.log(high / low) or 1.0
    position = np.log(np.maximum(np.where(known, values, low), low) / low) / span
    return np.where(known, np.minimum((position * HISTOGRAM_BINS).astype(np.int64), HISTOGRAM_BINS - 1), -1)

"""What is filtered, counted and sorted by of all parts of some libraries, as arrays in memory."""

import os
from collections import namedtuple

import numpy as np

from ..storage.part_query import FAILED, PartQuery
from .find_parts import FoundParts, find_parts

HISTOGRAM_BINS = 48

RANGES = {"thinnest_mm": ("least_thickness", "most_thickness"), "d1_mm": ("least_size", "most_size"),
          "volume_ratio": ("least_ratio", "most_ratio")}
"""Columns that ranges are chosen of, and the fields of a query that bound them."""

FLAGS = ("borderline", "has_notes")
TEXTS = ("label", "file")
SORTABLE = (*TEXTS, "category", *RANGES)

_FIRST = ("thin", "thin_features", "normal")
_SELECT = (f"SELECT parts.id, files.path, label, category, criteria, borderline, "
           "notes != '' OR mesh IS NOT NULL OR link IS NOT NULL, files.modified, "
           f"{', '.join(RANGES)} FROM parts JOIN files ON files.id = parts.file "
           "ORDER BY files.path, parts.id")

Selection = namedtuple("Selection", "rows categories criteria flags histograms")
"""Row numbers that fulfil a query, ndarray of int64; and what would be found if the query left out what is
counted: parts by category, by criterion, by flag, and in `HISTOGRAM_BINS` of each range's `scales`."""


class PartColumns:
    """Columns of all parts and failures of some libraries.

    Parameters
    ----------
    indexes : list of LibraryIndex

    Attributes
    ----------
    indexes : list of LibraryIndex
    scales : dict of str to (float, float)
        Least and greatest value above 0 of each of `RANGES`; (1, 1) where there is none.

    Notes
    -----
    `select` gives what `find_parts` gives, quicker where only a part of the query has changed. What
    takes texts or distributions is left to the index, and remembered for the next query.
    """

    def __init__(self, indexes):
        self.indexes = list(indexes)
        found = [index.query(_SELECT) for index in self.indexes]
        self._starts = np.cumsum([0, *map(len, found)])
        rows = [row for each in found for row in each]
        ids, paths, labels, categories, criteria, borderline, kept, modified, *numbers = (
            zip(*rows) if rows else [()] * (8 + len(RANGES)))
        self._ids = np.array(ids, dtype=np.int64)
        self._texts = {"label": [each or "" for each in labels], "file": list(map(os.fsdecode, paths))}
        self._ranks = {}
        self._set_categories([each or FAILED for each in categories])
        self._set_criteria(criteria)
        self._flags = {"borderline": np.array([bool(each) for each in borderline], dtype=bool),
                       "has_notes": np.array([bool(each) for each in kept], dtype=bool)}
        self._modified = np.array([each or "" for each in modified], dtype="U32")
        self._numbers = {name: np.array(values, dtype=float) for name, values in zip(RANGES, numbers)}
        self.scales = {name: _scale(values) for name, values in self._numbers.items()}
        self._bins = {name: _bins(values, self.scales[name]) for name, values in self._numbers.items()}
        self._by_index = None, None

    def __len__(self):
        return len(self._ids)

    @property
    def counts(self):
        """list of int: rows of each of `indexes`."""
        return np.diff(self._starts).tolist()

    def select(self, query):
        """Rows that fulfil a query, and counts.

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
            """Rows that fulfil all but one part of the query."""
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
        """Row numbers in another order; what has no value comes last either way.

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
        """Ids of some rows, an ndarray for each of `indexes`."""
        library = np.searchsorted(self._starts, rows, side="right") - 1
        return [self._ids[rows[library == place]] for place in range(len(self.indexes))]

    def rows_of(self, place, ids):
        """Row numbers of ids of an index, -1 for those that are not here.

        Parameters
        ----------
        place : int
            Of the index in `indexes`.
        ids : array of int64

        Returns
        -------
        ndarray of int64
        """
        start, end = self._starts[place:place + 2]
        own = self._ids[start:end]
        if not len(own):
            return np.full(len(ids), -1, dtype=np.int64)
        order = np.argsort(own)
        at = order[np.minimum(np.searchsorted(own, ids, sorter=order), len(own) - 1)]
        return np.where(own[at] == ids, at + start, -1)

    def parts(self, rows):
        """Parts of some rows, None for those that have gone from the index since.

        Parameters
        ----------
        rows : ndarray of int64

        Returns
        -------
        list of StoredPart or None
        """
        found = {}
        for place, (index, ids) in enumerate(zip(self.indexes, self.ids_by_index(rows))):
            found.update(((place, part.id), part) for part in FoundParts(index, ids.tolist()))
        library = np.searchsorted(self._starts, rows, side="right") - 1
        return [found.get(key) for key in zip(library.tolist(), self._ids[rows].tolist())]

    def _masks(self, query):
        """Arrays of bool by the names of those parts of the query that exclude something."""
        masks = {}
        if query.categories:
            wanted = [name in query.categories for name in self.categories]
            masks["categories"] = np.array(wanted, dtype=bool)[self._category]
        if query.criteria:
            wanted = np.array([name in query.criteria for name in self.criteria], dtype=bool)
            masks["criteria"] = (self._criteria_sets & wanted).any(axis=1)[self._criteria_set]
        failed = self._category == self.categories.index(FAILED)
        for name in FLAGS:
            wanted = getattr(query, name)
            if wanted is not None:
                # Of a failure nothing is known.
                masks[name] = (self._flags[name] == wanted) & ~failed
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
        if query.words.split() or query.conditions:
            masks["index"] = self._asked_index(query.words, query.conditions)
        return masks

    def _asked_index(self, words, conditions):
        if self._by_index[0] != (words, conditions):
            mask = np.zeros(len(self), dtype=bool)
            query = PartQuery(words=words, conditions=conditions, failed=None)
            for place, index in enumerate(self.indexes):
                rows = self.rows_of(place, np.array(find_parts(index, query, "").ids, dtype=np.int64))
                mask[rows[rows >= 0]] = True
            self._by_index = (words, conditions), mask
        return self._by_index[1]

    def _histogram(self, name, mask):
        return np.bincount(self._bins[name][mask] + 1, minlength=HISTOGRAM_BINS + 1)[1:].tolist()

    def _keys(self, column):
        if column == "category":
            return self._category
        if column in self._numbers:
            return self._numbers[column]
        if column not in self._ranks:
            texts = [each.casefold() for each in self._texts[column]]
            places = {text: place for place, text in enumerate(sorted(set(texts)))}
            self._ranks[column] = np.array([places[text] for text in texts], dtype=np.int64)
        return self._ranks[column]

    def _set_categories(self, names):
        others = sorted(set(names) - {*_FIRST, FAILED})
        self.categories = (*_FIRST, *others, FAILED)
        codes = {name: code for code, name in enumerate(self.categories)}
        self._category = np.array([codes[name] for name in names], dtype=np.int16)

    def _set_criteria(self, texts):
        distinct = {text: code for code, text in enumerate(dict.fromkeys(texts))}
        sets = [set((text or "").strip(",").split(",")) - {""} for text in distinct]
        self.criteria = tuple(sorted(set().union(*sets), key=lambda each: (len(each), each)))
        self._criteria_sets = np.array(
            [[name in each for name in self.criteria] for each in sets], dtype=bool,
        ).reshape(len(sets), len(self.criteria))
        self._criteria_set = np.array([distinct[text] for text in texts], dtype=np.int64)


def _scale(values):
    positive = values[values > 0.0]
    return (float(positive.min()), float(positive.max())) if len(positive) else (1.0, 1.0)


def _bins(values, scale):
    """Bin of each value on a logarithmic scale, -1 where there is no value."""
    low, high = scale
    known = np.isfinite(values)
    span = np.log(high / low) or 1.0
    place = np.log(np.maximum(np.where(known, values, low), low) / low) / span
    return np.where(known, np.minimum((place * HISTOGRAM_BINS).astype(np.int64), HISTOGRAM_BINS - 1), -1)

"""Parts of libraries that are most like a given one."""

import os
from collections import namedtuple

import numpy as np

from ..core.similarity import SIGNATURE_LENGTH, nearest, reasons, score, signature
from .find_parts import FoundParts

SimilarPart = namedtuple("SimilarPart", "part score reasons")
"""A StoredPart, how like it is from 100 to 0, and why, in words."""


def similar_parts(indexes, record, count, same_size=None, excluding=None, among=None):
    """The parts most like one, best first.

    Parameters
    ----------
    indexes : list of LibraryIndex
        Refreshed.
    record : dict
        Part record of the part that others are compared with.
    count : int
        How many at most.
    same_size : float, optional
        Factor, 1 or more, by which diagonals may differ; any size when left out.
    excluding : tuple of (str, str), optional
        Info file and name of the part itself, which is not told.
    among : list of ndarray of int64, optional
        For each index the ids of the parts that come into question; all when left out.

    Returns
    -------
    list of SimilarPart
    """
    wanted, found = signature(record), []
    for place, index in enumerate(indexes):
        ids, signatures = _signatures(index)
        if among is not None:
            chosen = np.isin(ids, among[place])
            ids, signatures = ids[chosen], signatures[chosen]
        # One more than wanted: the part itself is the most like.
        best = nearest(signatures, wanted, count + 1, same_size)
        parts = FoundParts(index, [int(ids[row]) for row in best.indices])
        found += zip(parts, best.distances, best.terms)
    found.sort(key=lambda each: each[1])
    distinct = {}
    for part, distance, terms in found:
        key = os.path.realpath(part.info_file), part.name
        if key != excluding:
            distinct.setdefault(key, SimilarPart(part, float(score(distance)), reasons(terms)))
    return list(distinct.values())[:count]


def _signatures(index):
    rows = index.query("SELECT id, signature FROM distributions")
    ids = np.fromiter((number for number, _ in rows), dtype=np.int64, count=len(rows))
    joined = b"".join(values for _, values in rows)
    return ids, np.frombuffer(joined, dtype=np.float32).reshape(len(rows), SIGNATURE_LENGTH)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parts of libraries that are most similar to a given part."""

import os
from collections import namedtuple

import numpy as np

from ...core.reuse.similarity import SIGNATURE_LENGTH, nearest, reasons, score, signature
from .find_parts import stored_parts

SimilarPart = namedtuple("SimilarPart", "part score reasons")
"""A StoredPart, its similarity from 100 to 0, and the reasons in words."""


def similar_parts(indexes, record, count, same_size=None, excluding=None, among=None):
    """The parts most similar to a given part, best first: list of SimilarPart.

    Parameters
    ----------
    indexes : list of LibraryIndex
        Refreshed.
    record : PartRecord
        Record of the given part.
    count : int
        Maximum number of results.
    same_size : float, optional
        Factor, 1 or more, by which diagonals may differ; any size by default.
    excluding : tuple of (str, str), optional
        Info file and name of the part itself, which is left out.
    among : list of ndarray of int64, optional
        The ids of the candidates in each index; all parts by default.
    """
    target = signature(record)
    found: list[tuple] = []
    for position, index in enumerate(indexes):
        ids, signatures = _signatures(index)
        if among is not None:
            is_candidate = np.isin(ids, among[position])
            ids, signatures = ids[is_candidate], signatures[is_candidate]
        # One more than `count`: the part itself is the most similar one.
        best = nearest(signatures, target, count + 1, same_size)
        parts = stored_parts(index, [int(ids[row]) for row in best.indices])
        found += zip(parts, best.distances, best.terms)
    found.sort(key=lambda candidate: candidate[1])
    distinct: dict[tuple[str, str], SimilarPart] = {}
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

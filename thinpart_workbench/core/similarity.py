"""Parts like another: alike in their walls, fill and box, wherever they stand and however large."""

import math
from typing import NamedTuple

import numpy as np

from .distribution import BINS

EDGE_STEPS = ((1, 30), (2, 80), (5, 150), (10, 300), (25, BINS))
"""Width of the intervals, in bins of the distribution, up to a bin: finest where thin parts differ."""

THICKNESS_UNIT = 0.05
"""The x (the paper's bound on thin features) from which on thicknesses are told apart by their ratio
rather than by their difference."""

NO_WALL = 0.25
"""How far from the thickest wall area counts that has no parallel wall, on the scale from 0 to 1."""

SIDES_RATIO = 10.0
"""Ratio of sides from which on two boxes are as different as boxes get."""

UNKNOWN_FILL = 0.25
"""Difference of fill where it is known of one part only; about that of two parts taken at random."""

HALF_SCORE = 0.2
"""Distance that halves the score."""

_AT_ONCE = 4096


class Term(NamedTuple):
    """One way in which two parts differ.

    Attributes
    ----------
    name : str
    weight : float
        In the distance; all of them sum to 1.
    near, less, much_less, more, much_more : str
        How it is said of a part that it has the same as the one looked for, somewhat and much less,
        and somewhat and much more. Less and more are one where the term has no direction.
    unknown : str
        How it is said that it cannot be compared.
    """

    name: str
    weight: float
    near: str
    less: str
    much_less: str
    more: str
    much_more: str
    unknown: str = ""


TERMS = (
    Term("walls", 0.45, "same wall distribution", "similar wall distribution",
         "different wall distribution", "similar wall distribution", "different wall distribution"),
    Term("fill", 0.2, "same fill", "less filled", "much less filled", "more filled",
         "much more filled", "fill not comparable"),
    Term("length", 0.125, "box as long", "shorter box", "much shorter box", "longer box",
         "much longer box"),
    Term("flatness", 0.125, "box as flat", "less flat box", "much less flat box", "flatter box",
         "much flatter box"),
    Term("slanted", 0.1, "", "fewer slanted walls", "far fewer slanted walls",
         "more slanted walls", "far more slanted walls"),
)
"""Every term of the distance, its weight and its words."""

NEAR, FAR = 0.04, 0.2
"""A term under the first is said to be the same, one from the second on to be far."""


def _edges():
    edges, start = [], 0
    for width, end in EDGE_STEPS:
        edges += range(start, end, width)
        start = end
    return np.array(edges)


def _spacing(edges):
    ends = np.append(edges, BINS) / BINS
    return np.diff(np.log1p(ends / THICKNESS_UNIT)) / math.log1p(1.0 / THICKNESS_UNIT)


EDGES = _edges()
"""ndarray of shape (INTERVALS,), int64: first bin of each interval of x."""

INTERVALS = len(EDGES)
_WIDTHS = np.diff(np.append(EDGES, BINS)).astype(float)

SPACING = _spacing(EDGES)
"""ndarray of shape (INTERVALS,): length of each interval on the scale of thickness, which is that of
``log(1 + x / THICKNESS_UNIT)`` and runs from 0 to 1."""

PARALLEL, NONPARALLEL, UNMEASURED, FILL, D2_D1, D3_D1, DIAGONAL = range(INTERVALS, INTERVALS + 7)
"""Columns of a signature behind those of the distribution."""

SIGNATURE_LENGTH = INTERVALS + 7

_WALL_WEIGHTS = (np.append(SPACING, NO_WALL) / (1.0 + NO_WALL)).astype(np.float32)
_WEIGHTS = np.array([term.weight for term in TERMS])
_LEAST_RATIO = np.float32(1e-4)


def signature(record):
    """What a part is compared by.

    Parameters
    ----------
    record : dict
        Part record.

    Returns
    -------
    ndarray of shape (SIGNATURE_LENGTH,), float32
        The share of the area over parallel walls thinner than x, as its mean over each interval of x
        (so that a wall which moves across an edge changes it steadily); from `PARALLEL` on the shares
        of parallel, non-parallel and unmeasured area, the fill V/VBB (NaN where it is not known),
        D2/D1, D3/D1, and the diagonal in mm.
    """
    content = record["descriptors"]
    table, shares, sides = content["distribution"], content["shares"], content["box_mm"]
    fill = content["volume_ratio"]
    area = np.zeros(BINS)
    if table["bins"]:
        area[table["bins"]] = table["area"]
    result = np.empty(SIGNATURE_LENGTH, dtype=np.float32)
    result[:INTERVALS] = np.add.reduceat(area.cumsum(), EDGES) / _WIDTHS
    result[INTERVALS:] = (
        shares["parallel"], shares["nonparallel"], shares["unmeasured"],
        math.nan if fill is None else fill, sides[1] / sides[0], sides[2] / sides[0],
        content["diagonal_mm"],
    )
    return result


class Similarity(NamedTuple):
    """The parts most like one, the likest first.

    Attributes
    ----------
    indices : ndarray of shape (k,), int64
        Rows of the signatures.
    distances : ndarray of shape (k,)
        From 0, the same, to about 1.
    terms : ndarray of shape (k, len(TERMS))
        What the distances are made of, each from -1 to 1: how much more the part has than the one
        looked for; without a sign for the walls. NaN where it is known of one of them only, or of
        none.
    """

    indices: np.ndarray
    distances: np.ndarray
    terms: np.ndarray


def nearest(signatures, wanted, count, same_size=None):
    """The parts most like a wanted one.

    Parameters
    ----------
    signatures : ndarray of shape (n, SIGNATURE_LENGTH), float32
    wanted : ndarray of shape (SIGNATURE_LENGTH,), float32
    count : int
        How many at most.
    same_size : float, optional
        Factor, 1 or more, by which diagonals may differ; any size when left out.

    Returns
    -------
    Similarity
        Parts that are equally like come in the order of their rows.

    Notes
    -----
    The distance is ``sqrt(sum(weight * term ** 2))`` over `TERMS`:

    - ``walls``: earth mover's distance (Rubner, Tomasi, Guibas, IJCV 2000) between the distributions of
      area by thickness, ``integral |F - G|`` over the scale of `SPACING`, where area without a parallel
      wall lies `NO_WALL` behind its end, divided by the length of it all. So it is 1 between a part that
      is all walls of no thickness and one that has no walls.
    - ``fill``: difference of V/VBB; where it is known of one part only, `UNKNOWN_FILL`; where of none, 0.
    - ``length``, ``flatness``: difference of the logarithms of D1/D2 and of D2/D3, in units of that of
      `SIDES_RATIO`, 1 at most.
    - ``slanted``: difference of the shares of area over non-parallel walls.
    """
    signatures = np.asarray(signatures, dtype=np.float32).reshape(-1, SIGNATURE_LENGTH)
    wanted = np.asarray(wanted, dtype=np.float32)
    chosen = np.arange(len(signatures))
    if same_size is not None:
        ratio = signatures[:, DIAGONAL] / wanted[DIAGONAL]
        chosen = np.flatnonzero((ratio <= same_size) & (ratio * same_size >= 1.0))
    distances = np.empty(len(chosen))
    for start in range(0, len(chosen), _AT_ONCE):
        rows = chosen[start:start + _AT_ONCE]
        # A slice is a view; rows picked out are a copy.
        part = signatures[start:start + _AT_ONCE] if same_size is None else signatures[rows]
        distances[start:start + _AT_ONCE] = _distances(part, wanted)
    best = _least(distances, count)
    found = chosen[best]
    return Similarity(found, distances[best], _terms(signatures[found], wanted))


def score(distance):
    """How like parts at a distance are, from 100 for the same to 0; halved by each `HALF_SCORE`."""
    return 100.0 * np.exp2(-np.asarray(distance) / HALF_SCORE)


def reasons(terms):
    """Why two parts are as like as they are, in words.

    Parameters
    ----------
    terms : ndarray of shape (len(TERMS),)
        A row of `Similarity.terms`.

    Returns
    -------
    str
        Such as "same wall distribution, same fill, longer box, less flat box".
    """
    return ", ".join(filter(None, map(_words, TERMS, terms)))


def _words(term, value):
    if math.isnan(value):
        return term.unknown
    if abs(value) < NEAR:
        return term.near
    if value < 0.0:
        return term.less if value > -FAR else term.much_less
    return term.more if value < FAR else term.much_more


def _terms(signatures, wanted):
    """Terms of the distance of each row from one signature, ndarray of shape (k, len(TERMS))."""
    walls = signatures[:, :PARALLEL + 1] - wanted[:PARALLEL + 1]
    np.abs(walls, out=walls)
    terms = np.empty((len(signatures), len(TERMS)), dtype=np.float32)
    terms[:, 0] = walls @ _WALL_WEIGHTS
    terms[:, 1] = signatures[:, FILL] - wanted[FILL]
    length, flatness = _sides(signatures.T)
    wanted_length, wanted_flatness = _sides(wanted)
    terms[:, 2] = np.clip(length - wanted_length, -1.0, 1.0)
    terms[:, 3] = np.clip(flatness - wanted_flatness, -1.0, 1.0)
    terms[:, 4] = signatures[:, NONPARALLEL] - wanted[NONPARALLEL]
    return terms


def _distances(signatures, wanted):
    squares = np.square(_terms(signatures, wanted))
    unknown, wanted_unknown = np.isnan(signatures[:, FILL]), np.isnan(wanted[FILL])
    squares[unknown | wanted_unknown, 1] = UNKNOWN_FILL ** 2
    # A part whose fill is not known is still the same as itself.
    squares[unknown & wanted_unknown, 1] = 0.0
    return np.sqrt(squares @ _WEIGHTS)


def _least(distances, count):
    """Indices of the `count` least, in order."""
    count = min(count, len(distances))
    if count <= 0:
        return np.empty(0, dtype=np.int64)
    limit = np.partition(distances, count - 1)[count - 1]
    among = np.flatnonzero(distances <= limit)
    return among[np.argsort(distances[among], kind="stable")[:count]]


def _sides(signatures):
    """Logarithms of D1/D2 and D2/D3; the first axis is that of the columns."""
    middle = np.log(np.maximum(signatures[D2_D1], _LEAST_RATIO))
    least = np.log(np.maximum(signatures[D3_D1], _LEAST_RATIO))
    unit = np.float32(math.log(SIDES_RATIO))
    return -middle / unit, (middle - least) / unit

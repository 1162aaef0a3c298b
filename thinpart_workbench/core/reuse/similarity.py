# SPDX-License-Identifier: LGPL-2.1-or-later
"""Similar parts: alike in their walls, form, fill and box, whatever their position and size."""

import math
from typing import NamedTuple

import numpy as np

from ..descriptors.bins import BINS
from ..errors import ThinPartError
from ..forms.directions import BINS as TURNS
from ..forms.directions import direction_distribution
from ..forms.recorded_form import form_of_record

EDGE_STEPS = ((1, 30), (2, 80), (5, 150), (10, 300), (25, BINS))
"""(width, end) in bins of the distribution: intervals of that width up to that bin, finest where thin parts differ."""

THICKNESS_UNIT = 0.05
"""The x (the paper's bound on thin features) above which thicknesses are compared by their ratio rather than by their
difference."""

NO_WALL = 0.25
"""Distance from the thickest wall, on the scale from 0 to 1, at which area without a parallel wall is placed."""

SIDES_RATIO = 10.0
"""Ratio of sides at which the difference between two boxes reaches its maximum."""

UNKNOWN_FILL = 0.25
"""Difference of fill where only one of two parts has a known fill; about that of two random parts."""

FORM_UNIT = 1.5
"""Difference of the proportions of two forms at which it reaches its maximum."""

UNKNOWN_FORM = 0.2
"""Term of the form where only one of two parts has a known one, which earlier versions did not record."""

UNKNOWN_DIRECTIONS = 0.1
"""Term of the directions where only one of two parts has known ones."""

HALF_SCORE = 0.2
"""Distance that halves the score."""

_AT_ONCE = 4096


class Term(NamedTuple):
    """One way in which two parts differ.

    Attributes
    ----------
    name : str
    weight : float
        Weight in the distance; all weights sum to 1.
    near, less, much_less, more, much_more : str
        Texts for a part that has the same as the reference part, somewhat and much less, and somewhat and much
        more. The texts for less and more are the same where the term has no direction.
    unknown : str
        Text for parts that cannot be compared.
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
    Term("walls", 0.27, "same wall distribution", "similar wall distribution",
         "different wall distribution", "similar wall distribution", "different wall distribution"),
    Term("directions", 0.23, "", "", "", "", ""),  # no words say more of it than those of walls and proportions
    Term("form", 0.19, "same proportions", "similar proportions", "different proportions", "similar proportions",
         "different proportions", "proportions not comparable"),
    Term("fill", 0.12, "same fill", "less filled", "much less filled", "more filled",
         "much more filled", "fill not comparable"),
    Term("length", 0.065, "box as long", "shorter box", "much shorter box", "longer box",
         "much longer box"),
    Term("flatness", 0.065, "box as flat", "less flat box", "much less flat box", "flatter box",
         "much flatter box"),
    Term("slanted", 0.06, "", "fewer tapered walls", "far fewer tapered walls",
         "more tapered walls", "far more tapered walls"),
)
"""The terms of the distance, with their weights and texts."""

NEAR, FAR = 0.04, 0.2
"""Terms below `NEAR` are described as the same, terms from `FAR` on as much less or much more."""


def _edges():
    edges: list[int] = []
    start = 0
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
"""ndarray of shape (INTERVALS,): length of each interval on the scale of thickness, which is proportional to
``log(1 + x / THICKNESS_UNIT)`` and runs from 0 to 1."""

PARALLEL, NONPARALLEL, UNMEASURED, FILL, D2_D1, D3_D1, DIAGONAL, FORM = range(INTERVALS, INTERVALS + 8)
DIRECTIONS = FORM + 3
"""Columns of a signature after those of the distribution; three from `FORM` on, and the rest from `DIRECTIONS` on."""

SIGNATURE_LENGTH = DIRECTIONS + TURNS

_ROWS = {term.name: row for row, term in enumerate(TERMS)}

_WALL_WEIGHTS = (np.append(SPACING, NO_WALL) / (1.0 + NO_WALL)).astype(np.float32)
_WEIGHTS = np.array([term.weight for term in TERMS])
_LEAST_RATIO = np.float32(1e-4)
_TINY = float(np.finfo(float).tiny)


def signature(record):
    """Compute the signature by which a part is compared.

    Returns an ndarray of shape (SIGNATURE_LENGTH,), float32: the share of the area over parallel walls thinner than x, as
    its mean over each interval of x (so that it changes continuously when a wall moves across an edge); from `PARALLEL` on
    the shares of parallel, non-parallel and unmeasured area, the fill V/VBB (NaN where it is not known), D2/D1, D3/D1,
    the diagonal in mm, the `proportions` of the form, and its `direction_distribution` (NaN where they are not known).
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
        content["diagonal_mm"], *proportions(record), *_directions(record),
    )
    return result


def proportions(record):
    """What stays the same of the form of a part record that is moved, mirrored or scaled: ndarray of shape (3,).

    The logarithm of the greatest radius of gyration of the surface by the square root of its area, and the two other radii
    by the greatest; NaN where an earlier version wrote the record.
    """
    form = record.get("form")
    if form is None:
        return np.full(3, math.nan)
    xx, xy, xz, yy, yz, zz = form["second_mm2"]
    squares = np.linalg.eigvalsh([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])[::-1]
    radii = np.sqrt(np.maximum(squares, 0.0))
    area = record["descriptors"]["area_mm2"]
    return np.array([math.log(max(radii[0], _TINY) / math.sqrt(max(area, _TINY))), *(radii[1:] / max(radii[0], _TINY))])


def _directions(record):
    try:
        form = form_of_record(record)
    except ThinPartError:  # its outline is damaged
        form = None
    return np.full(TURNS, math.nan) if form is None else direction_distribution(form.outline)


class Similarity(NamedTuple):
    """The parts most similar to a reference part, most similar first.

    Attributes
    ----------
    indices : ndarray of shape (k,), int64
        Rows of the signatures.
    distances : ndarray of shape (k,)
        From 0 for the same part to about 1.
    terms : ndarray of shape (k, len(TERMS))
        Terms of the distances, each from -1 to 1: how much more the part has than the reference part; without a
        sign for the walls. NaN where the value of one or both parts is unknown.
    """

    indices: np.ndarray
    distances: np.ndarray
    terms: np.ndarray


def nearest(signatures, reference, count, same_size=None):
    """Find the parts most similar to a reference part, equally similar ones in the order of their rows: Similarity.

    The distance is ``sqrt(sum(weight * term ** 2))`` over `TERMS`:

    - ``walls``: earth mover's distance (Rubner, Tomasi, Guibas, IJCV 2000) between the distributions of
      area by thickness, ``integral |F - G|`` over the scale of `SPACING`, where area without a parallel
      wall lies `NO_WALL` behind its end, divided by the total length. So it is 1 between a part whose walls all
      have no thickness and a part without walls.
    - ``form``: distance of the `proportions`, in units of `FORM_UNIT`, 1 at most; `UNKNOWN_FORM` if only one is known, 0
      if none is.
    - ``directions``: earth mover's distance between the distributions of the cosine of two normals; `UNKNOWN_DIRECTIONS` if
      only one is known, 0 if none is.
    - ``fill``: difference of V/VBB; `UNKNOWN_FILL` if only one is known, 0 if none is.
    - ``length``, ``flatness``: difference of the logarithms of D1/D2 and of D2/D3, in units of the
      logarithm of `SIDES_RATIO`, 1 at most.
    - ``slanted``: difference of the shares of area over non-parallel walls.

    Parameters
    ----------
    signatures : ndarray of shape (n, SIGNATURE_LENGTH), float32
    reference : ndarray of shape (SIGNATURE_LENGTH,), float32
    count : int
        How many at most.
    same_size : float, optional
        Factor, 1 or more, by which diagonals may differ; by default any size.
    """
    signatures = np.asarray(signatures, dtype=np.float32).reshape(-1, SIGNATURE_LENGTH)
    reference = np.asarray(reference, dtype=np.float32)
    chosen = np.arange(len(signatures))
    if same_size is not None:
        with np.errstate(over="ignore"):  # infinity is correctly treated as too different
            ratio = signatures[:, DIAGONAL] / reference[DIAGONAL]
        chosen = np.flatnonzero((ratio <= same_size) & (ratio * same_size >= 1.0))
    distances = np.empty(len(chosen))
    for start in range(0, len(chosen), _AT_ONCE):
        rows = chosen[start:start + _AT_ONCE]
        # A slice is a view; indexing with rows copies.
        part = signatures[start:start + _AT_ONCE] if same_size is None else signatures[rows]
        distances[start:start + _AT_ONCE] = _distances(part, reference)
    best = _least(distances, count)
    found = chosen[best]
    return Similarity(found, distances[best], _terms(signatures[found], reference))


def score(distance):
    """Similarity score of a distance, from 100 for the same part down to 0; each `HALF_SCORE` halves it."""
    return 100.0 * np.exp2(-np.asarray(distance) / HALF_SCORE)


def reasons(terms):
    """Describe the similarity of two parts, a row of `Similarity.terms`, in words: str.

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


def _terms(signatures, reference):
    """Terms of the distance of each row from one signature, ndarray of shape (k, len(TERMS))."""
    walls = signatures[:, :PARALLEL + 1] - reference[:PARALLEL + 1]
    np.abs(walls, out=walls)
    terms = np.empty((len(signatures), len(TERMS)), dtype=np.float32)
    terms[:, _ROWS["walls"]] = walls @ _WALL_WEIGHTS
    away = signatures[:, FORM:FORM + 3] - reference[FORM:FORM + 3]
    terms[:, _ROWS["form"]] = np.minimum(np.sqrt(np.square(away).sum(axis=1)) / np.float32(FORM_UNIT), 1.0)
    turned = signatures[:, DIRECTIONS:] - reference[DIRECTIONS:]
    terms[:, _ROWS["directions"]] = np.abs(turned, out=turned).sum(axis=1) * np.float32(2.0 / TURNS)
    terms[:, _ROWS["fill"]] = signatures[:, FILL] - reference[FILL]
    length, flatness = _sides(signatures.T)
    reference_length, reference_flatness = _sides(reference)
    terms[:, _ROWS["length"]] = np.clip(length - reference_length, -1.0, 1.0)
    terms[:, _ROWS["flatness"]] = np.clip(flatness - reference_flatness, -1.0, 1.0)
    terms[:, _ROWS["slanted"]] = signatures[:, NONPARALLEL] - reference[NONPARALLEL]
    return terms


def _distances(signatures, reference):
    squares = np.square(_terms(signatures, reference))
    for name, column, difference in (
            ("fill", FILL, UNKNOWN_FILL), ("form", FORM, UNKNOWN_FORM), ("directions", DIRECTIONS, UNKNOWN_DIRECTIONS)):
        unknown, reference_unknown = np.isnan(signatures[:, column]), np.isnan(reference[column])
        squares[unknown | reference_unknown, _ROWS[name]] = difference ** 2
        # A part of which it is unknown still has distance 0 from itself.
        squares[unknown & reference_unknown, _ROWS[name]] = 0.0
    return np.sqrt(squares @ _WEIGHTS)


def _least(distances, count):
    """Indices of the `count` least distances, in ascending order."""
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

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether walls are plates: wider than they are thick."""

import numpy as np

from ..tolerances import TOLERANCES

PROBED, NEAR = 500, 200
"""Places of a part at which walls are looked at, and points around each of them that are enough to tell its width."""

REACH = 3.0
"""Thicknesses around the middle of a wall within which it is looked at."""

LEAST_REACH = 3.0
"""The same in mean distances between points: of a very thin wall there are none nearer."""

ALONG = 0.5
"""Least cosine between the normals of a wall and of points of its sides: the other sides of a bar are left out."""

PLATE_FROM = 1.9, 2.5
"""Least variance along a wall by the variance through it: up to the first, the wall is no plate, from the second on it is
one. Of two sides that are w wide and t apart it is (w / t)^2 / 3: 0.33 of a square bar, 1.9 of a washer M10, 12 within the
reach on a plate."""

WITHIN = 1.6
"""Factor within which that ratio is certain."""

FEWEST = 8
"""Points from which extents can be told."""

_AT_ONCE = 100


def plate_likeness(points, region, place):
    """How much walls are plates at some places.

    Returns `likeness` (ndarray of shape (k,); from 0 to 1) and `error` (ndarray of shape (k,); by how much it changes where
    the ratio of variances is not certain).

    What the paper's distribution (Giannini, Petton, Pernot, TMCE 2012, 4.2.2) cannot tell apart: a bar and a plate of one
    thickness. About the middle of a wall, its two sides are as wide one way as the other on a plate, a tube or a shell, and
    as narrow as the wall is thick on a bar or a washer. The variances of their points along the wall and through it say
    which. The next turn of a coil is the same wall, and a section far longer than wide has no points near by: of those, the
    region as a whole knows better.

    Parameters
    ----------
    points : WallPoints
    region : ndarray of shape (n,), int
        The wall that each of them belongs to.
    place : ndarray of shape (k,), int64
        Among the points.
    """
    ratio = np.zeros(len(place))
    order, probed_order = np.argsort(region, kind="stable"), np.argsort(region[place], kind="stable")
    numbers, first = np.unique(region[place[probed_order]], return_index=True)
    start, end = (np.searchsorted(region[order], numbers, side=side) for side in ("left", "right"))
    for own, members in zip(np.split(probed_order, first[1:]), map(slice, start, end)):
        if members.stop - members.start >= FEWEST:
            ratio[own] = _variance_ratio(points.chosen(order[members]), points.chosen(place[own]))
    likeness = _likeness(ratio)
    return likeness, np.maximum(_likeness(ratio * WITHIN) - likeness, likeness - _likeness(ratio / WITHIN))


def _likeness(ratio):
    none, full = PLATE_FROM
    return np.clip((ratio - none) / (full - none), 0.0, 1.0)


def _variance_ratio(wall, probed):
    """Least variance along a wall by the variance through it, of its points around each middle: ndarray of shape (m,).

    0 where there are too few points. Both are WallPoints of the same wall.
    """
    reach = np.maximum(REACH * probed.thickness, LEAST_REACH * probed.spacing)
    # On a plate, so many points are within reach of half of the places.
    within = min(2.0 * np.pi * np.median(reach) ** 2 / np.median(wall.area), len(wall.sample))
    wall = wall.chosen(slice(None, None, max(1, int(within / NEAR))))
    centre = wall.points.mean(axis=0)
    points, middle = wall.points - centre, probed.middle - centre
    # One product of matrices has the sums over all points around a chunk of middles.
    rows, columns = np.triu_indices(3)
    terms = np.column_stack([np.ones(len(points)), points, points[:, rows] * points[:, columns]])
    squares = np.einsum("ij,ij->i", points, points)
    ratio = np.zeros(len(middle))
    for start in range(0, len(middle), _AT_ONCE):
        part = slice(start, start + _AT_ONCE)
        distance = squares + np.einsum("ij,ij->i", middle[part], middle[part])[:, None] - 2.0 * middle[part] @ points.T
        same = distance < reach[part, None] ** 2
        same &= np.abs(probed.normals[part] @ wall.normals.T) > ALONG
        # A taper that runs out of a wall, and is one region with it or not as the mesh has it, says nothing about its width.
        own = probed.thickness[part, None]
        same &= np.abs(wall.thickness - own) < (TOLERANCES.alike - 1.0) * own
        sums = same.astype(float) @ terms
        enough = np.flatnonzero(sums[:, 0] >= FEWEST)
        sums = sums[enough]
        mean = sums[:, 1:4] / sums[:, :1]
        covariance = np.empty((len(enough), 3, 3))
        covariance[:, rows, columns] = covariance[:, columns, rows] = (
            sums[:, 4:] / sums[:, :1] - mean[:, rows] * mean[:, columns])
        ratio[start + enough] = _along_by_through(covariance, probed.normals[part][enough])
    return ratio


def _along_by_through(covariance, normal):
    """Least variance in the plane across a direction by the variance along it: ndarray of shape (k,)."""
    through = np.einsum("ki,kij,kj->k", normal, covariance, normal)
    across = np.eye(3) - normal[:, :, None] * normal[:, None, :]
    # The variances in the plane are the two larger ones of what is left when the direction is taken out.
    along = np.linalg.eigvalsh(across @ covariance @ across)[:, 1]
    return along / np.maximum(through, 1e-9 * along + np.finfo(float).tiny)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Subdivision of facets along their longer sides, so that each piece can have its own value."""

import numpy as np

from ..columns import corners_of, dot

FACETS = 20_000
"""The surface of a part is cut about as finely as this many equal facets would be."""

LONGEST = 1.6
"""Sides longer than this many sides of such an equal facet are cut, so that no piece gets much shorter than one."""

MOST_FACETS = 60_000
"""Facets are cut more coarsely where there would be more than this. A surface mesh that is finer already may get at
most this many facets more, because its plane faces may still have large triangles."""

_CUTS = {
    # Key: the sides to cut, as bits. Value: the resulting facets; nodes 0 to 2 are the corners, 3 to 5 the
    # middles of the sides from corners 0, 1 and 2 to the next corner.
    0: ((0, 1, 2),),
    1: ((0, 3, 2), (3, 1, 2)),
    2: ((0, 1, 4), (0, 4, 2)),
    3: ((3, 1, 4), (0, 3, 4), (0, 4, 2)),
    4: ((0, 1, 5), (5, 1, 2)),
    5: ((0, 3, 5), (3, 1, 2), (3, 2, 5)),
    6: ((4, 2, 5), (0, 1, 4), (0, 4, 5)),
    7: ((0, 3, 5), (3, 1, 4), (5, 4, 2), (3, 4, 5)),
}


def small_facets(mesh):
    """Cut the triangles of a SurfaceMesh until they are small.

    Returns
    -------
    points : ndarray of shape (v, 3), mm
    facets : ndarray of shape (m, 3), int64
    parent : ndarray of shape (m,), int64
        The triangle that each is a piece of.
    size : float, mm
        No side is longer.
    most : int
        How many facets there may be at last.
    """
    points, facets = mesh.vertices, mesh.triangles
    parent = np.arange(mesh.count)
    size = LONGEST * np.sqrt(4.0 / np.sqrt(3.0) * mesh.areas.sum() / FACETS)
    most = max(MOST_FACETS, min(2 * mesh.count, MOST_FACETS + mesh.count))
    while True:
        long = side_lengths(points, facets) > size
        if not long.any():
            return points, facets, parent, size, most
        if too_many(facets, long, most):
            size *= 1.5
            continue
        points, facets, pieces = cut_sides(points, facets, long)
        parent = parent[pieces]


def too_many(facets, cut, most):
    """Whether there are more facets than `most` once sides are cut, as in `cut_sides`."""
    # Each cut side adds about one facet on either side of it, and is counted on both.
    return len(facets) + cut.sum() > most


def side_lengths(points, facets):
    """Compute the lengths of the sides from each corner to the next: ndarray of shape (m, 3), mm.

    Parameters
    ----------
    points : ndarray of shape (v, 3), mm
    facets : ndarray of shape (m, 3), int
    """
    corners = corners_of(np.ascontiguousarray(points.T), facets)
    lengths = np.empty((3, len(facets)))
    for corner in range(3):
        side = corners[:, (corner + 1) % 3] - corners[:, corner]
        np.sqrt(dot(side, side), out=lengths[corner])
    return lengths.T


def cut_sides(points, facets, cut, share=None):
    """Cut sides of facets, on both facets that share a side.

    Parameters
    ----------
    points : ndarray of shape (v, 3), mm
    facets : ndarray of shape (m, 3), int64
    cut : ndarray of shape (m, 3), bool
        Sides to cut, from each corner to the next. A shared side is cut if either of its two facets marks it.
    share : ndarray of shape (m, 3), optional
        Where they are cut, from 0 at the corner with the lower number to 1 at the other, by one of the facets that mark it
        (default: at their middle).

    Returns
    -------
    points : ndarray of shape (w, 3), mm
        The given points, then the places of the cuts.
    facets : ndarray of shape (k, 3), int64
        Facets that were not cut come first, in their given order.
    parent : ndarray of shape (k,), int64
        Index of the given facet that each one equals or is a piece of.
    """
    key = side_keys(facets, len(points))
    cut_keys, first = np.unique(key[cut], return_index=True)
    cut_index = np.minimum(np.searchsorted(cut_keys, key), max(len(cut_keys) - 1, 0))
    is_cut = cut_keys[cut_index] == key if len(cut_keys) else np.zeros_like(cut)
    at = 0.5 if share is None else share[cut][first][:, None]
    places = (1.0 - at) * points[cut_keys // len(points)] + at * points[cut_keys % len(points)]
    nodes = np.concatenate([facets, len(points) + cut_index], axis=1)
    code = is_cut @ np.array([1, 2, 4])
    pieces, parents = [], []
    for number, corners in _CUTS.items():
        which = np.flatnonzero(code == number)
        pieces.append(nodes[which][:, np.array(corners)].reshape(-1, 3))
        parents.append(np.repeat(which, len(corners)))
    return np.concatenate([points, places]), np.concatenate(pieces), np.concatenate(parents)


def side_keys(facets, count):
    """Compute a key for each side that is the same for the two facets that share it: ndarray of shape (m, 3), int64.

    Parameters
    ----------
    facets : ndarray of shape (m, 3), int64
    count : int
        Number of points.
    """
    ahead = np.roll(facets, -1, axis=1)
    return np.minimum(facets, ahead) * count + np.maximum(facets, ahead)

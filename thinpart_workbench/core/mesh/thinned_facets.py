# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fewer facets that look like many."""

import numpy as np

from ..columns import corners_of, cross, dot

_DIRECTIONS = 6
"""Of normals, along either way of each axis: what looks different ways is never united, or thin walls would collapse."""


def thinned_facets(points, facets, most):
    """Unite points that are near each other, and leave out the facets that collapse.

    Returns `points` (ndarray of shape (w, 3), mm), `facets` (ndarray of shape (k, 3), int64) and `kept` (ndarray of shape
    (k,), int64; the given facet that each one stands for).

    Rossignac and Borrel (1993), "Multi-resolution 3D approximations for rendering complex scenes": points in one cell of a
    grid become one, their mean. Points whose surface looks along different axes stay apart, so that the sides of a wall
    thinner than a cell do. It keeps no topology: for a first look only.

    Parameters
    ----------
    points : ndarray of shape (v, 3), mm
    facets : ndarray of shape (m, 3), int
    most : int
        About so many facets are left.
    """
    corners = corners_of(np.ascontiguousarray(points.T, dtype=np.float64), facets)
    vectors = cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    area = 0.5 * np.sqrt(dot(vectors, vectors)).sum()
    cell = _numbered(points, facets, vectors, np.sqrt(2.0 * area / most))
    count = int(cell.max()) + 1
    # Each point where the mean of those that are united with it is.
    shares = np.bincount(cell, minlength=count)
    united = np.stack([np.bincount(cell, points[:, axis], minlength=count) for axis in range(3)], axis=1)
    united /= np.maximum(shares, 1)[:, None]
    pieces = cell[facets]
    whole = np.flatnonzero((pieces[:, 0] != pieces[:, 1]) & (pieces[:, 1] != pieces[:, 2]) & (pieces[:, 2] != pieces[:, 0]))
    turned = np.sort(pieces[whole], axis=1)
    # There are too few cells for this to overflow, and one number is sorted faster than three.
    _, first = np.unique((turned[:, 0] * count + turned[:, 1]) * count + turned[:, 2], return_index=True)
    kept = whole[np.sort(first)]
    return united, pieces[kept].astype(np.int64), kept


def _numbered(points, facets, vectors, side):
    """The number of the cell of each point: ndarray of shape (v,), int64, from 0 without gaps."""
    axis = np.abs(vectors).argmax(axis=0)
    looks = 2 * axis + (np.take_along_axis(vectors, axis[None], axis=0)[0] > 0.0)
    direction = np.zeros(len(points), dtype=np.int64)
    direction[facets.ravel()] = np.repeat(looks, 3)
    low = points.min(axis=0)
    place = np.floor((points - low) / side).astype(np.int64)
    many = place.max(axis=0) + 1
    key = ((place[:, 0] * many[1] + place[:, 1]) * many[2] + place[:, 2]) * _DIRECTIONS + direction
    return np.unique(key, return_inverse=True)[1].ravel()

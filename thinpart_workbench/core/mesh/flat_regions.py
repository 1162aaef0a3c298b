# SPDX-License-Identifier: LGPL-2.1-or-later
"""Move the points of flat regions, which rounding displaced, back into their planes."""

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components

from ..columns import corners_of, cross, dot
from ..tolerances import TOLERANCES

_PLANES_APART = 1e-3
"""Planes through a point count as one below this share of the largest singular value."""


def flattened(vertices, triangles, sides, extent):
    """Move vertices into the planes of the flat regions that they belong to: ndarray of shape (v, 3), mm.

    No vertex has moved by more than a few times `Tolerances.flat`.

    FreeCAD and STL store points as float32. On a part that is not aligned with the axes, this tilts the normals of
    slender triangles of a plane by degrees, so that parallel walls seem to be at an angle and parallel rays
    diverge. A region consists of triangles connected by edges across which both triangles lie in one plane. Its
    normal is the sum of its area vectors, in which the rounding of inner points cancels.

    Parameters
    ----------
    vertices : ndarray of shape (v, 3), mm
    triangles : ndarray of shape (n, 3), int64
        Welded, none of zero area.
    sides : tuple of two ndarrays of shape (e,), int64
        The `shared_sides` of the triangles.
    extent : float, mm
    """
    tolerance = TOLERANCES.flat * extent
    corners = corners_of(np.ascontiguousarray(vertices.T), triangles)
    vectors = cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    region, count = _regions(corners, vectors, sides, tolerance)
    normal = np.stack([np.bincount(region, component, count) for component in vectors], axis=1)
    length = np.linalg.norm(normal, axis=1)
    normal /= np.where(length > 0.0, length, 1.0)[:, None]
    # One row for each vertex in each of its regions.
    keys = np.unique(region[:, None] * len(vertices) + triangles)
    own_region, vertex = np.divmod(keys, len(vertices))
    height = np.einsum("ij,ij->i", vertices[vertex], normal[own_region])
    members = np.bincount(own_region, minlength=count)
    level = np.bincount(own_region, height, count) / members
    off = level[own_region] - height
    most = np.maximum.reduceat(np.abs(off), np.cumsum(members) - members)
    is_flat = (length > 0.0) & (members > 3) & (most <= tolerance)
    if not (is_flat & (most > 0.0)).any():
        return vertices
    in_flat = is_flat[own_region]
    return _moved(vertices, vertex[in_flat], normal[own_region[in_flat]], off[in_flat], tolerance)


def _regions(corners, vectors, sides, tolerance):
    """Region of each triangle, and the number of regions."""
    doubled = np.sqrt(dot(vectors, vectors))
    first, second = sides
    one, other = first // 3, second // 3
    is_larger = doubled[one] >= doubled[other]
    large, smaller = np.where(is_larger, one, other), np.where(is_larger, second, first)
    # Corner k + 2 lies opposite the side from corner k to k + 1.
    small = smaller // 3
    away = corners[:, (smaller - 3 * small + 2) % 3, small] - corners[:, 0, large]
    flat = np.abs(dot(away, np.take(vectors, large, axis=1))) <= tolerance * doubled[large]
    flat &= dot(np.take(vectors, one, axis=1), np.take(vectors, other, axis=1)) > 0.0
    links = coo_matrix(
        (np.ones(flat.sum()), (one[flat], other[flat])), shape=(len(doubled),) * 2
    )
    count, region = connected_components(links, directed=False)
    return region.astype(np.int64), count


def _moved(vertices, vertex, normal, off, tolerance):
    """Move each vertex by the smallest vector that brings it into all its planes."""
    used, which = np.unique(vertex, return_inverse=True)
    which = which.ravel()
    matrix = np.empty((len(used), 3, 3))
    for i in range(3):
        for j in range(i + 1):
            matrix[:, i, j] = np.bincount(which, normal[:, i] * normal[:, j], len(used))
            matrix[:, j, i] = matrix[:, i, j]
    pull = np.stack([np.bincount(which, normal[:, k] * off, len(used)) for k in range(3)], axis=1)
    move = np.empty_like(pull)
    # Most vertices lie inside one region, where no equations have to be solved.
    single = np.bincount(which, minlength=len(used)) == 1
    move[single] = pull[single]
    inverse = np.linalg.pinv(matrix[~single], rcond=_PLANES_APART, hermitian=True)
    move[~single] = np.einsum("ijk,ik->ij", inverse, pull[~single])
    move[np.linalg.norm(move, axis=1) > 8.0 * tolerance] = 0.0
    moved = vertices.copy()
    moved[used] += move
    return moved

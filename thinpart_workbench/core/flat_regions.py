"""Flat parts of a surface whose points were rounded, put back into their planes."""

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components

from .edge_balance import shared_sides
from .tolerances import TOLERANCES

_PLANES_APART = 1e-3
"""Share of the largest singular value below which planes through a point count as one."""


def flattened(vertices, triangles, extent):
    """Vertices moved into the planes of the flat regions that they bound.

    Parameters
    ----------
    vertices : ndarray of shape (v, 3), mm
    triangles : ndarray of shape (n, 3), int64
        Welded, none of zero area.
    extent : float, mm

    Returns
    -------
    ndarray of shape (v, 3), mm
        No vertex has moved by more than a few times `Tolerances.flat`.

    Notes
    -----
    FreeCAD and STL keep points as float32. On a part that stands askew that turns the normals of
    slender triangles of a plane by degrees, so that parallel walls seem to stand at an angle, and
    rays that ran alike no longer do. A region is what is joined by edges across which both triangles
    lie in one plane; its normal is the sum of its area vectors, in which the rounding of inner
    points cancels.
    """
    tolerance = TOLERANCES.flat * extent
    region, count = _regions(vertices, triangles, tolerance)
    corners = vertices[triangles]
    vectors = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normal = np.stack([np.bincount(region, vectors[:, k], count) for k in range(3)], axis=1)
    length = np.linalg.norm(normal, axis=1)
    normal /= np.where(length > 0.0, length, 1.0)[:, None]
    # Each vertex once per region that it belongs to.
    keys = np.unique(region[:, None] * len(vertices) + triangles)
    own_region, vertex = np.divmod(keys, len(vertices))
    height = np.einsum("ij,ij->i", vertices[vertex], normal[own_region])
    members = np.bincount(own_region, minlength=count)
    level = np.bincount(own_region, height, count) / members
    off = level[own_region] - height
    most = np.zeros(count)
    np.maximum.at(most, own_region, np.abs(off))
    is_flat = (length > 0.0) & (members > 3) & (most <= tolerance)
    if not (is_flat & (most > 0.0)).any():
        return vertices
    kept = is_flat[own_region]
    return _moved(vertices, vertex[kept], normal[own_region[kept]], off[kept], tolerance)


def _regions(vertices, triangles, tolerance):
    """Region of each triangle, and how many there are."""
    first, second = shared_sides(triangles)
    # Corner k + 2 lies opposite the side from corner k to k + 1.
    corners = vertices[triangles]
    vectors = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    doubled = np.linalg.norm(vectors, axis=1)
    larger = np.where(doubled[first // 3] >= doubled[second // 3], first, second)
    smaller = first + second - larger
    apex = corners[smaller // 3, (smaller % 3 + 2) % 3]
    away = apex - corners[larger // 3, 0]
    off = np.einsum("ij,ij->i", away, vectors[larger // 3])
    flat = np.abs(off) <= tolerance * doubled[larger // 3]
    flat &= np.einsum("ij,ij->i", vectors[first // 3], vectors[second // 3]) > 0.0
    links = coo_matrix(
        (np.ones(flat.sum()), (first[flat] // 3, second[flat] // 3)), shape=(len(triangles),) * 2
    )
    count, region = connected_components(links, directed=False)
    return region.astype(np.int64), count


def _moved(vertices, vertex, normal, off, tolerance):
    """Each vertex moved by as little as puts it into all its planes."""
    used, which = np.unique(vertex, return_inverse=True)
    which = which.ravel()
    matrix = np.empty((len(used), 3, 3))
    for i in range(3):
        for j in range(i + 1):
            matrix[:, i, j] = np.bincount(which, normal[:, i] * normal[:, j], len(used))
            matrix[:, j, i] = matrix[:, i, j]
    pull = np.stack([np.bincount(which, normal[:, k] * off, len(used)) for k in range(3)], axis=1)
    move = np.empty_like(pull)
    # In the middle of one region, as most are, no equations have to be solved.
    single = np.bincount(which, minlength=len(used)) == 1
    move[single] = pull[single]
    inverse = np.linalg.pinv(matrix[~single], rcond=_PLANES_APART, hermitian=True)
    move[~single] = np.einsum("ijk,ik->ij", inverse, pull[~single])
    move[np.linalg.norm(move, axis=1) > 8.0 * tolerance] = 0.0
    moved = vertices.copy()
    moved[used] += move
    return moved

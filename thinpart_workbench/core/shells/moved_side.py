# SPDX-License-Identifier: LGPL-2.1-or-later
"""The triangles of one side of a wall, moved to its middle."""

import numpy as np
from scipy.sparse import coo_matrix
from scipy.spatial import cKDTree

from .walls_through import sides_of

INSET, DEPTH = 0.15, 0.3
"""Where the thickness at a node is measured: so far towards the middles of its triangles, and so many thicknesses below the
surface, so that a ray at the rim stays in the wall."""

MOST_THICK = 2.0
"""Thickness at a node by that of its face from which on it is that of a rib or a boss, and the nearest other counts."""

ALONG = 0.2
"""Least singular value of the normals of the faces at a node by the greatest: below, they are those of a smooth edge."""

FARTHEST = 3.0
"""How far a node may move, by half of the thickness: at the edge of two faces 39 degrees from each other."""

ROUNDS = 40
"""Of smoothing, at most, where triangles turned over."""

UPRIGHT = 0.3
"""Cosine of the angle by which a triangle may turn: at fillets that are narrower than an element and vanish."""


class SideNodes:
    """Nodes of a side, once for each face that they lie on.

    Attributes
    ----------
    node, face : ndarray of shape (k,), int64
        Row of the points, and index of the B-Rep face.
    inner : ndarray of shape (k, 3), mm
        A place of that face near the node.
    """

    def __init__(self, points, triangles, face):
        corners = np.repeat(np.arange(len(triangles)), triangles.shape[1])
        keys = np.column_stack([triangles.ravel(), face[corners]])
        pairs, number = np.unique(keys, axis=0, return_inverse=True)
        number = number.ravel()
        self.node, self.face = pairs.T
        middle = points[triangles[:, :3]].mean(axis=1)[corners]
        count = np.bincount(number)
        middle = np.column_stack([np.bincount(number, middle[:, axis]) for axis in range(3)]) / count[:, None]
        self.inner = points[self.node] + INSET * (middle - points[self.node])


def thickness_at(nodes, normals, side, mesh, rays, thickness_of_face):
    """Thickness of the wall below the nodes of a side: ndarray of shape (k,), mm.

    Parameters
    ----------
    nodes : SideNodes
    normals : ndarray of shape (k, 3)
        Outward.
    side : WallSide
    mesh : SurfaceMesh
        Of the solid.
    rays : InwardRays
        Of that mesh.
    thickness_of_face : ndarray of shape (number of faces,), mm
    """
    about = thickness_of_face[nodes.face]
    through = sides_of(mesh, rays, nodes.inner - DEPTH * about[:, None] * normals, -normals)
    found = through.ahead + through.behind
    known = through.is_between(side.pairs, len(thickness_of_face)) & (found < MOST_THICK * about)
    if not known.any():
        return about
    return np.where(known, found, found[known][cKDTree(nodes.inner[known]).query(nodes.inner)[1]])


def moved_side(points, triangles, nodes, normals, thickness):
    """Move the nodes of a side to the middle of the wall.

    Returns `points` (ndarray of shape (v, 3), mm) and `folded` (float: share of the area of triangles that turned over, once
    smoothed). At an edge, a node moves to where the middles of the walls on both sides of it meet.

    Parameters
    ----------
    points : ndarray of shape (v, 3), mm
    triangles : ndarray of int64, shape (n, 3) or (n, 6)
    nodes : SideNodes
    normals : ndarray of shape (k, 3)
    thickness : ndarray of shape (k,), mm
    """
    way = np.zeros_like(points)
    order = np.argsort(nodes.node, kind="stable")
    starts = np.flatnonzero(np.diff(nodes.node[order], prepend=-1))
    counts = np.diff(np.append(starts, len(order)))
    for count in np.unique(counts):
        rows = order[starts[counts == count][:, None] + np.arange(count)]
        inverse = np.linalg.pinv(normals[rows], rcond=ALONG)
        way[nodes.node[rows[:, 0]]] = np.einsum("kij,kj->ki", inverse, -0.5 * thickness[rows])
    length = np.linalg.norm(way, axis=1)
    most = np.zeros(len(points))
    np.maximum.at(most, nodes.node, 0.5 * FARTHEST * thickness)
    way *= np.minimum(1.0, most / np.maximum(length, 1e-300))[:, None]
    return _unfolded(points, triangles, way)


def _unfolded(points, triangles, way):
    """Smooth what moves nodes where triangles turned over: fillets with a radius of less than half of the thickness."""
    count = triangles.shape[1]
    sides = [(0, 1), (1, 2), (2, 0)] if count == 3 else [(0, 3), (3, 1), (1, 4), (4, 2), (2, 5), (5, 0)]
    ends = np.concatenate([triangles[:, side] for side in sides])
    ends = np.unique(np.concatenate([ends, ends[:, ::-1]]), axis=0)
    near = coo_matrix((np.ones(len(ends)), tuple(ends.T)), shape=(len(points),) * 2).tocsr()
    degree = np.maximum(np.asarray(near.sum(axis=1)), 1.0)
    area, before = _areas(points, triangles)
    for _ in range(ROUNDS):
        after_area, after = _areas(points + way, triangles)
        folded = (np.einsum("ij,ij->i", before, after) < UPRIGHT) & (after_area > 1e-6 * area)
        if not folded.any():
            break
        own = np.unique(triangles[folded])
        way[own] = 0.5 * way[own] + 0.5 * (near[own] @ way) / degree[own]
    return points + way, float(area[folded].sum() / area.sum())


def _areas(points, triangles):
    a, b, c = points[triangles[:, :3].T]
    across = np.cross(b - a, c - a)
    length = np.linalg.norm(across, axis=1)
    return 0.5 * length, across / np.maximum(length, 1e-300)[:, None]

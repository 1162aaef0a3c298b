# SPDX-License-Identifier: LGPL-2.1-or-later
"""The points of a mesh nearest to given points."""

import numpy as np
from scipy.spatial import cKDTree

from ..mesh.sampling import surface_samples
from ..rays.ball_descent import boxes_met, least_of_nodes
from ..rays.box_tree import box_tree
from ..rays.closest_points import closest_weights

SPREAD = 40_000
"""Points that are spread over the triangles: what is nearest is no farther than the nearest of them."""

_AT_ONCE = 2048
_WIDER = 1.0 + 1e-5  # the boxes of the tree are float32


class NearestOnMesh:
    """The triangles of a `SurfaceMesh`, among which the nearest points are looked for, in the coordinates of the mesh."""

    def __init__(self, mesh):
        self._corners = np.ascontiguousarray(mesh.corners.transpose(2, 1, 0))
        samples = surface_samples(mesh, SPREAD)
        self._samples, self._points = cKDTree(samples.points), samples.points
        self._boxes = box_tree(self._corners, np.ascontiguousarray(mesh.normals.T), mesh.areas)
        self._values = least_of_nodes(self._boxes, np.zeros(mesh.count))

    def nearest(self, points):
        """The points of the triangles nearest to points, both ndarray of shape (k, 3), mm."""
        feet = np.empty((len(points), 3))
        for start in range(0, len(points), _AT_ONCE):
            feet[start:start + _AT_ONCE] = self._nearest(points[start:start + _AT_ONCE])
        return feet

    def _nearest(self, points):
        radius, sample = self._samples.query(points)
        feet = self._points[sample].copy()
        radii = _WIDER * radius + np.float32(1e-6) * self._boxes.extent
        ball, leaf = boxes_met(self._boxes, points.T, radii, self._values, np.zeros(len(points)))
        columns = np.take(self._corners, self._boxes.order[leaf], axis=2)
        weights = closest_weights(points[ball].T, columns)
        found = np.einsum("kcn,cn->nk", columns, weights)
        away = np.linalg.norm(found - points[ball], axis=1)
        # Of several triangles of one ball, the last one that is written is the nearest.
        farthest_first = np.argsort(-away, kind="stable")
        ball, found, away = ball[farthest_first], found[farthest_first], away[farthest_first]
        is_nearer = away < radius[ball]
        feet[ball[is_nearer]] = found[is_nearer]
        return feet

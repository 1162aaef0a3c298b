# SPDX-License-Identifier: LGPL-2.1-or-later
"""The points of a mesh nearest to given points."""

from functools import cached_property

import numpy as np
from scipy.spatial import cKDTree

from ..mesh.sampling import surface_samples
from ..rays.ball_descent import boxes_met, least_of_nodes
from ..rays.box_tree import box_tree
from ..rays.closest_points import closest_weights

SPREAD = 40_000
"""Points that are spread over the triangles, to find those that are near."""

NEAR = 12
"""Near spread points whose triangles are looked at."""

EXACT_WITHIN = 4.0
"""Spacings of the spread points up to which all triangles are looked at that could be nearer than those."""

_AT_ONCE = 2048
_ROUNDING = 1e-6


class NearestOnMesh:
    """The triangles of a `SurfaceMesh`, among which the nearest points are looked for, in the coordinates of the mesh.

    Of points that lie many spacings of the spread points away, the nearest point is one of a few that are nearly as near.
    """

    def __init__(self, mesh):
        self._mesh, self._corners = mesh, mesh.corners
        samples = surface_samples(mesh, SPREAD)
        self._triangle, self._tree = samples.triangle, cKDTree(samples.points)
        self._exact_within = EXACT_WITHIN * float(np.sqrt(mesh.areas.sum() / samples.count))

    def nearest(self, points):
        """The points of the triangles nearest to points, both ndarray of shape (k, 3), mm."""
        feet = np.empty((len(points), 3))
        for start in range(0, len(points), _AT_ONCE):
            own = points[start:start + _AT_ONCE]
            near = self._triangle[self._tree.query(own, k=min(NEAR, len(self._triangle)))[1].reshape(len(own), -1)]
            found = self._feet(np.repeat(own, near.shape[1], axis=0), near.ravel()).reshape(len(own), -1, 3)
            away = own[:, None] - found
            nearest = np.einsum("knj,knj->kn", away, away).argmin(axis=1)
            feet[start:start + _AT_ONCE] = found[np.arange(len(own)), nearest]
        self._correct(points, feet)
        return feet

    def _correct(self, points, feet):
        """Look at all triangles that are nearer: long narrow ones have their spread points far away."""
        distance = np.linalg.norm(points - feet, axis=1)
        unsure = np.flatnonzero((distance > _ROUNDING * self._mesh.extent) & (distance < self._exact_within))
        boxes, any_value = self._boxes
        for start in range(0, len(unsure), _AT_ONCE):
            rows = unsure[start:start + _AT_ONCE]
            centres = np.ascontiguousarray(points[rows].T)
            ball, leaf = boxes_met(boxes, centres, distance[rows], any_value, np.zeros(len(rows)))
            if not len(ball):
                continue
            found = self._feet(points[rows[ball]], boxes.order[leaf])
            apart = np.linalg.norm(points[rows[ball]] - found, axis=1)
            order = np.lexsort((apart, ball))
            first = order[np.flatnonzero(np.diff(ball[order], prepend=-1))]
            first = first[apart[first] < distance[rows[ball[first]]]]
            feet[rows[ball[first]]] = found[first]

    def _feet(self, points, triangles):
        """The point of each of some triangles that is nearest to a point: ndarray of shape (k, 3), mm."""
        columns = np.ascontiguousarray(self._corners[triangles].transpose(2, 1, 0))
        weights = closest_weights(np.ascontiguousarray(points.T), columns)
        return np.einsum("kcn,cn->nk", columns, weights)

    @cached_property
    def _boxes(self):
        """A BoxTree, and values by which `boxes_met` leaves nothing out."""
        corners = np.ascontiguousarray(self._corners.transpose(2, 1, 0))
        tree = box_tree(corners, np.ascontiguousarray(self._mesh.normals.T), self._mesh.areas)
        return tree, least_of_nodes(tree, np.zeros(self._mesh.count))

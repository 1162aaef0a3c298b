# SPDX-License-Identifier: LGPL-2.1-or-later
"""The points of a mesh nearest to given points."""

import numpy as np
from scipy.spatial import cKDTree

from ..mesh.sampling import surface_samples
from ..rays.closest_points import closest_weights

SPREAD = 40_000
"""Points that are spread over the triangles, to find those that are near."""

NEAR = 12
"""Near spread points whose triangles are looked at."""

_AT_ONCE = 2048


class NearestOnMesh:
    """The triangles of a `SurfaceMesh`, among which the nearest points are looked for, in the coordinates of the mesh."""

    def __init__(self, mesh):
        self._corners = mesh.corners
        samples = surface_samples(mesh, SPREAD)
        self._triangle, self._tree = samples.triangle, cKDTree(samples.points)

    def nearest(self, points):
        """The points of the triangles nearest to points, both ndarray of shape (k, 3), mm."""
        feet = np.empty((len(points), 3))
        for start in range(0, len(points), _AT_ONCE):
            own = points[start:start + _AT_ONCE]
            near = self._triangle[self._tree.query(own, k=min(NEAR, len(self._triangle)))[1].reshape(len(own), -1)]
            corners = self._corners[near]
            columns = np.ascontiguousarray(corners.reshape(-1, 3, 3).transpose(2, 1, 0))
            weights = closest_weights(np.repeat(own.T, near.shape[1], axis=1), columns)
            found = np.einsum("kcn,cn->nk", columns, weights).reshape(len(own), -1, 3)
            away = own[:, None] - found
            nearest = np.einsum("knj,knj->kn", away, away).argmin(axis=1)
            feet[start:start + _AT_ONCE] = found[np.arange(len(own)), nearest]
        return feet

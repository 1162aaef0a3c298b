# SPDX-License-Identifier: LGPL-2.1-or-later
"""Find the facet of a thickness map that is nearest to a point or that a ray hits first."""

import numpy as np

_GROUP = 64
"""Consecutive facets that share a bounding box. Facets cut from one triangle are consecutive."""


class MapSearch:
    """Finds facets of a map. Build it once per map."""

    def __init__(self, thickness_map):
        self._map = thickness_map
        self._corners = thickness_map.points[thickness_map.facets]
        starts = np.arange(0, thickness_map.count, _GROUP)
        a, b, c = (self._corners[:, corner] for corner in range(3))
        low, high = np.minimum(np.minimum(a, b), c), np.maximum(np.maximum(a, b), c)
        self._low = np.minimum.reduceat(low, starts).astype(np.float64)
        self._high = np.maximum.reduceat(high, starts).astype(np.float64)

    def first_hit(self, eye, direction):
        """Find the facet that a ray hits first, from either side.

        Returns `facet` (int; -1 where it hits none) and `distance` (float; in units of `direction`; infinite where it hits
        none).

        Parameters
        ----------
        eye : ndarray of shape (3,), mm
            In the coordinates of the map.
        direction : ndarray of shape (3,)
        """
        eye = np.asarray(eye, dtype=np.float64) - self._map.origin
        direction = np.asarray(direction, dtype=np.float64)
        rows = self._rows(self._boxes_hit(eye, direction))
        corners = self._corners[rows].astype(np.float64)
        one, other = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
        across = np.cross(direction, other)
        volume = np.einsum("ij,ij->i", one, across)
        away = eye - corners[:, 0]
        beside = np.cross(away, one)
        with np.errstate(divide="ignore", invalid="ignore"):
            u = np.einsum("ij,ij->i", away, across) / volume
            v = beside @ direction / volume
            distance = np.einsum("ij,ij->i", other, beside) / volume
            slack = 1e-6  # so that no ray slips between two facets that share a side
            hit = (u >= -slack) & (v >= -slack) & (u + v <= 1.0 + slack) & (distance > 0.0)
        if not hit.any():
            return -1, np.inf
        nearest = np.flatnonzero(hit)[np.argmin(distance[hit])]
        return int(rows[nearest]), float(distance[nearest])

    def nearest_facet(self, point, reach):
        """Find the facet nearest to a point, no farther away than `reach` (mm); -1 for none."""
        point = np.asarray(point, dtype=np.float64) - self._map.origin
        off = np.maximum(np.maximum(self._low - point, point - self._high), 0.0)
        rows = self._rows(np.linalg.norm(off, axis=1) <= reach)
        if not len(rows):
            return -1
        distance = _distance(point, self._corners[rows].astype(np.float64))
        nearest = int(np.argmin(distance))
        return int(rows[nearest]) if distance[nearest] <= reach else -1

    def _boxes_hit(self, eye, direction):
        # Avoid division by zero: a ray in the plane of a box's side still hits the box.
        steep = np.where(np.abs(direction) > 1e-12, direction, 1e-12)
        enter, leave = (self._low - eye) / steep, (self._high - eye) / steep
        enter, leave = np.minimum(enter, leave).max(axis=1), np.maximum(enter, leave).min(axis=1)
        slack = 1e-6 * (np.abs(leave) + 1.0)
        return enter <= leave + slack

    def _rows(self, groups):
        rows = (np.flatnonzero(groups)[:, None] * _GROUP + np.arange(_GROUP)).ravel()
        return rows[rows < self._map.count]


def _distance(point, corners):
    """Distances of a point from triangles, ndarray of shape (k,)."""
    ends = np.roll(corners, -1, axis=1)
    along = ends - corners
    length = np.maximum(np.einsum("ijk,ijk->ij", along, along), np.finfo(float).tiny)
    share = np.clip(np.einsum("ijk,ijk->ij", point - corners, along) / length, 0.0, 1.0)
    to_sides = np.linalg.norm(corners + share[..., None] * along - point, axis=2).min(axis=1)
    normal = np.cross(along[:, 0], -along[:, 2])
    normal /= np.maximum(np.linalg.norm(normal, axis=1), np.finfo(float).tiny)[:, None]
    inside = np.einsum("ijk,ijk->ij", np.cross(along, point - corners), normal[:, None]) >= 0.0
    height = np.abs(np.einsum("ij,ij->i", point - corners[:, 0], normal))
    return np.where(inside.all(axis=1), height, to_sides)

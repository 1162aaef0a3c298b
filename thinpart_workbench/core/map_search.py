"""The facet of a thickness map that lies at a point or is first met by a line of sight."""

import numpy as np

_GROUP = 64
"""Facets that share a box. They follow each other, as those cut from one triangle do."""


class MapSearch:
    """Finds facets of a map; made once per map.

    Parameters
    ----------
    shown : ThicknessMap
    """

    def __init__(self, shown):
        self._map = shown
        self._corners = shown.points[shown.facets]
        starts = np.arange(0, shown.count, _GROUP)
        a, b, c = (self._corners[:, corner] for corner in range(3))
        low, high = np.minimum(np.minimum(a, b), c), np.maximum(np.maximum(a, b), c)
        self._low = np.minimum.reduceat(low, starts).astype(np.float64)
        self._high = np.maximum.reduceat(high, starts).astype(np.float64)

    def first_met(self, eye, direction):
        """The facet that a ray meets first, from either side.

        Parameters
        ----------
        eye : ndarray of shape (3,), mm
            In the coordinates of the map.
        direction : ndarray of shape (3,)

        Returns
        -------
        facet : int
            -1 where it meets none.
        distance : float
            In units of `direction`; infinite where it meets none.
        """
        eye = np.asarray(eye, dtype=np.float64) - self._map.origin
        direction = np.asarray(direction, dtype=np.float64)
        rows = self._rows(self._boxes_met(eye, direction))
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
            slack = 1e-6  # two facets have one side in common: no line passes between them
            met = (u >= -slack) & (v >= -slack) & (u + v <= 1.0 + slack) & (distance > 0.0)
        if not met.any():
            return -1, np.inf
        nearest = np.flatnonzero(met)[np.argmin(distance[met])]
        return int(rows[nearest]), float(distance[nearest])

    def at(self, point, reach):
        """The facet nearest to a point, no further away than `reach` (mm); -1 for none."""
        point = np.asarray(point, dtype=np.float64) - self._map.origin
        off = np.maximum(np.maximum(self._low - point, point - self._high), 0.0)
        rows = self._rows(np.linalg.norm(off, axis=1) <= reach)
        if not len(rows):
            return -1
        distance = _distance(point, self._corners[rows].astype(np.float64))
        nearest = int(np.argmin(distance))
        return int(rows[nearest]) if distance[nearest] <= reach else -1

    def _boxes_met(self, eye, direction):
        # Divided by almost nothing instead of by nothing: a ray in the plane of a box's side still meets it.
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

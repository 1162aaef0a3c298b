# SPDX-License-Identifier: LGPL-2.1-or-later
"""The point of a triangle that is closest to a given point."""

import numpy as np

from ..columns import dot


def closest_weights(points, corners):
    """Barycentric coordinates of the closest points of triangles: ndarray of shape (3, m).

    The regions are those of Ericson, Real-Time Collision Detection (2005), 5.1.5: inside, along a side, at a corner.

    Parameters
    ----------
    points : ndarray of shape (3, m), mm
    corners : ndarray of shape (3, 3, m), mm
        Coordinate, corner, triangle.
    """
    first = corners[:, 0]
    side_u, side_v, away = corners[:, 1] - first, corners[:, 2] - first, points - first
    uu, uv, vv = dot(side_u, side_u), dot(side_u, side_v), dot(side_v, side_v)
    pu, pv = dot(away, side_u), dot(away, side_v)
    determinant = np.maximum(uu * vv - uv * uv, np.finfo(float).tiny)
    u, v = (vv * pu - uv * pv) / determinant, (uu * pv - uv * pu) / determinant
    outside = np.flatnonzero((u < 0.0) | (v < 0.0) | (u + v > 1.0))
    if len(outside):
        u[outside], v[outside] = _on_sides(*(value[outside] for value in (uu, uv, vv, pu, pv)))
    return np.stack([1.0 - u - v, u, v])


def _on_sides(uu, uv, vv, pu, pv):
    """The second and third barycentric coordinate of the closest point of the three sides."""
    tiny = np.finfo(float).tiny
    along_u = np.clip(pu / np.maximum(uu, tiny), 0.0, 1.0)
    along_v = np.clip(pv / np.maximum(vv, tiny), 0.0, 1.0)
    opposite = np.maximum(uu - 2.0 * uv + vv, tiny)
    along = np.clip((pv - pu + uu - uv) / opposite, 0.0, 1.0)
    candidates_u = np.stack([along_u, np.zeros_like(along_u), 1.0 - along])
    candidates_v = np.stack([np.zeros_like(along_v), along_v, along])
    square = (candidates_u * candidates_u * uu + 2.0 * candidates_u * candidates_v * uv
              + candidates_v * candidates_v * vv - 2.0 * (candidates_u * pu + candidates_v * pv))
    nearest, rows = square.argmin(axis=0), np.arange(len(uu))
    return candidates_u[nearest, rows], candidates_v[nearest, rows]

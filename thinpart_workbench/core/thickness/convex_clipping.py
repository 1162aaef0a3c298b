# SPDX-License-Identifier: LGPL-2.1-or-later
"""Clip many convex polygons in the plane by half-planes together."""

import numpy as np


def clip(points, value):
    """Clip each polygon to where a linear function is not negative: ndarray of shape (m, k + 1, 2).

    Polygons of zero area where nothing is left.

    Sutherland and Hodgman (1974, doi:10.1145/360767.360802), one step for all polygons. A half-plane
    adds at most one corner to a convex polygon.

    Parameters
    ----------
    points : ndarray of shape (m, k, 2)
        Corners in order; a corner may be repeated.
    value : ndarray of shape (m, k)
        Values of the function at the corners.
    """
    count, corners = value.shape
    ahead, beyond = _ahead(points), _ahead(value)
    inside = value >= 0.0
    crossing = inside != (beyond >= 0.0)
    share = value / np.where(crossing, value - beyond, 1.0)
    slots = np.stack([points, points + share[:, :, None] * (ahead - points)], axis=2)
    slots = slots.reshape(count, 2 * corners, 2)
    used = np.stack([inside, crossing], axis=2).reshape(count, 2 * corners)
    rank = np.cumsum(used, axis=1)
    left = np.minimum(rank[:, -1:], corners + 1)
    used &= rank <= corners + 1
    clipped = np.zeros((count, corners + 1, 2))
    clipped[np.arange(corners + 1) < left] = slots[used]
    return np.where((np.arange(corners + 1) < left)[:, :, None], clipped, clipped[:, :1])


def areas(points):
    """ndarray of shape (m,): areas of convex polygons, ndarray of shape (m, k, 2)."""
    ahead = _ahead(points)
    doubled = points[..., 0] * ahead[..., 1] - points[..., 1] * ahead[..., 0]
    return 0.5 * np.abs(doubled.sum(axis=1))


def _ahead(corners):
    """The same of the next corner: `np.roll` is slow where there are few polygons."""
    return np.concatenate([corners[:, 1:], corners[:, :1]], axis=1)

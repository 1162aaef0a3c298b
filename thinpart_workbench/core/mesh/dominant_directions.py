# SPDX-License-Identifier: LGPL-2.1-or-later
"""Directions in which most of a surface faces."""

import numpy as np

_CELLS = 200
"""Cells per unit length into which normals are grouped: a cell is about a quarter of a degree wide."""


def dominant_directions(normals, areas, most):
    """Find unit directions by descending area; opposite normals count together.

    Returns an ndarray of shape (k, 3): they rotate with the part.

    Parameters
    ----------
    normals : ndarray of shape (n, 3)
    areas : ndarray of shape (n,)
    most : int
        Greatest number of directions.
    """
    side = np.where(normals @ np.array([1.0, 1e-3, 1e-6]) < 0.0, -1.0, 1.0)
    facing = normals * side[:, None]
    cell = np.round(facing * _CELLS).astype(np.int64)
    _, group = np.unique((cell[:, 0] * 1000 + cell[:, 1]) * 1000 + cell[:, 2], return_inverse=True)
    group = group.ravel()
    total = np.stack([np.bincount(group, facing[:, k] * areas) for k in range(3)], axis=1)
    weight = np.linalg.norm(total, axis=1)
    largest = np.argsort(-weight, kind="stable")[:most]
    return total[largest] / weight[largest, None]


def dominant_axes(normals, areas):
    """Find three perpendicular directions in which most of the surface faces: ndarray of shape (3, 3).

    Rows are unit vectors.

    Parameters
    ----------
    normals : ndarray of shape (n, 3)
    areas : ndarray of shape (n,)
    """
    candidates = dominant_directions(normals, areas, 50)
    first = candidates[0]
    across = candidates[np.abs(candidates @ first) < 0.05]
    second = across[0] if len(across) else np.eye(3)[np.abs(first).argmin()]
    second = second - first * (second @ first)
    second /= np.linalg.norm(second)
    return np.stack([first, second, np.cross(first, second)])

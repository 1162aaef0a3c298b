"""Boxes turned until they are smaller: the method of Nelder and Mead, for several boxes at once."""

import numpy as np
from scipy.spatial.transform import Rotation

STARTING_TURNS = (0.15, 0.005)
"""Radians, one search after the other: the second frees a simplex that collapsed beside an edge of
the function."""

STEPS = 90
SMALLEST_TURN = 1e-8
SMALLEST_GAIN = 1e-11


def refined_axes(points, axes):
    """Axes of boxes that are locally the smallest, near given ones.

    Parameters
    ----------
    points : ndarray of shape (v, 3), mm
    axes : ndarray of shape (k, 3, 3)
        Rows are the directions of a box's sides.

    Returns
    -------
    ndarray of shape (k, 3, 3)
        No box is larger than it was.

    Notes
    -----
    Nelder and Mead (1965, doi:10.1093/comjnl/7.4.308) with their coefficients, over rotation
    vectors. All boxes take each step together, so that a step costs two calls to numpy for all.
    """
    points = np.ascontiguousarray(points.T)
    for turn in STARTING_TURNS:
        axes = _search(points, axes, turn)
    return axes


def _search(points, axes, turn):
    def volumes(turns):
        return _volumes(points, _turned(axes, turns))

    each = np.arange(len(axes))
    simplex = np.zeros((len(axes), 4, 3))
    simplex[:, 1:] = turn * np.eye(3)
    found = np.stack([volumes(simplex[:, k]) for k in range(4)], axis=1)
    for _ in range(STEPS):
        order = np.argsort(found, axis=1, kind="stable")
        simplex, found = simplex[each[:, None], order], found[each[:, None], order]
        away = np.abs(simplex[:, 1:] - simplex[:, :1]).max(axis=(1, 2))
        rise = found[:, 3] - found[:, 0]
        if np.all((away <= SMALLEST_TURN) & (rise <= SMALLEST_GAIN * found[:, 0])):
            break
        middle = simplex[:, :3].mean(axis=1)
        outward = middle - simplex[:, 3]
        reflected = volumes(middle + outward)
        best, better = reflected < found[:, 0], reflected < found[:, 3]
        good = ~best & (reflected < found[:, 2])
        reach = np.select([best, good, better], [2.0, 1.0, 0.5], -0.5)
        tried = volumes(middle + reach[:, None] * outward)
        use_reflected = good | (best & (reflected <= tried))
        reach = np.where(use_reflected, 1.0, reach)
        tried = np.where(use_reflected, reflected, tried)
        taken = best | good | np.where(better, tried <= reflected, tried < found[:, 3])
        simplex[taken, 3] = (middle + reach[:, None] * outward)[taken]
        found[taken, 3] = tried[taken]
        if not taken.all():
            rest = np.flatnonzero(~taken)
            simplex[rest, 1:] = 0.5 * (simplex[rest, 1:] + simplex[rest, :1])
            shrunk = np.stack([volumes(simplex[:, k]) for k in range(1, 4)], axis=1)
            found[rest, 1:] = shrunk[rest]
    best = found.argmin(axis=1)
    return _turned(axes, simplex[each, best])


def _turned(axes, turns):
    return axes @ Rotation.from_rotvec(turns).as_matrix()


def _volumes(points, axes):
    """Volumes of the boxes along axes of shape (k, 3, 3) around points of shape (3, v)."""
    along = axes.reshape(-1, 3) @ points
    extents = along.max(axis=1) - along.min(axis=1)
    return extents.reshape(-1, 3).prod(axis=1)

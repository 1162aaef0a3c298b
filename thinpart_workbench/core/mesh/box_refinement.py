# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rotate boxes to make them smaller: the method of Nelder and Mead, for several boxes at once."""

import numpy as np
from scipy.spatial.transform import Rotation

STARTING_TURNS = (0.15, 0.005)
"""Radians, for one search after the other. The second search frees a simplex that collapsed at a crease of the
function."""

STEPS = 90
SMALLEST_TURN = 1e-8
SMALLEST_GAIN = 1e-11

PROBED_TURNS = (1e-3, 1e-2, 0.1)
"""Radians by which boxes are turned in many directions, to see which of them are minima: most are, if sides are flat."""

PROBES = 160
LEAST_GAIN = 1e-9
"""Share of its volume by which a turned box has to be smaller to count."""

SAME_BASIN = 0.05
"""Radians: a box that is turned by less from a smaller one is not refined as well."""


def refined_axes(points, axes):
    """Find the axes of boxes that are locally the smallest, near given ones: ndarray of shape (k, 3, 3).

    No box is larger than the given one. Those that no probe makes smaller are returned as they are.

    Nelder and Mead (1965, doi:10.1093/comjnl/7.4.308) with their coefficients, over rotation vectors. All boxes are
    refined together, so that a step costs two numpy calls for all of them.

    Parameters
    ----------
    points : ndarray of shape (v, 3), mm
    axes : ndarray of shape (k, 3, 3)
        Rows are the directions of a box's sides.
    """
    points = np.ascontiguousarray(points.T)
    axes = axes.copy()
    improvable = np.flatnonzero(~_are_minima(points, axes))
    if len(improvable):
        refined = axes[improvable]
        for turn in STARTING_TURNS:
            refined = _search(points, refined, turn)
        axes[improvable] = refined
    return axes


def distinct(axes):
    """Indices of boxes, the smallest first, that are not nearly turned like an earlier one.

    Parameters
    ----------
    axes : ndarray of shape (k, 3, 3)
        Rows are the directions of a box's sides, in any order.
    """
    chosen: list[int] = []
    for k, own in enumerate(axes):
        # Each direction of a box is near one of the other's, whichever way round, if their boxes are alike.
        cosines = np.abs(axes[chosen] @ own.T).max(axis=2).min(axis=1)
        if (cosines < np.cos(SAME_BASIN)).all():
            chosen.append(k)
    return chosen


def _are_minima(points, axes):
    turns = (np.array(PROBED_TURNS)[:, None, None] * spread_directions(PROBES)).reshape(-1, 3)
    turned = _rotated(axes[:, None], turns)
    least = _volumes(points, turned.reshape(-1, 3, 3)).reshape(len(axes), -1).min(axis=1)
    return least >= (1.0 - LEAST_GAIN) * _volumes(points, axes)


def _search(points, axes, turn):
    def volumes(turns):
        return _volumes(points, _rotated(axes, turns))

    rows = np.arange(len(axes))
    simplex = np.zeros((len(axes), 4, 3))
    simplex[:, 1:] = turn * np.eye(3)
    values = np.stack([volumes(simplex[:, k]) for k in range(4)], axis=1)
    for _ in range(STEPS):
        order = np.argsort(values, axis=1, kind="stable")
        simplex, values = simplex[rows[:, None], order], values[rows[:, None], order]
        away = np.abs(simplex[:, 1:] - simplex[:, :1]).max(axis=(1, 2))
        rise = values[:, 3] - values[:, 0]
        if np.all((away <= SMALLEST_TURN) & (rise <= SMALLEST_GAIN * values[:, 0])):
            break
        middle = simplex[:, :3].mean(axis=1)
        outward = middle - simplex[:, 3]
        reflected = volumes(middle + outward)
        best, better = reflected < values[:, 0], reflected < values[:, 3]
        good = ~best & (reflected < values[:, 2])
        reach = np.where(best, 2.0, np.where(good, 1.0, np.where(better, 0.5, -0.5)))
        tried = volumes(middle + reach[:, None] * outward)
        use_reflected = good | (best & (reflected <= tried))
        reach = np.where(use_reflected, 1.0, reach)
        tried = np.where(use_reflected, reflected, tried)
        accepted = best | good | np.where(better, tried <= reflected, tried < values[:, 3])
        simplex[accepted, 3] = (middle + reach[:, None] * outward)[accepted]
        values[accepted, 3] = tried[accepted]
        if not accepted.all():
            rest = np.flatnonzero(~accepted)
            simplex[rest, 1:] = 0.5 * (simplex[rest, 1:] + simplex[rest, :1])
            shrunk = np.stack([volumes(simplex[:, k]) for k in range(1, 4)], axis=1)
            values[rest, 1:] = shrunk[rest]
    best = values.argmin(axis=1)
    return _rotated(axes, simplex[rows, best])


def _rotated(axes, turns):
    return axes @ Rotation.from_rotvec(turns).as_matrix()


def _volumes(points, axes):
    """Volumes of the boxes along axes of shape (k, 3, 3) around points of shape (3, v)."""
    along = axes.reshape(-1, 3) @ points
    extents = along.max(axis=1) - along.min(axis=1)
    return extents.reshape(-1, 3).prod(axis=1)


def spread_directions(count):
    """Fibonacci lattice on the sphere, ndarray of shape (count, 3)."""
    index = np.arange(count) + 0.5
    polar = np.arccos(1.0 - 2.0 * index / count)
    turn = np.pi * (1.0 + 5.0 ** 0.5) * index
    return np.stack(
        [np.cos(turn) * np.sin(polar), np.sin(turn) * np.sin(polar), np.cos(polar)], axis=1
    )

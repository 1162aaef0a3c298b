# SPDX-License-Identifier: LGPL-2.1-or-later
"""How one form is laid upon another: turns that may do it, and the motion that does it best."""

import numpy as np

from .form import NORMAL_SPACINGS
from .motion import turn_by

EQUAL_RADII = 0.02
"""Radii of gyration that differ by less, as a share, do not say how a form is turned about the third axis."""

TURNS = 72
"""Turns about such an axis that are tried, from 0 to 180 degrees: the others follow from `_FLIPS`."""

ALL_AROUND = 1024
"""Turns that are tried where all radii are equal: some 15 degrees apart."""

APART = np.radians(8.0)
"""Turns that are less apart lead to one and the same motion."""

NEAREST = 16
"""Points of the other outline among which the partner of a point is chosen."""

LIKE_NORMALS = 0.5
"""Cosine of the angle up to which normals belong to one and the same place of two surfaces."""

REACH = 3.0
"""Spacings up to which a point of the other outline says where its surface is."""

ALONG = 0.005
"""What a distance along the surface counts beside one across it, for the choice of a partner."""

MOST_SKEW = 0.02
"""Difference of the third moments up to which two forms may be the same, as a share of the cube of the greatest radius."""

MOST_AWAY = 2.0
"""Spacings of an outline from which points of the same form, laid upon it as near as turns are tried, are in the mean."""

LEAST_FITTED = 6
"""Points without which no motion is fitted: a motion has as many freedoms."""

STILL = 1e-6
"""A motion that changes by less, as a share of the extent, is as near as it comes."""

_FIRST_POINTS, _TRIED_TURNS = 16, 256
_TRIED_POINTS = 96
_AXES_BESIDE = np.radians(3.0)  # where radii differ little, triangles of another fineness turn the axes
_ORDERS = np.array([np.eye(3)[list(order)] * [1.0, 1.0, sign] for order, sign in (
    ((0, 1, 2), 1), ((1, 2, 0), 1), ((2, 0, 1), 1), ((0, 2, 1), -1), ((2, 1, 0), -1), ((1, 0, 2), -1))])
_FLIPS = np.array([(1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1)], dtype=float)


def likely_turns(form, other, scale, is_mirrored, count, any_axes=False, whole=False):
    """Turns that lay the principal axes of a form upon those of another, the likeliest first.

    Returns an ndarray of shape (count at most, 3, 3). Where two radii of gyration are equal, all turns about the third axis
    are tried, and where all are, all turns. They are compared by the third moments and the distances of some points.

    Parameters
    ----------
    form, other : Form
    scale : float
        Factor by which the form is scaled.
    is_mirrored : bool
        Whether the form is mirrored besides.
    count : int
    any_axes : bool, optional
        Whether each axis may come upon each: that of a plate may be the longest of one and the second of a shorter one.
    whole : bool, optional
        Whether the forms are the same: turns after which their third moments or points differ are left out.
    """
    axes = _right_handed(form.axes) * np.array([1.0, 1.0, -1.0 if is_mirrored else 1.0])
    orders = _ORDERS if any_axes else _ORDERS[:1]
    upon, step = _turned_axes(other)
    turns = np.concatenate([np.einsum("ij,fj,kj->fik", turned, _FLIPS, axes @ order.T)
                            for turned in upon for order in orders])
    skew = np.abs(scale ** 3 * _turned_third(form, turns) - other.moments.third).max(axis=(1, 2, 3)) / other.radii[0] ** 3
    if whole:
        # A turn by a small angle changes no third moment by more than three times as much.
        is_likely = skew <= MOST_SKEW + 3.0 * step * np.abs(other.moments.third).max() / other.radii[0] ** 3
        turns, skew = turns[is_likely], skew[is_likely]
        if not len(turns):
            return turns
    if len(turns) > _TRIED_TURNS:
        best = np.argsort(_away(form.thinned(_FIRST_POINTS), other, scale, turns), kind="stable")[:_TRIED_TURNS]
        turns, skew = turns[best], skew[best]
    away = _away(form.thinned(_TRIED_POINTS), other, scale, turns)
    if whole:
        is_near = away <= (MOST_AWAY * other.normal_length / NORMAL_SPACINGS + step * other.radii[0]) / other.extent
        turns, away, skew = turns[is_near], away[is_near], skew[is_near]
    return _apart(turns[np.argsort(away + skew, kind="stable")], count)


def _away(form, other, scale, turns):
    """Mean distance of the points of a form from those of another, by its extent, after each turn: ndarray of shape (r,)."""
    few = form.outline
    moved = np.einsum("rij,pj->rpi", turns, np.hstack([scale * few.points, few.normals]).reshape(-1, 3))
    moved = moved.reshape(len(turns), -1, 6) * np.repeat([1.0, other.normal_length], 3)
    distance = other.directed_tree.query(moved.reshape(-1, 6))[0].reshape(len(turns), -1)
    return distance.mean(axis=1) / other.extent


def _apart(turns, count):
    """The first of some turns, without those that are less than `APART` from one before them."""
    chosen: list = []
    for turn in turns:
        if all(np.trace(turn.T @ other) < 1.0 + 2.0 * np.cos(APART) for other in chosen):
            chosen.append(turn)
            if len(chosen) == count:
                break
    return np.array(chosen)


def partners(form, other, motion):
    """For each point of a form, laid upon another: how far the surface of that lies there, and which of its points says so.

    Between two points with normals, the distance is taken along the mean of the normals: so it is exact where both lie on
    one plane, cylinder or sphere (Rusinkiewicz 2019, doi:10.1145/3306346.3323037).

    Returns
    -------
    distance : ndarray of shape (k,), mm
        Signed; inf where the other surface has nothing like it near by.
    partner : ndarray of shape (k,), int64
        The likest point of the other outline, also where that is far away.
    """
    points, normals = motion.points(form.outline.points), motion.directions(form.outline.normals)
    near = other.directed_tree.query(
        np.hstack([points, other.normal_length * normals]), k=min(NEAREST, other.outline.count))[1].reshape(len(points), -1)
    between, other_normals = points[:, None] - other.outline.points[near], other.outline.normals[near]
    away = np.sqrt(np.einsum("knj,knj->kn", between, between))
    mean = normals[:, None] + other_normals
    length = np.sqrt(np.einsum("knj,knj->kn", mean, mean))
    across = np.einsum("knj,knj->kn", between, mean) / np.where(length > 0.0, length, 1.0)
    is_like = np.einsum("kj,knj->kn", normals, other_normals) > LIKE_NORMALS
    is_like &= away <= REACH * (motion.scale * form.outline.spacing[:, None] + other.outline.spacing[near])
    best = np.where(is_like, np.abs(across) + ALONG * away, np.inf).argmin(axis=1)
    rows = np.arange(len(points))
    return np.where(is_like[rows, best], across[rows, best], np.inf), near[rows, best]


def fitted(form, other, motion, limits, steps=3):
    """A motion brought nearer to the best by least squares, in a few steps for each limit: `Motion`.

    Parameters
    ----------
    limits : sequence of float, mm
        Descending. Points that lie farther from the other surface do not count: what only one of the two has must not draw
        the rest.
    """
    for limit in limits:
        for _ in range(steps):
            distance, partner = partners(form, other, motion)
            away = np.abs(distance)
            used = np.flatnonzero(away <= limit)
            if len(used) < LEAST_FITTED:
                break
            points = motion.points(form.outline.points[used])
            normals = motion.directions(form.outline.normals[used]) + other.outline.normals[partner[used]]
            normals /= np.linalg.norm(normals, axis=1)[:, None]
            before, motion = motion, motion.nearer(points, distance[used], normals, form.outline.area[used])
            moved = np.abs(motion.turn - before.turn).max() * other.extent + np.abs(motion.shift - before.shift).max()
            # Where all points are within the last limit, the others count the same.
            if moved <= STILL * other.extent or away.max() <= limits[-1] < limit:
                break
    return motion


def _right_handed(axes):
    return axes * np.array([1.0, 1.0, np.sign(np.linalg.det(axes))])


def _turned_third(form, turns):
    third = np.einsum("ria,abc->ribc", turns, form.moments.third)
    third = np.einsum("rjb,ribc->rijc", turns, third)
    return np.einsum("rkc,rijc->rijk", turns, third)


def _turned_axes(form):
    """The principal axes of a form, and those that its radii do not tell from them.

    Returns an ndarray of shape (n, 3, 3), and the angle in radians by which the best of them may be beside the true ones.
    """
    axes, radii = _right_handed(form.axes), form.radii
    first, last = (radii[k] - radii[k + 1] <= EQUAL_RADII * radii[k] for k in range(2))
    if first and last:
        return axes @ _all_around(), np.radians(15.0)
    if first or last:
        vector = np.eye(3)[2 if first else 0]
        return np.array([axes @ turn_by(vector * angle) for angle in np.arange(TURNS) * (np.pi / TURNS)]), np.pi / TURNS
    return axes[None], _AXES_BESIDE


def _all_around():
    """Turns all around: ndarray of shape (ALL_AROUND, 3, 3), on a super-Fibonacci spiral (Alexa 2022,
    doi:10.1109/CVPR52688.2022.00811)."""
    index = np.arange(ALL_AROUND) + 0.5
    near, far = np.sqrt(index / ALL_AROUND), np.sqrt(1.0 - index / ALL_AROUND)
    first, second = 2.0 * np.pi * index / np.sqrt(2.0), 2.0 * np.pi * index / 1.533751168755204288
    x, y, z, w = near * np.sin(first), near * np.cos(first), far * np.sin(second), far * np.cos(second)
    rows = [[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]]
    return np.moveaxis(np.array(rows), 2, 0)

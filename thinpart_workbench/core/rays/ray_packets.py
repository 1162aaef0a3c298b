# SPDX-License-Identifier: LGPL-2.1-or-later
"""Packets of rays with similar origins and directions, which can descend a tree as one thick ray."""

from dataclasses import dataclass

import numpy as np

from .space_filling_curve import hilbert_index

PACKET = 8
"""Rays per packet."""

MOST_DIVERGENCE = 3.0
"""A packet that becomes wider than this many times the spread of its origins is cast ray by ray."""


def coherent_order(origins, directions):
    """Compute an order in which neighbouring rays have similar origins and directions: ndarray of shape (m,), int64.

    Both sides of a thin wall are in one cell of the curve. Therefore rays are sorted by the side of the cube that they
    point to first, and along the curve within that.

    Parameters
    ----------
    origins : ndarray of shape (3, m), mm
    directions : ndarray of shape (3, m)
    """
    return np.argsort(hilbert_index(origins) | side_of_cube(directions), kind="stable")


def side_of_cube(directions):
    """Side of a cube that each direction, shape (3, m), points to, in the bits above `hilbert_index`: shape (m,), uint64.

    Returns an ndarray of shape (m,), uint64.
    """
    steepness = np.abs(directions)
    axis = np.where(steepness[1] > steepness[0], 1, 0)
    axis = np.where(steepness[2] > np.maximum(steepness[0], steepness[1]), 2, axis)
    forward = np.choose(axis, directions) > 0.0
    return (2 * axis + forward).astype(np.uint64) << np.uint64(30)


@dataclass(frozen=True)
class ThickRays:
    """Packets of rays, each enclosed in one thick ray.

    Attributes
    ----------
    rows : ndarray of shape (10, p), float32
        Data for the test of a box: middle of the origins plus the reach, middle minus the reach, inverse of the
        direction of the axis, limit.
    axis : ndarray of shape (3, p), float32
        Direction of the axis.
    spread : ndarray of shape (p,), float32
        Upper bound of the difference between a direction of the packet and the axis, summed over the coordinates.
    divergent : ndarray of shape (p,), bool
        Packets that are so wide at their limit that casting their rays one by one is faster.
    """

    rows: np.ndarray
    axis: np.ndarray
    spread: np.ndarray
    divergent: np.ndarray


def thick_rays(origins, directions, limit, extent):
    """Enclose packets in thick rays: ThickRays.

    If any ray of the packet hits a box, the axis hits the box enlarged by the reach, because the distance of a ray from
    the axis at equal parameters is greatest at one of the ends.

    Parameters
    ----------
    origins, directions : ndarray of shape (3, k, p), float32
    limit : ndarray of shape (p,), float32, mm
        Length of the rays of each packet.
    extent : float, mm
        Size of the scene, to which rounding is proportional.
    """
    low, high = origins.min(axis=1), origins.max(axis=1)
    slow, fast = directions.min(axis=1), directions.max(axis=1)
    half = np.float32(0.5)
    middle, axis = (low + high) * half, (slow + fast) * half
    from_middle, from_axis = (high - low) * half, (fast - slow) * half
    reach = from_middle.copy()
    if from_axis.any():
        away = (origins - middle[:, None]) + (directions - axis[:, None]) * limit
        np.maximum(reach, np.abs(away, out=away).max(axis=1), out=reach)
    divergent = from_axis.max(axis=0) * limit > np.float32(MOST_DIVERGENCE) * from_middle.max(axis=0)
    reach = reach * np.float32(1.0 + 1e-5) + np.float32(1e-6 * extent)
    tiny = np.float32(1e-9)
    inverse = np.float32(1.0) / np.where(np.abs(axis) < tiny, tiny, axis)
    rows = np.concatenate([middle + reach, middle - reach, inverse, limit[None]])
    return ThickRays(rows, axis, from_axis.sum(axis=0) + np.float32(1e-4), divergent)

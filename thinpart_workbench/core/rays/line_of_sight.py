# SPDX-License-Identifier: LGPL-2.1-or-later
"""From where a place on a surface is seen: lines of sight that nothing blocks."""

from dataclasses import dataclass

import numpy as np

from ..columns import cross, dot
from .box_tree import box_tree
from .ray_casting import INNER, OUTER, first_hits, first_hits_within

_TILTS = np.radians([50.0, 40.0, 60.0, 30.0, 70.0, 20.0, 10.0, 78.0, 3.0])
"""Angles between a line of sight and the outward normal, the best first: at 50 degrees one sees the outer side of a wall and
most of the line through it. The last ones look into deep holes and under flanges."""

_AZIMUTHS = 36
"""Lines of sight around the normal at each of these angles."""

_STEEPER, _TURNED, _ALONE = 1.0, 0.5, 0.6
"""What a radian of tilt from the best one, half a turn from the present direction, and a blocked neighbour count for in the
choice among free lines of sight."""

_OFF_SURFACE = 1e-5
"""How far off the surface a line of sight begins, as a share of the extent of the scene; at most `_OF_WALL` of the wall."""

_OF_WALL = 0.05

_MESH_ERROR = 0.6
"""The drawn surface is looked for up to this share of the wall from its middle outward beyond half of it."""


@dataclass(frozen=True)
class Sight:
    """How to look at a wall.

    Attributes
    ----------
    target, other : ndarray of shape (3,), mm
        The end of the wall that is looked at, on the drawn surface, and its other end.
    direction : ndarray of shape (3,)
        Unit vector from the eye to the target.
    is_free : bool
        Whether nothing lies between.
    cost : float
        The less, the better it is seen; infinite where it is not.
    """

    target: np.ndarray
    other: np.ndarray
    direction: np.ndarray
    is_free: bool
    cost: float


class Scene:
    """Triangles that may stand before a place.

    Parameters
    ----------
    corners : ndarray of shape (n, 3, 3), mm
        Triangle, corner, coordinate; of either orientation.
    """

    def __init__(self, corners):
        low, high = (corners.reshape(-1, 3).min(axis=0), corners.reshape(-1, 3).max(axis=0)) if len(corners) else (
            np.zeros(3), np.zeros(3))
        self._origin, self._half = 0.5 * (low + high), 0.5 * (high - low)
        columns = np.ascontiguousarray((corners - self._origin).transpose(2, 1, 0))
        vectors = cross(columns[:, 1] - columns[:, 0], columns[:, 2] - columns[:, 0])
        double = np.sqrt(dot(vectors, vectors))
        # Flat triangles hide nothing, and have no normal.
        kept = double > 1e-12 * float(np.linalg.norm(high - low)) ** 2
        self._tree = None
        if kept.any():
            self._tree = box_tree(
                np.ascontiguousarray(columns[:, :, kept]), vectors[:, kept] / double[kept], 0.5 * double[kept])

    @property
    def extent(self):
        """float, mm: diagonal of the box of all triangles; 0 for none."""
        return 0.0 if self._tree is None else self._tree.extent

    def distances(self, start, directions):
        """Distance from a point to what lines meet first, on either side of it.

        Returns an ndarray of shape (m,), mm: inf where they meet nothing.

        Parameters
        ----------
        start : ndarray of shape (3,), mm
        directions : ndarray of shape (m, 3)
            Unit vectors.
        """
        if self._tree is None:
            return np.full(len(directions), np.inf)
        origins = np.repeat((start - self._origin)[:, None], len(directions), axis=1)
        columns = np.ascontiguousarray(directions.T, dtype=float)
        return np.minimum(*(first_hits(self._tree, origins, columns, side)[0] for side in (INNER, OUTER)))

    def distances_within(self, starts, directions, limits, side=INNER):
        """Distance from points to what lines meet first from one side, as far as a limit: ndarray of shape (m,), mm.

        The limit where they meet nothing before.

        Parameters
        ----------
        starts : ndarray of shape (m, 3), mm
        directions : ndarray of shape (m, 3)
            Unit vectors.
        limits : ndarray of shape (m,), mm
        side : float
            `INNER`, which a line out of the material meets, or `OUTER`.
        """
        if self._tree is None:
            return limits
        starts = starts - self._origin
        # Rays are followed as far as the scene extends: from where they enter its box.
        steep = np.where(np.abs(directions) > 1e-12, directions, 1e-12)
        entry = (np.minimum((-self._half - starts) / steep, (self._half - starts) / steep)).max(axis=1)
        entry = np.maximum(entry - 1e-3 * self.extent, 0.0)
        origins = np.ascontiguousarray((starts + entry[:, None] * directions).T)
        columns = np.ascontiguousarray(directions.T, dtype=float)
        distance, _ = first_hits_within(self._tree, origins, columns, np.maximum(limits - entry, 0.0), side)
        return np.minimum(distance + entry, limits)


def best_sight(scene, walls, current):
    """Choose the end of a wall and the direction in which it is seen best: Sight.

    Of the first wall from its first end if it is hidden from everywhere.

    Parameters
    ----------
    scene : Scene
        What is drawn.
    walls : list of (ndarray of shape (3,), ndarray of shape (3,)), mm
        Ends of the wall, at every place where it stands; the first one is preferred.
    current : ndarray of shape (3,)
        Direction in which the view looks now: of like directions, the nearest is chosen.
    """
    found = []
    for point, opposite in walls:
        found += [_sight(scene, np.asarray(target, dtype=float), np.asarray(other, dtype=float), current)
                  for target, other in ((point, opposite), (opposite, point))]
        if any(sight.is_free for sight in found):
            break
    return min(found, key=lambda sight: sight.cost)


def _sight(scene, target, other, current):
    across = target - other
    thickness = float(np.linalg.norm(across))
    outward = across / thickness if thickness else -current
    target = _on_drawn_surface(scene, target, outward, thickness)
    start = target + min(_OFF_SURFACE * scene.extent, _OF_WALL * thickness) * outward
    lines = _lines(outward, current)
    flat = lines.reshape(-1, 3)
    free = ~np.isfinite(scene.distances(start, flat).reshape(lines.shape[:2]))
    alone = 0.5 * (~np.roll(free, 1, axis=1)).astype(float) + 0.5 * ~np.roll(free, -1, axis=1)
    turned = np.arccos(np.clip(-(lines @ current), -1.0, 1.0)) / np.pi
    cost = _STEEPER * np.abs(_TILTS - _TILTS[0])[:, None] + _TURNED * turned + _ALONE * alone
    cost = np.where(free, cost, np.inf)
    row, column = np.unravel_index(np.argmin(cost), cost.shape) if free.any() else (0, 0)
    return Sight(target, other, -lines[row, column], bool(free.any()), float(cost[row, column]))


def _lines(outward, current):
    """Unit vectors from a place towards the eye, the first ones nearest to the present view: ndarray of shape (t, a, 3)."""
    side = -current + (current @ outward) * outward
    if np.linalg.norm(side) < 1e-3:
        side = np.cross(outward, np.eye(3)[np.argmin(np.abs(outward))])
    side /= np.linalg.norm(side)
    azimuth = 2.0 * np.pi * np.arange(_AZIMUTHS) / _AZIMUTHS
    around = np.outer(np.cos(azimuth), side) + np.outer(np.sin(azimuth), np.cross(outward, side))
    return np.cos(_TILTS)[:, None, None] * outward + np.sin(_TILTS)[:, None, None] * around


def _on_drawn_surface(scene, target, outward, thickness):
    """The place of the drawn surface that stands for a point of the exact one, which may lie under it."""
    half = 0.5 * thickness
    found = float(scene.distances(target - half * outward, outward[None])[0])
    return target + (found - half) * outward if abs(found - half) <= _MESH_ERROR * half else target

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pieces of triangles over other triangles that stand at an angle to them, with their distances."""

from dataclasses import dataclass

import numpy as np

from ..descriptors.descriptor_table import STATED_ANGLES
from ..mesh.sampling import SurfaceSamples
from ..mesh.smooth_normals import normals_at
from ..tolerances import TOLERANCES
from .convex_clipping import areas, clip

_BANDS, _LEAST_FACING = 8, 1e-3
_CERTAIN, _HALVED_EVERY = 1e-9, 6


@dataclass(frozen=True)
class SlantedPieces:
    """Pieces of triangles, each over one other triangle, as triangles of their own.

    Attributes
    ----------
    distance : ndarray of shape (m, 3), mm
        Distance of the corners from the other triangle, ascending; linear in between.
    area : ndarray of shape (m,), mm2
    """

    distance: np.ndarray
    area: np.ndarray

    @classmethod
    def none(cls):
        """No piece."""
        return cls(np.empty((0, 3)), np.empty(0))

    @classmethod
    def of(cls, points, distance):
        """Convex polygons, ndarray of shape (k, c, 2), with the distances of their corners, shape (k, c), mm."""
        ahead = points - points[:, :1]
        start = np.broadcast_to(distance[:, :1], distance[:, 2:].shape)
        corners = np.stack([start, distance[:, 1:-1], distance[:, 2:]], axis=2)
        spanned = ahead[:, 1:-1, 0] * ahead[:, 2:, 1] - ahead[:, 1:-1, 1] * ahead[:, 2:, 0]
        area = 0.5 * np.abs(spanned).ravel()
        left = np.flatnonzero(area > 0.0)
        return cls(np.sort(corners.reshape(-1, 3)[left], axis=1), area[left])

    def and_those(self, other):
        """These pieces and those of another `SlantedPieces`."""
        return SlantedPieces(np.concatenate([self.distance, other.distance]), np.concatenate([self.area, other.area]))

    def area_below(self, level):
        """float, mm2: area over walls nearer than a level, mm."""
        nearest, middle, farthest = self.distance.T
        share = (farthest <= level).astype(float)
        # What a level cuts off a triangle, at its nearest or at its farthest corner, is a triangle itself.
        near = np.flatnonzero((nearest < level) & (level <= middle) & (level < farthest))
        share[near] = (level - nearest[near]) ** 2 / ((middle[near] - nearest[near]) * (farthest[near] - nearest[near]))
        far = np.flatnonzero((middle < level) & (level < farthest))
        share[far] = 1.0 - (farthest[far] - level) ** 2 / ((farthest[far] - middle[far]) * (farthest[far] - nearest[far]))
        return float((share * self.area).sum())

    def distance_of(self, target):
        """float, mm: distance under which an area, mm2, lies; it must not exceed the total area."""
        nearest, farthest = self.distance[:, 0], self.distance[:, 2]
        # At least as far as if all pieces were nowhere farther than where they are nearest, and the other way round.
        low, high = _reached(nearest, self.area, target), _reached(farthest, self.area, target)
        below = farthest <= low
        across = ~below & (nearest < high)
        known = float(self.area[below].sum())
        others = SlantedPieces(self.distance[across], self.area[across])
        if known + others.area_below(low) >= target or low == high:
            return low
        return _zero(lambda level: known + others.area_below(level) - target, low, high)


def _zero(increasing, low, high):
    """float: where a function is 0 that is negative at a low argument and not at a high one, both above 0.

    By false position after Anderson and Björck (1973, doi:10.1007/BF01951936), and halving now and then, which ends also
    where the function jumps. Importing scipy's `brentq` takes as long as measuring a small part.
    """
    below, above, last, steps = increasing(low), increasing(high), 0.0, 0
    while high - low > _CERTAIN * high:
        steps += 1
        # Never nearer to an end than that, so that the other end follows.
        least = 0.5 * _CERTAIN * high
        share = -below / (above - below) if steps % _HALVED_EVERY else 0.5
        between = min(max(low + share * (high - low), low + least), high - least)
        value = increasing(between)
        if value < 0.0:
            above *= _kept(value / below) if last < 0.0 else 1.0
            low, below = between, value
        else:
            below *= _kept(value / above) if last > 0.0 and above > 0.0 else 1.0
            high, above = between, value
        last = value
    return float(high)


def _kept(share):
    """What the value at the end that stays is multiplied by, when the other one has come to a share of its value: float."""
    return 1.0 - share if share < 1.0 else 0.5


def _reached(value, area, target):
    """float: the value at which an area is reached, in ascending order."""
    order = np.argsort(value, kind="stable")
    return float(value[order[min(np.searchsorted(np.cumsum(area[order]), target), len(order) - 1)]])


@dataclass(frozen=True)
class Overlaps:
    """Parts of triangles that lie over another triangle, whatever lies between.

    Attributes
    ----------
    first, second : ndarray of shape (m,), int64
        Triangles.
    points : ndarray of shape (m, 6, 2), mm
        Polygons in the planes of the first triangles; corners may be repeated.
    slope : ndarray of shape (m, 2)
    level : ndarray of shape (m,), mm
        The distance of a point p from the second triangle is slope.p + level.
    nearest : ndarray of shape (m,), mm
        Least distance; negative where the triangles cross.
    """

    first: np.ndarray
    second: np.ndarray
    points: np.ndarray
    slope: np.ndarray
    level: np.ndarray
    nearest: np.ndarray

    @property
    def count(self):
        """Number of overlaps."""
        return len(self.first)

    def chosen(self, which):
        """Those of a mask or of indices."""
        return Overlaps(*(getattr(self, name)[which] for name in self.__dataclass_fields__))

    def and_those(self, other):
        """These and those of another `Overlaps`."""
        return Overlaps(*(np.concatenate([getattr(self, name), getattr(other, name)]) for name in self.__dataclass_fields__))


def least_distances(mesh, first, second):
    """Lower bounds of the distances of triangles from others below them: ndarray of shape (k,), mm.

    Over the overlap, distance is linear, and so nowhere less than at all corners of the first.
    """
    away, normals = mesh.corners[first] - mesh.corners[second, :1], mesh.normals[second]
    facing = np.einsum("ij,ij->i", mesh.normals[first], normals)
    least = np.einsum("ikj,ij->ik", away, normals).max(axis=1) / np.minimum(facing, -_LEAST_FACING)
    return np.where(facing < -_LEAST_FACING, least, 0.0)


def overlaps(mesh, first, second, limit):
    """Cut out the parts of triangles over others: Overlaps.

    Parameters
    ----------
    mesh : SurfaceMesh
    first, second : ndarray of shape (k,), int64
        Pairs of triangles.
    limit : float, mm
        Only what is nearer counts.
    """
    corner, along, across = _plane_of(mesh, first)
    own = _in_plane(mesh.corners[first], corner, along, across)
    other = _in_plane(mesh.corners[second], corner, along, across)
    points, over = _overlaps(own, other)
    first, second = first[over], second[over]
    slope, level = _linear(other[over], _depths(mesh, first, second))
    distance = _evaluate(slope, level, points)
    found = Overlaps(first, second, points, slope, level, distance.min(axis=1))
    # Triangles that only touch have, apart from rounding, no region in common.
    return found.chosen((found.nearest < limit) & (distance.max(axis=1) > TOLERANCES.self_hit * mesh.extent))


def slanted_pieces(mesh, rays, over, limit):
    """Cut overlaps into pieces, and choose those that count: SlantedPieces.

    Without those whose centre does not see the other triangle, or not at `STATED_ANGLES`.

    Parameters
    ----------
    mesh : SurfaceMesh
    rays : InwardRays
        Rays over that mesh.
    over : Overlaps
    limit : float, mm
        Only what is nearer counts.
    """
    points, which = _banded(over.points, over.slope, over.level, limit)
    distance = np.minimum(np.maximum(_evaluate(over.slope[which], over.level[which], points), 0.0), limit)
    first, second = over.first[which], over.second[which]
    middle, reach = points.mean(axis=1), distance.mean(axis=1)
    corner, along, across = _plane_of(mesh, first)
    centre = corner + middle[:, :1] * along + middle[:, 1:] * across
    counts = _is_slanted(mesh, first, second, centre, reach)
    counts = np.flatnonzero(counts)
    counts = counts[~rays.is_hidden(SurfaceSamples(centre[counts], first[counts], np.zeros(len(counts))), reach[counts])]
    return SlantedPieces.of(points[counts], distance[counts])


def _depths(mesh, first, second):
    """ndarray of shape (k, 3), mm: depth of the corners of the second triangles below the planes of the first."""
    away = mesh.corners[second] - mesh.corners[first, :1]
    return -np.einsum("ikj,ij->ik", away, mesh.normals[first])


def _overlaps(own, other):
    """Intersection polygons of pairs of triangles, and the indices of the pairs that have one."""
    own_low, own_high, low, high = (
        how(how(corners[:, 0], corners[:, 1]), corners[:, 2])
        for corners in (own, other) for how in (np.minimum, np.maximum))
    over = np.flatnonzero(~((own_low > high) | (low > own_high)).any(axis=1))
    points = own[over]
    for k in range(3):
        points = clip(points, _side_of(points, other[over], k))
        left = np.flatnonzero(areas(points) > 0.0)
        points, over = points[left], over[left]
    return points, over


def _plane_of(mesh, triangle):
    corners = mesh.corners[triangle]
    along = corners[:, 1] - corners[:, 0]
    along /= np.linalg.norm(along, axis=1)[:, None]
    return corners[:, 0], along, np.cross(mesh.normals[triangle], along)


def _in_plane(points, corner, along, across):
    away = points - corner[:, None]
    return np.stack(
        [np.einsum("ikj,ij->ik", away, axis) for axis in (along, across)], axis=2
    )


def _side_of(points, triangle, k):
    """Twice the area of the triangle of each point and side k of its triangle, positive inside."""
    start = triangle[:, k, None]
    side = triangle[:, (k + 1) % 3, None] - start
    away = points - start
    spanned = side[..., 0] * away[..., 1] - side[..., 1] * away[..., 0]
    return spanned * np.sign(_doubled_area(triangle))[:, None]


def _doubled_area(triangle):
    first, second = triangle[:, 1] - triangle[:, 0], triangle[:, 2] - triangle[:, 0]
    return first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0]


def _linear(triangle, values):
    """Slopes, and values at the origin, of the linear functions with given values at the corners."""
    first, second = triangle[:, 1] - triangle[:, 0], triangle[:, 2] - triangle[:, 0]
    rise_first, rise_second = values[:, 1] - values[:, 0], values[:, 2] - values[:, 0]
    doubled = _doubled_area(triangle)
    doubled = np.where(doubled == 0.0, np.inf, doubled)
    slope = np.stack([
        rise_first * second[:, 1] - rise_second * first[:, 1],
        rise_second * first[:, 0] - rise_first * second[:, 0],
    ], axis=1) / doubled[:, None]
    return slope, values[:, 0] - np.einsum("ij,ij->i", slope, triangle[:, 0])


def _evaluate(slope, level, points):
    return np.einsum("ij,ikj->ik", slope, points) + level[:, None]


def _banded(points, slope, level, limit):
    """Cut polygons into bands of distance, so that pieces are small where a polygon may be partly hidden.

    Returns the pieces, and the indices of the polygons that they are of.
    """
    distance, width = _evaluate(slope, level, points), limit / _BANDS
    first = np.clip(np.floor(distance.min(axis=1) / width), 0, _BANDS - 1).astype(np.int64)
    last = np.clip(np.ceil(distance.max(axis=1) / width) - 1, first, _BANDS - 1).astype(np.int64)
    count = last - first + 1
    which = np.repeat(np.arange(len(points)), count)
    low = width * (np.arange(len(which)) - np.repeat(np.cumsum(count) - count - first, count))
    band = clip(points[which], distance[which] - low[:, None])
    band = clip(band, (low + width)[:, None] - _evaluate(slope[which], level[which], band))
    left = np.flatnonzero(areas(band) > 0.0)
    return band[left], which[left]


def _is_slanted(mesh, first, second, centre, reach):
    """Whether the smooth surfaces at both ends are at `STATED_ANGLES` to each other."""
    low, high = (np.radians(angle) - TOLERANCES.angle for angle in STATED_ANGLES)
    here = normals_at(mesh, first, centre)
    there = normals_at(mesh, second, centre - mesh.normals[first] * reach[:, None])
    cosine = np.clip(-np.einsum("ij,ij->i", here, there), -1.0, 1.0)
    angle = np.arccos(cosine)
    return (angle >= low) & (angle < high)

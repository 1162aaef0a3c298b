"""Least distance between walls that are not parallel, exact where samples are too coarse."""

from dataclasses import dataclass

import numpy as np

from .convex_clipping import areas, clip
from .descriptors import STATED_ANGLES, STATED_FLOOR
from .progress import portion
from .sampling import SurfaceSamples
from .slanted_pairs import slanted_pairs
from .smooth_normals import normals_at
from .tolerances import TOLERANCES

SEARCHED = 0.05
"""Share of the diagonal within which is searched where samples alone do not reach the floor."""

_TIMES_THE_AREA = (2, 16)
_MARGIN = 1.0 + 1e-6
_FARTHEST = 4.0
_PAIRS_AT_ONCE = 8192
_BANDS = 4


def nonparallel_minimum(mesh, rays, field, diagonal, report=None):
    """Least distance that non-parallel walls reach on `STATED_FLOOR` of the area.

    Parameters
    ----------
    mesh : SurfaceMesh
    rays : InwardRays
        Over that mesh.
    field : ThicknessField
        Over samples of that mesh.
    diagonal : float, mm
    report : callable, optional
        Called with the fraction done; may raise to stop.

    Returns
    -------
    float or None
        Share of the diagonal; None where the floor is not reached.

    Notes
    -----
    Where two faces meet in a wedge their distance falls to nothing; what is asked for is the
    distance that a given area lies under, and where that area is a thousandth of a triangle, samples
    of the triangles find it or not. So all pairs of triangles are found that stand so near and at
    such an angle (by the tree, bounded by what the samples saw), the region of one over the other is
    cut out as a polygon, over which the distance is linear, and area is summed by distance. Pieces
    that something else hides, as seen from their middle, are left out.
    """
    target = STATED_FLOOR * field.area.sum()
    for attempt, limit in enumerate(_limits(field, target, diagonal)):
        # How many attempts there will be is not known; most often it is one.
        attempt_report = portion(report, 1.0 - 0.1 ** attempt, 1.0 - 0.1 ** (attempt + 1))
        regions = _regions(mesh, rays, limit, attempt_report)
        if regions.area.sum() >= target:
            return regions.distance_of(target) / diagonal
    return _of_samples(field, target, diagonal)


def _slanted(field):
    """Non-parallel samples at the angles asked for, nearest first."""
    low, high = (np.radians(angle) - TOLERANCES.angle for angle in STATED_ANGLES)
    chosen = np.flatnonzero((field.wedge_angle >= low) & (field.wedge_angle < high))
    return chosen[np.argsort(field.distance[chosen], kind="stable")]


def _of_samples(field, target, diagonal):
    chosen = _slanted(field)
    reached = np.flatnonzero(np.cumsum(field.area[chosen]) >= target)
    return float(field.distance[chosen[reached[0]]]) / diagonal if len(reached) else None


def _limits(field, target, diagonal):
    """Distances, mm, to search within, one after the other until the area is found.

    The samples say under which distance a few times the area lies. Where they found too little, the
    search widens from the nearest of them.
    """
    chosen = _slanted(field)
    if not len(chosen):
        return
    distance, area = field.distance[chosen], np.cumsum(field.area[chosen])
    if area[-1] >= target:
        for times in _TIMES_THE_AREA:
            yield float(distance[min(np.searchsorted(area, times * target), len(area) - 1)]) * _MARGIN
        yield float(distance[np.searchsorted(area, target)]) * _FARTHEST
        return
    limit, farthest = float(distance[0]) * _FARTHEST, SEARCHED * diagonal
    while limit < farthest * _FARTHEST:
        yield min(limit, farthest)
        limit *= _FARTHEST


@dataclass(frozen=True)
class _Regions:
    """Pieces of triangles, each over one other triangle.

    Attributes
    ----------
    points : ndarray of shape (m, k, 2), mm
        Polygons in the planes of their triangles.
    distance : ndarray of shape (m, k), mm
        To the other triangle, at the corners; linear between.
    area : ndarray of shape (m,), mm2
    """

    points: np.ndarray
    distance: np.ndarray
    area: np.ndarray

    def area_below(self, level):
        """float, mm2: area over walls nearer than a level."""
        below = self.distance.max(axis=1) <= level
        cut = ~below & (self.distance.min(axis=1) < level)
        left = clip(self.points[cut], level - self.distance[cut])
        return float(self.area[below].sum() + areas(left).sum())

    def distance_of(self, target):
        """float, mm: distance that an area, no more than there is, lies under."""
        low, high = float(self.distance.min()), float(self.distance.max())
        if self.area_below(low) >= target or low == high:
            return low
        from scipy.optimize import brentq  # takes as long to load as a small part to measure

        return brentq(lambda level: self.area_below(level) - target, low, high, rtol=1e-9)


def _regions(mesh, rays, limit, report):
    parts = [
        _regions_of(mesh, rays, first, second, limit)
        for first, second in _gathered(slanted_pairs(mesh, rays, limit, report))
    ]
    corners = 3 + 3 + 2 + 2
    if not parts:
        return _Regions(np.empty((0, corners, 2)), np.empty((0, corners)), np.empty(0))
    return _Regions(*(np.concatenate(each) for each in zip(*parts)))


def _gathered(pairs):
    """The same pairs, as many together as are worth the calls to numpy and no more."""
    waiting, count = [], 0
    for each in pairs:
        waiting.append(each)
        count += len(each[0])
        if count >= _PAIRS_AT_ONCE:
            yield tuple(np.concatenate(column) for column in zip(*waiting))
            waiting, count = [], 0
    if count:
        yield tuple(np.concatenate(column) for column in zip(*waiting))


def _depths(mesh, first, second):
    """How far the corners of the second lie under the plane of the first, ndarray of shape (k, 3)."""
    away = mesh.corners[second] - mesh.corners[first, :1]
    return -np.einsum("ikj,ij->ik", away, mesh.normals[first])


def _regions_of(mesh, rays, first, second, limit):
    """Points, distances and areas of the regions of the first triangles over the second."""
    corner, along, across = _plane_of(mesh, first)
    own = _in_plane(mesh.corners[first], corner, along, across)
    other = _in_plane(mesh.corners[second], corner, along, across)
    slope, level = _linear(other, _depths(mesh, first, second))
    points, over = _overlaps(own, other)
    distance = _evaluate(slope[over], level[over], points)
    # What only touches lies over nothing, but for rounding.
    touching = TOLERANCES.self_hit * mesh.extent
    near = (distance.min(axis=1) < limit) & (distance.max(axis=1) > touching)
    points, over = points[near], over[near]
    first, second, slope, level = first[over], second[over], slope[over], level[over]
    corner, along, across = corner[over], along[over], across[over]
    points = clip(points, _evaluate(slope, level, points))
    points, which = _banded(points, slope, level, limit)
    first, second = first[which], second[which]
    distance = np.clip(_evaluate(slope[which], level[which], points), 0.0, limit)
    area = areas(points)
    seen = np.flatnonzero(area > 0.0)
    points, distance, area = points[seen], distance[seen], area[seen]
    first, second, which = first[seen], second[seen], which[seen]
    middle, reach = points.mean(axis=1), distance.mean(axis=1)
    place = (corner[which] + middle[:, :1] * along[which] + middle[:, 1:] * across[which])
    kept = _is_slanted(mesh, first, second, place, reach)
    kept[kept] = ~rays.is_hidden(SurfaceSamples(place[kept], first[kept], area[kept]), reach[kept])
    return points[kept], distance[kept], area[kept]


def _overlaps(own, other):
    """Polygons that two triangles have in common, and which pairs have one."""
    apart = (own.min(axis=1) > other.max(axis=1)) | (other.min(axis=1) > own.max(axis=1))
    over = np.flatnonzero(~apart.any(axis=1))
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
    """Twice the area that each point spans with side k of its triangle, positive inside."""
    start = triangle[:, k, None]
    side = triangle[:, (k + 1) % 3, None] - start
    away = points - start
    spanned = side[..., 0] * away[..., 1] - side[..., 1] * away[..., 0]
    return spanned * np.sign(_doubled_area(triangle))[:, None]


def _doubled_area(triangle):
    first, second = triangle[:, 1] - triangle[:, 0], triangle[:, 2] - triangle[:, 0]
    return first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0]


def _linear(triangle, values):
    """Slope and value at zero of the linear functions with given values at the corners."""
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
    """Polygons cut into bands of distance, so that each is small where it may be hidden in part."""
    bands, which = [], []
    for low, high in zip(np.arange(_BANDS), np.arange(1, _BANDS + 1)):
        band = clip(points, _evaluate(slope, level, points) - limit * low / _BANDS)
        band = clip(band, limit * high / _BANDS - _evaluate(slope, level, band))
        left = np.flatnonzero(areas(band) > 0.0)
        bands.append(band[left])
        which.append(left)
    # A piece that closes with its first corner gets one more corner, so all have as many.
    return np.concatenate([np.concatenate([band, band[:, :1]], axis=1) for band in bands]), \
        np.concatenate(which)


def _is_slanted(mesh, first, second, place, reach):
    """Whether the smooth surfaces at both ends stand at the angles asked for."""
    low, high = (np.radians(angle) - TOLERANCES.angle for angle in STATED_ANGLES)
    here = normals_at(mesh, first, place)
    there = normals_at(mesh, second, place - mesh.normals[first] * reach[:, None])
    cosine = np.clip(-np.einsum("ij,ij->i", here, there), -1.0, 1.0)
    angle = np.arccos(cosine)
    return (angle >= low) & (angle < high)

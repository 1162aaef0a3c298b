# SPDX-License-Identifier: LGPL-2.1-or-later
"""Points that stand for the walls of a part, and which of them belong to one wall."""

from dataclasses import dataclass

import numpy as np
from scipy.sparse import coo_matrix
from scipy.spatial import cKDTree

from ..columns import dot
from ..mesh.smooth_normals import normals_at
from ..tolerances import TOLERANCES
from ..walls.thickness_field import SLOPE_ALLOWANCE
from ..walls.walls import is_parallel

LEAST_POINTS, MOST_POINTS = 4_000, 10_000
"""Points that stand for the walls, at most: a region of half a percent of the surface has twenty or more."""

SPACED, SPACED_SHARE = 0.4, 0.95
"""Between these numbers, there are as many as make them no farther apart than this share of the thickness, at this share of
them: of a solid body, fewer tell as much."""

DENSER = 16.0
"""Thin walls have more points than their area, by the square of their thickness, up to so many times."""

NEIGHBOURS = 16
"""Points around each one that are tried; those of the other side of a thin wall are among them."""

FEW_LINKS, CROWDED = 6, 80
"""Points with fewer links than this try so many points around: among close fins, most of the nearest are of others."""

OPPOSITE = 4
"""Points around the other end of a wall that are tried."""

FARTHEST, FARTHEST_ROUND_EDGES = 3.0, 1.5
"""Greatest distance of neighbours in spacings of the points; farther ones lie beyond a gap. Round an edge, where nothing
says that they lie on one surface, they have to be next to each other."""

AROUND_EDGES = -0.25
"""Least cosine between normals of neighbours: a sheet that is bent by a right angle is one wall, but points on
both sides of a narrow slot have nothing to do with each other."""

SMOOTH, OFF_SURFACE = 0.7, 0.5
"""Neighbours whose normals have at least this cosine lie on one smooth surface, and so no farther off it than this share of
the thickness: the next fin of a heat sink is at least a whole one away."""

ASIDE = 0.25
"""How far aside of a point, by its depth below it, is still right below it: beside the step of a shaft is not."""

STEEPEST = 2.0
"""Greatest ratio of thicknesses at neighbouring places of a wedge."""

OPPOSED = -0.3
"""Greatest cosine between the normals at both ends of a wall: up to `NONPARALLEL_BELOW`, and some rounding."""

_STEPS, _FOR_MEDIAN, _TIMES_AS_MANY = 4, 2000, 8
_GOLDEN = 0.6180339887498949


@dataclass(frozen=True)
class WallPoints:
    """Samples that stand for the walls.

    Attributes
    ----------
    sample : ndarray of shape (n,), int64
        Of the field, ascending.
    points, normals, middle : ndarray of shape (n, 3), mm
        On the surface, outward of its triangle, and half-way through the wall.
    smooth_normals : ndarray of shape (n, 3)
        Of the smooth surface.
    thickness, wedge_angle : ndarray of shape (n,), mm and radians
    area : ndarray of shape (n,), mm2
        That each one stands for.
    """

    sample: np.ndarray
    points: np.ndarray
    normals: np.ndarray
    middle: np.ndarray
    smooth_normals: np.ndarray
    thickness: np.ndarray
    wedge_angle: np.ndarray
    area: np.ndarray

    @property
    def spacing(self):
        """ndarray of shape (n,), mm: mean distance of neighbours."""
        return np.sqrt(self.area)

    def chosen(self, which):
        """Those of a mask or of indices."""
        return WallPoints(*(getattr(self, name)[which] for name in self.__dataclass_fields__))


def wall_points(field):
    """Choose the points of a thickness field, evenly over the surface and denser on thin walls.

    Returns
    -------
    points : WallPoints
        Those on rims, which see along a wall, not through it, are left out.
    certain : ndarray of shape (n,), bool
        Points that have no thinner wall near by: what has none of them is no wall of its own.
    """
    wall = np.flatnonzero((field.parallel | field.nonparallel) & np.isfinite(field.distance) & (field.area > 0.0))
    if not len(wall):
        return _points_of(field, wall, np.zeros(0)), np.zeros(0, dtype=bool)
    median = np.median(field.distance[wall[_evenly(field.area[wall], _FOR_MEDIAN)]])
    wall = wall[field.distance[wall] > TOLERANCES.touching * median]
    thickness, area = field.distance[wall], field.area[wall]
    density = np.clip((median / thickness) ** 2, 1.0, DENSER)
    weight = area * density
    count = min(_points_needed(thickness, density, weight), len(wall))
    place, times = np.unique(_evenly(weight, count), return_counts=True)
    points = _points_of(field, wall[place], times * weight.sum() / count / density[place])
    near_thinner, on_rim = _near_thinner_walls(points)
    return points.chosen(~on_rim), ~near_thinner[~on_rim]


def _points_needed(thickness, density, weight):
    """How many points stand for walls that are chosen by a weight: int."""
    some = _evenly(weight, _FOR_MEDIAN)
    needed = np.quantile(weight.sum() / density[some] / (SPACED * thickness[some]) ** 2, SPACED_SHARE)
    return int(np.clip(needed, LEAST_POINTS, MOST_POINTS))


def _evenly(weight, count):
    """Indices that each stand for the same share of a weight, ndarray of shape (count,); some may occur twice."""
    cumulative, number = np.cumsum(weight), np.arange(count)
    # Somewhere in each share: equal steps could fall in with those of the triangles round an axis.
    wanted = (number + (number * _GOLDEN) % 1.0) / count * cumulative[-1]
    return np.minimum(np.searchsorted(cumulative, wanted), len(weight) - 1)


def _points_of(field, sample, area):
    triangle, thickness = field.samples.triangle[sample], field.distance[sample]
    points, normals = field.samples.points[sample], field.mesh.normals[triangle]
    return WallPoints(sample, points, normals, points - 0.5 * thickness[:, None] * normals,
                      normals_at(field.mesh, triangle, points), thickness, field.wedge_angle[sample], area)


def _near_thinner_walls(points):
    """Points half-way under which a thinner wall is near, and those that lie on its rim: two ndarrays of bool.

    The rim of a plate sees its opposite rim, which is parallel. But half-way there, the surface of a thinner wall is much
    nearer than half of that distance, and right above. Beside the step of a shaft it is near, but not right above.
    """
    near, on_rim = np.zeros((2, len(points.sample)), dtype=bool)
    if not len(near):
        return near, on_rim
    # Points that are `_STEPS` of these steps thinner are no longer alike.
    step = np.log(points.thickness / np.median(points.thickness)) / np.log(TOLERANCES.alike)
    step = np.rint(_STEPS * step).astype(np.int64)
    expected = 0.5 * points.thickness * np.cos(points.wedge_angle) / TOLERANCES.alike
    own, nearest, above = _nearest_thinner(points, step, expected)
    depth = np.einsum("ij,ij->i", points.points[above] - points.middle[own], points.normals[above])
    aside = np.sqrt(np.maximum(nearest**2 - depth**2, 0.0))
    near[own] = True
    on_rim[own] = (aside < np.maximum(ASIDE * np.abs(depth), 2.0 * points.spacing[above])) \
        | ~is_parallel(points.wedge_angle[own])
    return near, on_rim


def _nearest_thinner(points, step, within):
    """Points with a thinner one nearer to their middle than a distance, mm; that distance, and the thinner one.

    Those that are near are asked for until one is thin enough or none is left: under most points, none is near at all.
    """
    thinner = np.flatnonzero(step <= step.max() - _STEPS)
    asking = np.flatnonzero(step >= step.min() + _STEPS)
    tree, found, asked = cKDTree(points.points[thinner], balanced_tree=False), [], 1
    while len(asking):
        asked = min(asked, len(thinner))
        distance, which = tree.query(points.middle[asking], k=np.arange(1, asked + 1),
                                     distance_upper_bound=within[asking].max())
        is_near = distance < within[asking, None]
        other = thinner[np.minimum(which, len(thinner) - 1)]
        counts = is_near & (step[other] <= step[asking, None] - _STEPS)
        first, row = np.argmax(counts, axis=1), np.arange(len(asking))
        done = counts[row, first]
        found.append((asking[done], distance[row, first][done], other[row, first][done]))
        if asked == len(thinner):
            break
        asking = asking[~done & is_near[:, -1]]
        asked *= _TIMES_AS_MANY
    if not found:
        return np.empty(0, dtype=np.int64), np.empty(0), np.empty(0, dtype=np.int64)
    return tuple(np.concatenate(column) for column in zip(*found))


def wall_links(points):
    """Find which points belong to one wall: csr_matrix of shape (n, n).

    Distance, mm, between the middles of walls that are linked along the surface or through the wall.
    """
    count = len(points.sample)
    if count < 2:
        return coo_matrix((count, count)).tocsr()
    # Thickness is a fourth direction, so that neighbours are alike although other walls are nearer: of the crest of a
    # thread, its flanks are.
    opposite = points.points - points.thickness[:, None] * points.normals
    apart = FARTHEST * np.median(points.spacing) / np.log(TOLERANCES.alike)
    level = apart * np.log(points.thickness)
    place = np.column_stack([points.points, level])
    tree, columns = cKDTree(place, balanced_tree=False), _columns_of(points)
    linked = _links_along(columns, tree, place, np.arange(count), NEIGHBOURS)
    alone = np.flatnonzero(np.bincount(linked[0], minlength=count) < FEW_LINKS)
    first, second = np.concatenate([linked, _links_along(columns, tree, place, alone, CROWDED),
                                    _links_through(columns, tree, np.column_stack([opposite, level]))], axis=1)
    # Links that were found from both ends, or both ways, are one.
    links = coo_matrix((np.ones(len(first), dtype=np.int8), (np.minimum(first, second), np.maximum(first, second))),
                       shape=(count, count)).tocsr()
    first, second = np.repeat(np.arange(count), np.diff(links.indptr)), links.indices
    away = np.take(points.middle, first, axis=0) - np.take(points.middle, second, axis=0)
    # Distances of zero would be no links.
    links.data = np.maximum(np.sqrt(np.einsum("ij,ij->i", away, away)), 1e-9 * points.thickness[first])
    return links


@dataclass(frozen=True)
class _Columns:
    """What links depend on, in float32 and the long axis contiguous: the rules are no finer than that.

    Attributes
    ----------
    points, normals, smooth_normals : ndarray of shape (3, n), mm
        Points from the middle of all.
    thickness, spacing, slope : ndarray of shape (n,)
        Slope: by how much thickness may change on the way, at most, per length.
    """

    points: np.ndarray
    normals: np.ndarray
    smooth_normals: np.ndarray
    thickness: np.ndarray
    spacing: np.ndarray
    slope: np.ndarray


def _columns_of(points):
    rows = (points.points - points.points.mean(axis=0)).T, points.normals.T, points.smooth_normals.T, \
        points.thickness, points.spacing, np.tan(points.wedge_angle + SLOPE_ALLOWANCE)
    return _Columns(*(np.ascontiguousarray(row, dtype=np.float32) for row in rows))


def _links_along(columns, tree, place, which, most):
    """Links of some points to the nearest ones along the surface: ndarray of shape (2, k)."""
    near = min(most + 1, len(place))
    _, there = tree.query(place[which], k=near)
    return _alike(columns, np.repeat(which, near), there.reshape(-1), _is_beside)


def _links_through(columns, tree, opposite):
    """Links of points to those at the other end of the wall: ndarray of shape (2, k)."""
    near = min(OPPOSITE, len(opposite))
    _, there = tree.query(opposite, k=near)
    return _alike(columns, np.repeat(np.arange(len(opposite)), near), there.reshape(-1), _is_opposite)


def _alike(columns, first, second, belong):
    """Of pairs of points, those that belong together and whose walls are alike: ndarray of shape (2, k)."""
    away = np.take(columns.points, second, axis=1) - np.take(columns.points, first, axis=1)
    reach = np.maximum(np.take(columns.spacing, first), np.take(columns.spacing, second))
    thickness = np.take(columns.thickness, first)
    kept = belong(columns, first, second, away, reach, thickness) & (first != second)
    kept = np.flatnonzero(kept & _is_alike(columns, first, second, np.sqrt(dot(away, away)), reach, thickness))
    return np.stack([first[kept], second[kept]])


def _is_beside(columns, first, second, away, reach, thickness):
    """Whether neighbours lie on one surface, be it round an edge."""
    one, other = (np.take(columns.smooth_normals, which, axis=1) for which in (first, second))
    facing, square = dot(one, other), dot(away, away)
    # Of two points of a circle, the chord is across the sum of their normals.
    one += other
    off = np.abs(dot(away, one)) * np.float32(0.5)
    round_edge = (facing > AROUND_EDGES) & (square < (FARTHEST_ROUND_EDGES * reach) ** 2)
    smooth = (off < OFF_SURFACE * thickness) & (square < (FARTHEST * reach) ** 2)
    return np.where(facing < SMOOTH, round_edge, smooth)


def _is_opposite(columns, first, second, away, reach, thickness):
    """Whether a point lies on the surface that another one sees at the other end of the wall."""
    normal, normal_there = (np.take(columns.normals, which, axis=1) for which in (first, second))
    facing = dot(normal, normal_there)
    normal *= thickness
    from_end = away + normal
    off = np.abs(dot(from_end, np.take(columns.smooth_normals, second, axis=1)))
    return (facing < OPPOSED) & (off < OFF_SURFACE * thickness) & (dot(from_end, from_end) < (FARTHEST * reach) ** 2)


def _is_alike(columns, first, second, apart, reach, one):
    """Whether walls are alike in thickness, apart from what both of them change by on the way."""
    other = np.take(columns.thickness, second)
    slope = np.minimum(np.take(columns.slope, first), np.take(columns.slope, second))
    # Both ends of one wall are apart by its thickness, along which it does not change.
    apart = np.minimum(apart, FARTHEST * reach)
    thinner = np.minimum(one, other)
    return np.abs(one - other) < np.minimum((TOLERANCES.alike - 1.0) * thinner + slope * apart, (STEEPEST - 1.0) * thinner)

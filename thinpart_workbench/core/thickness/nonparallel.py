# SPDX-License-Identifier: LGPL-2.1-or-later
"""Least distance between walls that are not parallel: from samples, and computed exactly within a budget of work."""

import math
from typing import NamedTuple, Optional

import numpy as np

from ..analysis_settings import AnalysisSettings
from ..descriptors.descriptor_table import STATED_FLOOR
from ..descriptors.precision import STRATIFIED
from ..progress import portion
from .search_budget import SearchBudget, cost_of_rays
from .slanted_pairs import slanted_pairs
from .slanted_pieces import SlantedPieces, least_distances, overlaps, slanted_pieces

SEARCHED = 0.05
"""Greatest distance to search, as a share of the diagonal, if samples alone do not reach the area floor."""

TIMES_THE_AREA = 2, 16
"""By the samples, so many times the area floor lies within the distances that are searched, one after the other."""

WIDER = 1.05, 1.25
"""What those are multiplied by: facets and samples may miss by so much."""

SHARE_OF_RAYS = 0.16
"""What the search may cost, by the cost of the rays: as counts do not tell times exactly, it takes at most a quarter."""

NEARER, NEARER_BY = 0.25, 0.006
"""Walls may be nearer than the samples say by this share of the distance, or where that is less, by so many diagonals.
Fitted to the exact distances of real parts, so that 95 % of differences are smaller with the default number of samples."""

FARTHER = 2.0
"""They may be as far as the samples say of this number of floors more."""

_FARTHEST = 4.0
_AT_ONCE = 1024


class LeastSlanted(NamedTuple):
    """A least distance of walls that are not parallel.

    Attributes
    ----------
    distance : float or None
        In diagonals; None where there are too few such walls.
    error : float
        In diagonals; 0 where the distance was computed exactly.
    """

    distance: Optional[float]
    error: float = 0.0


def sampled_minimum(field, diagonal):
    """The distance under which non-parallel walls lie on `STATED_FLOOR` of the area, by the samples: LeastSlanted.

    Parameters
    ----------
    field : ThicknessField
    diagonal : float, mm
    """
    chosen = field.slanted
    reached, target = np.cumsum(field.area[chosen]), STATED_FLOOR * field.area.sum()

    def distance_of(area):
        number = np.searchsorted(reached, area)
        # No wall is thicker than the part is long.
        return float(field.distance[chosen[number]]) / diagonal if number < len(chosen) else 1.0

    if not len(chosen) or reached[-1] < target:
        return LeastSlanted(None)
    spread = (np.count_nonzero(field.area) / AnalysisSettings.minimum_samples) ** STRATIFIED
    least = distance_of(target)
    nearer = min(spread * max(NEARER * least, min(least, NEARER_BY)), least)
    return LeastSlanted(least, max(nearer, distance_of((1.0 + spread * FARTHER) * target) - least))


def nonparallel_minimum(mesh, rays, field, diagonal, report=None, work=None, share_of_rays=SHARE_OF_RAYS):
    """Find the distance under which non-parallel walls lie on `STATED_FLOOR` of the area: LeastSlanted.

    Where two faces meet in a wedge, their distance goes to 0. The result is the distance under which a given area
    lies; if that area is a thousandth of a triangle, samples of the triangles may miss it. Therefore the tree finds
    all pairs of triangles at such a distance and angle, with a limit from the samples. The region of one triangle
    over the other is clipped to a polygon, over which the distance is linear, and area is summed by distance. Pieces
    whose centre does not see the other triangle, because something lies between, are left out. The nearest pairs are
    cut first, until all others are farther away than the result.

    The search ends where it would cost more than its share of what the rays cost, by counted work, so that the result is
    the same on every machine. The result is then what the samples say, between the distance up to which all pairs were cut
    and that of the area that was found.

    Parameters
    ----------
    mesh : SurfaceMesh
    rays : InwardRays
        Rays over that mesh, by which the field was measured.
    field : ThicknessField
        Field over samples of that mesh.
    diagonal : float, mm
    report : callable, optional
        Called with the fraction done; may raise to stop.
    work : Work, optional
        Counters to increase; `exact` is the number of pairs of triangles that are cut.
    share_of_rays : float
        inf for a search that is never ended.
    """
    sampled = sampled_minimum(field, diagonal)
    target = STATED_FLOOR * field.area.sum()
    budget = SearchBudget(share_of_rays * cost_of_rays(field.samples.count, rays.work), work)
    for attempt, limit in enumerate(_limits(field, target, diagonal)):
        # The number of attempts is not known in advance; mostly it is one.
        attempt_report = portion(report, 1.0 - 0.1 ** attempt, 1.0 - 0.1 ** (attempt + 1))
        low, high = _least_within(mesh, rays, limit, target, attempt_report, budget)
        if low == high:
            return LeastSlanted(low / diagonal)
        if budget.is_spent:
            return _between(sampled, low / diagonal, high / diagonal)
    return sampled


def _between(sampled, low, high):
    """What the samples say, with the bounds of a search that was ended: LeastSlanted."""
    if sampled.distance is None:
        return sampled if math.isinf(high) else LeastSlanted(high, high - low)
    low, high = max(low, sampled.distance - sampled.error), min(high, sampled.distance + sampled.error)
    distance = min(max(sampled.distance, low), high)
    return LeastSlanted(distance, max(high - distance, distance - low))


def _limits(field, target, diagonal):
    """Yield distances, mm, to search within one after the other until the area is found.

    By the samples, many times the area lies under the first. If the samples have too little area, the search widens from
    the nearest sample.
    """
    chosen = field.slanted
    if not len(chosen):
        return
    reached = np.cumsum(field.area[chosen])
    if reached[-1] >= target:
        nearest = chosen[:np.searchsorted(reached, TIMES_THE_AREA[-1] * target) + 1]
        distance = _between_facets(field, nearest)
        order = np.argsort(distance, kind="stable")
        reached = np.cumsum(field.area[nearest[order]])
        for times, wider in zip(TIMES_THE_AREA, WIDER):
            limit = float(distance[order[min(np.searchsorted(reached, times * target), len(order) - 1)]])
            yield limit * wider
        yield limit * _FARTHEST
        return
    limit, farthest = float(field.distance[chosen[0]]) * _FARTHEST, SEARCHED * diagonal
    while limit < farthest * _FARTHEST:
        yield min(limit, farthest)
        limit *= _FARTHEST


def _between_facets(field, samples):
    """ndarray of shape (k,), mm: the distance of samples from the facets that they see, along the normals of their own.

    Fields are measured between the smooth surfaces, pieces between facets. Here each facet is extended to its plane.
    """
    mesh, own, other = field.mesh, field.samples.triangle[samples], field.opposite[samples]
    measured = field.distance[samples]
    here, there = mesh.normals[own], mesh.normals[other]
    away = field.samples.points[samples] - mesh.corners[other, 0]
    facing = np.minimum(np.einsum("ij,ij->i", here, there), -0.5)
    return np.clip(np.einsum("ij,ij->i", away, there) / facing, 0.5 * measured, 2.0 * measured)


def _least_within(mesh, rays, limit, target, report, budget):
    """Bounds of the distance under which an area, mm2, lies: two floats, mm, equal where it is known.

    The lower one is the limit where there is less area within it, the upper one infinite where less was found.
    """
    pieces, reached = SlantedPieces.none(), 0.0
    if not budget.begin_search(mesh.count):
        return 0.0, math.inf
    pairs = _all_within(slanted_pairs(mesh, rays, limit, report, budget.work), budget)
    if pairs is None:
        return 0.0, math.inf
    for over, reached in _nearest_first(mesh, pairs, limit, budget):
        budget.work.exact += over.count
        pieces = pieces.and_those(slanted_pieces(mesh, rays, over, limit))
        if pieces.area.sum() >= target and pieces.area_below(reached) >= target:
            return (pieces.distance_of(target),) * 2
    found = pieces.area.sum() >= target
    return (reached if budget.is_spent else limit), (pieces.distance_of(target) if found else math.inf)


def _all_within(portions, budget):
    """Pairs of triangles, all portions together; None where there are more than the budget allows."""
    found = []
    for one in portions:
        if not budget.begin_portion():
            return None
        found.append(one)
    if not found:
        return [np.empty(0, dtype=np.int64)] * 2 + [np.empty(0)]
    return [np.concatenate(column) for column in zip(*found)]


def _nearest_first(mesh, pairs, limit, budget):
    """Yield overlaps of pairs of triangles, and the distance, mm, that none of those still to come is nearer than."""
    first, second, depth = pairs
    least = np.maximum(least_distances(mesh, first, second), depth)
    order = np.argsort(least, kind="stable")
    order = order[:np.searchsorted(least[order], limit)]
    waiting, start, count = None, 0, _AT_ONCE
    while start < len(order):
        part = order[start:start + budget.begin_overlaps(count)]
        if not len(part):
            return
        start += len(part)
        count *= 2
        budget.work.overlaps += len(part)
        found = overlaps(mesh, first[part], second[part], limit)
        waiting = found if waiting is None else waiting.and_those(found)
        reached = least[order[start]] if start < len(order) else limit
        # Of those, what is nearer than all other pairs is next.
        waiting = waiting.chosen(np.argsort(waiting.nearest, kind="stable"))
        known, begin = int(np.searchsorted(waiting.nearest, reached)), 0
        while begin < known:
            end = min(begin + budget.begin_cuts(_AT_ONCE), known)
            if end == begin:
                return
            yield waiting.chosen(slice(begin, end)), waiting.nearest[end] if end < known else reached
            begin = end
        waiting = waiting.chosen(slice(known, None))

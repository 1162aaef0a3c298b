"""Least distance between walls that are not parallel, computed exactly where samples are too coarse."""

import numpy as np

from ..descriptors.descriptor_table import STATED_ANGLES, STATED_FLOOR
from ..progress import portion
from ..rays.tree_descent import Work
from ..tolerances import TOLERANCES
from .slanted_pairs import slanted_pairs
from .slanted_pieces import SlantedPieces, least_distances, overlaps, slanted_pieces

SEARCHED = 0.05
"""Greatest distance to search, as a share of the diagonal, if samples alone do not reach the area floor."""

TIMES_THE_AREA = 2, 16
"""By the samples, so many times the area floor lies within the distances that are searched, one after the other."""

WIDER = 1.05, 1.25
"""What those are multiplied by: facets and samples may miss by so much."""

_FARTHEST = 4.0
_AT_ONCE = 1024


def nonparallel_minimum(mesh, rays, field, diagonal, report=None, work=None):
    """Find the distance under which non-parallel walls lie on `STATED_FLOOR` of the area: float or None.

    Share of the diagonal; None if the floor is not reached.

    Where two faces meet in a wedge, their distance goes to 0. The result is the distance under which a given area
    lies; if that area is a thousandth of a triangle, samples of the triangles may miss it. Therefore the tree finds
    all pairs of triangles at such a distance and angle, with a limit from the samples. The region of one triangle
    over the other is clipped to a polygon, over which the distance is linear, and area is summed by distance. Pieces
    whose centre does not see the other triangle, because something lies between, are left out. The nearest pairs are
    cut first, until all others are farther away than the result.

    Parameters
    ----------
    mesh : SurfaceMesh
    rays : InwardRays
        Rays over that mesh.
    field : ThicknessField
        Field over samples of that mesh.
    diagonal : float, mm
    report : callable, optional
        Called with the fraction done; may raise to stop.
    work : Work, optional
        Counters to increase; `exact` is the number of pairs of triangles that are cut.
    """
    target = STATED_FLOOR * field.area.sum()
    for attempt, limit in enumerate(_limits(field, target, diagonal)):
        # The number of attempts is not known in advance; mostly it is one.
        attempt_report = portion(report, 1.0 - 0.1 ** attempt, 1.0 - 0.1 ** (attempt + 1))
        least = _least_within(mesh, rays, limit, target, attempt_report, work or Work())
        if least is not None:
            return least / diagonal
    return _of_samples(field, target, diagonal)


def _slanted(field):
    """Non-parallel samples at `STATED_ANGLES`, nearest first."""
    low, high = (np.radians(angle) - TOLERANCES.angle for angle in STATED_ANGLES)
    chosen = np.flatnonzero((field.wedge_angle >= low) & (field.wedge_angle < high))
    return chosen[np.argsort(field.distance[chosen], kind="stable")]


def _of_samples(field, target, diagonal):
    chosen = _slanted(field)
    reached = np.flatnonzero(np.cumsum(field.area[chosen]) >= target)
    return float(field.distance[chosen[reached[0]]]) / diagonal if len(reached) else None


def _limits(field, target, diagonal):
    """Yield distances, mm, to search within one after the other until the area is found.

    By the samples, many times the area lies under the first. If the samples have too little area, the search widens from
    the nearest sample.
    """
    chosen = _slanted(field)
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


def _least_within(mesh, rays, limit, target, report, work):
    """Distance under which an area, mm2, lies, mm; None where there is less of it within the limit."""
    pieces = SlantedPieces.none()
    for over, reached in _nearest_first(mesh, slanted_pairs(mesh, rays, limit, report, work), limit):
        work.exact += over.count
        pieces = pieces.and_those(slanted_pieces(mesh, rays, over, limit))
        if pieces.area.sum() >= target and pieces.area_below(reached) >= target:
            return pieces.distance_of(target)
    return None


def _nearest_first(mesh, pairs, limit):
    """Yield overlaps of pairs of triangles, and the distance, mm, that none of those still to come is nearer than."""
    pairs = [*pairs]
    if not pairs:
        return
    first, second, depth = (np.concatenate(column) for column in zip(*pairs))
    least = np.maximum(least_distances(mesh, first, second), depth)
    order = np.argsort(least, kind="stable")
    order = order[:np.searchsorted(least[order], limit)]
    waiting, start, count = None, 0, _AT_ONCE
    while start < len(order):
        part = order[start:start + count]
        start += len(part)
        count *= 2
        found = overlaps(mesh, first[part], second[part], limit)
        waiting = found if waiting is None else waiting.and_those(found)
        reached = least[order[start]] if start < len(order) else limit
        # Of those, what is nearer than all other pairs is next.
        waiting = waiting.chosen(np.argsort(waiting.nearest, kind="stable"))
        known = int(np.searchsorted(waiting.nearest, reached))
        for begin in range(0, known, _AT_ONCE):
            end = min(begin + _AT_ONCE, known)
            yield waiting.chosen(slice(begin, end)), waiting.nearest[end] if end < known else reached
        waiting = waiting.chosen(slice(known, None))

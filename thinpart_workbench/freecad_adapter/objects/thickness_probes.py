# SPDX-License-Identifier: LGPL-2.1-or-later
"""Probes: points of a thickness map at which the user has queried the exact thickness."""

from dataclasses import dataclass, replace

import numpy as np

from ...core.maps.map_search import MapSearch
from ...core.rigid_transform import inverse, transform_points
from ..shapes.placements import placement_matrix
from .thickness_object import motion

SURFACE_TOLERANCE = 1e-3
"""Share of the diagonal: maximum distance of a point that still lies on a remeasured surface."""


@dataclass(frozen=True)
class Probe:
    """The wall at a point.

    Attributes
    ----------
    point, opposite : tuple of float, mm
        In the coordinates of the document at the time of measuring: they move with the map.
    value : float, mm
    """

    point: tuple
    opposite: tuple
    value: float


def probes_of(thickness):
    """list of Probe. If a user has edited the property lists to different lengths, the shortest counts."""
    return [Probe(tuple(point), tuple(opposite), value) for point, opposite, value in zip(
        thickness.ProbePoints, thickness.ProbeOpposites, thickness.ProbeValues)]


def set_probes(thickness, probes):
    """Replace the probes of a thickness map."""
    thickness.ProbePoints = [_vector(probe.point) for probe in probes]
    thickness.ProbeOpposites = [_vector(probe.opposite) for probe in probes]
    thickness.ProbeValues = [probe.value for probe in probes]


def moved_matrix(thickness):
    """ndarray of shape (4, 4): from the position of the parts when they were measured to the current one."""
    moved = motion(thickness)
    return np.eye(4) if moved is None else placement_matrix(moved)


def wall_at_placement(part, placement, facet, point):
    """The wall under a point of a part at one of its placements, both in the coordinates of the document.

    Returns `thickness` (float or None, mm) and `opposite` (ndarray of shape (3,), mm, or None).

    Parameters
    ----------
    part : MappedPart
    placement : int
        Index into ``part.matrices``.
    facet : int
    point : ndarray of shape (3,), mm
    """
    matrix = part.matrices[placement]
    thickness, opposite = part.map.wall_at(facet, transform_points(inverse(matrix), point))
    return thickness, None if opposite is None else transform_points(matrix, opposite)


def carried_probes(thickness, parts):
    """The probes of a map, updated to remeasured maps; those that are off the surface are left out."""
    moved = moved_matrix(thickness)
    tolerance = SURFACE_TOLERANCE * max(thickness.Diagonal, 1e-9)
    found = []
    for probe in probes_of(thickness):
        point = transform_points(moved, probe.point)
        wall = _wall_near(parts, point, tolerance)
        if wall is not None:
            found.append(replace(probe, point=tuple(point), value=wall[0], opposite=tuple(wall[1])))
    return found


def _wall_near(parts, point, tolerance):
    for part in parts:
        search = MapSearch(part.map)
        for placement, matrix in enumerate(part.matrices):
            facet = search.nearest_facet(transform_points(inverse(matrix), point), tolerance)
            if facet >= 0:
                value, opposite = wall_at_placement(part, placement, facet, point)
                return None if value is None else (value, opposite)
    return None


def _vector(point):
    return tuple(float(coordinate) for coordinate in point)

"""Places of a thickness map where somebody asked for the exact thickness."""

from dataclasses import dataclass, replace

import numpy as np

from ..core.map_search import MapSearch
from ..freecad_adapter.thickness_object import motion

ON_SURFACE = 1e-3
"""Share of the diagonal within which a point still lies on a surface that was measured again."""


@dataclass(frozen=True)
class Probe:
    """A wall at one point.

    Attributes
    ----------
    point, opposite : tuple of float, mm
        In the coordinates of the document when it was measured: a map that is moved takes them along.
    value : float, mm
    """

    point: tuple
    opposite: tuple
    value: float


def probes_of(thickness):
    """list of Probe. Lists of unlike length, which somebody has edited, end with the shortest."""
    return [Probe(tuple(point), tuple(opposite), value) for point, opposite, value in zip(
        thickness.ProbePoints, thickness.ProbeOpposites, thickness.ProbeValues)]


def set_probes(thickness, probes):
    """Replace the probes of a thickness map."""
    thickness.ProbePoints = [_vector(each.point) for each in probes]
    thickness.ProbeOpposites = [_vector(each.opposite) for each in probes]
    thickness.ProbeValues = [each.value for each in probes]


def moved_matrix(thickness):
    """ndarray of shape (4, 4): from where the parts were measured to where they stand now."""
    moved = motion(thickness)
    return np.eye(4) if moved is None else np.array(moved.toMatrix().A).reshape(4, 4)


def wall_at_place(part, place, facet, point):
    """The wall under a point of a part at one of its places, both in the coordinates of the document.

    Parameters
    ----------
    part : MappedPart
    place : int
    facet : int
    point : ndarray of shape (3,), mm

    Returns
    -------
    thickness : float or None, mm
    opposite : ndarray of shape (3,), mm, or None
    """
    matrix = part.places[place]
    back = np.linalg.inv(matrix)
    thickness, opposite = part.map.wall_at(facet, back[:3, :3] @ point + back[:3, 3])
    return thickness, None if opposite is None else matrix[:3, :3] @ opposite + matrix[:3, 3]


def carried_probes(thickness, parts):
    """The probes of a map on maps that were measured again; those off the surface are left out."""
    moved = moved_matrix(thickness)
    reach = ON_SURFACE * max(thickness.Diagonal, 1e-9)
    found = []
    for probe in probes_of(thickness):
        point = moved[:3, :3] @ np.array(probe.point) + moved[:3, 3]
        where = _wall_near(parts, point, reach)
        if where is not None:
            found.append(replace(probe, point=tuple(point), value=where[0], opposite=tuple(where[1])))
    return found


def _wall_near(parts, point, reach):
    for part in parts:
        search = MapSearch(part.map)
        for place, matrix in enumerate(part.places):
            back = np.linalg.inv(matrix)
            facet = search.at(back[:3, :3] @ point + back[:3, 3], reach)
            if facet >= 0:
                value, opposite = wall_at_place(part, place, facet, point)
                return None if value is None else (value, opposite)
    return None


def _vector(point):
    return tuple(float(each) for each in point)

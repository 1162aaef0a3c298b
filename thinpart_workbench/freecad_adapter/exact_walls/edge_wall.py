# SPDX-License-Identifier: LGPL-2.1-or-later
"""How thick a wall is beside the sharp edge in which it ends."""

import numpy as np

from ...core.walls.thin_places import LEAST_AT_EDGE, WALL_BELOW
from ..bootstrap import load_freecad
from .face_places import common_edges, distance_to_edge, on_edge, wedge_angle
from .wall_lines import WallLines, below

_STEPS = 6
"""Times that the step along an edge is halved."""

_MOST_EDGES = 4
"""Edges at which two faces meet that are looked at, such as both ends of a thread."""

_PLACES, _OF_EDGE = np.linspace(0.0, 1.0, 5), 0.1
"""Places along an edge that are looked at first, and the first step from there, as shares of it without its ends: nearer to
them than the depth, where an edge may run out to nothing, none is."""


def exact_edge_wall(solid, wall, depth):
    """A wall that ends in a sharp edge, as thick as it is at a depth beside it: Witness or None.

    The depth is measured across either face of the wall, at a right angle to the edge. Of places along the edge, but for its
    ends, the thinnest is taken, of several edges the thinnest. None where the two faces have no edge together that is as
    long as the depth, or no wall there.

    Parameters
    ----------
    solid : Part.Solid
    wall : Witness
    depth : float, mm
    """
    edges = [edge for edge in common_edges(solid.Faces[wall.face], solid.Faces[wall.opposite_face]) if edge.Length >= depth]
    apart = np.array([distance_to_edge(edge, wall.point) for edge in edges])
    nearest = [edges[number] for number in np.argsort(apart, kind="stable")[:_MOST_EDGES] if np.isfinite(apart[number])]
    found = (_beside_edge(edge, side, depth, WallLines(solid, side, LEAST_AT_EDGE * depth))
             for edge in nearest for side in (wall, wall.turned))
    return min((each for each in found if each is not None), key=lambda each: each.distance, default=None)


def _beside_edge(edge, wall, depth, lines):
    """The wall at a depth beside one edge, across its first face: Witness or None."""
    start, (first, last) = on_edge(edge, load_freecad().Vector(*wall.point)), edge.ParameterRange

    def at(parameter, thinner_than=np.inf):
        place = _beside(lines.face, edge, parameter, wall.point, depth)
        found = None if place is None else lines.through(place, thinner_than)
        return None if found is None or wedge_angle((lines.face, lines.opposite), found) >= WALL_BELOW else found

    ends = min(depth / edge.Length, 0.5) * (last - first)
    length = last - first - 2.0 * ends
    places = [first + ends + share * length for share in _PLACES]
    found = [(at(place), place) for place in places]
    known = [(wall, place) for wall, place in found if wall is not None]
    if not known:
        return at(start)
    best, place = min(known, key=lambda each: each[0].distance)
    step = _OF_EDGE * length
    for _ in range(_STEPS):
        for other in (place - step, place + step):
            is_within = places[0] <= other <= places[-1] and lines.left > 0
            found = at(other, below(best)) if is_within else None
            if found is not None:
                best, place = found, other
        step *= 0.5
    return best


def _beside(face, edge, parameter, towards, depth):
    """Parameters of the place of a face at a depth beside an edge; None where the face ends before."""
    App = load_freecad()
    try:
        here = np.array(edge.valueAt(parameter))
        tangent = np.array(edge.tangentAt(parameter))
        normal = np.array(face.normalAt(*face.Surface.parameter(App.Vector(*here))))
        way = np.cross(normal, tangent)
        way *= np.sign(way @ (np.asarray(towards) - here)) / np.linalg.norm(way)
        reach = depth
        for _ in range(3):  # the surface may be curved: the place is that far from the edge
            place = tuple(map(float, face.Surface.parameter(App.Vector(*(here + reach * way)))))
            reach *= depth / np.linalg.norm(np.array(face.valueAt(*place)) - here)
    except (RuntimeError, ValueError, ArithmeticError):
        return None
    return place if face.isPartOfDomain(*place) else None

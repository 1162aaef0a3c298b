# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where a tapered wall is thinnest, and how thin, by lines through the shape itself and not through a mesh."""

from dataclasses import replace

import numpy as np

from ..bootstrap import load_freecad
from .face_crossings import is_on, surface_crossings

_STEPS = 6
"""Times that the step along an edge is halved."""

_FIRST_STEP, _LAST_STEP = 2.0, 0.002
"""Steps across a face, in thicknesses: the first is no longer, the last about as long."""

_MOST_LINES = 250
"""Lines through the shape for one wall."""

_FACTOR = 2.0
"""How many times as thick as the facets said a wall may be, and how many times as thin."""

_OF_EDGE = 0.05
"""First step along an edge, as a share of its length."""


def exact_taper(solid, wall, step, depth):
    """A tapered wall where it is thinnest near a place that was found between facets: Witness or None.

    Looked for across the face, along its normals, no farther than twice a step away.

    Parameters
    ----------
    solid : Part.Solid
    wall : Witness
    step : float, mm
        First step: about the size of the facets there.
    depth : float, mm
        No nearer than that to an edge at which the two faces meet.
    """
    face = solid.Faces[wall.face]
    edges = _common_edges(face, solid.Faces[wall.opposite_face])
    start = _parameters(face, wall.point)
    if start is None:
        return None
    lines = _Lines(solid, wall)
    per_mm = _parameters_per_mm(face, start)

    def at(place, thinner_than=np.inf):
        place = float(place[0]), float(place[1])
        found = lines.through(place, thinner_than)
        if found is None or any(_distance(edge, found.point) < depth for edge in edges):
            return None
        return found if face.isPartOfDomain(*place) else None

    best, place = at(start), np.array(start)
    reach, step, tried = 2.0 * step, min(step, _FIRST_STEP * wall.distance), {(0.0, 0.0)}
    while step > _LAST_STEP * wall.distance and lines.left > 0:
        moved = True
        while moved and lines.left > 0:
            moved = False
            for way in ((1, 0), (-1, 0), (0, 1), (0, -1), (1, 1), (-1, 1), (1, -1), (-1, -1)):
                other = place + step * np.array(way) * per_mm
                moved_on = (other - start) / per_mm
                number = tuple(np.rint(moved_on / (_LAST_STEP * wall.distance / 2.0)))
                if number in tried or np.linalg.norm(moved_on) > reach:
                    continue
                tried.add(number)
                found = at(other, _thinner(best))
                if found is not None:
                    best, place, moved = found, other, True
        step *= 0.5
    return best


def exact_edge_wall(solid, wall, depth):
    """A wall that ends in a sharp edge, as thick as it is at a depth beside it: Witness or None.

    The depth is measured across the face of the wall, at a right angle to the edge. Along the edge, the thinnest place
    near by is taken. None where the two faces have no edge together.

    Parameters
    ----------
    solid : Part.Solid
    wall : Witness
    depth : float, mm
    """
    App = load_freecad()
    face, point = solid.Faces[wall.face], App.Vector(*wall.point)
    placed = [(_distance(edge, point), number, at, edge)
              for number, edge in enumerate(_common_edges(face, solid.Faces[wall.opposite_face]))
              for at in [_on_edge(edge, point)] if at is not None]
    if not placed:
        return None
    _, _, start, edge = min(placed)
    lines = _Lines(solid, wall)
    first, last = edge.ParameterRange

    def at(parameter, thinner_than=np.inf):
        place = _beside(face, edge, parameter, wall.point, depth)
        return None if place is None else lines.through(place, thinner_than)

    best, place, step = at(start), start, _OF_EDGE * (last - first)
    for _ in range(_STEPS):
        for other in (place - step, place + step):
            found = at(other, _thinner(best)) if first < other < last and lines.left > 0 else None
            if found is not None:
                best, place = found, other
        step *= 0.5
    return best


class _Lines:
    """Lines through a wall, across its face to the opposite one."""

    def __init__(self, solid, wall):
        self._face, self._opposite = solid.Faces[wall.face], solid.Faces[wall.opposite_face]
        self._wall, self.left = wall, _MOST_LINES

    def through(self, place, thinner_than=np.inf):
        """The wall under a place of the face, by its parameters: Witness.

        None where there is none of about that size, or none that is thinner than a limit, mm.
        """
        App = load_freecad()
        import Part

        self.left -= 1
        wall = self._wall
        try:
            start, normal = np.array(self._face.valueAt(*place)), np.array(self._face.normalAt(*place))
            way = -normal * np.sign(normal @ (wall.point - wall.opposite))
            if not np.isfinite(way).all() or not way.any():
                return None
            line = Part.LineSegment(App.Vector(*start), App.Vector(*(start + _FACTOR * wall.distance * way)))
            ends = surface_crossings(line, self._opposite)
            lengths = [float((np.array(end) - start) @ way) for end in ends]
            most = min(_FACTOR * wall.distance, thinner_than)
            length = next((lengths[end] for end in np.argsort(lengths)
                           if wall.distance / _FACTOR < lengths[end] < most and is_on(self._opposite, ends[end])), None)
        except (RuntimeError, ValueError, ArithmeticError):  # OCC's own errors are RuntimeErrors: no normal there
            return None
        return None if length is None else replace(wall, distance=length, point=start, opposite=start + length * way)


def _thinner(best):
    """mm: what the thickness of another wall has to be under for it to be thinner than the best one, Witness or None."""
    return np.inf if best is None else best.distance * (1.0 - 1e-9)


def _parameters(face, point):
    App = load_freecad()
    try:
        return tuple(map(float, face.Surface.parameter(App.Vector(*point))))
    except (RuntimeError, ValueError):
        return None


def _parameters_per_mm(face, place):
    """ndarray of shape (2,): parameters of a surface by which a place moves on by a millimetre."""
    along, across = (np.linalg.norm(np.array(each)) for each in face.derivative1At(*place))
    return 1.0 / np.maximum([along, across], 1e-12)


def _common_edges(face, opposite):
    """Edges at which two faces meet; none where they are one face."""
    if face.isSame(opposite):
        return []
    others = opposite.Edges
    return [edge for edge in face.Edges if any(edge.isSame(other) for other in others)]


def _distance(edge, point):
    """Distance, mm, of a point from an edge; inf where that is not known."""
    App = load_freecad()
    point = App.Vector(*point)
    at = _on_edge(edge, point)
    return np.inf if at is None else edge.Curve.value(at).distanceToPoint(point)


def _on_edge(edge, point):
    """Parameter of the place of an edge nearest to a point; None where its curve has none."""
    try:
        first, last = edge.ParameterRange
        found = edge.Curve.parameter(point)
    except (RuntimeError, ValueError, AttributeError, TypeError):  # the pole of a ball is an edge without a curve
        return None
    return min(max(float(found), first), last)


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

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lines through a wall, across one of its faces."""

from dataclasses import replace

import numpy as np

from ..bootstrap import load_freecad
from .face_crossings import has_formula, is_on, surface_crossings
from .followed_crossing import FollowedCrossing

_MOST_LINES = 250
"""Lines through the shape for one wall."""

_FACTOR = 2.0
"""How many times as thick as the facets said a wall may be, and how many times as thin, where nothing else is known."""

_ALL_THE_WAY = 0.999
"""Share of the way through a wall that has to be inside."""


class WallLines:
    """Lines through a wall, across its face to the opposite one.

    Parameters
    ----------
    solid : Part.Solid
    wall : Witness
    least : float, mm, optional
        What is no thicker is another wall: half of this one by default.
    factor : float, optional
        How many times as thick as this one it may be.
    """

    def __init__(self, solid, wall, least=None, factor=_FACTOR):
        self.face, self.opposite = solid.Faces[wall.face], solid.Faces[wall.opposite_face]
        self._wall, self.left = wall, _MOST_LINES
        self._least = wall.distance / _FACTOR if least is None else least
        self._reach = factor * wall.distance
        # OCC cuts the others in a tenth of a millisecond.
        self._followed = None if has_formula(self.opposite) else FollowedCrossing(self.opposite, wall.opposite)
        self._expected = wall.distance

    def through(self, place, thinner_than=np.inf):
        """The wall under a place of the face, by its parameters: Witness.

        None where there is none of about that size, or none that is thinner than a limit, mm.
        """
        self.left -= 1
        wall = self._wall
        try:
            start, normal = np.array(self.face.valueAt(*place)), np.array(self.face.normalAt(*place))
            way = -normal * np.sign(normal @ (wall.point - wall.opposite))
            if not np.isfinite(way).all() or not way.any():
                return None
            length = self._length(start, way, min(self._reach, thinner_than))
        except (RuntimeError, ValueError, ArithmeticError):  # OCC's own errors are RuntimeErrors: no normal there
            return None
        return None if length is None else replace(wall, distance=length, point=start, opposite=start + length * way)

    def _length(self, start, way, most):
        """Length to the nearest crossing with the opposite face, mm; None where there is none within the limits."""
        length = None if self._followed is None else self._followed.along(start, way, self._expected)
        if length is not None and self._least < length:
            self._expected = length
            return length if length < most and self._followed.is_on_face else None
        return self._first_length(start, way, most)

    def _first_length(self, start, way, most):
        App = load_freecad()
        import Part

        line = Part.LineSegment(App.Vector(*start), App.Vector(*(start + self._reach * way)))
        ends = surface_crossings(line, self.opposite)
        lengths = [float((np.array(end) - start) @ way) for end in ends]
        return next((lengths[end] for end in np.argsort(lengths)
                     if self._least < lengths[end] < most and is_on(self.opposite, ends[end])), None)


def is_through_material(solid, wall):
    """Whether there is material all the way through a wall, and no bore: bool."""
    App = load_freecad()
    import Part

    try:
        inside = solid.common(Part.makeLine(App.Vector(*wall.point), App.Vector(*wall.opposite)))
    except (RuntimeError, ValueError):  # OCC's own errors are RuntimeErrors
        return False
    return inside.Length >= _ALL_THE_WAY * wall.distance


def below(best):
    """mm: what the thickness of another wall has to be under for it to be thinner than the best one, Witness or None."""
    return np.inf if best is None else best.distance * (1.0 - 1e-9)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The thickness of a wall by a line through the shape itself, and not through a mesh."""

from dataclasses import replace

import numpy as np

from ..bootstrap import load_freecad
from .face_crossings import crossings

_BEYOND = 1e-3
"""Length, as a share of the wall and of the solid, by which a line reaches beyond the wall on either side."""

_FURTHEST = 4.0
"""Chord errors between where facets have a wall's end and where the surface has it."""

_ABOUT = 0.97
"""Cosine of the greatest angle between a ray and the way across the face that it came from."""

_OTHER = 0.2
"""Share of its thickness by which a wall may differ from what facets said, where that is more."""


def exact_wall(solid, wall, error):
    """A wall that was found between facets, as the faces themselves have it: Witness or None.

    None where the faces do not enclose a wall there.

    Parameters
    ----------
    solid : Part.Solid
    wall : Witness
    error : float, mm
        How far facets lie from their faces.
    """
    App = load_freecad()
    import Part

    length = float(np.linalg.norm(wall.opposite - wall.point))
    if length <= 0.0:
        return None
    along = _through(solid.Faces[wall.face], wall, length)
    slack = max(_FURTHEST * error, _OTHER * length)
    beyond = slack + _BEYOND * (length + solid.BoundBox.DiagonalLength)
    start, end = wall.point - beyond * along, wall.point + (length + beyond) * along
    line = Part.LineSegment(App.Vector(*start), App.Vector(*end))
    ends = []
    for face, expected in ((wall.face, wall.point), (wall.opposite_face, wall.opposite)):
        met = [np.array(each) for each in crossings(line, solid.Faces[face])]
        near = [each for each in met if abs((each - expected) @ along) <= slack]
        if not near:
            return None
        ends.append(min(near, key=lambda each: abs((each - expected) @ along)))
    thickness = float((ends[1] - ends[0]) @ along)
    if thickness <= 0.0 or abs(thickness - length) > slack:
        return None
    return replace(wall, distance=thickness, point=ends[0], opposite=ends[1])


def _through(face, wall, length):
    """Direction through a wall, ndarray of shape (3,): across the face where that is about the way of the ray.

    A facet of a round face leans by up to half the angle between facets, and a line that leans is longer.
    """
    App = load_freecad()

    ray = (wall.opposite - wall.point) / length
    try:
        across = np.array(face.normalAt(*face.Surface.parameter(App.Vector(*wall.point))))
    except (RuntimeError, ValueError, ArithmeticError):  # OCC's own errors are RuntimeErrors: no normal there, as at an apex
        return ray
    across *= np.sign(across @ ray)
    return across if across @ ray > _ABOUT else ray

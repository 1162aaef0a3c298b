# SPDX-License-Identifier: LGPL-2.1-or-later
"""Places on faces and edges by their parameters."""

import numpy as np

from ...core.walls.walls import NONPARALLEL_BELOW
from ..bootstrap import load_freecad

STEEPEST = NONPARALLEL_BELOW + np.radians(0.5)
"""Angle, rad, between two faces from which on they enclose no wall: those of a thread of 60 degrees do, however its pitch
turns them and however they were made."""

_MOST_PARAMETERS = 100.0
"""Parameters by which a place moves on by a millimetre, at most, in ranges of the face, which may be small."""


def parameters(face, point):
    App = load_freecad()
    try:
        return tuple(map(float, face.Surface.parameter(App.Vector(*point))))
    except (RuntimeError, ValueError):
        return None


def parameters_per_mm(face, place):
    """ndarray of shape (2,): parameters of a surface by which a place moves on by a millimetre.

    At the pole of a ball or the tip of a cone no change of one of them moves it: that one is bounded. OCC takes minutes to
    bring an angle of a million turns back to the first one.
    """
    along, across = (np.linalg.norm(np.array(each)) for each in face.derivative1At(*place))
    first, last, low, high = face.ParameterRange
    most = _MOST_PARAMETERS * np.array([last - first, high - low])
    return np.minimum(1.0 / np.maximum([along, across], np.finfo(float).tiny), most)


def normals(faces, points):
    """Normals of faces, of each at its own point: ndarray of shape (k, 3); None where one has none."""
    found = []
    for face, point in zip(faces, points):
        place = parameters(face, point)
        try:
            found.append(None if place is None else np.array(face.normalAt(*place)))
        except (RuntimeError, ValueError, ArithmeticError):  # OCC's own errors are RuntimeErrors: no normal there
            return None
    if any(each is None or not np.isfinite(each).all() or not each.any() for each in found):
        return None
    return np.array(found)


def wedge_angle(faces, wall):
    """Angle, rad, between the two sides of a wall between two faces; 0 where a normal is not known."""
    across = normals(faces, (wall.point, wall.opposite))
    return 0.0 if across is None else float(np.arccos(np.clip(abs(across[0] @ across[1]), 0.0, 1.0)))


def common_edges(face, opposite):
    """Edges at which two faces meet; none where they are one face."""
    if face.isSame(opposite):
        return []
    others = opposite.Edges
    return [edge for edge in face.Edges if any(edge.isSame(other) for other in others)]


def distance_to_edge(edge, point):
    """Distance, mm, of a point from an edge; inf where that is not known."""
    App = load_freecad()
    point = App.Vector(*point)
    at = on_edge(edge, point)
    return np.inf if at is None else edge.Curve.value(at).distanceToPoint(point)


def on_edge(edge, point):
    """Parameter of the place of an edge nearest to a point; None where its curve has none."""
    try:
        first, last = edge.ParameterRange
        found = edge.Curve.parameter(point)
    except (RuntimeError, ValueError, AttributeError, TypeError):  # the pole of a ball is an edge without a curve
        return None
    return min(max(float(found), first), last)

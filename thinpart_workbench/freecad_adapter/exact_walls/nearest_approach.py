# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the two faces of a tapered wall come nearest to each other, on the shape itself and not on a mesh."""

from dataclasses import replace
from typing import NamedTuple, Optional

import numpy as np

from ...core.walls.face_thickness import Witness
from ...core.walls.thin_places import LEAST
from ..bootstrap import load_freecad
from .face_places import STEEPEST, common_edges, distance_to_edge, normals, parameters

_MOST_TURNS = 60
"""Turns in which two faces are followed to where they are nearest; 20 are enough where they do not touch."""

_SETTLED = 1e-6
"""Share by which the way between them gets shorter in the last turn."""

_STRAIGHT = np.cos(np.radians(0.5))
"""Cosine of the angle up to which a way through a wall is straight across a face."""


class Approach(NamedTuple):
    """What becomes of a wall towards where its faces come nearest to each other.

    Attributes
    ----------
    wall : Witness or None
        The wall there, straight across one of the faces; None where there is none.
    ends : list of two ndarrays of shape (3,), mm, or None
        The nearest places, where the wall is across neither of the faces, as at the top of a rib with a draft.
    meets : bool
        Whether the faces meet there, in an edge.
    is_wall : bool
        Whether they enclose a wall up to there: not where they round off, so that the wall ends at steeper angles.
    """

    wall: Optional[Witness] = None
    ends: Optional[list] = None
    meets: bool = False
    is_wall: bool = True

    @property
    def apart(self):
        """float, mm: distance of the nearest places; 0 where they are not known."""
        return 0.0 if self.ends is None else float(np.linalg.norm(self.ends[1] - self.ends[0]))


def nearest_approach(solid, wall, depth):
    """Follow a wall to where its two faces come nearest to each other: Approach.

    A search along the normals of one face stops at its border, and knows not how thin the wall is across the other one. The
    nearest places of the one and of the other are taken in turn instead, on their borders too (Cheney and Goldstein 1959,
    doi:10.1090/S0002-9939-1959-0105008-8), with longer and longer steps while they lead on.

    Parameters
    ----------
    solid : Part.Solid
    wall : Witness
    depth : float, mm
        No nearer than that to an edge at which the two faces meet.
    """
    faces = solid.Faces[wall.face], solid.Faces[wall.opposite_face]
    if faces[0].isSame(faces[1]):
        return Approach()
    edges = common_edges(*faces)

    def meet(ends):
        return any(distance_to_edge(edge, end) < depth for edge in edges for end in ends)

    ends = _followed(faces, wall.point, meet)
    if ends is None:
        return Approach()
    if meet(ends):
        return Approach(meets=True)
    length = float(np.linalg.norm(ends[1] - ends[0]))
    before, after = normals(faces, (wall.point, wall.opposite)), normals(faces, ends)
    if before is None or after is None:
        return Approach()
    # Which side of a face the material is on does not change along it.
    across = after * np.sign(before @ (wall.opposite - wall.point))[:, None]
    if length <= LEAST * depth:
        return Approach()
    along = (ends[1] - ends[0]) / length
    if min(across @ along) <= 0.0:
        return Approach()  # not through the material: a face bends round to where it is nearer through the air
    if max(across @ along) < _STRAIGHT:
        return Approach(ends=ends)
    if across[0] @ across[1] < np.cos(STEEPEST):
        return Approach(is_wall=False)
    return Approach(replace(wall, distance=length, point=ends[0], opposite=ends[1]))


def _followed(faces, start, meet):
    """The places of two faces nearest to each other, from a point of the first on: list of two ndarrays, or None.

    What comes to where the faces `meet` is followed no further.
    """
    here, there = start, _nearest_on(faces[1], start)
    length, stretch = np.inf, 1.0
    for _ in range(_MOST_TURNS):
        if there is None:
            return None
        onward = _nearest_on(faces[0], there)
        if onward is None:
            return None
        step, here = onward - here, onward
        before, length = length, float(np.linalg.norm(there - here))
        if length > before * (1.0 - _SETTLED) or meet([here, there]):
            break
        further = _nearest_on(faces[0], here + stretch * step)
        beyond = None if further is None else _nearest_on(faces[1], further)
        if beyond is not None and np.linalg.norm(beyond - further) < length:
            here, there, stretch = further, beyond, 2.0 * stretch
        else:
            there, stretch = _nearest_on(faces[1], here), 1.0
    return None if there is None else [here, there]


def _nearest_on(face, point):
    """The point of a face nearest to another: ndarray of shape (3,); None where OCC knows none."""
    App = load_freecad()
    import Part

    place = parameters(face, point)
    try:
        if place is not None and face.isPartOfDomain(*place):
            return np.array(face.valueAt(*place))
        _, pairs, _ = face.distToShape(Part.Vertex(App.Vector(*point)))
        return np.array(pairs[0][0])
    except (RuntimeError, ValueError, ArithmeticError, IndexError):  # OCC's own errors are RuntimeErrors
        return None

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Walls between faces that are near each other, wherever samples lie."""

from dataclasses import dataclass, field

import numpy as np

MOST_TRIED = 40
"""Pairs of faces, equal ones counted once, that are looked for in the part's own geometry, the nearest first."""

EQUALLY_THIN = 1.02
"""How many times as thick as another one a place may be, between equal faces, that is no wall where the other is none."""

_THINNER = 0.99
"""Share of the thinnest under which another wall is looked for: what is no thinner tells nothing new."""

_SAME_PLACE = 2.0
"""How far apart, in thicknesses, two places of two faces are one."""


@dataclass
class NearWalls:
    """What was found between faces that are near each other.

    Attributes
    ----------
    walls : list of (Witness, kind)
        Each thinner than all before.
    no_walls : dict
        A Witness of two faces that enclose no wall where they are nearest, by the numbers of these, the lower first.
    left_out : set
        Pairs of faces that were not looked at: neighbours.
    """

    walls: list = field(default_factory=list)
    no_walls: dict = field(default_factory=dict)
    left_out: set = field(default_factory=set)

    def has_seen(self, wall):
        """Whether the two faces of a wall were looked at, if they are near enough to be its sides: bool."""
        return wall.face != wall.opposite_face and _faces_of(wall) not in self.left_out

    def is_no_wall(self, wall):
        """Whether there is none at the place of another: bool."""
        nearest = self.no_walls.get(_faces_of(wall))
        return nearest is not None and min(
            np.linalg.norm(side.point - nearest.point) for side in (wall, wall.turned)) <= _SAME_PLACE * nearest.distance


def near_walls(near, confirmed, thinnest, left_out, equal_faces):
    """Look for walls thinner than what is known between faces that are near each other: NearWalls.

    Parameters
    ----------
    near : callable
        Called with a callable that returns how near faces have to be, mm; yields pairs of them as Witness: `near_faces`.
    confirmed : callable
        As of `thinnest_place`.
    thinnest : float, mm
    left_out : set
        Pairs of faces that `near` leaves out.
    equal_faces : ndarray of shape (f,), int64, or None
        For each face, the first one equal to it.
    """
    found = NearWalls(left_out=left_out)
    tried: dict = {}  # how near the last ones were, by what their faces are equal to

    def least():
        return _THINNER * min([thinnest, *(wall.distance for wall, _ in found.walls)])

    for pair in near(least):
        faces = _faces_of(pair)
        equal = faces if equal_faces is None else tuple(sorted(equal_faces[list(faces)]))
        if pair.distance >= least() or len(tried) == MOST_TRIED:
            break
        if pair.distance <= EQUALLY_THIN * tried.get(equal, 0.0):
            continue
        tried[equal] = pair.distance
        wall, kind = confirmed(pair, None, pair.distance, np.inf, least())
        if wall is None:
            found.no_walls[faces] = pair
        elif wall.distance < least():
            found.walls.append((wall, kind))
    return found


def _faces_of(wall):
    return min(wall.face, wall.opposite_face), max(wall.face, wall.opposite_face)

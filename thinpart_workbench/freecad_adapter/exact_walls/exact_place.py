# SPDX-License-Identifier: LGPL-2.1-or-later
"""The thinnest place near a wall that was found between facets."""

from typing import NamedTuple, Optional

import numpy as np

from ...core.descriptors.wall_kinds import EDGE, PARALLEL, TAPERED
from ...core.walls.face_thickness import Witness
from ...core.walls.thin_places import ends_in_sharp_edge, is_blunt_edge
from ...core.walls.walls import PARALLEL_BELOW
from .edge_wall import exact_edge_wall
from .exact_taper import exact_taper
from .exact_wall import exact_wall
from .face_places import STEEPEST, wedge_angle
from .nearest_approach import nearest_approach
from .wall_extent import with_extent

_MOST_FOLLOWED, _SETTLED = 4, 0.99
"""Times that a wall that may be the thinnest is followed on, where it was found as far away as was looked, and the share of
its thickness from which on that leads no further."""


class ExactPlace(NamedTuple):
    """The thinnest place near a wall.

    Attributes
    ----------
    wall : Witness or None
        None where OCC finds none.
    kind : str or None
        One of `WALL_KINDS`: `EDGE` where it is told at a depth beside a sharp edge; None where it is not known.
    is_wall : bool
        False where the two faces enclose no wall after all, but round off, or break an edge.
    """

    wall: Optional[Witness] = None
    kind: Optional[str] = None
    is_wall: bool = True


def exact_place(solid, wall, error, kind, depth, step, least):
    """The thinnest place near a wall between facets, as the faces have it: ExactPlace.

    Parameters
    ----------
    solid : Part.Solid
    wall : Witness
    error : float, mm
        How far facets lie from their faces.
    kind : str or None
        One of `WALL_KINDS`: `EDGE` where its two faces are known to meet in a sharp edge; None for two faces that are near
        each other, and of which only a wall thinner than `least` is of interest.
    depth : float, mm
        Beside such an edge, at which the wall is measured.
    step : float, mm
        Size of the facets there.
    least : float, mm
        The thinnest that is known of the part; what is no thinner, such as an equal tooth, is not searched to the end.
    """
    if kind == EDGE:
        return ExactPlace(exact_edge_wall(solid, wall, depth), EDGE)
    approach = nearest_approach(solid, wall, depth)
    if kind is None and (approach.meets or approach.apart >= least):
        return ExactPlace(is_wall=False)
    beside = exact_edge_wall(solid, wall, depth) if approach.meets else None
    if beside is not None and ends_in_sharp_edge(beside.distance, depth):
        return ExactPlace(beside, EDGE)
    # Two halves of a body meet in edges that are not sharp, and see each other across it.
    if beside is None and (approach.meets or not approach.is_wall):
        return ExactPlace(is_wall=False)
    sides = (wall, wall.turned) if kind is None or approach.ends else (wall,)
    walls = [approach.wall] if approach.wall else _along_normals(solid, sides, approach.ends, step, depth, least)
    if not walls and kind is not None:
        walls = [each for each in [exact_wall(solid, wall, error)] if each is not None]
    if not walls:
        return ExactPlace()
    found = next(filter(None, (
        each if each.distance >= least else with_extent(solid, each, depth) for each in walls)), None)
    if found is None:
        return ExactPlace(is_wall=False)
    angle = wedge_angle((solid.Faces[found.face], solid.Faces[found.opposite_face]), found)
    if angle >= STEEPEST or is_blunt_edge(angle, found.distance, depth):
        return ExactPlace(is_wall=False)
    return ExactPlace(found, PARALLEL if angle < PARALLEL_BELOW else TAPERED)


def _along_normals(solid, sides, nearest, step, depth, least):
    """What is found along the normals of the first face of each side of a wall, the thinnest first: list of Witness."""
    found = [_followed_on(solid, side, step, depth, towards, least) for side, towards in zip(sides, nearest or [None, None])]
    return sorted((each for each in found if each is not None), key=lambda each: each.distance)


def _followed_on(solid, wall, step, depth, towards, least):
    """The thinnest along the normals of its first face, followed further as long as it may be the thinnest of the part."""
    found = exact_taper(solid, wall, step, depth, towards, least)
    for _ in range(_MOST_FOLLOWED):
        if found is None or found.distance >= least or np.linalg.norm(found.point - wall.point) < step:
            break
        further = exact_taper(solid, found, step, depth, None, least)
        if further is None or further.distance > _SETTLED * found.distance:
            break
        wall, found = found, further
    return found

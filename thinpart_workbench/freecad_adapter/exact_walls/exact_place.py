# SPDX-License-Identifier: LGPL-2.1-or-later
"""The thinnest place near a wall that was found between facets."""

from typing import NamedTuple, Optional

from ...core.walls.face_thickness import Witness
from ...core.walls.walls import NONPARALLEL_BELOW
from .edge_wall import exact_edge_wall
from .exact_taper import exact_taper
from .exact_wall import exact_wall
from .face_places import wedge_angle
from .nearest_approach import nearest_approach


class ExactPlace(NamedTuple):
    """The thinnest place near a wall.

    Attributes
    ----------
    wall : Witness or None
        None where OCC finds none.
    ends_in_edge : bool
        Whether it ends in a sharp edge, so that it is told at a depth beside it.
    is_wall : bool
        False where the two faces enclose no wall after all, but round off.
    """

    wall: Optional[Witness] = None
    ends_in_edge: bool = False
    is_wall: bool = True


def exact_place(solid, wall, error, ends_in_edge, depth, step, least):
    """The thinnest place near a wall between facets, as the faces have it: ExactPlace.

    Parameters
    ----------
    solid : Part.Solid
    wall : Witness
    error : float, mm
        How far facets lie from their faces.
    ends_in_edge : bool
        Whether its two faces are known to meet in a sharp edge.
    depth : float, mm
        Beside such an edge, at which the wall is measured.
    step : float, mm
        Size of the facets there.
    least : float, mm
        The thinnest that is known of the part; what is no thinner, such as an equal tooth, is not searched to the end.
    """
    if ends_in_edge:
        return ExactPlace(exact_edge_wall(solid, wall, depth), True)
    approach = nearest_approach(solid, wall, depth)
    if approach.meets:
        beside = exact_edge_wall(solid, wall, depth)
        return ExactPlace(beside, True, beside is not None)
    if not approach.is_wall:
        return ExactPlace(is_wall=False)
    if approach.wall is not None:
        return ExactPlace(approach.wall)
    found = _along_normals(solid, wall, approach.ends, step, depth, least)
    if found is None:
        return ExactPlace(exact_wall(solid, wall, error))
    rounds_off = wedge_angle((solid.Faces[found.face], solid.Faces[found.opposite_face]), found) >= NONPARALLEL_BELOW
    return ExactPlace(is_wall=False) if rounds_off else ExactPlace(found)


def _along_normals(solid, wall, nearest, step, depth, least):
    """The thinnest of what is found along the normals of either face: Witness or None."""
    found = [exact_taper(solid, side, step, depth, towards, least)
             for side, towards in zip((wall, wall.turned), nearest or [None])]
    return min((each for each in found if each is not None), key=lambda each: each.distance, default=None)

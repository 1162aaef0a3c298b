# SPDX-License-Identifier: LGPL-2.1-or-later
"""The thinnest place near a wall that was found between facets."""

from typing import NamedTuple, Optional

from ...core.descriptors.wall_kinds import EDGE, PARALLEL, TAPERED
from ...core.walls.face_thickness import Witness
from ...core.walls.thin_places import ends_in_sharp_edge, is_blunt_edge
from ...core.walls.walls import NONPARALLEL_BELOW, PARALLEL_BELOW
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
    kind : str or None
        One of `WALL_KINDS`: `EDGE` where it is told at a depth beside a sharp edge; None where it is not known.
    is_wall : bool
        False where the two faces enclose no wall after all, but round off, or break an edge.
    """

    wall: Optional[Witness] = None
    kind: Optional[str] = None
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
        return ExactPlace(exact_edge_wall(solid, wall, depth), EDGE)
    approach = nearest_approach(solid, wall, depth)
    beside = exact_edge_wall(solid, wall, depth) if approach.meets else None
    if beside is not None and ends_in_sharp_edge(beside.distance, depth):
        return ExactPlace(beside, EDGE)
    # Two halves of a body meet in edges that are not sharp, and see each other across it.
    if beside is None and (approach.meets or not approach.is_wall):
        return ExactPlace(is_wall=False)
    found = approach.wall or _along_normals(solid, wall, approach.ends, step, depth, least)
    if found is None:
        return ExactPlace(exact_wall(solid, wall, error))
    angle = wedge_angle((solid.Faces[found.face], solid.Faces[found.opposite_face]), found)
    if angle >= NONPARALLEL_BELOW or is_blunt_edge(angle, found.distance, depth):
        return ExactPlace(is_wall=False)
    return ExactPlace(found, PARALLEL if angle < PARALLEL_BELOW else TAPERED)


def _along_normals(solid, wall, nearest, step, depth, least):
    """The thinnest of what is found along the normals of either face: Witness or None."""
    found = [exact_taper(solid, side, step, depth, towards, least)
             for side, towards in zip((wall, wall.turned), nearest or [None])]
    return min((each for each in found if each is not None), key=lambda each: each.distance, default=None)

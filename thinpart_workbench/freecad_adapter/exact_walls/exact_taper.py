# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where a tapered wall is thinnest along the normals of one of its faces."""

import numpy as np

from ...core.walls.thin_places import LEAST
from .face_places import common_edges, distance_to_edge, parameters, parameters_per_mm
from .wall_lines import WallLines, below

_ON_THE_WAY = np.append(np.linspace(0.125, 0.875, 7), 1.0 - 1e-6)
"""Places from a sample to where the faces are nearest, as shares of the way; the last is on a border, but for rounding."""

_FIRST_STEP, _LAST_STEP = 2.0, 0.002
"""Steps across a face, in thicknesses: the first is no longer, the last about as long."""

_STEEPEST = 4.0
"""How much thinner a wall may get near by, in steps that led to nothing thinner: its sides are at 60 degrees at most, and
one may lean."""


def exact_taper(solid, wall, step, depth, towards=None, least=np.inf):
    """A tapered wall where it is thinnest near a place that was found between facets: Witness or None.

    Looked for across the face, along its normals, no farther away than twice a step and the way to where the faces are
    nearest, and first on that way.

    Parameters
    ----------
    solid : Part.Solid
    wall : Witness
    step : float, mm
        First step: about the size of the facets there.
    depth : float, mm
        No nearer than that to an edge at which the two faces meet.
    towards : ndarray of shape (3,), mm, optional
        The place of the face that is nearest to the opposite one; across it, there may be no wall.
    least : float, mm, optional
        Where a wall is not that thin, and cannot be near by, it is not followed further.
    """
    face = solid.Faces[wall.face]
    edges = common_edges(face, solid.Faces[wall.opposite_face])
    start = parameters(face, wall.point)
    if start is None:
        return None
    lines = WallLines(solid, wall, LEAST * depth)
    per_mm = parameters_per_mm(face, start)

    def at(place, thinner_than=np.inf):
        place = float(place[0]), float(place[1])
        found = lines.through(place, thinner_than)
        if found is None or any(distance_to_edge(edge, found.point) < depth for edge in edges):
            return None
        return found if face.isPartOfDomain(*place) else None

    best, place, reach = at(start), np.array(start), 2.0 * step
    nearest = None if towards is None else parameters(face, towards)
    if nearest is not None:
        for share in _ON_THE_WAY:
            other = (1.0 - share) * np.array(start) + share * np.array(nearest)
            found = at(other, below(best))
            if found is not None:
                best, place = found, other
        if best is not None and best.distance >= least:
            return best
        reach += float(np.linalg.norm((np.array(nearest) - start) / per_mm))
    step, tried = min(step, _FIRST_STEP * wall.distance), {(0.0, 0.0)}
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
                found = at(other, below(best))
                if found is not None:
                    best, place, moved = found, other, True
        if best is not None and best.distance - _STEEPEST * step >= least:
            break
        step *= 0.5
    return best

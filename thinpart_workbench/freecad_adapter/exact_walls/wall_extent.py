# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether a wall covers some area, and has the material between its faces."""

import numpy as np

from .face_places import normals, parameters
from .wall_lines import WallLines, is_through_material

_BESIDE = ((np.sqrt(2.0), 8), (2.0, 16))
"""How far from the thinnest place the wall is looked for, in depths, and in how many directions: two neighbours and the
thinnest place enclose about the square of the depth, the second two in a corner too."""

_THICKER = 5.0
"""How many times as thick the wall may be there: at 60 degrees, beside a depth that is as long as it is thick, 4.5 times."""

_AT_PLACE, _HALVED = 0.01, 6
"""Share of the way to such a neighbour up to which the wall is at its place, and times that the way is halved otherwise."""


def with_extent(solid, wall, depth):
    """The wall, if it goes on from its thinnest place, across one of its faces, over an area of a depth by a depth: Witness.

    Two faces may be nearest where the one ends and the other begins, such as a pin that stands on a face near its border:
    nothing lies between them. Or there is air between them, such as a bore: None then. Where a side of the wall is hollow,
    the wall is there where it begins.

    Parameters
    ----------
    solid : Part.Solid
    wall : Witness
    depth : float, mm
    """
    found = (_covering(solid, side, depth) for side in (wall, wall.turned))
    return next((each for each in found if each is not None), None)


def _covering(solid, wall, depth):
    """The wall, if it covers that across its first face: Witness or None."""
    lines = WallLines(solid, wall, 0.0, _THICKER)
    normal = normals([lines.face], [wall.point])
    if normal is None:
        return None
    along = np.linalg.svd(normal)[2][1:]
    for reach, count in _BESIDE:
        ways = 2.0 * np.pi * np.arange(count) / count
        last = _through(lines, wall.point + reach * depth * along[0])
        for way in [*ways[1:], 0.0]:
            before, last = last, _through(
                lines, wall.point + reach * depth * (np.cos(way) * along[0] + np.sin(way) * along[1]))
            if before is not None and last is not None and is_through_material(solid, last):
                return _first_inside(solid, lines, wall, last)
    return None


def _first_inside(solid, lines, wall, inside):
    """The wall, or the nearest one on the way to another, that has the material between its faces as that has: Witness."""
    def at(share):
        found = _through(lines, (1.0 - share) * wall.point + share * inside.point)
        return found if found is not None and is_through_material(solid, found) else None

    if at(_AT_PLACE) is not None:
        return wall
    nearest, low, high = inside, _AT_PLACE, 1.0
    for _ in range(_HALVED):
        middle = 0.5 * (low + high)
        found = at(middle)
        low, high = (middle, high) if found is None else (low, middle)
        nearest = nearest if found is None else found
    return nearest


def _through(lines, point):
    """The wall under the place of the face near a point: Witness or None."""
    place = parameters(lines.face, point)
    return lines.through(place) if place is not None and lines.face.isPartOfDomain(*place) else None

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether a tapered wall is as wide as it is thick, or only a broken edge."""

import numpy as np

from ..bootstrap import load_freecad
from .face_places import STEEPEST, normals, parameters, parameters_per_mm, wedge_angle
from .wall_lines import WallLines, is_through_material

_AS_WIDE = 0.98
"""Width, in thicknesses, from which on a taper is a wall: not quite 1, so that a square counts however it is rounded."""

_FIRST_STEP, _LAST_STEP, _LONGER = 0.5, 0.05, 1.5
"""Steps across a face, in thicknesses, and how much longer the next one is after one that led on."""

_GROWS = 1e-4
"""Share by which a wall is thicker after a step that leads on."""

_MOST = 5.0
"""How many times as thick a wall may get on the way: at 60 degrees, 2.7 times, and twice as thick across the other face."""

_LEVEL, _BENEATH = 0.5, 0.1
"""Share by which a wall gets thinner beyond a taper, of what it would at the same angle, up to which it levels off; and
where it begins there, in thicknesses: its first face may bend."""

_ACROSS = np.cos(np.radians(2.0))
"""Cosine of the angle up to which a wall is across a face."""

_OF_THREAD = np.radians(59.0)
"""Angle from which on two sides may be flanks of a thread of 60 degrees."""

_STEPS = 8
"""Steps in which a face is followed for as long as the wall is thick."""

_WAYS = tuple((np.cos(way), np.sin(way)) for way in np.radians(np.arange(0.0, 360.0, 45.0)))


def goes_on(solid, wall, depth):
    """Whether there is a wall beyond a taper where that is thinnest, no thinner, as below the corner of a slot: bool.

    Beyond a chamfer there is none, and beyond a part of a rounded edge it gets thinner still.

    Parameters
    ----------
    solid : Part.Solid
    wall : Witness
        Where the taper is thinnest.
    depth : float, mm
        How far beyond.
    """
    return any(_levels_off(solid, side, depth) for side in (wall, wall.turned))


def _levels_off(solid, wall, depth):
    """Whether there is one across its first face, if the wall is across that: bool."""
    App = load_freecad()

    faces = solid.Faces[wall.face], solid.Faces[wall.opposite_face]
    across = normals(faces, (wall.point, wall.opposite))
    through = wall.opposite - wall.point
    if across is None or abs(across[0] @ through) < _ACROSS * wall.distance:
        return False
    beyond = wall.point - depth * _steepest(*across, through)
    thinner = _LEVEL * depth * np.tan(wedge_angle(faces, wall)) / wall.distance
    return all(solid.isInside(App.Vector(*(beyond + share * through)), 0.0, False) for share in (1.0 - thinner, _BENEATH))


def is_as_wide_as_thick(solid, wall):
    """Whether a tapered wall goes on, where it gets thicker, until it is as wide as it is thick: bool.

    A chamfer does not: it is narrower than the part is thick there. The width is along the way by which the thickness
    grows most; or, where the two sides part along another one as on a thread that runs out, that over which it grows as
    much at the angle of the sides.

    Parameters
    ----------
    solid : Part.Solid
    wall : Witness
        Where the taper is thinnest.
    """
    sides, faces = (wall, wall.turned), (solid.Faces[wall.face], solid.Faces[wall.opposite_face])
    return any(_gets_wide(solid, side) for side in sides) or (
        wedge_angle(faces, wall) >= _OF_THREAD and all(_is_as_long(solid, side) for side in sides))


def _is_as_long(solid, wall):
    """Whether its first face is as long, along the way by which the wall gets thicker, as the wall is thick: bool.

    Straight across one flank of a thread, the other one soon ends, however long both are: the wall itself is not as wide.
    """
    face = solid.Faces[wall.face]
    across = normals((face, solid.Faces[wall.opposite_face]), (wall.point, wall.opposite))
    if across is None:
        return False
    way = _AS_WIDE * wall.distance * _steepest(*across, wall.opposite - wall.point)

    def steps(sense):
        places = (wall.point + sense * (step + 1) / _STEPS * way for step in range(_STEPS))
        return next((step for step, place in enumerate(places) if not _is_on(face, place)), _STEPS)

    return steps(1.0) + steps(-1.0) >= _STEPS


def _is_on(face, point):
    place = parameters(face, point)
    return place is not None and face.isPartOfDomain(*place)


def _gets_wide(solid, wall):
    """Whether the wall does so across its first face: bool."""
    faces = solid.Faces[wall.face], solid.Faces[wall.opposite_face]
    across, place = normals(faces, (wall.point, wall.opposite)), parameters(faces[0], wall.point)
    lines = WallLines(solid, wall, 0.0, _MOST)
    here = None if across is None or place is None else lines.through(place)
    if here is None:
        return False
    width, steepest = _AS_WIDE * wall.distance, _steepest(*across, wall.opposite - wall.point)
    enough = here.distance + width * np.tan(wedge_angle(faces, wall))
    per_mm, thickness, step = parameters_per_mm(faces[0], place), here.distance, _FIRST_STEP * wall.distance
    while step > _LAST_STEP * wall.distance and lines.left > 0:
        thicker, onward = thickness * (1.0 + _GROWS), None
        for way in _WAYS:
            other = tuple(np.array(place) + step * np.array(way) * per_mm)
            found = lines.through(other) if faces[0].isPartOfDomain(*other) else None
            if found is None or found.distance <= here.distance or wedge_angle(faces, found) >= STEEPEST:
                continue
            moved = found.point - wall.point
            if (moved @ steepest >= width or found.distance >= enough and np.linalg.norm(moved) >= width) \
                    and is_through_material(solid, found):
                return True
            if found.distance > thicker:
                thicker, onward = found.distance, other
        if onward is None:
            step *= 0.5
        else:
            place, thickness, step = onward, thicker, _LONGER * step
    return False


def _steepest(here, there, through):
    """Unit vector along a face, ndarray of shape (3,), by which the wall gets thicker most; zeros where it is parallel.

    Parameters
    ----------
    here, there : ndarray of shape (3,)
        Normals of the face and of the opposite one.
    through : ndarray of shape (3,)
        From the face to the opposite one.
    """
    outward = there * np.sign(there @ through)
    way = (outward @ here) * here - outward
    return way / max(float(np.linalg.norm(way)), np.finfo(float).tiny)

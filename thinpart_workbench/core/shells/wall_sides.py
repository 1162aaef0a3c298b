# SPDX-License-Identifier: LGPL-2.1-or-later
"""The two sides of a part that is one wall throughout: bent, drawn, blown or lofted, whatever its faces are."""

from dataclasses import dataclass

import numpy as np

from ..thickness.region_shape import area_median

FARTHEST = 2.0
"""Thickness by its median up to which two faces are the sides of one wall: beyond, they see each other through a rib."""

MOST_ANGLE = np.radians(40.0)
"""Between two sides of a wall: a rim that is cut at a slant sees one of them at a greater one."""

WALLED = 0.5
"""Share of a face that is such a side from which on it belongs to one: rims see each other across the part."""

LEAST_SQUARES = 40.0
"""Area of a side by the squared thickness from which on it is one of a shell."""


@dataclass(frozen=True)
class WallSide:
    """Faces that hold together and lie on one side of the wall.

    Attributes
    ----------
    faces : tuple of int
        Indices of B-Rep faces, from 0, in rising order.
    pairs : list of tuple of int
        Two faces each, one of this side and one that it sees on the other, the lower first.
    area : float, mm2
    thickness : float, mm
        Median by area.
    """

    faces: tuple
    pairs: list
    area: float
    thickness: float


def wall_sides(field, meetings, count):
    """Divide the faces of a solid into the two sides of its wall: list of WallSide, the largest first.

    Faces that see each other through the material lie on different sides, faces that share an edge on the same one. The
    heavier claims count first; what contradicts them, as at the root of a rib, is dropped. Sides that are too small by the
    thickness of the wall are not given.

    Parameters
    ----------
    field : ThicknessField
    meetings : dict
        Length of the edges that two faces share, mm, by their indices, the lower first.
    count : int
        Number of faces.
    """
    known = np.flatnonzero((field.area > 0.0) & (field.opposite >= 0))
    if not len(known):
        return []
    thickness = area_median(field.distance[known], field.area[known])
    near = known[(field.distance[known] < FARTHEST * thickness) & (field.wedge_angle[known] < MOST_ANGLE)]
    here, there = field.face[near], field.mesh.face_of_triangle[field.opposite[near]]
    area = np.bincount(field.face, field.area, count)
    walled = np.bincount(here, field.area[near], count) > WALLED * area
    claims = [(length, *faces, 0) for faces, length in meetings.items() if walled[list(faces)].all()]
    pairs, number = np.unique(np.column_stack([np.minimum(here, there), np.maximum(here, there)]), axis=0,
                              return_inverse=True)
    weights = np.bincount(number.ravel(), field.area[near] / field.distance[near])
    claims += [(weight, first, second, 1) for (first, second), weight in zip(pairs.tolist(), weights.tolist())
               if first != second]
    side = _by_parity(claims, count)
    found = []
    for faces in _connected(np.flatnonzero(walled).tolist(), meetings, side):
        root, parity = side[faces[0]]
        own = near[np.isin(here, faces)]
        if not len(own) or area[faces].sum() < LEAST_SQUARES * thickness ** 2:
            continue
        seen = [pair for pair in map(tuple, pairs.tolist()) if any(
            pair[here] in faces and side[pair[1 - here]] == (root, 1 - parity) for here in (0, 1))]
        found.append(WallSide(tuple(faces), seen, float(area[faces].sum()),
                              area_median(field.distance[own], field.area[own])))
    return sorted(found, key=lambda each: -each.area)


def _by_parity(claims, count):
    """What each face is tied to, and whether on the same side: list of (int, 0 or 1).

    Claims are weight, two faces, and 1 where they lie on different sides.
    """
    parent, turned = list(range(count)), [0] * count

    def root(face):
        parity = 0
        while parent[face] != face:
            parity ^= turned[face]
            face = parent[face]
        return face, parity

    for _, first, second, differs in sorted(claims, reverse=True):
        (one, parity), (other, far) = root(first), root(second)
        if one != other:
            parent[one], turned[one] = other, parity ^ far ^ differs
    return [root(face) for face in range(count)]


def _connected(faces, meetings, side):
    """Groups of faces that share edges and lie on one side: list of list of int, in rising order."""
    meets: dict = {face: set() for face in faces}
    for first, second in meetings:
        if first in meets and second in meets and side[first] == side[second]:
            meets[first].add(second)
            meets[second].add(first)
    left, groups = set(faces), []
    while left:
        group = [left.pop()]
        for face in group:
            more = meets[face] & left
            left -= more
            group += sorted(more)
        groups.append(sorted(group))
    return groups

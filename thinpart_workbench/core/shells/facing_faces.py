# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pairs of faces that are the two sides of a wall."""

from dataclasses import dataclass

import numpy as np

MOST_ANGLE = np.radians(15.0)
"""Between two sides of a wall that a shell can stand for: a rib with seven degrees of draft on each side."""

LEAST_SQUARES = 0.25
"""Area of a side by the squared thickness from which on two faces are looked at."""

VARIED = 1.6
"""Ratio of the thickness at 90 percent of a pair to that at 10 percent from which on it is no wall of two sides."""


@dataclass(frozen=True)
class FacingFaces:
    """Two faces with material between them.

    Attributes
    ----------
    faces : tuple of int
        Two indices of B-Rep faces, the lower first.
    area : float, mm2
        Of one side.
    thickness : float, mm
        Median.
    middles : ndarray of shape (m, 3), mm
        Half-way through the wall, from either side, in the coordinates of the document.
    distances : ndarray of shape (m,), mm
        Thickness there.
    """

    faces: tuple
    area: float
    thickness: float
    middles: np.ndarray
    distances: np.ndarray


def facing_faces(field):
    """Find the pairs of faces that are the sides of walls: list of FacingFaces.

    The largest in terms of its thickness first. A face that sees itself, as that of a rod does, is no wall.
    """
    known = np.flatnonzero((field.area > 0.0) & (field.opposite >= 0) & (field.wedge_angle < MOST_ANGLE))
    here, there = field.face[known], field.mesh.face_of_triangle[field.opposite[known]]
    known, here, there = (each[here != there] for each in (known, here, there))
    if not len(known):
        return []
    pairs, number = np.unique(np.column_stack([np.minimum(here, there), np.maximum(here, there)]), axis=0,
                              return_inverse=True)
    number = number.ravel()
    order = np.argsort(number, kind="stable")
    found = []
    for pair, members in zip(pairs, np.split(known[order], np.cumsum(np.bincount(number))[:-1])):
        distance = field.distance[members]
        thickness = float(np.median(distance))
        area = 0.5 * float(field.area[members].sum())
        low, high = np.quantile(distance, (0.1, 0.9))
        if area < LEAST_SQUARES * thickness ** 2 or high > VARIED * low:
            continue
        middles = field.samples.points[members] + field.mesh.origin - 0.5 * distance[:, None] * field.normals[members]
        found.append(FacingFaces(tuple(map(int, pair)), area, thickness, middles, distance))
    return sorted(found, key=lambda each: -each.area / each.thickness ** 2)

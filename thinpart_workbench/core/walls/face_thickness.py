# SPDX-License-Identifier: LGPL-2.1-or-later
"""Thickness per B-Rep face, with the points where it was measured."""

from dataclasses import dataclass, replace
from typing import Optional

import numpy as np

from ..descriptors.descriptor_table import STATED_FLOOR
from ..tolerances import TOLERANCES
from .thinnest_wall import first_of_extent

NEARLY = 0.02
"""Share by which facets may come closer to each other than the part's thinnest wall, which its faces themselves have."""


@dataclass(frozen=True)
class Witness:
    """Where a wall was measured.

    Attributes
    ----------
    distance : float, mm
    point, opposite : ndarray of shape (3,), mm
        In the coordinates of the document.
    face, opposite_face : int
        Indices of B-Rep faces.
    """

    distance: float
    point: np.ndarray
    opposite: np.ndarray
    face: int
    opposite_face: int

    @property
    def turned(self):
        """The same wall from its other side: Witness."""
        return Witness(self.distance, self.opposite, self.point, self.opposite_face, self.face)


@dataclass(frozen=True)
class FaceThickness:
    """The walls under one B-Rep face.

    Attributes
    ----------
    face : int
        Index of the face, from 0.
    area : float, mm2
    minimum : float or None, mm
        Over walls at any angle, see `thin_places`; None where there is no wall.
    median, maximum : float or None, mm
        Over parallel walls, or tapered ones where none is parallel; the median by area.
    thin_share : float
        Share of the face's area over walls, parallel or not, thinner than the limit.
    unmeasured_share : float
    witness : Witness or None
        Where the minimum was measured.
    wedge : Witness or None
        Where the nearest non-parallel wall was measured.
    """

    face: int
    area: float
    minimum: Optional[float]
    median: Optional[float]
    maximum: Optional[float]
    thin_share: float
    unmeasured_share: float
    witness: Optional[Witness]
    wedge: Optional[Witness]


def face_thicknesses(field, thin_limit_mm, thinnest=None, places=None, thinnest_of_all=None):
    """Summarise a thickness field by B-Rep face: list of FaceThickness, one per face that has triangles, by index.

    Parameters
    ----------
    field : ThicknessField
    thin_limit_mm : float, mm
        Distance under which area counts as thin.
    thinnest : Witness, optional
        The thinnest parallel wall of the part: its face has it for its minimum, and no face has a thinner parallel one.
    places : ThinPlaces, optional
        Walls at any angle between pairs of faces.
    thinnest_of_all : ThinnestPlace, optional
        Their thinnest.
    """
    face = field.face
    placed = {} if places is None or thinnest_of_all is None else _placed(
        places.chosen(~places.is_narrow), thinnest_of_all.witness)
    order = np.lexsort([field.distance, face])
    faces, start = np.unique(face[order], return_index=True)
    return [
        _face_thickness(field, int(face), rows, float(thin_share), _thinner(witness, placed.get(int(face))))
        for face, rows, thin_share, witness in zip(
            faces, np.split(order, start[1:]), thin_shares(field, thin_limit_mm), _thinnest_under(field, faces, thinnest))
    ]


def thin_shares(field, thin_limit_mm):
    """Share of the area of each B-Rep face that lies over walls thinner than a limit: ndarray of shape (n,).

    For each face that has triangles, by index, in the order of `face_thicknesses`.

    Parameters
    ----------
    field : ThicknessField
    thin_limit_mm : float, mm
    """
    faces, face_row = np.unique(field.face, return_inverse=True)
    thin = (field.parallel | field.nonparallel) & (field.distance < thin_limit_mm)
    total = np.bincount(face_row, field.area, len(faces))
    return np.bincount(face_row[thin], field.area[thin], len(faces)) / total


def _placed(places, thinnest):
    """The `Witness` of the thinnest wall of each face, by its number: dict. None is thinner than the thinnest of all."""
    found: dict[int, Witness] = {}
    if thinnest is None:
        return found
    for number in range(len(places.samples) - 1, -1, -1):  # the thinnest is set last
        wall = places.witness(number)
        wall = replace(wall, distance=max(wall.distance, thinnest.distance))
        found[wall.opposite_face], found[wall.face] = wall.turned, wall
    for wall in (*places.exact, thinnest):
        for side in (wall.turned, wall):
            found[side.face] = _thinner(side, found.get(side.face))
    return found


def _thinner(first, second):
    """The thinner of two walls, either of which may be None."""
    return second if first is None or second is not None and second.distance < first.distance else first


def _face_thickness(field, face, rows, thin_share, witness):
    """Summary of one face; `rows` are its samples by ascending distance."""
    area = field.area[rows]
    total = float(area.sum())
    measured = field.parallel[rows] | field.nonparallel[rows]
    parallel = rows[field.parallel[rows]]
    slanted = rows[field.nonparallel[rows]]
    minimum = median = maximum = None
    walls = parallel if len(parallel) else slanted
    if len(walls):
        cumulative = np.cumsum(field.area[walls])
        middle = np.searchsorted(cumulative, 0.5 * cumulative[-1])
        median, maximum = (float(field.distance[walls[k]]) for k in (middle, -1))
    if witness is not None:
        # Facets of round faces are a little closer than the faces themselves.
        minimum = witness.distance
        median, maximum = max(median or 0.0, minimum), max(maximum or 0.0, minimum)
    return FaceThickness(
        face, total, minimum, median, maximum,
        thin_share, float(area[~measured].sum()) / total,
        witness,
        witness_of(field, slanted[0]) if len(slanted) else None,
    )


def _thinnest_under(field, faces, thinnest):
    """The `Witness` of the thinnest wall of some extent under each of some faces: list; None where there is none."""
    parallel = np.flatnonzero(field.parallel)
    group = np.searchsorted(faces, field.face[parallel])
    floor = np.minimum(STATED_FLOOR * float(field.area.sum()),
                       TOLERANCES.face_floor * np.bincount(group, field.area[parallel], len(faces)))
    if thinnest is not None:
        kept = field.distance[parallel] >= thinnest.distance * (1.0 - NEARLY)
        parallel, group = parallel[kept], group[kept]
    found = [None if sample < 0 else witness_of(field, sample)
             for sample in first_of_extent(field, parallel, group, floor)]
    if thinnest is None:
        return found
    return [thinnest if face == thinnest.face else witness if witness is None or witness.distance >= thinnest.distance
            else replace(witness, distance=thinnest.distance) for face, witness in zip(faces, found)]


def witness_of(field, sample):
    """The `Witness` of one sample."""
    here, there = field.points(sample)
    face = int(field.mesh.face_of_triangle[field.samples.triangle[sample]])
    return Witness(float(field.distance[sample]), here, there, face, field.opposite_face(sample))

"""Thickness per B-Rep face, each finding with its place."""

from dataclasses import dataclass
from typing import Optional

import numpy as np


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


@dataclass(frozen=True)
class FaceThickness:
    """What lies under one B-Rep face.

    Attributes
    ----------
    face : int
        Index of the face, from 0.
    area : float, mm2
    minimum, median, maximum : float or None, mm
        Over parallel walls, the median by area; None where no wall is parallel.
    thin_share : float
        Share of the face's area over walls, parallel or not, thinner than the limit.
    unmeasured_share : float
    witness : Witness or None
        Where the parallel minimum is.
    wedge : Witness or None
        Where the nearest non-parallel wall is.
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


def face_thicknesses(field, thin_limit):
    """Summarise a thickness field by B-Rep face.

    Parameters
    ----------
    field : ThicknessField
    thin_limit : float, mm
        Distance under which area counts as thin.

    Returns
    -------
    list of FaceThickness
        One per face that has triangles, by index.
    """
    face = field.face
    order = np.lexsort([field.distance, face])
    faces, start = np.unique(face[order], return_index=True)
    return [
        _face_thickness(field, int(face), rows, float(thin_share))
        for face, rows, thin_share in zip(
            faces, np.split(order, start[1:]), thin_shares(field, thin_limit))
    ]


def thin_shares(field, thin_limit):
    """Share of the area of each B-Rep face that lies over walls thinner than a limit.

    Parameters
    ----------
    field : ThicknessField
    thin_limit : float, mm

    Returns
    -------
    ndarray of shape (n,)
        For each face that has triangles, by index, as `face_thicknesses` has them.
    """
    faces, place = np.unique(field.face, return_inverse=True)
    thin = (field.parallel | field.nonparallel) & (field.distance < thin_limit)
    total = np.bincount(place, field.area, len(faces))
    return np.bincount(place[thin], field.area[thin], len(faces)) / total


def _face_thickness(field, face, rows, thin_share):
    """Summary of one face; `rows` are its samples by ascending distance."""
    area = field.area[rows]
    total = float(area.sum())
    measured = field.parallel[rows] | field.nonparallel[rows]
    parallel = rows[field.parallel[rows]]
    slanted = rows[field.nonparallel[rows]]
    minimum = median = maximum = None
    if len(parallel):
        cumulative = np.cumsum(field.area[parallel])
        middle = np.searchsorted(cumulative, 0.5 * cumulative[-1])
        minimum, median, maximum = (
            float(field.distance[parallel[k]]) for k in (0, middle, -1)
        )
    return FaceThickness(
        face, total, minimum, median, maximum,
        thin_share, float(area[~measured].sum()) / total,
        witness_of(field, parallel[0]) if len(parallel) else None,
        witness_of(field, slanted[0]) if len(slanted) else None,
    )


def witness_of(field, sample):
    """The `Witness` of one sample."""
    here, there = field.points(sample)
    face = int(field.mesh.face_of_triangle[field.samples.triangle[sample]])
    return Witness(float(field.distance[sample]), here, there, face, field.opposite_face(sample))

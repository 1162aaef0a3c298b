"""Solids that are one part: copies of one shape, or equal shapes that stand elsewhere."""

import math

import numpy as np

from .part import SolidPart
from .solid_measures import SolidMeasures

_EQUAL_MEASURES = 1e-7
"""Relative difference of volumes and areas of one solid that was written and read twice."""

_SAME_PLACE = 1e-6
"""Share of the diagonal that corresponding points may lie apart."""


def equal_part(parts, solid):
    """The part whose shape a solid has, in whatever place, or None.

    Parameters
    ----------
    parts : list of SolidPart or MeshedPart
    solid : Part.Shape

    Returns
    -------
    SolidPart or None

    Notes
    -----
    Exchange files write each copy of a part as a solid of its own. Two solids are equal when all faces,
    edges and corners correspond in their order and a rotation carries the points of one to those of the
    other; a mirror image is another part.
    """
    solids = [part for part in parts if isinstance(part, SolidPart)]
    shared = (part for part in solids if part.shape.isPartner(solid))
    measures = SolidMeasures(solid)
    return next(shared, None) or next((part for part in solids if _is_equal(part.measures, measures)), None)


def motion(one, other):
    """Rotation and translation that carry a solid onto an equal one, ndarray of shape (4, 4), mm."""
    if one.isPartner(other):
        placed = other.Placement.multiply(one.Placement.inverse())
        return np.array(placed.toMatrix().A).reshape(4, 4)
    return _motion(SolidMeasures(one).points, SolidMeasures(other).points)


def _is_equal(one, other):
    if one.counts != other.counts:
        return False
    if not (_agree(one.volume, other.volume) and _agree(one.area, other.area)):
        return False
    if not all(map(_agree, one.face_areas, other.face_areas)):
        return False
    points, others = one.points, other.points
    if len(points) != len(others):
        return False
    diagonal = float(np.linalg.norm(np.ptp(points, axis=0)))
    carried = _motion(points, others)
    turned = points @ carried[:3, :3].T + carried[:3, 3]
    return float(np.linalg.norm(turned - others, axis=1).max()) <= _SAME_PLACE * diagonal


def _agree(one, other):
    return math.isclose(one, other, rel_tol=_EQUAL_MEASURES, abs_tol=1e-300)


def _motion(points, others):
    """The rotation and translation that carry points nearest to others (Kabsch 1976,
    doi:10.1107/S0567739476001873): ndarray of shape (4, 4)."""
    middle, other_middle = points.mean(axis=0), others.mean(axis=0)
    left, _, right = np.linalg.svd((points - middle).T @ (others - other_middle))
    left[:, 2] *= np.sign(np.linalg.det(left @ right))
    matrix = np.eye(4)
    matrix[:3, :3] = (left @ right).T
    matrix[:3, 3] = other_middle - matrix[:3, :3] @ middle
    return matrix

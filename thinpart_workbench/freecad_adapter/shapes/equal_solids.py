# SPDX-License-Identifier: LGPL-2.1-or-later
"""Find solids that are the same part: copies of one shape, or equal shapes with another placement."""

import math

import numpy as np

from ...core.rigid_transform import nearest_motion, transform_points
from .part import SolidPart
from .placements import placement_matrix
from .solid_measures import SolidMeasures
from .tolerances import SHAPE_TOLERANCES


def equal_part(parts, solid):
    """The part with the same shape as a solid, whatever its placement, or None: SolidPart.

    Exchange files store each copy of a part as a separate solid. Two solids are equal if all faces, edges and
    corners correspond in their order and a rigid motion maps the points of one onto those of the other. A mirror
    image is another part.

    Parameters
    ----------
    parts : list of SolidPart or MeshedPart
    solid : Part.Shape
    """
    solids = [part for part in parts if isinstance(part, SolidPart)]
    shared = (part for part in solids if part.shape.isPartner(solid))
    measures = SolidMeasures(solid)
    return next(shared, None) or next((part for part in solids if _is_equal(part.measures, measures)), None)


def motion(one, other):
    """Rotation and translation that map a solid onto an equal one, ndarray of shape (4, 4), mm."""
    if one.isPartner(other):
        return placement_matrix(other.Placement.multiply(one.Placement.inverse()))
    return nearest_motion(SolidMeasures(one).points, SolidMeasures(other).points)


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
    apart = transform_points(nearest_motion(points, others), points) - others
    return float(np.linalg.norm(apart, axis=1).max()) <= SHAPE_TOLERANCES.moved * diagonal


def _agree(one, other):
    return math.isclose(one, other, rel_tol=SHAPE_TOLERANCES.reread, abs_tol=1e-300)

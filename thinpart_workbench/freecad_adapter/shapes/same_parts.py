# SPDX-License-Identifier: LGPL-2.1-or-later
"""Check whether the parts of a document are still the measured ones."""

import math

import numpy as np

from .part import SolidPart
from .tolerances import SHAPE_TOLERANCES


def same_parts(before, now):
    """Whether two results of `document_parts` hold the same parts in the same order.

    Placements are ignored: a part that was moved is still the same part.
    """
    return len(before) == len(now) and all(map(_same, before, now))


def _same(one, other):
    if (one.name, type(one)) != (other.name, type(other)) or one.instances != other.instances:
        return False
    if isinstance(one, SolidPart):
        return one.shape.isPartner(other.shape) or _measures_agree(one.shape, other.shape)
    return np.array_equal(one.points, other.points) and np.array_equal(
        one.triangles, other.triangles
    )


def _measures_agree(one, other):
    """Compare all measures: a recompute that changed nothing makes a new shape with equal measures."""
    if len(one.Faces) != len(other.Faces):
        return False
    pairs = [(one.Volume, other.Volume), (one.Area, other.Area)]
    pairs += zip((face.Area for face in one.Faces), (face.Area for face in other.Faces))
    pairs += zip(_inertia(one), _inertia(other))
    share, largest = SHAPE_TOLERANCES.recomputed, one.Area
    return all(math.isclose(a, b, rel_tol=share, abs_tol=share * largest) for a, b in pairs)


def _inertia(shape):
    return sorted(shape.PrincipalProperties["Moments"])

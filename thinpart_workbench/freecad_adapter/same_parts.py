"""Whether the parts of a document are still those that were measured."""

import math

import numpy as np

from .part import SolidPart

_EQUAL = 1e-9
"""Relative difference of two measures of one shape that was computed twice."""


def same_parts(before, now):
    """Whether two answers of `document_parts` hold the same parts in the same order.

    Placement does not count: a part that was moved is still the same part.
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
    """A recompute that changed nothing makes a new shape, equal in everything that is measured."""
    if len(one.Faces) != len(other.Faces):
        return False
    pairs = [(one.Volume, other.Volume), (one.Area, other.Area)]
    pairs += zip((face.Area for face in one.Faces), (face.Area for face in other.Faces))
    pairs += zip(_inertia(one), _inertia(other))
    largest = one.Area
    return all(math.isclose(a, b, rel_tol=_EQUAL, abs_tol=_EQUAL * largest) for a, b in pairs)


def _inertia(shape):
    return sorted(shape.PrincipalProperties["Moments"])

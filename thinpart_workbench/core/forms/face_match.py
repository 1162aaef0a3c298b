# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which faces of two parts are the same, by the points of their outlines."""

from typing import NamedTuple

import numpy as np


class FaceMatch(NamedTuple):
    """The faces of one of two parts that were laid upon each other.

    Attributes
    ----------
    faces : ndarray of shape (f,), int64
    share : ndarray of shape (f,)
        Share of the points of each face that lie on the other surface.
    place : ndarray of shape (f, 3), mm
        The point of each face that is farthest from the other surface, from the centroid.
    distance : ndarray of shape (f,), mm
        How far that is; inf where the other surface has nothing like it near by.
    """

    faces: np.ndarray
    share: np.ndarray
    place: np.ndarray
    distance: np.ndarray


def face_match(outline, distance, same):
    """The `FaceMatch` of an outline.

    Parameters
    ----------
    outline : Outline
    distance : ndarray of shape (k,), mm
        Of its points from the other surface.
    same : float, mm
        Distance up to which surfaces are the same.
    """
    faces, which = np.unique(outline.face, return_inverse=True)
    count = np.bincount(which)
    share = np.bincount(which, distance <= same) / count
    order = np.lexsort((distance, which))
    farthest = order[np.cumsum(count) - 1]
    return FaceMatch(faces, share, outline.points[farthest], distance[farthest])

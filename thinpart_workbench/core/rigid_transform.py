# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rigid transforms: rotations with translations, as matrices of shape (4, 4), in mm.

They are composed by ``@``: ``second @ first`` applies ``first`` and then ``second``.
"""

import numpy as np


def rigid_transform(rotation, translation):
    """Make the transform that rotates, and then translates: ndarray of shape (4, 4).

    Parameters
    ----------
    rotation : array_like of shape (3, 3)
        Its columns are the images of the axes.
    translation : array_like of shape (3,), mm
    """
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = rotation, translation
    return matrix


def rotation(matrix):
    """ndarray of shape (3, 3)."""
    return matrix[:3, :3]


def translation(matrix):
    """ndarray of shape (3,), mm: the image of the origin."""
    return matrix[:3, 3]


def transform_points(matrix, points):
    """Apply a transform, which may also scale, to points: ndarray of the same shape, mm.

    Parameters
    ----------
    matrix : ndarray of shape (4, 4)
    points : array_like of shape (3,) or (n, 3), mm
    """
    return np.asarray(points) @ rotation(matrix).T + translation(matrix)


def transform_directions(matrix, directions):
    """Rotate directions, array_like of shape (3,) or (n, 3), by a transform: ndarray of the same shape."""
    return np.asarray(directions) @ rotation(matrix).T


def inverse(matrix):
    """Invert a rigid transform: ndarray of shape (4, 4).

    Parameters
    ----------
    matrix : ndarray of shape (4, 4)
        A rotation and a translation only: the transposed matrix is the inverse of no other.
    """
    back = rotation(matrix).T
    return rigid_transform(back, -back @ translation(matrix))


def nearest_motion(points, others):
    """Rigid transform that brings points nearest to others, both of shape (n, 3), mm, by least squares: shape (4, 4).

    Kabsch 1976, doi:10.1107/S0567739476001873. Mirrored points are not brought onto the others: the result is
    always a rotation.
    """
    middle, other_middle = points.mean(axis=0), others.mean(axis=0)
    left, _, right = np.linalg.svd((points - middle).T @ (others - other_middle))
    left[:, 2] *= np.sign(np.linalg.det(left @ right))
    turn = (left @ right).T
    return rigid_transform(turn, other_middle - turn @ middle)

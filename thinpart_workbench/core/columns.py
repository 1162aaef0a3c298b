# SPDX-License-Identifier: LGPL-2.1-or-later
"""Vectors as columns, ``(3, ...)``: numpy is several times faster when the long axis is contiguous."""

import numpy as np


def dot(first, second):
    """Scalar products of two arrays of shape (3, ...)."""
    total = first[0] * second[0]
    term = first[1] * second[1]
    total += term
    np.multiply(first[2], second[2], out=term)
    total += term
    return total


def cross(first, second):
    """Vector products of two arrays of shape (3, ...), of the same shape."""
    product = np.empty_like(first)
    for k in range(3):
        one, two = (k + 1) % 3, (k + 2) % 3
        np.multiply(first[one], second[two], out=product[k])
        product[k] -= first[two] * second[one]
    return product


def corners_of(vertices, triangles):
    """Corners of triangles, ndarray of shape (3, 3, m): coordinate, corner, triangle.

    Parameters
    ----------
    vertices : ndarray of shape (3, v)
        Contiguous.
    triangles : ndarray of shape (m, 3), int64
    """
    return np.take(vertices, triangles.T, axis=1, mode="clip")

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Check the arrays of vertices and triangles that a caller of the API passes."""

import numpy as np

from ..core.errors import MeshError


def checked_arrays(vertices, triangles, face_of_triangle=None):
    """Check shapes and types of the arrays and convert them, to float64 and int64; None stays. `surface_mesh` checks values.

    Parameters
    ----------
    vertices : array_like of shape (v, 3), mm
    triangles : array_like of shape (n, 3), int
        Indices into `vertices`, counter-clockwise as seen from outside.
    face_of_triangle : array_like of shape (n,), int, optional
        The face that each triangle belongs to, from 0.

    Raises
    ------
    MeshError
        kind ``usage`` for wrong shapes or types.

    Examples
    --------
    >>> points, numbers, faces = checked_arrays([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
    >>> points.dtype.name, numbers.shape, faces
    ('float64', (1, 3), None)
    """
    vertices = _array(vertices, "vertices", "fiu", (None, 3)).astype(np.float64)
    triangles = _array(triangles, "triangles", "iu", (None, 3)).astype(np.int64)
    if face_of_triangle is not None:
        face_of_triangle = _array(face_of_triangle, "face_of_triangle", "iu", (len(triangles),)).astype(np.int64)
        if len(triangles) and face_of_triangle.min() < 0:
            raise MeshError("face_of_triangle has negative numbers: faces are counted from 0.", "usage")
    return vertices, triangles, face_of_triangle


_NUMBERS = {"fiu": "numbers", "iu": "whole numbers"}


def _array(values, name, kinds, shape):
    try:
        array = np.asarray(values)
    except ValueError:  # rows of different lengths
        array = np.empty(0, object)
    if array.size == 0 and array.ndim == 1 and array.dtype != object:
        array = np.empty([length or 0 for length in shape], np.int64)  # an empty list has no second dimension
    fits = array.ndim == len(shape) and all(
        expected in (None, length) for expected, length in zip(shape, array.shape))
    if not fits or array.dtype.kind not in kinds:
        rows = ", ".join("n" if length is None else str(length) for length in shape)
        raise MeshError(
            f"{name} must be an array of {_NUMBERS[kinds]} of shape ({rows}{',' if len(shape) == 1 else ''}), and "
            f"has the shape {array.shape} and the type {array.dtype}.", "usage")
    return array

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Triangles of a mesh that face each other within a distance, found without trying every two of them."""

import numpy as np

from .box_tree import WIDTH
from .closest_points import closest_weights
from .space_filling_curve import hilbert_index

_PARTS, _MOST = 50_000, 5_000_000
"""Pairs of boxes whose children are compared at once, and pairs that are too many; both bound the memory used."""


def facing_triangles(mesh, below, cosine, left_out):
    """Find the pairs of triangles of two faces that may be near each other through the material: two ndarrays of int64.

    Both descend one tree of boxes, of places, normals and faces at once, from its root down (Ericson, Real-Time Collision
    Detection, 2005, 6.3): what lies side by side on a flat face goes no further than the first boxes. None where there are
    millions of them.

    Parameters
    ----------
    mesh : SurfaceMesh
    below : float, mm
        Greatest distance between boxes.
    cosine : float
        Of the angle between outward normals from which on two triangles face each other.
    left_out : ndarray of shape (2, k), int64
        Pairs of faces, the lower number first, between which none are looked for.
    """
    count = int(mesh.face_of_triangle.max()) + 1
    left_out = np.unique(left_out[0] * count + left_out[1])

    def near(level, first, second):
        first, second = _near(level, first, second, below, cosine)
        return _of_other_faces(level, first, second, left_out, count)

    low, high = mesh.corners.min(axis=1).T, mesh.corners.max(axis=1).T
    order = _order_of_faces(low + high, mesh.face_of_triangle)
    rest = np.concatenate([mesh.normals.T, mesh.face_of_triangle[None]])
    levels = _levels(*(np.concatenate([bound, rest])[:, order] for bound in (low, high)))
    first, second = near(levels[0], *np.triu_indices(levels[0][0].shape[1]))
    children = np.arange(WIDTH)
    for level in levels[1:]:
        found = [(first[:0], second[:0])]
        for start in range(0, len(first), _PARTS):
            one = np.repeat(first[start:start + _PARTS, None] * WIDTH + children, WIDTH, axis=1).ravel()
            other = np.tile(second[start:start + _PARTS, None] * WIDTH + children, WIDTH).ravel()
            exist = (one <= other) & (other < level[0].shape[1])
            found.append(near(level, one[exist], other[exist]))
        first, second = map(np.concatenate, zip(*found))
        if len(first) > _MOST:
            return None
    return order[first], order[second]


def closest_points_of_triangles(first, second):
    """Find where two triangles are closest to each other: two ndarrays of shape (m, 3), mm.

    Triangles that cut through each other have their closest borders instead.

    Parameters
    ----------
    first, second : ndarray of shape (m, 3, 3), mm
        Triangle, corner, coordinate.
    """
    here, there, square = np.zeros((len(first), 3)), np.zeros((len(first), 3)), np.full(len(first), np.inf)

    def take(one, other):
        found = ((one - other) ** 2).sum(axis=1)
        nearer = found < square
        here[nearer], there[nearer], square[nearer] = one[nearer], other[nearer], found[nearer]

    for corner in range(3):
        take(first[:, corner], _closest_of(second, first[:, corner]))
        take(_closest_of(first, second[:, corner]), second[:, corner])
    for side in range(3):
        for other in range(3):
            take(*_closest_of_sides(first[:, side], first[:, (side + 1) % 3], second[:, other], second[:, (other + 1) % 3]))
    return here, there


def _order_of_faces(middles, face_of_triangle):
    """Order of triangles along a curve through the faces, and along one through the triangles of each: ndarray of int64.

    So that boxes hold the triangles of one face, as far as it has many.
    """
    count = np.maximum(np.bincount(face_of_triangle), 1)
    middle = np.stack([np.bincount(face_of_triangle, row) / count for row in middles])
    return np.lexsort([hilbert_index(middles), face_of_triangle, hilbert_index(middle)[face_of_triangle]])


def _levels(low, high):
    """Boxes of all levels, the root first, as lower and upper corners of places, normals and face, of shape (7, q).

    Those of node q hold the nodes 8 q to 8 q + 7 of the next level.
    """
    levels = [(low, high)]
    while low.shape[1] > WIDTH:
        missing = ((0, 0), (0, -low.shape[1] % WIDTH))
        low = np.pad(low, missing, constant_values=np.inf).reshape(len(low), -1, WIDTH).min(axis=2)
        high = np.pad(high, missing, constant_values=-np.inf).reshape(len(high), -1, WIDTH).max(axis=2)
        levels.append((low, high))
    return levels[::-1]


def _near(level, first, second, below, cosine):
    """Those pairs of boxes of a level that are near and may hold triangles that face each other through the material."""
    low, high = level
    square = np.zeros(len(first))
    for axis in range(3):
        gap = np.maximum(low[axis][first] - high[axis][second], low[axis][second] - high[axis][first])
        square += np.square(np.maximum(gap, 0.0, out=gap), out=gap)
    near = np.flatnonzero(square < below * below)
    first, second = first[near], second[near]
    turned = sum(_least_product(*(bound[axis][node] for node in (first, second) for bound in level)) for axis in range(3, 6))
    facing = np.flatnonzero(turned < cosine)
    first, second = first[facing], second[facing]
    beneath = np.flatnonzero((_least_height(level, first, second) < 0.0) & (_least_height(level, second, first) < 0.0))
    return first[beneath], second[beneath]


def _least_height(level, first, second):
    """How low second boxes may lie beneath the facets of first ones, in lengths: ndarray; negative on the inner side."""
    low, high = level
    return sum(_least_product(low[3 + axis][first], high[3 + axis][first], low[axis][second] - high[axis][first],
                              high[axis][second] - low[axis][first]) for axis in range(3))


def _of_other_faces(level, first, second, left_out, count):
    """Those pairs of boxes that hold triangles of other faces than one, or than two between which none is looked for."""
    low, high = level[0][6], level[1][6]
    faces = np.sort([low[first], low[second]], axis=0)
    of_two = (low[first] == high[first]) & (low[second] == high[second])
    none = of_two & ((faces[0] == faces[1]) | np.isin(faces[0] * count + faces[1], left_out))
    return first[~none], second[~none]


def _least_product(low, high, other_low, other_high):
    """The least product of two numbers within bounds."""
    return np.minimum(np.minimum(low * other_low, low * other_high), np.minimum(high * other_low, high * other_high))


def _closest_of(triangles, points):
    weights = closest_weights(points.T, triangles.transpose(2, 1, 0))
    return np.einsum("ki,ikj->ij", weights, triangles)


def _closest_of_sides(start, end, other_start, other_end):
    """The closest points of two line segments, as of Ericson (2005), 5.1.9: two ndarrays of shape (m, 3)."""
    way, other_way, apart = end - start, other_end - other_start, start - other_start
    square, other_square, both = (np.einsum("ij,ij->i", one, other) for one, other in (
        (way, way), (other_way, other_way), (way, other_way)))
    along, other_along = np.einsum("ij,ij->i", way, apart), np.einsum("ij,ij->i", other_way, apart)
    tiny = np.finfo(float).tiny
    determinant = square * other_square - both * both
    # Where they are parallel, any place will do.
    share = np.divide(both * other_along - along * other_square, determinant, out=np.zeros(len(start)),
                      where=determinant > 1e-12 * square * other_square)
    share = np.clip(share, 0.0, 1.0)
    other_share = np.clip((both * share + other_along) / np.maximum(other_square, tiny), 0.0, 1.0)
    share = np.clip((both * other_share - along) / np.maximum(square, tiny), 0.0, 1.0)
    return start + share[:, None] * way, other_start + other_share[:, None] * other_way

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which faces of a part are equal, such as the sides of equal holes or of the teeth of a gear."""

import numpy as np

from ..columns import dot
from .topology import neighbouring_faces

SAME = 0.01
"""Share by which areas and borders of equal faces differ, since facets lie inside of round faces."""

SAME_TURN = 0.1
"""By how much the turn of equal faces differs, see `equal_faces`: a facet more or less."""

SAME_DEPTH = 1.25
"""Ratio of the median local thickness under equal faces. Of two walls of a box with one outline, one may be thicker."""

_HOLLOW = -0.1
"""Turn from which on a face is hollow: that of a hole of 100 times the thickness of its sheet is -0.25."""

_WAYS = 3


def equal_faces(mesh, local=None):
    """Find the equal faces of a part: ndarray of shape (f,), int64; for each face, the number of the first one equal to it.

    Equal faces have the same area, border and turn (the integral of twice the mean curvature by the root of the area), and
    neighbours of which the same holds and which they meet in the same way; and beneath them, the part is as thick. The sides
    of holes and slots, which are hollow or go over into what is, see along the wall, so what is beneath them counts for
    nothing: a hole near an edge is equal to the others.

    Parameters
    ----------
    mesh : SurfaceMesh
    local : ndarray of shape (f,), mm, optional
        Median local thickness under each face; nan where it is not known.
    """
    area, border, turn = _measures(mesh)
    turn = turn / np.sqrt(np.maximum(area, np.finfo(float).tiny))  # whole numbers where no side joins two facets of a face
    kind = np.zeros(len(area), dtype=np.int64)
    for measure in (area, border):
        kind = _split(kind, np.log(np.maximum(measure, np.finfo(float).tiny)), np.log1p(SAME))
    kind = _split(kind, turn, SAME_TURN)
    first, second, way = (np.asarray(column, dtype=np.int64) for column in neighbouring_faces(mesh))
    around = _around(kind, first, second, way)
    kind = np.unique(np.column_stack([kind, around]), axis=0, return_inverse=True)[1].ravel()
    if local is not None:
        hollow = turn < _HOLLOW
        one, other = first[way == 0], second[way == 0]
        hollow[np.concatenate([one[hollow[other]], other[hollow[one]]])] = True
        on_wall = np.isfinite(local) & (local > 0.0) & ~hollow
        depth = np.zeros(len(area))
        depth[on_wall] = np.log(local[on_wall])
        kind = _split(np.where(on_wall, kind, kind + kind.max() + 1), depth, np.log(SAME_DEPTH))
    first, own = np.unique(kind, return_index=True, return_inverse=True)[1:]
    return np.where(area > 0.0, first[own.ravel()], np.arange(len(area)))


def _measures(mesh):
    """Area, mm2, length of the border, mm, and sum of length times turn over the edges within, mm, convex positive."""
    faces = int(mesh.face_of_triangle.max()) + 1
    area = np.bincount(mesh.face_of_triangle, mesh.areas, faces)
    one, other = (side // 3 for side in mesh.shared_sides)
    corner = mesh.shared_sides[0] % 3
    start, end = mesh.corners[one, corner], mesh.corners[one, (corner + 1) % 3]
    length = np.linalg.norm(end - start, axis=1)
    here, there = mesh.face_of_triangle[one], mesh.face_of_triangle[other]
    between = here != there
    border = np.bincount(here[between], length[between], faces) + np.bincount(there[between], length[between], faces)
    within = ~between
    normals = mesh.normals
    angle = np.arccos(np.clip(dot(normals[one].T, normals[other].T), -1.0, 1.0))
    rise = dot((mesh.corners[other].mean(axis=1) - mesh.corners[one].mean(axis=1)).T, normals[one].T)
    turn = np.where(rise < 0.0, angle, -angle) * length
    return area, border, np.bincount(here[within], turn[within], faces)


def _around(kind, first, second, way):
    """A number for each face that follows from the kinds of its neighbours and how it meets them: ndarray of int64.

    Parameters
    ----------
    kind : ndarray of shape (f,), int64
    first, second, way : ndarray of shape (k,), int64
        See `neighbouring_faces`.
    """
    # Sums of numbers drawn at random are equal where what is summed up is, whatever its order.
    drawn = np.random.default_rng(0).integers(0, 2**62, _WAYS * (int(kind.max()) + 1), dtype=np.int64)
    around = np.zeros(len(kind), dtype=np.int64)
    np.add.at(around, first, drawn[_WAYS * kind[second] + way + 1])
    np.add.at(around, second, drawn[_WAYS * kind[first] + way + 1])
    return around


def _split(kind, value, reach):
    """Split kinds where a value differs by more than it may: ndarray of int64.

    Of each kind, the values are taken in their order; one that is more than the reach above the first begins a new one.
    """
    order = np.lexsort([value, kind])
    found = np.empty_like(kind)
    number, at_kind, least = -1, None, 0.0
    for place, own, here in zip(order.tolist(), kind[order].tolist(), value[order].tolist()):
        if own != at_kind or here > least + reach:
            number, at_kind, least = number + 1, own, here
        found[place] = number
    return found

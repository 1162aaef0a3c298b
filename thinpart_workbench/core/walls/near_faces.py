# SPDX-License-Identifier: LGPL-2.1-or-later
"""Faces that come near each other through the material, wherever samples lie."""

import numpy as np

from ..rays.close_triangles import closest_points_of_triangles, facing_triangles
from .face_thickness import Witness
from .walls import NONPARALLEL_BELOW

_FACETS_TURN = np.radians(15.0)
"""Angle by which facets may be turned against each other more than the faces that they approximate."""

_LEAST_THROUGH = 0.2
"""Cosine of the greatest angle between the way from face to face and the way into the material: along the narrow top of a
rib with a draft, the sides are nearest."""

_SHARES = (0.1, 0.4, 1.0)
"""Distances up to which faces are looked for, one after the other, as shares of the greatest: what faces each other
everywhere, such as the flanks of a thread, is not looked for again."""

_AT_FIRST, _AT_ONCE = 4096, 131_072
"""Pairs of facets whose closest points are computed first, the nearest boxes; then twice as many, and so on."""


def neighbours(mesh):
    """Pairs of faces that have sides of triangles in common, the lower number first: ndarray of shape (2, k), int64."""
    faces = np.sort(mesh.face_of_triangle[np.stack(mesh.shared_sides) // 3], axis=0)
    return np.unique(faces[:, faces[0] != faces[1]], axis=1)


def near_faces(mesh, below, least):
    """Find pairs of faces that are near each other through the material: yields a Witness of each, the nearest first.

    Samples meet a small corner of a part or miss it. Here every two facets are seen, so that no wall is missed because of
    where samples lie. The way between two faces is not across them, nor is it always a wall: that is for the geometry of
    the part to say. `neighbours` are not looked at: beside their edge, they are as near as one wants. Where too many facets
    face each other, only the nearest faces are found.

    Parameters
    ----------
    mesh : SurfaceMesh
    below : callable
        Returns the distance, mm, that they have to be nearer than; it may get less meanwhile.
    least : float, mm
        That they have to be farther apart than, wherever they are nearest.
    """
    known = neighbours(mesh)
    greatest, reached = below(), 0.0
    for share in _SHARES:
        if reached >= below():
            return
        reached = min(share * greatest, below())
        facets = facing_triangles(mesh, reached, -np.cos(NONPARALLEL_BELOW + _FACETS_TURN), known)
        if facets is None:
            return
        first, second = facets
        found = _nearest_facets(mesh, first, second, reached)
        yield from (wall for wall in found if wall.distance > least)
        faces = np.array([[wall.face, wall.opposite_face] for wall in found], dtype=np.int64).reshape(-1, 2).T
        known = np.concatenate([known, np.sort(faces, axis=0)], axis=1)


def _nearest_facets(mesh, first, second, below):
    """Of each pair of faces, where its facets are nearest: list of Witness, the nearest first.

    Those whose boxes are nearest are computed first: of most others, these alone show that they are farther away.
    """
    faces = mesh.face_of_triangle
    _, pair = np.unique(np.sort(faces[np.stack([first, second])], axis=0), axis=1, return_inverse=True)
    pair, at_least = pair.ravel(), _distance_of_boxes(mesh, first, second)
    best = np.full(int(pair.max(initial=-1)) + 1, below)
    nearest: dict = {}
    left, size = np.argsort(at_least, kind="stable"), _AT_FIRST
    while len(left):
        now, left, size = left[:size], left[size:], min(2 * size, _AT_ONCE)
        now = now[_are_beneath(mesh, first[now], second[now])]
        here, there = closest_points_of_triangles(mesh.corners[first[now]], mesh.corners[second[now]])
        distance = np.linalg.norm(there - here, axis=1)
        through = _are_through(mesh, first[now], second[now], here, there)
        for k in np.flatnonzero(through & (distance < best[pair[now]])):
            number = now[k]
            if distance[k] < best[pair[number]]:
                best[pair[number]] = distance[k]
                nearest[pair[number]] = Witness(float(distance[k]), here[k] + mesh.origin, there[k] + mesh.origin,
                                                int(faces[first[number]]), int(faces[second[number]]))
        left = left[at_least[left] < best[pair[left]]]
    return sorted(nearest.values(), key=lambda wall: wall.distance)


def _distance_of_boxes(mesh, first, second):
    """Distance between the boxes around two triangles: ndarray of shape (m,), mm."""
    low, high = mesh.corners.min(axis=1), mesh.corners.max(axis=1)
    gap = np.maximum(np.maximum(low[first] - high[second], low[second] - high[first]), 0.0)
    return np.linalg.norm(gap, axis=1)


def _are_through(mesh, first, second, here, there):
    """Whether the way from one triangle to the other goes into the material and out again: ndarray of shape (m,), bool."""
    way = there - here
    length = np.linalg.norm(way, axis=1)
    into, out = -np.einsum("ij,ij->i", way, mesh.normals[first]), np.einsum("ij,ij->i", way, mesh.normals[second])
    return np.minimum(into, out) > _LEAST_THROUGH * length


def _are_beneath(mesh, first, second):
    """Whether some of each of two triangles lies on the inner side of the other one: ndarray of shape (m,), bool."""
    def beneath(one, other):
        heights = np.einsum("mkj,mj->mk", mesh.corners[other] - mesh.corners[one][:, :1], mesh.normals[one])
        return heights.min(axis=1) < 0.0

    return beneath(first, second) & beneath(second, first)

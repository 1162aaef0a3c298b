# SPDX-License-Identifier: LGPL-2.1-or-later
"""The curves along which faces meet: how far they rise above the sides of the triangles that approximate them."""

import numpy as np

from ..columns import cross, dot

_STRAIGHT = np.sin(1e-3)
"""Sides that turn by less, sine of the angle, are taken for one straight line."""

_CORNER = np.cos(np.radians(45.0))
"""Sides that turn by more, cosine of the angle, meet at a corner and not along a curve."""

_SHORTEST = 0.2
"""A side that is shorter than this share of the next one says too little about its arc: points are rounded."""

_LEVEL = 1e-4
"""Planes of arcs that are tilted from a side of the box by less, sine of the angle, are parallel to it."""

_ALIKE = 2.0
"""Two estimates of one arc are averaged if neither exceeds the other by this factor: the curve is smooth there."""


class Rims:
    """Curved edges of a mesh.

    Over the side of a triangle, a curve is taken for the arc of the circle through the ends of this side and the next
    point of the curve, on either side. This is exact on the rims of cylinders, cones and spheres.

    Parameters
    ----------
    mesh : SurfaceMesh
        A mesh with B-Rep faces.
    near : ndarray of shape (m,), int64
        Triangles between which curves are looked for.
    """

    def __init__(self, mesh, near):
        ends, beyond = _sides_of_curves(mesh, near)
        points = mesh.vertex_columns
        self._start, self._end = points[:, ends[:, 0]], points[:, ends[:, 1]]
        self._arcs = [
            _Arcs(points[:, beyond[:, k]], points[:, ends[:, k]], points[:, ends[:, 1 - k]], beyond[:, k] >= 0)
            for k in range(2)
        ]

    def top(self, direction):
        """Height, mm, of the highest arc along a unit vector; -inf if no arc has its top between the ends of its side."""
        if not self._start.shape[1]:
            return -np.inf
        start, end = direction @ self._start, direction @ self._end
        higher = np.maximum(start, end)
        first, second = (arcs.rise(direction, self._start, self._end, higher) for arcs in self._arcs)
        # Where the curve ends or has a corner, there is one estimate only.
        low, high = np.fmin(first, second), np.fmax(first, second)
        rise = np.where(high <= _ALIKE * low, 0.5 * (low + high), low)
        return float(np.max(np.where(rise > 0.0, higher + rise, -np.inf)))


class _Arcs:
    """Circles through three consecutive points each, columns of shape (3, k); the latter two are the ends of a side."""

    def __init__(self, before, start, end, known):
        first, both = start - before, end - before
        normal = cross(first, both)
        across, second = dot(normal, normal), end - start
        size, next_size = dot(first, first), dot(second, second)
        turn = np.sqrt(across / np.where(known, size * next_size, 1.0))
        self._unknown = ~known | (dot(first, second) < _CORNER * np.sqrt(size * next_size))
        self._unknown |= size < _SHORTEST ** 2 * next_size
        self._straight = ~self._unknown & (turn < _STRAIGHT)
        doubled = np.where(self._unknown | self._straight, 1.0, 2.0 * across)
        to_centre = (cross(normal, first) * dot(both, both) + cross(both, normal) * size) / doubled
        self._centre, self._radius = before + to_centre, np.sqrt(dot(to_centre, to_centre))
        self._normal = normal / np.sqrt(np.where(across > 0.0, across, 1.0))

    def rise(self, direction, start, end, higher):
        """How far, mm, the top of each arc is above the higher end of its side; 0 if it is not between the ends, NaN if
        the circle is not known."""
        direction = direction[:, None]
        in_plane = direction - dot(self._normal, direction) * self._normal
        length = np.sqrt(dot(in_plane, in_plane))
        tilted = length > _LEVEL
        top = self._centre + in_plane * (self._radius / np.where(tilted, length, 1.0))
        middle, side = 0.5 * (start + end), end - start
        from_middle = top - middle
        between = np.abs(dot(from_middle, side)) < 0.5 * dot(side, side)
        between &= dot(from_middle, middle - self._centre) > 0.0
        rise = np.where(between & tilted & ~self._straight, dot(top, direction) - higher, 0.0)
        return np.where(self._unknown, np.nan, rise)


def _sides_of_curves(mesh, near):
    """Sides of triangles along curves between faces: two ndarray of shape (k, 2), int64.

    Vertices at both ends of each side, and the next ones of the curve beyond them; -1 where it does not go on.
    """
    chosen = np.zeros(mesh.count, dtype=bool)
    chosen[near] = True
    side, other = mesh.shared_sides
    one, two = side // 3, other // 3
    is_curve = mesh.face_of_triangle[one] != mesh.face_of_triangle[two]
    is_curve &= chosen[one] & chosen[two] & (mesh.is_bent[one] | mesh.is_bent[two])
    side, faces = side[is_curve], mesh.face_of_triangle[np.stack([one[is_curve], two[is_curve]])]
    faces_beside = faces.min(axis=0) * (int(mesh.face_of_triangle.max()) + 1) + faces.max(axis=0)
    ends = np.stack([mesh.triangles[side // 3, side % 3], mesh.triangles[side // 3, (side + 1) % 3]], axis=1)
    # Sides of one curve are between the same faces. Where not two of them meet, the curve ends.
    at, between = ends.ravel(), np.repeat(faces_beside, 2)
    order = np.lexsort([at, between])
    same = (at[order][1:] == at[order][:-1]) & (between[order][1:] == between[order][:-1])
    pair = same & ~np.append(same[1:], False) & ~np.append([False], same[:-1]) if len(same) else same
    one, other = order[:-1][pair], order[1:][pair]
    beyond = np.full(2 * len(side), -1)
    far = ends[:, ::-1].ravel()
    beyond[one], beyond[other] = far[other], far[one]
    return ends, beyond.reshape(-1, 2)

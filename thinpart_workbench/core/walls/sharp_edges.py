# SPDX-License-Identifier: LGPL-2.1-or-later
"""Edges at which two faces meet under a small angle inside the material: knife's edges, run-outs, tips of teeth."""

from dataclasses import dataclass

import numpy as np
from scipy.spatial import cKDTree

_FACET_TURN = np.radians(20.0)
"""Facets are turned by less against the smooth surface, so that theirs tell which edges to look at."""

_SPACING = 0.25
"""Distance of the points that stand for an edge, in depths: what lies one depth off is told within 1 %."""

_MOST_POINTS = 200_000


@dataclass(frozen=True)
class SharpEdges:
    """Edges of a mesh between two of its faces.

    Attributes
    ----------
    first, second : ndarray of shape (e,), int64
        Sides ``3 t + k`` of the two triangles, as `SurfaceMesh.shared_sides` has them.
    start, end : ndarray of shape (e, 3), mm
        As the first triangle has them.
    angle : ndarray of shape (e,), radians
        Between the two faces, inside the material.
    """

    first: np.ndarray
    second: np.ndarray
    start: np.ndarray
    end: np.ndarray
    angle: np.ndarray

    @property
    def lengths(self):
        """ndarray of shape (e,), mm."""
        return np.linalg.norm(self.end - self.start, axis=1)

    def under(self, angle):
        """Those under an angle, radians: SharpEdges."""
        chosen = self.angle < angle
        return SharpEdges(*(getattr(self, name)[chosen] for name in self.__dataclass_fields__))

    def faces(self, mesh):
        """The two faces of each, the lower number first: ndarray of shape (2, e), int64."""
        return np.sort(mesh.face_of_triangle[np.stack([self.first, self.second]) // 3], axis=0)

    def are_near(self, points, depth):
        """Whether points, ndarray of shape (m, 3), lie nearer to an edge than a depth, mm: ndarray of shape (m,), bool."""
        if not len(self.first) or not len(points):
            return np.zeros(len(points), dtype=bool)
        pieces = np.maximum(np.ceil(self.lengths / (_SPACING * depth)).astype(np.int64), 1)
        if pieces.sum() > _MOST_POINTS:
            pieces = np.maximum((pieces * (_MOST_POINTS / pieces.sum())).astype(np.int64), 1)
        edge = np.repeat(np.arange(len(pieces)), pieces)
        number = np.arange(len(edge)) - np.repeat(np.cumsum(pieces) - pieces, pieces)
        share = ((number + 0.5) / pieces[edge])[:, None]
        tree = cKDTree(self.start[edge] * (1.0 - share) + self.end[edge] * share)
        distance, _ = tree.query(points, distance_upper_bound=depth)
        return np.isfinite(distance)


def sharp_edges(mesh, angle):
    """Find the edges at which two faces of a mesh meet under less than an angle inside the material: SharpEdges.

    Parameters
    ----------
    mesh : SurfaceMesh
    angle : float, radians
        Between the smooth surfaces, at most a right angle.
    """
    first, second = mesh.shared_sides
    facets = mesh.normals
    one, other = first // 3, second // 3
    against = np.einsum("ij,ij->i", facets[one], facets[other]) < -np.cos(angle + _FACET_TURN)
    chosen = np.flatnonzero(against & (mesh.face_of_triangle[one] != mesh.face_of_triangle[other]))
    first, second = first[chosen], second[chosen]
    (one, here), (other, there) = np.divmod(first, 3), np.divmod(second, 3)
    corners, normals = mesh.corners, mesh.corner_normals
    normal = _unit(normals[here, :, one] + normals[(here + 1) % 3, :, one])
    normal_there = _unit(normals[there, :, other] + normals[(there + 1) % 3, :, other])
    start, end = corners[one, here], corners[one, (here + 1) % 3]
    into = corners[other, (there + 2) % 3] - start
    is_convex = np.einsum("ij,ij->i", normal, into) < 0.0
    chord = normal + normal_there  # the arc cosine loses all digits near 1
    between = 2.0 * np.arcsin(np.clip(0.5 * np.linalg.norm(chord, axis=1), 0.0, 1.0))
    sharp = is_convex & (between < angle)
    return SharpEdges(first[sharp], second[sharp], start[sharp], end[sharp], between[sharp])


def _unit(vectors):
    return vectors / np.maximum(np.linalg.norm(vectors, axis=1), np.finfo(float).tiny)[:, None]

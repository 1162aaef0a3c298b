# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rays from samples of a surface into the material."""

import numpy as np

from ..columns import corners_of
from ..mesh.dominant_directions import dominant_axes
from ..progress import portion, report_progress
from ..tolerances import TOLERANCES
from .box_tree import box_tree
from .ray_casting import OUTER, first_hits_about, first_hits_in_order, first_hits_within
from .ray_packets import side_of_cube
from .space_filling_curve import hilbert_index
from .tree_descent import Work

ENTRY_SAMPLES = 1000
"""Number of samples that are checked for a surface that intersects itself."""

BLOCK = 65536
"""Number of rays that are cast together; it bounds the memory used."""


class InwardRays:
    """Casts rays along the inward normals of samples of a mesh, with a tree over its triangles.

    The mesh is first rotated to its dominant directions, because the boxes of slender triangles that are askew to the
    axes are large, which costs up to a factor of twenty.

    Attributes
    ----------
    tree : BoxTree
    normals : ndarray of shape (3, n)
        Normals of the triangles in the coordinates of the tree.
    work : Work
        What casting many rays together has taken so far.
    """

    def __init__(self, mesh):
        self._mesh, self.work = mesh, Work()
        self._axes = dominant_axes(mesh.normals, mesh.areas)
        self.normals = self._axes @ mesh.normals.T
        vertices = self._axes @ mesh.vertices.T
        low, high = vertices.min(axis=1), vertices.max(axis=1)
        self._middle, self._half = 0.5 * (low + high), 0.5 * (high - low)
        vertices -= self._middle[:, None]
        gap = TOLERANCES.gap * mesh.extent if mesh.cracked else 0.0
        self.tree = box_tree(corners_of(vertices, mesh.triangles), self.normals, mesh.areas, gap)

    def first_hits(self, samples, side, report=None, expected=None):
        """Find the first triangle under each sample.

        Returns `distance` (ndarray of shape (m,), mm) and `triangle` (ndarray of shape (m,), int64): inf and -1 where
        nothing is hit.

        Parameters
        ----------
        samples : SurfaceSamples
        side : float
            Side of the triangles that can be hit; see `ray_casting`.
        report : callable, optional
            Called with the fraction done; may raise to stop.
        expected : ndarray of shape (m,), mm, optional
            About how far the hits are, for samples that are few and far from each other.
        """
        if expected is not None:
            origins, directions = self._rays(samples, slice(None))
            return first_hits_about(self.tree, origins, directions, expected, side)
        report_progress(report, 0.0)
        order = self._coherent_order(samples)
        report_progress(report, 0.0)
        distance = np.empty(samples.count)
        triangle = np.empty(samples.count, dtype=np.int64)
        for start in range(0, samples.count, BLOCK):
            rays = order[start:start + BLOCK]
            origins, directions = self._rays(samples, rays)
            distance[rays], triangle[rays] = first_hits_in_order(
                self.tree, origins, directions, side,
                portion(report, start / samples.count, (start + len(rays)) / samples.count), self.work,
            )
        return distance, triangle

    def _coherent_order(self, samples):
        corners = self._middle - self._half, self._middle + self._half
        side = side_of_cube(-self.normals)
        keys = np.empty(samples.count, dtype=np.uint64)
        for start in range(0, samples.count, BLOCK):
            part = slice(start, start + BLOCK)
            curve_index = hilbert_index(self._axes @ samples.points[part].T, corners)
            keys[part] = curve_index | side[samples.triangle[part]]
        return np.argsort(keys, kind="stable")

    def entered(self, samples, distance):
        """Check a few samples, and return those whose ray enters the material again before leaving it.

        Parameters
        ----------
        samples : SurfaceSamples
        distance : ndarray of shape (m,), mm
            Where each ray leaves the material.
        """
        checked = np.arange(0, samples.count, max(1, samples.count // ENTRY_SAMPLES))
        # Where two solids touch, a ray enters the second one exactly where it leaves the first.
        before = distance[checked] - TOLERANCES.self_hit * self.tree.extent
        origins, directions = self._rays(samples, checked)
        entry, _ = first_hits_within(self.tree, origins, directions, before, OUTER)
        entered = checked[entry < before]
        # Beside a sharp edge, the ray leaves the material within the distance at which hits are ignored.
        inside = _distance_to_edges(self._mesh, samples, entered)
        return entered[inside > TOLERANCES.beside_edge * self.tree.extent]

    def corners(self, triangles):
        """ndarray of shape (..., 3, 3), mm: corners of triangles in the coordinates of the tree."""
        return self._mesh.corners[triangles] @ self._axes.T - self._middle

    def turned(self, points):
        """Points of the mesh, ndarray of shape (m, 3), mm, as columns in the coordinates of the tree."""
        return self._axes @ points.T - self._middle[:, None]

    def turned_directions(self, directions):
        """Directions, ndarray of shape (m, 3), as columns in the coordinates of the tree."""
        return self._axes @ directions.T

    def is_hidden(self, samples, distance):
        """Whether a ray hits something before a distance, ndarray of shape (m,), bool.

        Parameters
        ----------
        samples : SurfaceSamples
        distance : ndarray of shape (m,), mm
        """
        before = distance - TOLERANCES.self_hit * self.tree.extent
        origins, directions = self._rays(samples, slice(None))
        met, _ = first_hits_within(self.tree, origins, directions, before)
        return met < before

    def _rays(self, samples, chosen):
        """Origins and directions in the coordinates of the tree."""
        origins = self._axes @ samples.points[chosen].T - self._middle[:, None]
        if samples.normals is None:
            return origins, -np.take(self.normals, samples.triangle[chosen], axis=1)
        return origins, self._axes @ -samples.normals[chosen].T


def _distance_to_edges(mesh, samples, chosen):
    corners = mesh.corners[samples.triangle[chosen]]
    ahead = np.roll(corners, -1, axis=1) - corners
    across = np.cross(ahead, samples.points[chosen, None] - corners)
    return (np.linalg.norm(across, axis=2) / np.linalg.norm(ahead, axis=2)).min(axis=1)

"""Rays from samples of a surface into the material."""

import numpy as np

from .box_tree import box_tree
from .columns import corners_of
from .dominant_directions import dominant_axes
from .progress import portion, tell
from .ray_casting import OUTER, first_hits_in_order, first_hits_within
from .ray_packets import side_of_cube
from .space_filling_curve import hilbert_index
from .tolerances import TOLERANCES

ENTRY_SAMPLES = 1000
"""Samples that are tried for a surface that passes through itself."""

BLOCK = 65536
"""Rays that are cast together: it bounds the memory that casting takes."""


class InwardRays:
    """The tree over a mesh, and rays along its inward normals.

    Parameters
    ----------
    mesh : SurfaceMesh

    Attributes
    ----------
    tree : BoxTree
    normals : ndarray of shape (3, n)
        As the tree has them.

    Notes
    -----
    The mesh is turned to its own dominant directions first: boxes of slender triangles that lie
    askew are fat, which costs up to a factor of twenty.
    """

    def __init__(self, mesh):
        self._mesh = mesh
        self._axes = dominant_axes(mesh.normals, mesh.areas)
        self.normals = self._axes @ mesh.normals.T
        vertices = self._axes @ mesh.vertices.T
        low, high = vertices.min(axis=1), vertices.max(axis=1)
        self._middle, self._half = 0.5 * (low + high), 0.5 * (high - low)
        vertices -= self._middle[:, None]
        gap = TOLERANCES.gap * mesh.extent if mesh.cracked else 0.0
        self.tree = box_tree(corners_of(vertices, mesh.triangles), self.normals, mesh.areas, gap)

    def first_hits(self, samples, side, report=None):
        """First triangle under each sample.

        Parameters
        ----------
        samples : SurfaceSamples
        side : float
            Of the triangles that count; see `ray_casting`.
        report : callable, optional
            Called with the fraction done; may raise to stop.

        Returns
        -------
        distance : ndarray of shape (m,), mm
        triangle : ndarray of shape (m,), int64
            inf and -1 where nothing is met.
        """
        tell(report, 0.0)
        order = self._coherent_order(samples)
        tell(report, 0.0)
        distance = np.empty(samples.count)
        triangle = np.empty(samples.count, dtype=np.int64)
        for start in range(0, samples.count, BLOCK):
            rays = order[start:start + BLOCK]
            distance[rays], triangle[rays] = first_hits_in_order(
                self.tree, *self._rays(samples, rays), side,
                portion(report, start / samples.count, (start + len(rays)) / samples.count),
            )
        return distance, triangle

    def _coherent_order(self, samples):
        corners = self._middle - self._half, self._middle + self._half
        side = side_of_cube(-self.normals)
        keys = np.empty(samples.count, dtype=np.uint64)
        for start in range(0, samples.count, BLOCK):
            part = slice(start, start + BLOCK)
            place = hilbert_index(self._axes @ samples.points[part].T, corners)
            keys[part] = place | side[samples.triangle[part]]
        return np.argsort(keys, kind="stable")

    def entered(self, samples, distance):
        """Samples, of a few, whose ray enters the material again before it has left it.

        Parameters
        ----------
        samples : SurfaceSamples
        distance : ndarray of shape (m,), mm
            Where each ray leaves the material.
        """
        tried = np.arange(0, samples.count, max(1, samples.count // ENTRY_SAMPLES))
        # Two solids that touch are entered just where the first is left.
        before = distance[tried] - TOLERANCES.self_hit * self.tree.extent
        entry, _ = first_hits_within(self.tree, *self._rays(samples, tried), before, OUTER)
        entered = tried[entry < before]
        # Beside a sharp edge the ray has left again before it counts as having started.
        inside = _distance_to_edges(self._mesh, samples, entered)
        return entered[inside > TOLERANCES.beside_edge * self.tree.extent]

    def corners(self, triangles):
        """Corners of some triangles as the tree has them, ndarray of shape (..., 3, 3), mm."""
        return self._mesh.corners[triangles] @ self._axes.T - self._middle

    def is_hidden(self, samples, distance):
        """Whether something is met before a distance, ndarray of shape (m,), bool.

        Parameters
        ----------
        samples : SurfaceSamples
        distance : ndarray of shape (m,), mm
        """
        before = distance - TOLERANCES.self_hit * self.tree.extent
        met, _ = first_hits_within(self.tree, *self._rays(samples, slice(None)), before)
        return met < before

    def _rays(self, samples, chosen):
        """Origins and directions as the tree has them."""
        origins = self._axes @ samples.points[chosen].T - self._middle[:, None]
        return origins, -np.take(self.normals, samples.triangle[chosen], axis=1)


def _distance_to_edges(mesh, samples, chosen):
    corners = mesh.corners[samples.triangle[chosen]]
    ahead = np.roll(corners, -1, axis=1) - corners
    across = np.cross(ahead, samples.points[chosen, None] - corners)
    return (np.linalg.norm(across, axis=2) / np.linalg.norm(ahead, axis=2)).min(axis=1)

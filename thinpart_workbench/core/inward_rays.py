"""Rays from samples of a surface into the material."""

import numpy as np

from .box_tree import box_tree
from .dominant_directions import dominant_axes
from .ray_casting import OUTER, PACKET, first_hits
from .space_filling_curve import hilbert_order
from .tolerances import TOLERANCES

ENTRY_PACKETS = 250
"""Packets of samples that are tried for a surface that passes through itself."""


class InwardRays:
    """The tree over a mesh, and rays along its inward normals.

    Parameters
    ----------
    mesh : SurfaceMesh

    Notes
    -----
    The mesh is turned to its own dominant directions first: boxes of slender triangles that lie
    askew are fat, which costs up to a factor of twenty.
    """

    def __init__(self, mesh):
        self._mesh = mesh
        self._axes = dominant_axes(mesh.normals, mesh.areas)
        self._normals = mesh.normals @ self._axes.T
        corners = mesh.corners @ self._axes.T
        self._middle = 0.5 * (corners.min(axis=(0, 1)) + corners.max(axis=(0, 1)))
        self._tree = box_tree(corners - self._middle, self._normals, mesh.areas)

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
        return self._cast(samples, _packets(self._mesh, samples), side, report)

    def entered(self, samples, distance):
        """Samples, of a few, whose ray enters the material again before it has left it.

        Parameters
        ----------
        samples : SurfaceSamples
        distance : ndarray of shape (m,), mm
            Where each ray leaves the material.
        """
        packets = _packets(self._mesh, samples)
        step = max(1, packets.shape[1] // ENTRY_PACKETS)
        entry, _ = self._cast(samples, packets[:, ::step], OUTER)
        # Two solids that touch are entered just where the first is left.
        entered = np.flatnonzero(entry < distance - TOLERANCES.self_hit * self._tree.extent)
        # Beside a sharp edge the ray has left again before it counts as having started.
        inside = _distance_to_edges(self._mesh, samples, entered)
        return entered[inside > TOLERANCES.beside_edge * self._tree.extent]

    def _cast(self, samples, packets, side, report=None):
        if samples.count == 0:
            return np.empty(0), np.empty(0, dtype=np.int64)
        origins = samples.points[packets] @ self._axes.T - self._middle
        directions = -self._normals[samples.triangle[packets[0]]]
        packed_distance, packed_triangle = first_hits(
            self._tree, origins, directions, report, side
        )
        # A packet that is not full repeats a ray; both results are the same.
        distance = np.full(samples.count, np.inf)
        triangle = np.full(samples.count, -1, dtype=np.int64)
        distance[packets], triangle[packets] = packed_distance, packed_triangle
        return distance, triangle


def _distance_to_edges(mesh, samples, chosen):
    corners = mesh.corners[samples.triangle[chosen]]
    ahead = np.roll(corners, -1, axis=1) - corners
    across = np.cross(ahead, samples.points[chosen, None] - corners)
    return (np.linalg.norm(across, axis=2) / np.linalg.norm(ahead, axis=2)).min(axis=1)


def _packets(mesh, samples):
    """Samples in packets of eight that share a triangle, ndarray of shape (8, p).

    Within a large triangle samples are put in spatial order first; packets follow the curve.
    """
    if samples.count == 0:
        return np.empty((PACKET, 0), dtype=np.int64)
    count = np.bincount(samples.triangle, minlength=mesh.count)
    order = np.arange(samples.count)
    crowded = np.flatnonzero(count[samples.triangle] > PACKET)
    if len(crowded):
        inner = hilbert_order(samples.points[crowded])
        by_triangle = np.argsort(samples.triangle[crowded][inner], kind="stable")
        order[crowded] = crowded[inner[by_triangle]]
    packets_of = -(-count // PACKET)
    start = np.cumsum(count) - count
    first_packet = np.cumsum(packets_of) - packets_of
    triangle = np.repeat(np.arange(mesh.count), packets_of)
    within = (np.arange(len(triangle)) - first_packet[triangle]) * PACKET
    last = start[triangle] + count[triangle] - 1
    places = np.minimum(start[triangle] + within + np.arange(PACKET)[:, None], last)
    packets = order[places]
    middle = samples.points[packets[0]]
    return packets[:, hilbert_order(middle)]

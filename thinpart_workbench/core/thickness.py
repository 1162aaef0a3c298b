"""Thickness of the material under every sample of the surface."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from .box_tree import box_tree
from .ray_casting import PACKET, first_hits
from .space_filling_curve import hilbert_order

PARALLEL_BELOW = np.radians(10.0)
"""Wedge angle under which two walls are parallel (Giannini et al. 2012, 4.2.2)."""

NONPARALLEL_BELOW = np.radians(60.0)
"""Wedge angle from which two faces do not enclose a thickness (same place)."""


@dataclass(frozen=True)
class ThicknessField:
    """What each sample sees through the material.

    Attributes
    ----------
    distance : ndarray of shape (m,), mm
        To the opposite side; inf where nothing was met.
    wedge_angle : ndarray of shape (m,), radians
        Angle between the normal here and the reversed normal there: 0 for parallel walls; pi
        where nothing was met.
    opposite : ndarray of shape (m,), int64
        Triangle met, -1 for none.
    area : ndarray of shape (m,), mm2
        Area that each sample stands for.
    face : ndarray of shape (m,), int64
        B-Rep face of each sample.
    opposite_face : ndarray of shape (m,), int64
        B-Rep face met, -1 for none.
    points, opposite_points : ndarray of shape (m, 3), mm
        In the coordinates of the part's document.
    """

    distance: np.ndarray
    wedge_angle: np.ndarray
    opposite: np.ndarray
    area: np.ndarray
    face: np.ndarray
    opposite_face: np.ndarray
    points: np.ndarray
    opposite_points: np.ndarray

    @cached_property
    def parallel(self):
        """ndarray of shape (m,), bool: samples that enter the parallel distribution."""
        return self.wedge_angle < PARALLEL_BELOW

    @cached_property
    def nonparallel(self):
        """ndarray of shape (m,), bool: samples that enter the non-parallel table."""
        return ~self.parallel & (self.wedge_angle < NONPARALLEL_BELOW)


def measure_rays(mesh, samples, report=None):
    """First-hit thickness along the inward normal of every sample.

    Parameters
    ----------
    mesh : SurfaceMesh
    samples : SurfaceSamples
    report : callable, optional
        Called with the fraction done; may raise to stop.

    Returns
    -------
    ThicknessField

    Notes
    -----
    Giannini, Petton, Pernot (TMCE 2012), 4.2.2, want the distance between faces that enclose
    material, never across a void. Their rule on pairs of triangles (`pair_rule`) sees through
    whatever lies between; the first triangle met from inside is the wall itself. The mesh is first
    turned to its own dominant directions: boxes of slender triangles that lie askew are fat, which
    costs up to a factor of twenty, and the result is then the same for every placement.
    """
    axes = dominant_axes(mesh.normals, mesh.areas)
    normals = mesh.normals @ axes.T
    corners = mesh.corners @ axes.T
    corners -= 0.5 * (corners.min(axis=(0, 1)) + corners.max(axis=(0, 1)))
    tree = box_tree(corners, normals, mesh.areas)
    packets = _packets(mesh, samples)
    barycentre = mesh.corners[0, 0] @ axes.T - corners[0, 0]
    origins = samples.points[packets] @ axes.T - barycentre
    directions = -normals[samples.triangle[packets[0]]]
    packed_distance, packed_triangle = first_hits(tree, origins, directions, report)
    # A packet that is not full repeats a ray; both results are the same.
    distance = np.empty(samples.count)
    opposite = np.empty(samples.count, dtype=np.int64)
    distance[packets], opposite[packets] = packed_distance, packed_triangle
    return thickness_field(mesh, samples, distance, opposite)


def thickness_field(mesh, samples, distance, opposite):
    """Complete distances and opposite triangles of samples to a `ThicknessField`."""
    met = opposite >= 0
    own = mesh.normals[samples.triangle]
    cosine = np.where(met, -np.einsum("ij,ij->i", own, mesh.normals[opposite]), -1.0)
    # Near 1 the arc cosine has no digits; the chord between the two directions has them all.
    chord = own + mesh.normals[opposite]
    half = np.clip(0.5 * np.sqrt(np.einsum("ij,ij->i", chord, chord)), 0.0, 1.0)
    wedge_angle = np.where(cosine > 0.5, 2.0 * np.arcsin(half), np.arccos(np.clip(cosine, -1, 1)))
    points = samples.points + mesh.origin
    reach = np.where(met, distance, 0.0)
    face = mesh.face_of_triangle[samples.triangle]
    return ThicknessField(
        distance, wedge_angle, opposite, samples.area, face,
        np.where(met, mesh.face_of_triangle[opposite], -1),
        points, points - own * reach[:, None],
    )


def dominant_axes(normals, areas):
    """Three perpendicular directions in which most of the surface faces.

    Parameters
    ----------
    normals : ndarray of shape (n, 3)
    areas : ndarray of shape (n,)

    Returns
    -------
    ndarray of shape (3, 3)
        Rows are unit vectors. They turn with the part.
    """
    side = np.where(normals @ np.array([1.0, 1e-3, 1e-6]) < 0.0, -1.0, 1.0)
    facing = normals * side[:, None]
    cell = np.round(facing * 200.0).astype(np.int64)
    _, group = np.unique((cell[:, 0] * 1000 + cell[:, 1]) * 1000 + cell[:, 2], return_inverse=True)
    group = group.ravel()
    total = np.stack([np.bincount(group, facing[:, k] * areas) for k in range(3)], axis=1)
    weight = np.linalg.norm(total, axis=1)
    largest = np.argsort(-weight, kind="stable")[:50]
    candidates = total[largest] / weight[largest, None]
    first = candidates[0]
    across = candidates[np.abs(candidates @ first) < 0.05]
    second = across[0] if len(across) else np.eye(3)[np.abs(first).argmin()]
    second = second - first * (second @ first)
    second /= np.linalg.norm(second)
    return np.stack([first, second, np.cross(first, second)])


def _packets(mesh, samples):
    """Samples in packets of eight that share a triangle, ndarray of shape (8, p).

    Within a large triangle samples are put in spatial order first; packets follow the curve.
    """
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

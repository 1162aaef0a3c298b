"""Thickness of the material under every sample of the surface."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from .box_tree import box_tree
from .dominant_directions import dominant_axes
from .ray_casting import PACKET, first_hits
from .smooth_normals import normals_at
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
        Angle between the normal here and the reversed normal there: 0 for parallel walls; pi where
        nothing was met.
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
    """Complete distances and opposite triangles of samples to a `ThicknessField`.

    Notes
    -----
    The wedge angle is taken between the normals of the smooth surfaces, not of the facets: those
    deviate by half the angular deflection on either side, and near the poles of a sphere by more,
    so that a shell of constant wall would seem to have wedges in it.
    """
    met = np.flatnonzero(opposite >= 0)
    facet = mesh.normals[samples.triangle]
    reach = np.where(opposite >= 0, distance, 0.0)
    hit_points = samples.points - facet * reach[:, None]
    wedge_angle = np.full(samples.count, np.pi)
    here = normals_at(mesh, samples.triangle[met], samples.points[met])
    there = normals_at(mesh, opposite[met], hit_points[met])
    wedge_angle[met] = _angle_between(here, -there)
    return ThicknessField(
        distance, wedge_angle, opposite, samples.area, mesh.face_of_triangle[samples.triangle],
        np.where(opposite >= 0, mesh.face_of_triangle[opposite], -1),
        samples.points + mesh.origin, hit_points + mesh.origin,
    )


def _angle_between(first, second):
    # The arc cosine has no digits near 1; the chord between the two directions has them all.
    chord = first - second
    half = 0.5 * np.sqrt(np.einsum("ij,ij->i", chord, chord))
    return 2.0 * np.arcsin(np.clip(half, 0.0, 1.0))


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

"""Thickness of the material under every sample of the surface."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from .box_tree import box_tree
from .dominant_directions import dominant_axes
from .ray_casting import INNER, OUTER, PACKET, first_hits
from .smooth_normals import normals_at
from .space_filling_curve import hilbert_order
from .tolerances import TOLERANCES

PARALLEL_BELOW = np.radians(10.0)
"""Wedge angle under which two walls are parallel (Giannini et al. 2012, 4.2.2)."""

ENTRY_PACKETS = 250
"""Packets of samples that are tried for a surface that passes through itself."""

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
    entered : ndarray of shape (k,), int64
        Samples, of a few that were tried, whose ray enters the material again before it has left
        it: there the surface passes through itself or is inside-out.
    """

    distance: np.ndarray
    wedge_angle: np.ndarray
    opposite: np.ndarray
    area: np.ndarray
    face: np.ndarray
    opposite_face: np.ndarray
    points: np.ndarray
    opposite_points: np.ndarray
    entered: np.ndarray

    @cached_property
    def parallel(self):
        """ndarray of shape (m,), bool: samples that enter the parallel distribution."""
        return self.wedge_angle < PARALLEL_BELOW - TOLERANCES.angle

    @cached_property
    def nonparallel(self):
        """ndarray of shape (m,), bool: samples that enter the non-parallel table."""
        return ~self.parallel & (self.wedge_angle < NONPARALLEL_BELOW - TOLERANCES.angle)


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
    rays = _InwardRays(mesh, samples)
    distance, opposite = rays.first_hits(rays.packets, INNER, report)
    return thickness_field(mesh, samples, distance, opposite, rays.entered(distance))


class _InwardRays:
    """Rays from samples along the inward normals, and the tree that they descend."""

    def __init__(self, mesh, samples):
        self.mesh, self.samples = mesh, samples
        axes = dominant_axes(mesh.normals, mesh.areas)
        normals = mesh.normals @ axes.T
        corners = mesh.corners @ axes.T
        middle = 0.5 * (corners.min(axis=(0, 1)) + corners.max(axis=(0, 1)))
        self.tree = box_tree(corners - middle, normals, mesh.areas)
        self.origins = samples.points @ axes.T - middle
        self.directions = -normals[samples.triangle]
        self.packets = _packets(mesh, samples)

    def first_hits(self, packets, side, report=None):
        """Distance and triangle per sample; samples in none of the packets met nothing."""
        packed_distance, packed_triangle = first_hits(
            self.tree, self.origins[packets], self.directions[packets[0]], report, side
        )
        # A packet that is not full repeats a ray; both results are the same.
        distance = np.full(len(self.origins), np.inf)
        triangle = np.full(len(self.origins), -1, dtype=np.int64)
        distance[packets], triangle[packets] = packed_distance, packed_triangle
        return distance, triangle

    def entered(self, distance):
        """Samples, of some, whose ray enters the material again before it has left it."""
        step = max(1, self.packets.shape[1] // ENTRY_PACKETS)
        entry, _ = self.first_hits(self.packets[:, ::step], OUTER)
        # Two solids that touch are entered just where the first is left.
        entered = np.flatnonzero(entry < distance - TOLERANCES.self_hit * self.tree.extent)
        # Beside a sharp edge the ray has left again before it counts as having started.
        inside = _distance_to_edges(self.mesh, self.samples, entered)
        return entered[inside > TOLERANCES.beside_edge * self.tree.extent]


def thickness_field(mesh, samples, distance, opposite, entered=()):
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
        samples.points + mesh.origin, hit_points + mesh.origin, np.asarray(entered, dtype=np.int64),
    )


def _angle_between(first, second):
    # The arc cosine has no digits near 1; the chord between the two directions has them all.
    chord = first - second
    half = 0.5 * np.sqrt(np.einsum("ij,ij->i", chord, chord))
    return 2.0 * np.arcsin(np.clip(half, 0.0, 1.0))


def _distance_to_edges(mesh, samples, chosen):
    corners = mesh.corners[samples.triangle[chosen]]
    ahead = np.roll(corners, -1, axis=1) - corners
    across = np.cross(ahead, samples.points[chosen, None] - corners)
    return (np.linalg.norm(across, axis=2) / np.linalg.norm(ahead, axis=2)).min(axis=1)


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

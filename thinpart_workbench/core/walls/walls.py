# SPDX-License-Identifier: LGPL-2.1-or-later
"""Walls: what lies opposite of points of the surface, through the material."""

from typing import NamedTuple

import numpy as np

from ..mesh.smooth_normals import bent_points, interpolated_normals
from ..progress import portion, report_progress
from ..rays.ray_casting import INNER
from ..tolerances import TOLERANCES

PARALLEL_BELOW = np.radians(10.0)
"""Wedge angle under which two walls are parallel (Giannini et al. 2012, 4.2.2)."""

NONPARALLEL_BELOW = np.radians(60.0)
"""Wedge angle from which on two faces do not enclose a thickness (Giannini et al. 2012, 4.2.2)."""

RAYS_DONE = 0.9
"""Progress when all rays are cast."""


class Walls(NamedTuple):
    """What samples see; see `ThicknessField`.

    Attributes
    ----------
    distance : ndarray of shape (m,), mm
    wedge_angle : ndarray of shape (m,), radians
    opposite : ndarray of shape (m,), int64
    """

    distance: np.ndarray
    wedge_angle: np.ndarray
    opposite: np.ndarray


def walls_under(mesh, rays, samples, report=None, expected=None):
    """Measure the walls under samples, between the smooth surfaces that the facets approximate.

    Returns `walls` (Walls) and `reach` (ndarray of shape (m,), mm; distance between the facets themselves).

    The ray runs from the facet, along the normal of the smooth surface there. What the surface rises above either facet
    (`CurvedSurface`) is added, so that the diameter of a rod is that of the rod and not of a prism.

    Parameters
    ----------
    mesh : SurfaceMesh
    rays : InwardRays
    samples : SurfaceSamples
    report : callable, optional
        Called with the fraction done; may raise to stop.
    expected : ndarray of shape (m,), mm, optional
        About how far samples see, where that is known; it saves time and changes nothing.
    """
    reach, opposite = rays.first_hits(samples, INNER, portion(report, 0.0, RAYS_DONE), expected)
    distance, angle = reach.copy(), np.full(samples.count, np.pi)
    met = np.flatnonzero(opposite >= 0)
    normals = samples.normals_on(mesh)[met]
    points, triangle, other = samples.points[met], samples.triangle[met], opposite[met]
    report_progress(report, RAYS_DONE)
    rise, _ = _smooth(mesh, triangle, points)
    rise_there, normals_there = _smooth(mesh, other, points - normals * reach[met, None])
    angle[met] = angle_between(normals, -normals_there)
    slant = np.cos(np.minimum(angle[met], NONPARALLEL_BELOW))
    # However the surface bulges, a wall does not vanish or double by it.
    distance[met] += np.clip(rise + rise_there / slant, -0.5 * reach[met], reach[met])
    report_progress(report, 1.0)
    return Walls(distance, angle, opposite), reach


def _smooth(mesh, triangle, points):
    """How far the smooth surface lies above points of facets, mm, and its normals there: shapes (m,) and (m, 3)."""
    rise, normals = np.zeros(len(triangle)), np.take(mesh.normals, triangle, axis=0)
    for chosen, own, weights in bent_points(mesh, triangle, points):
        rise[chosen] = mesh.curved_surface.heights_at(own, weights)
        normals[chosen] = interpolated_normals(mesh, own, weights)
    return rise, normals


def is_parallel(wedge_angle):
    """Whether walls at a wedge angle, radians, are parallel."""
    return wedge_angle < PARALLEL_BELOW - TOLERANCES.angle


def angle_between(first, second):
    """Angles between unit vectors, each of shape (m, 3): ndarray of shape (m,), radians."""
    # The arc cosine loses all digits near 1; the chord between the two directions keeps them.
    chord = first - second
    half = 0.5 * np.sqrt(np.einsum("ij,ij->i", chord, chord))
    return 2.0 * np.arcsin(np.clip(half, 0.0, 1.0))

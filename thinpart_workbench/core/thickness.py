"""Thickness of the material under every sample of the surface."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from .inward_rays import InwardRays
from .ray_casting import INNER
from .progress import portion, tell
from .sampling import SurfaceSamples, corner_samples
from .smooth_normals import normals_at
from .surface_mesh import SurfaceMesh
from .tolerances import TOLERANCES

PARALLEL_BELOW = np.radians(10.0)
"""Wedge angle under which two walls are parallel (Giannini et al. 2012, 4.2.2)."""

PROBED_TRIANGLES = 400
"""Triangles, beside the likely thinnest of each face, whose corners are tried for the minimum."""

SLOPE_ALLOWANCE = np.radians(1.0)
"""Added to wedge angles, which are those of interpolated normals."""

NONPARALLEL_BELOW = np.radians(60.0)
"""Wedge angle from which two faces do not enclose a thickness (same place)."""

RAYS_DONE, ANGLES_DONE, CORNERS_CHOSEN = 0.85, 0.95, 0.98
"""Progress after each step of measuring by rays."""

_AT_ONCE = 16384


@dataclass(frozen=True)
class ThicknessField:
    """What each sample sees through the material.

    Attributes
    ----------
    mesh : SurfaceMesh
    samples : SurfaceSamples
        Those that were added to find the minimum, which stand for no area, come last.
    distance : ndarray of shape (m,), mm
        To the opposite side; inf where nothing was met.
    wedge_angle : ndarray of shape (m,), radians
        Angle between the normal here and the reversed normal there: 0 for parallel walls; pi where
        nothing was met.
    opposite : ndarray of shape (m,), int64
        Triangle met, -1 for none.
    entered : ndarray of shape (k,), int64
        Samples, of a few that were tried, whose ray enters the material again before it has left
        it: there the surface passes through itself or is inside-out.
    """

    mesh: SurfaceMesh
    samples: SurfaceSamples
    distance: np.ndarray
    wedge_angle: np.ndarray
    opposite: np.ndarray
    entered: np.ndarray

    @property
    def area(self):
        """ndarray of shape (m,), mm2: area that each sample stands for."""
        return self.samples.area

    @cached_property
    def parallel(self):
        """ndarray of shape (m,), bool: samples that enter the parallel distribution."""
        return is_parallel(self.wedge_angle)

    @cached_property
    def nonparallel(self):
        """ndarray of shape (m,), bool: samples that enter the non-parallel table."""
        return ~self.parallel & (self.wedge_angle < NONPARALLEL_BELOW - TOLERANCES.angle)

    @property
    def face(self):
        """ndarray of shape (m,), int64: B-Rep face of each sample."""
        return self.mesh.face_of_triangle[self.samples.triangle]

    def opposite_face(self, sample):
        """B-Rep face that one sample sees, -1 for none."""
        met = self.opposite[sample]
        return int(self.mesh.face_of_triangle[met]) if met >= 0 else -1

    def points(self, sample):
        """Where one sample is and what it sees, two ndarrays of shape (3,), mm.

        In the coordinates of the part's document; both are one where nothing was met.
        """
        here = self.samples.points[sample]
        reach = self.distance[sample] if self.opposite[sample] >= 0 else 0.0
        there = here - self.mesh.normals[self.samples.triangle[sample]] * reach
        return here + self.mesh.origin, there + self.mesh.origin


def is_parallel(wedge_angle):
    """Whether walls at a wedge angle, radians, are parallel."""
    return wedge_angle < PARALLEL_BELOW - TOLERANCES.angle


def measure_rays(mesh, samples, report=None, rays=None):
    """First-hit thickness along the inward normal of every sample.

    Parameters
    ----------
    mesh : SurfaceMesh
    samples : SurfaceSamples
    report : callable, optional
        Called with the fraction done; may raise to stop.
    rays : InwardRays, optional
        Over the mesh; is built where it is not given.

    Returns
    -------
    ThicknessField

    Notes
    -----
    Giannini, Petton, Pernot (TMCE 2012), 4.2.2, want the distance between faces that enclose
    material, never across a void. Their rule on pairs of triangles (`pair_rule`) sees through
    whatever lies between; the first triangle met from inside is the wall itself.
    """
    rays = rays or InwardRays(mesh)
    distance, opposite = rays.first_hits(samples, INNER, portion(report, 0.0, RAYS_DONE))
    angle = wedge_angles(mesh, samples, distance, opposite, portion(report, RAYS_DONE, ANGLES_DONE))
    entered = rays.entered(samples, distance)
    corners = corner_samples(mesh, _likely_thinnest(mesh, samples, distance, angle))
    tell(report, CORNERS_CHOSEN)
    corner_distance, corner_opposite = rays.first_hits(corners, INNER)
    corner_angle = wedge_angles(mesh, corners, corner_distance, corner_opposite)
    tell(report, 1.0)
    return ThicknessField(
        mesh, samples.followed_by(corners), np.concatenate([distance, corner_distance]),
        np.concatenate([angle, corner_angle]), np.concatenate([opposite, corner_opposite]), entered,
    )


def _likely_thinnest(mesh, samples, distance, wedge_angle):
    """Triangles whose corners may lie over a thinner wall than any sample does.

    Samples stand in the middle of the area they represent; where a wall tapers, its thinnest place
    is at the end. From a sample the wall can shrink by the tangent of its wedge angle.
    """
    parallel = np.flatnonzero(is_parallel(wedge_angle))
    triangle = samples.triangle[parallel]
    sides = mesh.corners - np.roll(mesh.corners, 1, axis=1)
    longest = np.sqrt((sides * sides).sum(axis=2).max(axis=1))
    slope = np.tan(wedge_angle[parallel] + SLOPE_ALLOWANCE)
    least = np.full(mesh.count, np.inf)
    np.minimum.at(least, triangle, distance[parallel] - longest[triangle] * slope)
    order = np.argsort(least, kind="stable")
    order = order[np.isfinite(least[order])]
    _, first_of_face = np.unique(mesh.face_of_triangle[order], return_index=True)
    return np.union1d(order[:PROBED_TRIANGLES], order[first_of_face])


def wedge_angles(mesh, samples, distance, opposite, report=None):
    """Wedge angles between samples and the triangles that they see.

    Parameters
    ----------
    mesh : SurfaceMesh
    samples : SurfaceSamples
    distance : ndarray of shape (m,), mm
    opposite : ndarray of shape (m,), int64
        -1 where nothing is met.
    report : callable, optional
        Called with the fraction done; may raise to stop.

    Returns
    -------
    ndarray of shape (m,), radians
        pi where nothing is met.

    Notes
    -----
    They are taken between the normals of the smooth surfaces, not of the facets: those deviate by
    half the angular deflection on either side, and near the poles of a sphere by more, so that a
    shell of constant wall would seem to have wedges in it.
    """
    angle = np.full(samples.count, np.pi)
    for start in range(0, samples.count, _AT_ONCE):
        met = start + np.flatnonzero(opposite[start:start + _AT_ONCE] >= 0)
        triangle, points = samples.triangle[met], samples.points[met]
        here = normals_at(mesh, triangle, points)
        there = points - mesh.normals[triangle] * distance[met, None]
        tell(report, start / samples.count)
        angle[met] = _angle_between(here, -normals_at(mesh, opposite[met], there))
    return angle


def _angle_between(first, second):
    # The arc cosine has no digits near 1; the chord between the two directions has them all.
    chord = first - second
    half = 0.5 * np.sqrt(np.einsum("ij,ij->i", chord, chord))
    return 2.0 * np.arcsin(np.clip(half, 0.0, 1.0))

"""Thickness of the material under every sample of the surface."""

from dataclasses import dataclass
from dataclasses import fields as dataclass_fields
from functools import cached_property

import numpy as np

from .inward_rays import InwardRays
from .ray_casting import INNER
from .sampling import corner_samples
from .smooth_normals import normals_at
from .tolerances import TOLERANCES

PARALLEL_BELOW = np.radians(10.0)
"""Wedge angle under which two walls are parallel (Giannini et al. 2012, 4.2.2)."""

PROBED_TRIANGLES = 400
"""Triangles, beside the likely thinnest of each face, whose corners are tried for the minimum."""

SLOPE_ALLOWANCE = np.radians(1.0)
"""Added to wedge angles, which are those of interpolated normals."""

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
        Area that each sample stands for; 0 for those that were added to find the minimum.
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
    whatever lies between; the first triangle met from inside is the wall itself. The mesh is first
    turned to its own dominant directions: boxes of slender triangles that lie askew are fat, which
    costs up to a factor of twenty, and the result is then the same for every placement.
    """
    rays = rays or InwardRays(mesh)
    distance, opposite = rays.first_hits(samples, INNER, report)
    field = thickness_field(mesh, samples, distance, opposite, rays.entered(samples, distance))
    corners = corner_samples(mesh, _likely_thinnest(mesh, samples, field))
    return _joined(field, thickness_field(mesh, corners, *rays.first_hits(corners, INNER)))


def _likely_thinnest(mesh, samples, field):
    """Triangles whose corners may lie over a thinner wall than any sample does.

    Samples stand in the middle of the area they represent; where a wall tapers, its thinnest place
    is at the end. From a sample the wall can shrink by the tangent of its wedge angle.
    """
    parallel = np.flatnonzero(field.parallel)
    triangle = samples.triangle[parallel]
    sides = mesh.corners - np.roll(mesh.corners, 1, axis=1)
    longest = np.sqrt((sides * sides).sum(axis=2).max(axis=1))
    slope = np.tan(field.wedge_angle[parallel] + SLOPE_ALLOWANCE)
    least = np.full(mesh.count, np.inf)
    np.minimum.at(least, triangle, field.distance[parallel] - longest[triangle] * slope)
    order = np.argsort(least, kind="stable")
    order = order[np.isfinite(least[order])]
    _, first_of_face = np.unique(mesh.face_of_triangle[order], return_index=True)
    return np.union1d(order[:PROBED_TRIANGLES], order[first_of_face])


def _joined(*fields):
    return ThicknessField(**{
        each.name: np.concatenate([getattr(field, each.name) for field in fields])
        for each in dataclass_fields(ThicknessField)
    })


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

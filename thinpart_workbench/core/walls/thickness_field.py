# SPDX-License-Identifier: LGPL-2.1-or-later
"""Thickness of the material under every sample of the surface."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ..descriptors.descriptor_table import STATED_ANGLES
from ..mesh.sampling import SurfaceSamples, corner_samples
from ..mesh.surface_mesh import SurfaceMesh
from ..progress import portion, report_progress
from ..rays.inward_rays import InwardRays
from ..tolerances import TOLERANCES
from .sharp_edges import sharp_edges
from .walls import NONPARALLEL_BELOW, is_parallel, walls_under

PROBED_TRIANGLES = 400
"""Number of triangles, besides the probably thinnest one of each face, whose corners are checked for the minimum."""

SLOPE_ALLOWANCE = np.radians(1.0)
"""Added to wedge angles, because they come from interpolated normals."""

WALLS_DONE, CORNERS_CHOSEN = 0.95, 0.98
"""Progress after each step of a measurement by rays."""


@dataclass(frozen=True)
class ThicknessField:
    """What each sample sees through the material.

    Attributes
    ----------
    mesh : SurfaceMesh
    samples : SurfaceSamples
        Samples that were added to find the minimum, which represent no area, come last.
    distance : ndarray of shape (m,), mm
        Distance to the opposite side; inf where the ray hit nothing.
    wedge_angle : ndarray of shape (m,), radians
        Angle between the normal at the sample and the reversed normal at the hit: 0 for parallel walls; pi where the
        ray hit nothing.
    opposite : ndarray of shape (m,), int64
        Triangle that the ray hit, -1 for none.
    entered : ndarray of shape (k,), int64
        The samples, among the few checked, whose ray enters the material again before leaving it: there the surface
        intersects itself or is inside-out.
    """

    mesh: SurfaceMesh
    samples: SurfaceSamples
    distance: np.ndarray
    wedge_angle: np.ndarray
    opposite: np.ndarray
    entered: np.ndarray

    @property
    def area(self):
        """ndarray of shape (m,), mm2: area that each sample represents."""
        return self.samples.area

    @cached_property
    def normals(self):
        """ndarray of shape (m, 3): outward unit normals of the samples, against which walls are measured."""
        return self.samples.normals_on(self.mesh)

    @cached_property
    def parallel(self):
        """ndarray of shape (m,), bool: samples that enter the parallel distribution."""
        return is_parallel(self.wedge_angle)

    @cached_property
    def nonparallel(self):
        """ndarray of shape (m,), bool: samples that enter the non-parallel table."""
        return ~self.parallel & (self.wedge_angle < NONPARALLEL_BELOW - TOLERANCES.angle)

    @cached_property
    def slanted(self):
        """ndarray of shape (k,), int64: samples over walls at `STATED_ANGLES`, nearest first."""
        low, high = (np.radians(angle) - TOLERANCES.angle for angle in STATED_ANGLES)
        chosen = np.flatnonzero((self.wedge_angle >= low) & (self.wedge_angle < high))
        return chosen[np.argsort(self.distance[chosen], kind="stable")]

    @cached_property
    def sharp_edges(self):
        """The `SharpEdges` at which faces meet under less than `NONPARALLEL_BELOW`."""
        return sharp_edges(self.mesh, NONPARALLEL_BELOW)

    @property
    def face(self):
        """ndarray of shape (m,), int64: B-Rep face of each sample."""
        return self.mesh.face_of_triangle[self.samples.triangle]

    def opposite_face(self, sample):
        """B-Rep face that one sample sees, -1 for none."""
        met = self.opposite[sample]
        return int(self.mesh.face_of_triangle[met]) if met >= 0 else -1

    def points(self, sample):
        """Points of one sample and of what it sees, two ndarrays of shape (3,), mm.

        They are in the coordinates of the part's document, and are equal where the ray hit nothing.
        """
        here = self.samples.points[sample]
        reach = self.distance[sample] if self.opposite[sample] >= 0 else 0.0
        there = here - self.normals[sample] * reach
        return here + self.mesh.origin, there + self.mesh.origin


def measure_rays(mesh, samples, report=None, rays=None):
    """Measure the distance to the first hit along the inward normal of every sample: ThicknessField.

    Giannini, Petton, Pernot (TMCE 2012), 4.2.2, define thickness as the distance between faces that enclose material,
    never across a void. Their rule for pairs of triangles (`pair_rule`) ignores what lies between the two; the first
    triangle hit from inside is always the opposite side of the wall.

    Parameters
    ----------
    mesh : SurfaceMesh
    samples : SurfaceSamples
    report : callable, optional
        Called with the fraction done; may raise to stop.
    rays : InwardRays, optional
        Rays over the mesh; built if not given.
    """
    rays = rays or InwardRays(mesh)
    walls, reach = walls_under(mesh, rays, samples, portion(report, 0.0, WALLS_DONE))
    entered = rays.entered(samples, reach)
    corners = corner_samples(mesh, likely_thinnest(mesh, samples, walls, is_parallel(walls.wedge_angle)))
    report_progress(report, CORNERS_CHOSEN)
    of_corners, _ = walls_under(mesh, rays, corners, expected=_farthest_on(mesh, samples, reach)[corners.triangle])
    report_progress(report, 1.0)
    return ThicknessField(mesh, samples.followed_by(corners),
                          np.concatenate([walls.distance, of_corners.distance]),
                          np.concatenate([walls.wedge_angle, of_corners.wedge_angle]),
                          np.concatenate([walls.opposite, of_corners.opposite]), entered)


def _farthest_on(mesh, samples, reach):
    """Distance, mm, that no sample of a triangle sees farther than: ndarray of shape (n,), inf where that is not known."""
    hit = np.flatnonzero(np.isfinite(reach))
    farthest = np.zeros(mesh.count)
    np.maximum.at(farthest, samples.triangle[hit], reach[hit])
    return np.where(farthest > 0.0, farthest, np.inf)


def likely_thinnest(mesh, samples, walls, chosen):
    """Triangles whose corners may lie over a thinner wall than any sample: ndarray of shape (k,), int64, ascending.

    Samples are in the middle of the area they represent, but a tapered wall is thinnest at its end. Away from a
    sample, the wall can get thinner by the tangent of its wedge angle.

    Parameters
    ----------
    mesh : SurfaceMesh
    samples : SurfaceSamples
    walls : Walls or ThicknessField
        Under each of the samples.
    chosen : ndarray of shape (m,), bool
        The samples over walls that are looked at.
    """
    chosen = np.flatnonzero(chosen)
    triangle = samples.triangle[chosen]
    sides = mesh.corners - np.roll(mesh.corners, 1, axis=1)
    longest = np.sqrt((sides * sides).sum(axis=2).max(axis=1))
    slope = np.tan(np.minimum(walls.wedge_angle[chosen] + SLOPE_ALLOWANCE, NONPARALLEL_BELOW))
    least = np.full(mesh.count, np.inf)
    np.minimum.at(least, triangle, walls.distance[chosen] - longest[triangle] * slope)
    order = np.argsort(least, kind="stable")
    order = order[np.isfinite(least[order])]
    _, first_of_face = np.unique(mesh.face_of_triangle[order], return_index=True)
    return np.union1d(order[:PROBED_TRIANGLES], order[first_of_face])

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measure everything on a surface mesh."""

from dataclasses import dataclass, replace
from functools import cached_property
from typing import Optional

import numpy as np

from ..descriptors.descriptor_table import STATED_ANGLES, STATED_FLOOR, Descriptors
from ..descriptors.distribution import distribution
from ..descriptors.equal_walls import WallSize
from ..descriptors.local_distribution import local_distribution
from ..descriptors.precision import EXACT
from ..descriptors.ridges import ridge_ratio
from ..forms.equal_faces import equal_faces
from ..mesh.bounds import minimal_box, principal_box
from ..mesh.dominant_directions import dominant_directions
from ..mesh.mass_properties import area, volume
from ..mesh.round_sides import box_of_round_sides
from ..mesh.sampling import centroid_samples, surface_samples
from ..progress import portion, report_progress
from ..rays.inward_rays import InwardRays
from ..walls.face_thickness import Witness, face_thicknesses, witness_of
from ..walls.thickness_field import ThicknessField, measure_rays
from ..walls.thin_places import ThinPlaces, thin_places
from ..walls.thinnest_place import ThinnestPlace, thinnest_place
from ..walls.thinnest_wall import thinnest_walls
from .local_thickness import local_thickness
from .nonparallel import LeastSlanted, nonparallel_minimum, sampled_minimum
from .pair_rule import measure_pairs
from .wall_regions import WallRegions, wall_regions, with_thinnest, with_thinnest_taper

BOX_DONE, TREE_DONE, RAYS_DONE = 0.1, 0.15, 0.85
"""Progress after the box is found, after the tree is built, and after all rays are cast. The rest is the search for
slanted walls."""

FLAT_DIRECTIONS = 16
"""Number of sides of a part that are tried as sides of its box."""


@dataclass(frozen=True)
class Measurement:
    """What was measured on one part.

    Attributes
    ----------
    descriptors : Descriptors
    field : ThicknessField
        The thickness under every sample, for colours and per-face summaries.
    rays : InwardRays or None
        The rays of the measurement; None if it was made by pairs.
    thinnest_wall : Witness or None
        The thinnest parallel wall that covers `STATED_FLOOR` of the surface (see `thinnest_walls`).
    regions : WallRegions
    thin_samples : ndarray of shape (k,), int64, or None
        The `thinnest_walls` of the field.
    slanted_error : float
        How far ``min_nonparallel`` may be off because the search for it was ended, in diagonals.
    places : ThinPlaces
        The walls between pairs of faces, at any angle.
    thinnest : ThinnestPlace or None
        The thinnest of all of these.
    equal_faces : ndarray of shape (f,), int64, or None
        For each face, the first one equal to it; see `equal_faces`.
    balls_at_faces : ndarray of shape (f,), mm, or None
        The median of each face: local thickness, or thickness across where that is less; nan where it is not known.
    """

    descriptors: Descriptors
    field: ThicknessField
    rays: Optional[InwardRays] = None
    thinnest_wall: Optional[Witness] = None
    regions: WallRegions = WallRegions()
    thin_samples: Optional[np.ndarray] = None
    slanted_error: float = 0.0
    places: ThinPlaces = ThinPlaces()
    thinnest: Optional[ThinnestPlace] = None
    equal_faces: Optional[np.ndarray] = None
    balls_at_faces: Optional[np.ndarray] = None

    def __repr__(self):
        # The arrays are left out because they would fill a console.
        return f"Measurement(thinnest_mm={self.thinnest_mm}, box_mm={self.box_mm}, volume_mm3={self.volume_mm3})"

    def with_thinnest_wall(self, wall):
        """The same measurement with another `Witness` of the thinnest parallel wall, such as that of the exact shape."""
        return self._with_regions(with_thinnest(self.regions, wall), thinnest_wall=wall)

    def with_thinnest_place(self, confirmed=None, near=None):
        """The same measurement with its thinnest place; `confirmed` and `near` as of `thinnest_place`."""
        thinnest, places = thinnest_place(self.thinnest_wall, self.places, confirmed, self.equal_faces, near)
        mesh = self.field.mesh
        regions = self.regions if thinnest is None else with_thinnest_taper(
            self.regions, thinnest, np.bincount(mesh.face_of_triangle, mesh.areas))
        return self._with_regions(regions, thinnest=thinnest, places=places)

    def _with_regions(self, regions, **changes):
        mesh, known = self.field.mesh, self.descriptors
        counts = {**regions.counts, "ridge_ratio": _ridge_ratio(
            regions.listed, float(known.box.dimensions[1]), np.bincount(mesh.face_of_triangle, mesh.areas))}
        return replace(self, regions=regions, descriptors=replace(known, regions=counts), **changes)

    @property
    def thinnest_mm(self):
        """float or None: thickness of the thinnest wall, at any angle; see `thin_places`."""
        return self.wall_range[0]

    @property
    def volume_mm3(self):
        """float or None: None where the surface is not watertight."""
        return self.descriptors.volume

    @property
    def area_mm2(self):
        """float: area of the surface."""
        return self.descriptors.area

    @property
    def box_mm(self):
        """tuple of float: sides of the bounding box, longest first."""
        return tuple(map(float, self.descriptors.box.dimensions))

    @property
    def is_watertight(self):
        """Whether the surface bounds a volume."""
        return self.field.mesh.watertight

    @property
    def warnings(self):
        """tuple of str: defects of the triangles, a sentence each."""
        return self.field.mesh.warnings

    def value(self, quantity):
        """Value of a quantity, such as ``V/VBB``, ``d2_d3`` or ``F[0;0.25]``; docs/info-file.md lists them.

        Returns a float or None: None where it could not be measured. Raises ThinPartError, kind ``usage`` if there is no
        such quantity.
        """
        return self.descriptors.named_value(quantity)

    def faces(self, thinner_than=None):
        """Summarise the faces, in the order of their numbers: list of FaceThickness.

        For triangles that were given without faces, they are smooth patches of the surface.

        Parameters
        ----------
        thinner_than : float, mm, optional
            Only faces with a wall thinner than this; ``thin_share`` is the share of their area over thinner walls.
        """
        faces = face_thicknesses(self.field, thinner_than or 0.0, self.thinnest_wall, self.places, self.thinnest)
        return faces if thinner_than is None else [
            face for face in faces if face.minimum is not None and face.minimum < thinner_than]

    @cached_property
    def wall_range(self):
        """Thinnest wall of all, and median by area and greatest distance of parallel walls, mm, or None."""
        thinnest = None if self.thinnest is None else self.thinnest.witness.distance
        walls = self.field.distance[self.field.parallel]
        if not len(walls):
            return thinnest, None, None
        order = np.argsort(walls, kind="stable")
        cumulative = np.cumsum(self.field.area[self.field.parallel][order])
        middle = order[np.searchsorted(cumulative, 0.5 * cumulative[-1])]
        least = 0.0 if thinnest is None else thinnest
        return thinnest, max(float(walls[middle]), least), max(float(walls[order[-1]]), least)


def measure(mesh, settings, report=None, is_fine_enough=None, is_near_enough=None):
    """Measure a part: Measurement, or None where the mesh is not fine enough.

    Raises MeshError, kind ``zero_volume`` if a closed surface encloses nothing.

    Parameters
    ----------
    mesh : SurfaceMesh
    settings : AnalysisSettings
    report : callable, optional
        Called with the fraction done; may raise to stop.
    is_fine_enough : callable, optional
        Called with the `Descriptors` that are known once the thickness is, the `ThicknessField` and the samples of the
        thinnest walls in it. Where it returns False, the mesh will give way to a finer one, and nothing more is measured.
    is_near_enough : callable, optional
        Called with the `Descriptors` that samples give, among them ``min_nonparallel`` with its error. Where it returns
        True, the least distance of slanted walls is not searched for.
    """
    report_progress(report, 0.0)
    enclosed = volume(mesh)
    box = _box(mesh, settings.box, portion(report, 0.0, BOX_DONE))
    rays = None
    if settings.measure == "pairs":
        pairs_report = portion(report, BOX_DONE, 1.0)
        field, shares = measure_pairs(mesh, centroid_samples(mesh), box.diagonal, pairs_report)
    else:
        report_progress(report, BOX_DONE)
        rays = InwardRays(mesh)
        report_progress(report, TREE_DONE)
        samples = surface_samples(mesh, settings.minimum_samples)
        field = measure_rays(mesh, samples, portion(report, TREE_DONE, RAYS_DONE), rays)
        shares = distribution(field, box.diagonal, float(box.dimensions[1]))
    thinnest = thinnest_walls(field)
    wall = witness_of(field, thinnest[0]) if len(thinnest) else None
    known = Descriptors(enclosed, area(mesh), box, shares, None)
    if is_fine_enough is not None and not is_fine_enough(known, field, thinnest):
        return None
    if settings.measure == "pairs":
        least = LeastSlanted(shares.nonparallel_minimum(STATED_FLOOR, *STATED_ANGLES))
    else:
        least = sampled_minimum(field, box.diagonal)
        if is_near_enough is None or least.distance is None or not is_near_enough(_with_least(known, least)):
            least = nonparallel_minimum(mesh, rays, field, box.diagonal, portion(report, RAYS_DONE, 1.0))
    local = beneath = balls_at_faces = None
    if rays is not None and box.dimensions[2] > 0.0:  # a flat open surface has no inside
        balls, counted = local_thickness(mesh, field, rays, float(box.dimensions[2])), field.area > 0.0
        local = local_distribution(balls, field.area[counted], float(box.dimensions[1]))
        beneath = _median_of_faces(mesh, field.face[counted], balls, field.area[counted])
        # The ball of a body reaches over low threads and teeth on it: these are no thicker than they are across.
        across = np.where(field.parallel | field.nonparallel, field.distance, np.inf)[counted]
        balls_at_faces = _median_of_faces(mesh, field.face[counted], np.minimum(balls, across), field.area[counted])
    report_progress(report, 1.0)
    regions = wall_regions(field, enclosed, wall)
    descriptors = replace(known, min_nonparallel=least.distance, plate_share=regions.plate_share, local=local)
    places = ThinPlaces()
    if rays is not None and box.dimensions[2] > 0.0:
        places = thin_places(field, rays, float(box.dimensions[1]))
    return Measurement(descriptors, field, rays, wall, regions, thinnest, least.error, places,
                       equal_faces=equal_faces(mesh, beneath), balls_at_faces=balls_at_faces).with_thinnest_place()


def _median_of_faces(mesh, face, thickness, area):
    """Median by area of each face, mm; nan where it has no sample: ndarray of shape (f,)."""
    order = np.lexsort([thickness, face])
    face, thickness, covered = face[order], thickness[order], np.cumsum(area[order])
    faces, start = np.unique(face, return_index=True)
    end = np.append(start[1:], len(face)) - 1
    before = np.where(start > 0, covered[start - 1], 0.0)
    found = np.full(int(mesh.face_of_triangle.max()) + 1, np.nan)
    found[faces] = thickness[np.minimum(np.searchsorted(covered, 0.5 * (before + covered[end])), end)]
    return found


def _ridge_ratio(regions, width, face_areas):
    sizes = [WallSize.of_region(region, face_areas) for region in regions]
    return ridge_ratio(sizes, [region.volume_share for region in regions], [region.faces for region in regions], width,
                       float(np.sum(face_areas)))


def _with_least(known, least):
    return replace(known, min_nonparallel=least.distance, precision=replace(EXACT, slanted=least.error))


def _box(mesh, kind, report=None):
    if kind == "principal":
        return principal_box(mesh.vertices)
    flat = dominant_directions(mesh.normals, mesh.areas, FLAT_DIRECTIONS)
    box = minimal_box(mesh.vertices, flat, report)
    return box_of_round_sides(mesh, box) if mesh.has_faces else box

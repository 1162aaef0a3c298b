# SPDX-License-Identifier: LGPL-2.1-or-later
"""The thickness map of a part, as it is drawn: small facets, each with its own value."""

from dataclasses import dataclass, field
from functools import cached_property
from typing import Optional

import numpy as np

from ..analysis_settings import LOCAL, RAY, SPHERE
from ..columns import corners_of, cross, dot
from ..mesh.sampling import smooth_samples
from ..progress import portion, report_progress
from ..rays.inward_rays import InwardRays
from ..thickness.inscribed_balls import inscribed_balls
from ..thickness.local_thickness import local_thickness
from ..walls.walls import NONPARALLEL_BELOW
from .facet_refinement import cut_sides, side_keys, side_lengths, small_facets, too_many
from .jump_lines import cut_along_jumps
from .map_outline import outline

JUMP = 1.15
"""Neighbours on which balls differ by more than this ratio are cut further."""

JUMP_ROUNDS = 2
"""How many times such facets are halved."""

CUT_DONE = 0.05
"""Progress when the facets are small enough."""

WALLS_DONE = 0.8
"""The share of the rest after which the walls across are known, where balls follow."""


@dataclass(frozen=True)
class ThicknessMap:
    """Thickness under every facet of a part.

    Attributes
    ----------
    points : ndarray of shape (v, 3), float32, mm
        Relative to `origin`.
    facets : ndarray of shape (m, 3), int32
        Counter-clockwise seen from outside.
    thickness : ndarray of shape (m,), float32, mm
        From the middle of the facet along the inward normal to the opposite side, or the diameter of the largest ball
        inside that touches the surface there, or that reaches it; nan where nothing was measured: no wall, or one at more
        than 60 degrees.
    opposite : ndarray of shape (m,), int32
        A facet in the plane of the triangle that the ray hits; -1 for none, as for all balls.
    face : ndarray of shape (m,), int32
        B-Rep face, from 0.
    origin : ndarray of shape (3,), float64, mm
    measure : str
        One of `SHOWN_MEASURES`.
    corner_thickness : ndarray of shape (m, 3), float32, mm
        At the corners of each facet, on which the thickness changes linearly; across the line between two facets it may
        jump. nan where nothing was measured.
    balls : ndarray of shape (m,), float32, mm, or None
        Beside walls across, the local thickness: the diameter of the largest ball inside that reaches the middle of each
        facet, or the thickness across where that is less. None for maps of balls, and where balls were not looked for.
    """

    points: np.ndarray
    facets: np.ndarray
    thickness: np.ndarray
    opposite: np.ndarray
    face: np.ndarray
    origin: np.ndarray = field(default_factory=lambda: np.zeros(3))
    measure: str = RAY
    corner_thickness: Optional[np.ndarray] = None
    balls: Optional[np.ndarray] = None

    def __post_init__(self):
        if self.corner_thickness is None:
            # One thickness all over each facet, as in maps of earlier versions and of balls.
            object.__setattr__(self, "corner_thickness", np.repeat(self.thickness[:, None], 3, axis=1))

    @property
    def count(self):
        """Number of facets."""
        return len(self.facets)

    @cached_property
    def corners(self):
        """ndarray of shape (m, 3, 3), float64, mm."""
        return self.points.astype(np.float64)[self.facets]

    @cached_property
    def _area_vectors(self):
        """ndarray of shape (3, m), mm2: outward normals whose lengths are the areas of the facets."""
        corners = corners_of(np.ascontiguousarray(self.points.T, dtype=np.float64), self.facets)
        return 0.5 * cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])

    @cached_property
    def areas(self):
        """ndarray of shape (m,), mm2."""
        return np.sqrt(dot(self._area_vectors, self._area_vectors))

    @cached_property
    def normals(self):
        """ndarray of shape (m, 3): unit outward normals."""
        return (self._area_vectors / np.maximum(self.areas, np.finfo(float).tiny)).T

    @cached_property
    def outline(self):
        """ndarray of shape (k, 2), int32: rows of `points`, the ends of each line of the outline."""
        return outline(self)

    @cached_property
    def measured(self):
        """ndarray of shape (m,), bool."""
        return np.isfinite(self.thickness)

    @cached_property
    def ends(self):
        """(float, float) or None: least and greatest thickness, mm; None where nothing was measured."""
        if not self.measured.any():
            return None
        return float(np.nanmin(self.thickness)), float(np.nanmax(self.thickness))

    def normal(self, facet):
        """ndarray of shape (3,): unit outward normal of one facet."""
        return self.normals[facet]

    def wall_at(self, facet, point):
        """Measure the wall under any point of a facet, to the plane of the facet that its middle sees.

        A ball is that of the middle of the facet. Returns `thickness` (float or None, mm; None where nothing was measured)
        and `opposite` (ndarray of shape (3,), mm, or None; in the coordinates of the document; the far end of the ball's
        diameter).

        Parameters
        ----------
        facet : int
        point : array_like of shape (3,), mm
            In the coordinates of the document.
        """
        if not np.isfinite(self.thickness[facet]):
            return None, None
        inward = -self.normal(facet)
        point = np.asarray(point, dtype=np.float64)
        distance = float(self.thickness[facet])
        opposite_facet = self.opposite[facet]
        if opposite_facet >= 0:
            plane = self.normal(opposite_facet)
            along = inward @ plane
            if abs(along) > np.cos(NONPARALLEL_BELOW):
                corner = self.points[self.facets[opposite_facet, 0]] + self.origin
                distance = float((corner - point) @ plane / along)
        return distance, point + distance * inward


def thickness_map(measurement, report=None, by=RAY, has_balls=False):
    """Compute the thickness of a measured part, facet by facet: ThicknessMap.

    Large triangles are cut until their sides are about as long as those of `FACETS` equal facets. Where the thickness jumps
    they are cut along the line of the jump (`jump_lines`), so that a web under a plate has a sharp outline. The diameters of
    balls, which fall off towards sharp edges, are one for each facet.

    Parameters
    ----------
    measurement : Measurement
    report : callable, optional
        Called with the fraction done; may raise to stop.
    by : str
        One of `SHOWN_MEASURES`.
    has_balls : bool
        Whether a map of walls across is to have `balls` too, which tell what is too thick.
    """
    mesh = measurement.field.mesh
    rays = measurement.rays or InwardRays(mesh)
    report_progress(report, 0.0)
    points, facets, parent, size, most = small_facets(mesh)
    report_progress(report, CUT_DONE)
    made = portion(report, CUT_DONE, 1.0)
    if by == RAY:
        # A flat open surface has no inside.
        diameters = _reaching(measurement, rays) if has_balls and measurement.box_mm[2] > 0.0 else None
        found = _map_of_walls(mesh, rays, points, facets, parent, diameters, made)
    else:
        found = _map_of_balls(_DIAMETERS[by](measurement, rays), by, mesh, points, facets, parent, size, most, made)
    report_progress(report, 1.0)
    return found


def _map_of_walls(mesh, rays, points, facets, parent, diameters, report):
    done = 1.0 if diameters is None else WALLS_DONE
    cut = cut_along_jumps(mesh, rays, points, facets, parent, portion(report, 0.0, done))
    known = np.isfinite(cut.corner_thickness)
    mean = np.divide(np.where(known, cut.corner_thickness, 0.0).sum(axis=1), known.sum(axis=1),
                     out=np.full(len(known), np.nan), where=known.any(axis=1))
    at_corners = np.where(known, cut.corner_thickness, mean[:, None])
    balls = None if diameters is None else np.fmin(diameters(
        cut.points[cut.facets].mean(axis=1), cut.parent, portion(report, done, 1.0)), mean).astype(np.float32)
    return _assembled(mesh, cut.points, cut.facets, cut.parent, mean, np.where(np.isfinite(mean), cut.opposite, -1), RAY,
                      at_corners, balls)


def _map_of_balls(diameters, by, mesh, points, facets, parent, size, most, report):
    thickness, unknown = np.full(len(facets), np.nan), np.ones(len(facets), dtype=bool)
    for step in range(JUMP_ROUNDS + 1):
        new = np.flatnonzero(unknown)
        if len(new):
            thickness[new] = diameters(points[facets[new]].mean(axis=1), parent[new],
                                       portion(report, step / (JUMP_ROUNDS + 1), (step + 1) / (JUMP_ROUNDS + 1)))
        if step == JUMP_ROUNDS:
            break
        sides = side_lengths(points, facets) > 0.5 * size / 2 ** step
        cut = sides & _beside_jump(facets, len(points), thickness)[:, None]
        if not cut.any() or too_many(facets, cut, most):
            break
        points, facets, pieces = cut_sides(points, facets, cut)
        parent = parent[pieces]
        unknown = np.bincount(pieces, minlength=len(thickness))[pieces] > 1
        thickness = thickness[pieces]
    return _assembled(mesh, points, facets, parent, thickness, np.full(len(facets), -1), by)


def _touching(measurement, rays):
    """The diameters of the largest balls that touch points of triangles, as a function."""
    mesh = measurement.field.mesh
    return lambda points, parent, report: inscribed_balls(mesh, _samples(mesh, points, parent), rays, report)


def _reaching(measurement, rays):
    """The local thickness at points, as such a function."""
    field, most = measurement.field, measurement.box_mm[2]
    return lambda points, parent, report: local_thickness(
        field.mesh, field, rays, most, _samples(field.mesh, points, parent), report)


def _samples(mesh, points, parent):
    return smooth_samples(mesh, points, parent, np.zeros(len(points)))


_DIAMETERS = {SPHERE: _touching, LOCAL: _reaching}


def _beside_jump(facets, count, thickness):
    """ndarray of shape (m,), bool: facets beside a jump in thickness."""
    key = side_keys(facets, count).ravel()
    order = np.argsort(key, kind="stable")
    shared = np.flatnonzero(key[order[1:]] == key[order[:-1]])
    one, other = order[shared] // 3, order[shared + 1] // 3
    low = np.minimum(thickness[one], thickness[other])
    high = np.maximum(thickness[one], thickness[other])
    jump = np.isfinite(low) & (high > JUMP * low)
    beside = np.zeros(len(facets), dtype=bool)
    beside[one[jump]] = beside[other[jump]] = True
    return beside


def _assembled(mesh, points, facets, parent, thickness, opposite, by, corner_thickness=None, balls=None):
    facet_of_triangle = np.full(mesh.count, -1, dtype=np.int64)
    facet_of_triangle[parent[::-1]] = np.arange(len(parent))[::-1]
    opposite_facet = np.where(opposite >= 0, facet_of_triangle[opposite], -1)
    return ThicknessMap(
        points.astype(np.float32), facets.astype(np.int32),
        np.where(np.isfinite(thickness), thickness, np.nan).astype(np.float32),
        opposite_facet.astype(np.int32), mesh.face_of_triangle[parent].astype(np.int32), mesh.origin, by,
        None if corner_thickness is None else corner_thickness.astype(np.float32), balls,
    )

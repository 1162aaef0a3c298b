"""The thickness of a part as it is shown: small facets, each with its own value."""

from dataclasses import dataclass, field, replace
from functools import cached_property

import numpy as np

from .columns import corners_of, cross, dot
from .facet_refinement import cut_sides, side_keys, side_lengths
from .inward_rays import InwardRays
from .map_outline import outline
from .progress import portion, tell
from .ray_casting import INNER
from .sampling import SurfaceSamples
from .thickness import NONPARALLEL_BELOW, wedge_angles
from .tolerances import TOLERANCES

FACETS = 20_000
"""Equal facets whose sides say how fine the surface of a part is cut."""

LONGEST = 1.6
"""Sides longer than this many of those are cut, so that none is left much shorter than one."""

MOST_FACETS = 60_000
"""Cutting is coarser where it would make more than this. A finer surface mesh gets as many more at most: its
plane faces may have large triangles all the same."""

JUMP = 1.15
"""Ratio of the values of two neighbours from which the border between them is drawn finer."""

JUMP_ROUNDS = 2
"""Times that facets at such a border are halved."""


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
        To the opposite side along the inward normal from the middle of the facet; nan where nothing was
        measured: no wall, or one at more than 60 degrees.
    opposite : ndarray of shape (m,), int32
        A facet in the plane of the triangle that is met; -1 for none.
    face : ndarray of shape (m,), int32
        B-Rep face, from 0.
    origin : ndarray of shape (3,), float64, mm
    """

    points: np.ndarray
    facets: np.ndarray
    thickness: np.ndarray
    opposite: np.ndarray
    face: np.ndarray
    origin: np.ndarray = field(default_factory=lambda: np.zeros(3))

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
        """ndarray of shape (3, m): outward normals as long as the facets are large."""
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
        """ndarray of shape (k, 2), int32: rows of `points` between which the lines of the part run."""
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
        """The wall under any point of a facet, to the plane of what its middle sees.

        Parameters
        ----------
        facet : int
        point : array_like of shape (3,), mm
            In the coordinates of the document.

        Returns
        -------
        thickness : float or None, mm
            None where nothing was measured.
        opposite : ndarray of shape (3,), mm, or None
            In the coordinates of the document.
        """
        if not np.isfinite(self.thickness[facet]):
            return None, None
        inward = -self.normal(facet)
        point = np.asarray(point, dtype=np.float64)
        distance = float(self.thickness[facet])
        there = self.opposite[facet]
        if there >= 0:
            plane = self.normal(there)
            along = inward @ plane
            if abs(along) > np.cos(NONPARALLEL_BELOW):
                corner = self.points[self.facets[there, 0]] + self.origin
                distance = float((corner - point) @ plane / along)
        return distance, point + distance * inward


def thickness_map(measurement, report=None):
    """Thickness of a measured part, facet by facet.

    Parameters
    ----------
    measurement : Measurement
    report : callable, optional
        Called with the fraction done; may raise to stop.

    Returns
    -------
    ThicknessMap

    Notes
    -----
    Large triangles are cut until their sides are about as long as those of `FACETS` equal facets; where the
    thickness jumps, twice as fine again, so that a web under a plate has a sharp outline. Triangles that need no
    cutting keep what was measured at their centroid: of a fine surface mesh hardly anything is cast again.
    """
    mesh = measurement.field.mesh
    rays = measurement.rays or InwardRays(mesh)
    points, facets = mesh.vertices, mesh.triangles
    parent = np.arange(mesh.count)
    size = LONGEST * np.sqrt(4.0 / np.sqrt(3.0) * mesh.areas.sum() / FACETS)
    most = max(MOST_FACETS, min(2 * mesh.count, MOST_FACETS + mesh.count))
    tell(report, 0.0)
    while True:
        long = side_lengths(points, facets) > size
        if not long.any():
            break
        if _too_many(facets, long, most):
            size *= 1.5
            continue
        points, facets, pieces = cut_sides(points, facets, long)
        parent = parent[pieces]
    thickness, opposite = _known(measurement, points, facets, parent)
    unknown = np.isnan(thickness)
    for step in range(JUMP_ROUNDS + 1):
        new = np.flatnonzero(unknown)
        thickness[new], opposite[new] = _cast(
            mesh, rays, points, facets[new], parent[new],
            portion(report, step / (JUMP_ROUNDS + 1), (step + 1) / (JUMP_ROUNDS + 1)))
        if step == JUMP_ROUNDS:
            break
        sides = side_lengths(points, facets) > 0.5 * size / 2 ** step
        cut = sides & _beside_jump(facets, len(points), thickness)[:, None]
        if not cut.any() or _too_many(facets, cut, most):
            break
        points, facets, pieces = cut_sides(points, facets, cut)
        parent = parent[pieces]
        whole = np.bincount(pieces, minlength=len(thickness))[pieces] == 1
        thickness, opposite = thickness[pieces], opposite[pieces]
        unknown = ~whole
    tell(report, 1.0)
    return _shown(mesh, points, facets, parent, thickness, opposite)


def _too_many(facets, cut, most):
    # Each side that is cut makes about one facet more on either side of it, and is counted on both.
    return len(facets) + cut.sum() > most


def _known(measurement, points, facets, parent):
    """What was measured at the middle of facets that are whole triangles; nan elsewhere, inf for no wall."""
    thickness, opposite = np.full(len(facets), np.nan), np.full(len(facets), -1, dtype=np.int64)
    measured = measurement.field
    if measurement.rays is None:
        return thickness, opposite  # by pairs, which see through what lies between
    mesh = measured.mesh
    first = np.full(mesh.count, -1, dtype=np.int64)
    sample = np.flatnonzero(measured.samples.area > 0.0)[::-1]
    first[measured.samples.triangle[sample]] = sample
    # Pieces follow the facets that were not cut.
    whole = np.flatnonzero((np.bincount(parent, minlength=mesh.count)[parent] == 1) & (first[parent] >= 0))
    rows = first[parent[whole]]
    off = measured.samples.points[rows] - points[facets[whole]].mean(axis=1)
    central = np.abs(off).max(axis=1, initial=0.0) <= TOLERANCES.weld * mesh.extent
    whole, rows = whole[central], rows[central]
    seen = measured.wedge_angle[rows] < NONPARALLEL_BELOW - TOLERANCES.angle
    thickness[whole] = np.where(seen, measured.distance[rows], np.inf)
    opposite[whole] = np.where(seen, measured.opposite[rows], -1)
    return thickness, opposite


def _cast(mesh, rays, points, facets, parent, report):
    if not len(facets):
        return np.empty(0), np.empty(0, dtype=np.int64)
    samples = SurfaceSamples(points[facets].mean(axis=1), parent, np.zeros(len(facets)))
    distance, opposite = rays.first_hits(samples, INNER, report)
    seen = wedge_angles(mesh, samples, distance, opposite) < NONPARALLEL_BELOW - TOLERANCES.angle
    return np.where(seen, distance, np.inf), np.where(seen, opposite, -1)


def _beside_jump(facets, count, thickness):
    """Facets with a neighbour of another thickness, ndarray of shape (m,), bool."""
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


def _shown(mesh, points, facets, parent, thickness, opposite):
    facet_of_triangle = np.full(mesh.count, -1, dtype=np.int64)
    facet_of_triangle[parent[::-1]] = np.arange(len(parent))[::-1]
    there = np.where(opposite >= 0, facet_of_triangle[opposite], -1)
    return ThicknessMap(
        points.astype(np.float32), facets.astype(np.int32),
        np.where(np.isfinite(thickness), thickness, np.nan).astype(np.float32),
        there.astype(np.int32), mesh.face_of_triangle[parent].astype(np.int32), mesh.origin,
    )


def at_place(shown, matrix):
    """A map carried to another place.

    Parameters
    ----------
    shown : ThicknessMap
    matrix : ndarray of shape (4, 4)
        A rotation and a translation in mm.
    """
    points = shown.points @ matrix[:3, :3].T
    return replace(shown, points=points.astype(np.float32),
                   origin=matrix[:3, :3] @ shown.origin + matrix[:3, 3])

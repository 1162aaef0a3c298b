# SPDX-License-Identifier: LGPL-2.1-or-later
"""Places of a part that ask for small elements: walls, curves, narrow faces, short edges."""

from dataclasses import dataclass, replace

import numpy as np
from scipy.spatial import cKDTree

from ..rays.inward_rays import InwardRays
from ..thickness.local_thickness import local_thickness
from ..walls.walls import NONPARALLEL_BELOW
from .error_law import size_for_error, without_thinnest_places
from .mesh_hazards import greatest_curvature
from .size_field import SizeField
from .sizing_settings import LEAST_SHARE

NO_REGION = -1
"""Of sources that are no wall of a listed region."""

CHORD_SHARE = 0.25
"""Greatest chord error of an element by the thickness of the wall that it is on: two sides that are each off by less
than half of it cannot cross."""

SPACING = 0.8
"""Greatest distance from the nearest sample by the root of the area that each stands for: 0.71 of a square grid."""

OF_REGION = 1.5
"""A thin place of a face belongs to the region of that face whose median thickness is within this factor, or to none."""

NARROW = 0.1
"""Share of the extent below which a face may be narrow for some size."""

LEAST_DETAIL = 0.2
"""Share of the size for an error aimed at to which a curve, a narrow face or a short edge makes elements smaller at most."""

_MOST_ON_SIDE = 64


@dataclass(frozen=True)
class SizeSources:
    """Points with the element size that each one asks for.

    Attributes
    ----------
    points : ndarray of shape (n, 3), mm
        In the coordinates of the document.
    sizes : ndarray of shape (n,), mm
    region : ndarray of shape (n,), int64
        Number of the listed wall region, or `NO_REGION`.
    radius : ndarray of shape (n,), mm
        Around each point the same is asked for: a sample stands for some surface.
    """

    points: np.ndarray
    sizes: np.ndarray
    region: np.ndarray
    radius: np.ndarray

    @property
    def count(self):
        """Number of points."""
        return len(self.sizes)

    def scaled(self, factor, least=0.0):
        """Sources whose sizes are multiplied, but stay at least as large as a length, mm."""
        return replace(self, sizes=np.maximum(self.sizes * factor, least))

    def below(self, size):
        """Those that ask for less than a size, mm."""
        chosen = self.sizes < size
        return SizeSources(*(getattr(self, name)[chosen] for name in self.__dataclass_fields__))

    def at_most(self, size):
        """All of them, which ask for no more than a size, mm."""
        return replace(self, sizes=np.minimum(self.sizes, size))

    def with_region_sizes(self, sizes):
        """Sources of which some wall regions have other sizes: SizeSources.

        Within a region, thinner places keep their smaller sizes.

        Parameters
        ----------
        sizes : dict
            Median size, mm, by number of the region; None for a region that asks for nothing.
        """
        factor, asks = np.ones(self.count), np.ones(self.count, dtype=bool)
        for number, size in sizes.items():
            own = self.region == number
            if size is None:
                asks[own] = False
            elif own.any():
                factor[own] = size / np.median(self.sizes[own])
        found = replace(self, sizes=self.sizes * factor)
        return SizeSources(*(getattr(found, name)[asks] for name in self.__dataclass_fields__))

    def of_regions(self, numbers):
        """Those of some wall regions, by their numbers."""
        chosen = np.isin(self.region, list(numbers))
        return SizeSources(*(getattr(self, name)[chosen] for name in self.__dataclass_fields__))

    def followed_by(self, other):
        """These and other sources."""
        return SizeSources(*(np.concatenate([getattr(each, name) for each in (self, other)])
                             for name in self.__dataclass_fields__))


def size_sources(measurement, thin_limit, settings, has_details=True):
    """Find the sources of a part: SizeSources.

    For an error that is aimed at, sizes follow from the local thickness everywhere: see `error_law`. With layers, they are
    those of thin walls. A wall of thickness t has the size t / divisions, and no more than the chord of a curved side that
    is a quarter of the wall off: sqrt(2 R t) at a radius of curvature R. Across a taper, the thickness is that between its
    sides, not along the ray.
    A narrow face asks for elements as small as it is wide, an edge for as small as it is long: else the mesher makes needles
    of them, or facets that cross. Beside sizes for an error, they and curves ask for no less than `LEAST_DETAIL` of the size
    there.

    Parameters
    ----------
    measurement : Measurement
    thin_limit : float, mm
        Walls that are thinner are thin.
    settings : SizingSettings
    has_details : bool
        Whether narrow faces and short edges ask for sizes too, and beside sizes for an error curves.
    """
    diagonal = measurement.descriptors.box.diagonal
    walls = _for_error(measurement, settings.error, has_details) if settings.is_by_error else _of_walls(
        measurement, thin_limit, settings.divisions)
    if not walls.count:
        return walls
    mesh, least = measurement.field.mesh, LEAST_SHARE * diagonal
    if not has_details:
        return walls.scaled(1.0, least)
    details = _of_narrow_faces(mesh).followed_by(_of_short_edges(mesh))
    if settings.is_by_error:
        there = SizeField(walls, settings.global_size(diagonal), settings.growth).at(details.points)
        details = replace(details, sizes=np.maximum(details.sizes, LEAST_DETAIL * there))
    return walls.followed_by(details).scaled(1.0, least)


def _for_error(measurement, error, follows_curves):
    """Sizes from the local thickness, and from curves if wanted, at all samples and half-way through the wall under them."""
    field = measurement.field
    counted = np.flatnonzero(field.area > 0.0)
    box = measurement.descriptors.box
    rays = measurement.rays or InwardRays(field.mesh)
    thickness = local_thickness(field.mesh, field, rays, float(box.dimensions[2]))
    size = without_thinnest_places(size_for_error(thickness, box.diagonal, error), field.area[counted])
    if follows_curves:
        curvature = greatest_curvature(field.mesh)[field.samples.triangle[counted]]
        size /= np.clip(curvature * size, 1.0, 1.0 / LEAST_DETAIL)  # as long as the radius, six around a circle
    region = regions_of(measurement.regions.listed, field.face[counted], field.distance[counted])
    return _through(field, counted, np.minimum(field.distance[counted], thickness), size, region)


def _of_walls(measurement, thin_limit, divisions):
    field = measurement.field
    thin = np.flatnonzero((field.area > 0.0) & (field.distance < thin_limit) & (field.wedge_angle < NONPARALLEL_BELOW))
    if not len(thin):
        return places(np.empty((0, 3)), np.empty(0))
    thickness = field.distance[thin] * np.cos(field.wedge_angle[thin])
    # The edge of a taper has no thickness of its own: no size follows from less than the thinnest wall that counts.
    known = measurement.descriptors
    across = known.min_nonparallel and known.min_nonparallel * known.box.diagonal
    wall = None if measurement.thinnest_wall is None else measurement.thinnest_wall.distance
    least = min((value for value in (wall, across) if value), default=0.0)
    sizes = np.maximum(thickness, least) / divisions
    curvature = greatest_curvature(field.mesh)[field.samples.triangle[thin]]
    squared = np.divide(8.0 * CHORD_SHARE * thickness, curvature, out=np.full(len(thin), np.inf), where=curvature > 0.0)
    sizes = np.minimum(sizes, np.sqrt(squared))
    region = regions_of(measurement.regions.listed, field.face[thin], thickness)
    return _through(field, thin, field.distance[thin], sizes, region)


def _through(field, samples, depth, sizes, region):
    """Sources at samples and half-way through the wall, or else the size has grown there before the other side is near."""
    here = field.samples.points[samples] + field.mesh.origin
    middle = here - 0.5 * depth[:, None] * field.normals[samples]
    radius = SPACING * np.sqrt(field.area[samples])
    return SizeSources(np.concatenate([here, middle]), np.tile(sizes, 2), np.tile(region, 2), np.tile(radius, 2))


def regions_of(regions, faces, thickness):
    """Which wall region places belong to: of those with their face, the one most like them.

    Returns an ndarray of shape (n,), int64: number of the region, or `NO_REGION`.

    Parameters
    ----------
    regions : sequence of WallRegion
    faces : ndarray of shape (n,), int64
    thickness : ndarray of shape (n,), mm
    """
    best, region = np.full(len(faces), np.log(OF_REGION)), np.full(len(faces), NO_REGION, dtype=np.int64)
    for number, each in enumerate(regions):
        away = np.abs(np.log(np.maximum(thickness / each.median, np.finfo(float).tiny)))
        away[(thickness >= each.least) & (thickness <= each.median)] = 0.0
        own = np.isin(faces, each.faces) & (away < best)
        best[own], region[own] = away[own], number
    return region


def _of_narrow_faces(mesh):
    """Along the outline of each face, its mean width: its area by half of its outline."""
    first, second = mesh.shared_sides
    apart = mesh.face_of_triangle[first // 3] != mesh.face_of_triangle[second // 3]
    sides = np.concatenate([first[apart], second[apart]])
    start, end = mesh.vertices[mesh.triangles.ravel()[sides]], mesh.vertices[_next_corner(mesh.triangles, sides)]
    length = np.linalg.norm(end - start, axis=1)
    face = mesh.face_of_triangle[sides // 3]
    count = int(mesh.face_of_triangle.max()) + 1
    outline = np.bincount(face, length, count)
    area = np.bincount(mesh.face_of_triangle, mesh.areas, count)
    width = np.divide(2.0 * area, outline, out=np.full(count, np.inf), where=outline > 0.0)[face]
    narrow = np.flatnonzero(width < NARROW * mesh.extent)
    pieces = np.clip(np.ceil(length[narrow] / width[narrow]), 1, _MOST_ON_SIDE).astype(np.int64)
    row = np.repeat(narrow, pieces)
    step = (np.arange(len(row)) - np.repeat(np.cumsum(pieces) - pieces, pieces) + 0.5) / np.repeat(pieces, pieces)
    points = start[row] + step[:, None] * (end - start)[row]
    return places(points + mesh.origin, width[row])


def _next_corner(triangles, sides):
    return triangles[sides // 3, (sides % 3 + 1) % 3]


def _of_short_edges(mesh):
    """At each corner of the part, where three faces meet or more, the distance to the nearest other corner."""
    vertex, face = mesh.triangles.ravel(), np.repeat(mesh.face_of_triangle, 3)
    pairs = np.unique(np.column_stack([vertex, face]), axis=0)
    corner = np.flatnonzero(np.bincount(pairs[:, 0], minlength=len(mesh.vertices)) >= 3)
    if len(corner) < 2:
        return places(np.empty((0, 3)), np.empty(0))
    points = mesh.vertices[corner]
    distance = cKDTree(points).query(points, k=2)[0][:, 1]
    return places(points + mesh.origin, distance)


def places(points, sizes):
    """Sources that are points of no region.

    Parameters
    ----------
    points : ndarray of shape (n, 3), mm
    sizes : ndarray of shape (n,), mm
    """
    return SizeSources(points, sizes, np.full(len(sizes), NO_REGION, dtype=np.int64), np.zeros(len(sizes)))

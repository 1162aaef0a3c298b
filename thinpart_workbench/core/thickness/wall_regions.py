# SPDX-License-Identifier: LGPL-2.1-or-later
"""Wall regions: places whose walls are alike in thickness and connected along the surface or through the wall."""

from dataclasses import dataclass, replace
from typing import Optional

import numpy as np
from scipy.sparse.csgraph import connected_components

from ..descriptors.descriptor_table import STATED_FLOOR
from ..descriptors.equal_walls import WallSize, are_equal
from ..descriptors.region_kinds import REGION_KINDS, TUBE
from ..descriptors.wall_kinds import EDGE, PARALLEL
from ..mesh.sampling import even_samples
from ..tolerances import TOLERANCES
from ..walls.face_thickness import Witness, witness_of
from ..walls.walls import is_parallel
from .listed_regions import COUNTED_SHARE, FEWEST_POINTS, listed_regions
from .plate_likeness import PROBED, plate_likeness
from .region_shape import area_median, region_shape
from .wall_graph import wall_links, wall_points

LEAST_EXTENT = 0.02
"""Share of a region over which walls lie that give its least thickness, where that is more than `STATED_FLOOR`."""

PLATE_FROM_WIDTH = (1.5, 1.9, 3.2, 4.8)
"""Developed width by thickness: up to the first, no place of a region is a plate, from the last on, every place is; between
the middle two, each place is looked at, and from one to the next it passes over. 1.6 of a round bar, a ring or a coil, 2 of
a square bar, 2.4 of a washer M10."""

WIDTH_WITHIN = 1.5
"""Factor within which the developed width of a region is certain."""

_CERTAIN = 0.05
"""Share by which the median of a region may be under the thinnest place by chance."""

OF_FACE, OF_REGION = 0.1, 0.1
"""A face belongs to a region that has this share of the face, or of which the face has this share."""


@dataclass(frozen=True)
class WallRegion:
    """A connected wall.

    Attributes
    ----------
    kind : str
        One of `REGION_KINDS`.
    area : float, mm2
        Of both of its sides, without its rims.
    least, median : float, mm
        Thickness: the least that has some extent, the median by area.
    length, width : float, mm
        See `region_shape.RegionShape`.
    volume_share : float or None
        Share of the part's volume; None where that is not known.
    place : ndarray of shape (3,), mm
        A point of its surface, near its middle, in the coordinates of the document.
    faces : tuple of int
        Indices of B-Rep faces, from 0.
    witness : Witness
        Where it is `least` thick.
    is_slanted : bool
        Whether most of it lies over walls at more than 10 degrees.
    """

    kind: str
    area: float
    least: float
    median: float
    length: float
    width: float
    volume_share: Optional[float]
    place: np.ndarray
    faces: tuple
    witness: Witness
    is_slanted: bool = False


@dataclass(frozen=True)
class WallRegions:
    """The regions of a part.

    Attributes
    ----------
    listed : tuple of WallRegion
        The thinnest first: that is where a part breaks, and where a mesh has to be finest.
    others : int
        Number of smaller regions.
    others_share : float
        Share of the surface that they have.
    plate_share : float
        Share of the surface over walls that are plates, tubes and shells among them; see `plate_likeness`.
    plate_share_error : float
        By how much that changes where the widths of the regions are not certain.
    """

    listed: tuple = ()
    others: int = 0
    others_share: float = 0.0
    plate_share: float = 0.0
    plate_share_error: float = 0.0

    @property
    def counts(self):
        """dict: what `Descriptors.regions` has: median of the thinnest region, number of all, and of each kind."""
        kinds = [region.kind for region in self.listed]
        return {"thinnest_mm": min((region.median for region in self.listed), default=None),
                "count": len(self.listed) + self.others, **{kind: kinds.count(kind) for kind in REGION_KINDS}}


def wall_regions(field, enclosed=None, thinnest=None):
    """Find the regions of a part: WallRegions.

    Points that are spread over the surface are linked to their neighbours and to what they see through the wall, where
    the walls are alike in thickness; regions are the connected components of that graph. Triangles play no part, so a
    large one may lie over several walls, and another tessellation has the same regions. Surface under which the wall
    has no thickness of its own, such as the rim of a plate, belongs to no region.

    Parameters
    ----------
    field : ThicknessField
    enclosed : float, mm3, optional
        Volume of the part, where it is known.
    thinnest : Witness, optional
        The thinnest wall of the part: see `with_thinnest`.
    """
    points, certain = wall_points(field)
    if len(points.sample) < FEWEST_POINTS:
        return WallRegions()
    links = wall_links(points)
    count, component = connected_components(links, directed=False)
    area = np.bincount(component, points.area, count)
    surface = float(field.area.sum())
    size = np.bincount(component, certain, count)
    order = np.argsort(component, kind="stable")
    members = np.split(order, np.cumsum(np.bincount(component, minlength=count))[:-1])
    face_areas = np.bincount(field.face, field.area)
    median = np.array([area_median(points.thickness[own], points.area[own]) for own in members])
    exact = np.bincount(field.mesh.face_of_triangle, field.mesh.areas)
    listed = listed_regions(points, component, area, size, median, surface, exact, lambda number: _region(
        field, points, links, members[number], enclosed, surface, face_areas))
    regions = list(listed.values())
    listed = list(listed)
    others = np.setdiff1d(np.flatnonzero((size >= FEWEST_POINTS) & (area >= COUNTED_SHARE * surface)), listed)
    others_share = float(area[others].sum() / surface)
    plates, plates_error = _plate_share(points, component, dict(zip(listed, regions)))
    on_walls = float(points.area.sum()) / surface
    found = WallRegions(_thinnest_first(regions), len(others), others_share, min(plates * on_walls, 1.0),
                        min(plates_error * on_walls, 1.0))
    return with_thinnest(found, thinnest)


def _plate_share(points, component, regions):
    """Share of the walls that are plates, and its error: by the regions where they are clear, else by their places."""
    place = even_samples(points.area, PROBED)
    numbers, own, count = np.unique(component[place], return_inverse=True, return_counts=True)
    widths = np.array([_plate_width(regions.get(number)) for number in numbers])
    is_open = (widths < PLATE_FROM_WIDTH[-1] * WIDTH_WITHIN) & (widths > PLATE_FROM_WIDTH[0] / WIDTH_WITHIN)
    looked_at = np.flatnonzero(is_open[own])
    likeness, unclear = np.zeros((2, PROBED))
    likeness[looked_at], unclear[looked_at] = plate_likeness(points, component, place[looked_at])
    by_place = np.bincount(own, likeness) / count
    by_place_error = np.bincount(own, unclear) / count + np.sqrt(np.bincount(own, (likeness - by_place[own])**2)) / count
    share = _plates_of(widths, by_place)
    varied = [_plates_of(widths * factor, np.clip(by_place + error, 0.0, 1.0))
              for factor in (WIDTH_WITHIN, 1.0, 1.0 / WIDTH_WITHIN) for error in (-by_place_error, by_place_error)]
    # Regions that no place fell upon are less than one of them, all together mostly.
    area = np.bincount(component, points.area)
    weight = area[numbers] / area.sum()
    missed = max(1.0 - float(weight.sum()), 0.0)
    return float(share @ weight), float(np.max(np.abs(varied - share), axis=0) @ weight) + missed


def _plate_width(region):
    """Developed width by thickness of a region, which says whether it is a plate; one without a shape is looked at."""
    if region is None:
        return float(np.sqrt(PLATE_FROM_WIDTH[1] * PLATE_FROM_WIDTH[2]))
    if region.kind == TUBE:
        return np.inf
    return min(region.width, region.length) / region.median


def _plates_of(widths, by_place):
    """ndarray of shape (k,): the share of regions that are plates, from their widths and from the places that are."""
    none, low, high, every = PLATE_FROM_WIDTH
    to_places = np.clip((widths - none) / (low - none), 0.0, 1.0)
    to_all = np.clip((widths - high) / (every - high), 0.0, 1.0)
    return by_place * to_places * (1.0 - to_all) + to_all


def with_thinnest(regions, thinnest):
    """The same regions; none is thinner than the thinnest wall, and the first one that has its face is as thin.

    Slanted ones are as they were: the thinnest wall is the thinnest parallel one. Returns WallRegions.

    Parameters
    ----------
    regions : WallRegions
    thinnest : Witness or None
    """
    if thinnest is None:
        return regions
    listed = [region if region.is_slanted else replace(
        region, least=max(region.least, thinnest.distance), median=max(region.median, thinnest.distance))
        for region in regions.listed]
    own = next((number for number, region in enumerate(listed)
                if thinnest.face in region.faces and not region.is_slanted
                and region.least < TOLERANCES.alike * thinnest.distance), None)
    if own is not None:
        listed[own] = replace(listed[own], least=thinnest.distance, witness=thinnest)
    listed = [replace(region, witness=replace(region.witness, distance=region.least)) for region in listed]
    return replace(regions, listed=_thinnest_first(listed))


def with_thinnest_taper(regions, thinnest, face_areas):
    """The same regions; none is thinner than the part's thinnest place, and the first one that has it is as thin.

    So are those that are equal to it, such as the other teeth of a gear. Where none has both of its faces, as of a web
    between a bore and the side of a plate that few samples met, the thinnest that has one of them is that thin there. A
    region most of which is thinner is no wall, but the surface beside an edge of more than `WALL_BELOW`: it is not listed.

    Parameters
    ----------
    regions : WallRegions
    thinnest : ThinnestPlace
    face_areas : ndarray of shape (f,), mm2
    """
    wall = thinnest.witness
    walls = [region for region in regions.listed if region.median >= (1.0 - _CERTAIN) * wall.distance]
    beside_edges = [region for region in regions.listed if region.median < (1.0 - _CERTAIN) * wall.distance]
    listed = [replace(region, least=max(region.least, wall.distance), median=max(region.median, wall.distance))
              for region in walls]
    faces = {wall.face, wall.opposite_face}
    own = [number for number, region in enumerate(listed) if faces <= set(region.faces)]
    touching = [] if thinnest.kind == EDGE else [
        number for number, region in enumerate(listed) if faces & set(region.faces)]
    if own or touching:
        first = min(own or touching, key=lambda number: listed[number].is_slanted != (thinnest.kind != PARALLEL))
        sizes = [WallSize.of_region(region, face_areas) for region in listed]
        listed = [replace(region, least=wall.distance) if own and are_equal(sizes[first], size) else region
                  for region, size in zip(listed, sizes)]
        listed[first] = replace(listed[first], least=wall.distance, witness=wall)
    listed = [replace(region, witness=replace(region.witness, distance=region.least)) for region in listed]
    others = sum(region.area for region in beside_edges) / float(np.sum(face_areas))
    return replace(regions, listed=_thinnest_first(listed), others=regions.others + len(beside_edges),
                   others_share=min(1.0, regions.others_share + others))


def _thinnest_first(regions):
    """Regions by their median: the least thickness of a taper says how far it was measured towards its edge."""
    return tuple(sorted(regions, key=lambda region: (region.median, -region.area)))


def _region(field, all_points, links, members, enclosed, surface, face_areas):
    points = all_points.chosen(members)
    is_most = 2 * len(members) > len(all_points.sample)
    shape = region_shape(points, links[members][:, members], enclosed, None if is_most else wall_links)
    area = float(points.area.sum())
    middle = np.average(points.middle, axis=0, weights=points.area)
    nearest = np.argmin(np.linalg.norm(points.points - middle, axis=1))
    face_area = np.bincount(field.face[points.sample], points.area, len(face_areas))
    faces = np.flatnonzero((face_area > 0.0) & ((face_area >= OF_FACE * face_areas) | (face_area >= OF_REGION * area)))
    thinnest = _thinnest_point(points, max(STATED_FLOOR * surface, LEAST_EXTENT * area))
    return WallRegion(
        shape.kind, area, float(points.thickness[thinnest]),
        area_median(points.thickness, points.area), shape.length, shape.width,
        min(1.0, shape.volume / enclosed) if enclosed else None,
        points.points[nearest] + field.mesh.origin, tuple(map(int, faces)),
        witness_of(field, int(points.sample[thinnest])),
        bool(points.area[~is_parallel(points.wedge_angle)].sum() > 0.5 * area))


def _thinnest_point(points, floor):
    """Number of the point from whose thickness which on walls that are no more than a quarter thicker cover an area."""
    order = np.argsort(points.thickness, kind="stable")
    thickness, covered = points.thickness[order], np.concatenate([[0.0], np.cumsum(points.area[order])])
    last = np.searchsorted(thickness, TOLERANCES.alike * thickness, side="right")
    return int(order[np.argmax(covered[last] - covered[:-1] >= floor)])

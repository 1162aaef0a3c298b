# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which wall regions of a part are listed: the largest with all that are equal to them, and the thinnest."""

from dataclasses import dataclass, replace

import numpy as np

from ..descriptors.equal_walls import SAME_AREA, SAME_TAPER, WallSize, are_equal
from ..walls.walls import is_parallel

LEAST_SHARE = 0.005
"""Share of the surface from which on a region is listed."""

THINNEST_SHARE = 0.0005
"""Share of the surface from which on the thinnest region is listed; less is the rim of a fillet or of an engraving."""

COUNTED_SHARE = 0.002
"""Share of the surface from which on a region that is not listed is counted."""

MOST_LISTED = 20
"""Regions that are listed: the largest, and always the thinnest. Equal ones are one of them."""

FEWEST_POINTS = 8
"""Points of the cloud from which on a region has a shape."""


def listed_regions(points, component, area, size, median, surface, face_areas, region_of):
    """The regions that are listed, by the number of their component: dict of WallRegion. Equal ones are of one kind.

    Parameters
    ----------
    points : WallPoints
    component : ndarray of shape (n,), int64
        Of each point.
    area, size, median : ndarray of shape (k,)
        Of each component: mm2, number of its certain points, thickness in mm.
    surface : float, mm2
    face_areas : ndarray of shape (f,), mm2
    region_of : callable
        Measures the region of a component.
    """
    enough = size >= FEWEST_POINTS
    large = np.flatnonzero(enough & (area >= LEAST_SHARE * surface))
    large = large[np.argsort(-area[large], kind="stable")]
    rows: list[_Row] = []
    for number in large:
        _add(rows, int(number), region_of(number), face_areas, is_new=len(rows) < MOST_LISTED)
    # The run-out of a wedge is thinner than anything, and no wall.
    parallel = np.bincount(component, points.area * is_parallel(points.wedge_angle), len(area)) > 0.5 * area
    walls = np.flatnonzero(enough & (area >= THINNEST_SHARE * surface) & parallel)
    if len(walls):
        least = np.full(len(area), np.inf)
        np.minimum.at(least, component, points.thickness)
        thinnest = int(walls[np.argmin(least[walls])])
        if not any(thinnest in row.regions for row in rows):
            del rows[MOST_LISTED - 1:]
            _add(rows, thinnest, region_of(thinnest), face_areas, is_new=True)
    # Of equal ones, some may be just too small, or have lost more points at their borders.
    for number in np.flatnonzero(enough & (area >= COUNTED_SHARE * surface) & (area < LEAST_SHARE * surface)):
        if any(abs(row.size.area - area[number]) <= SAME_AREA * row.size.area
               and abs(row.size.median - median[number]) <= SAME_TAPER * row.size.median for row in rows):
            _add(rows, int(number), region_of(number), face_areas, is_new=False)
    return {number: region for row in rows for number, region in row.of_one_kind().items()}


@dataclass(frozen=True)
class _Row:
    """Equal regions by the number of their component, and the size of the first."""

    size: WallSize
    regions: dict

    def of_one_kind(self):
        """The regions, all of the kind that most of their area has: dict."""
        areas: dict = {}
        for region in self.regions.values():
            areas[region.kind] = areas.get(region.kind, 0.0) + region.area
        kind = max(areas, key=lambda each: areas[each])
        return {number: replace(region, kind=kind) for number, region in self.regions.items()}


def _add(rows, number, region, face_areas, is_new):
    """Add a region to the row of its equals; where there is none, to a new one if there may be one."""
    size = WallSize.of_region(region, face_areas)
    row = next((row for row in rows if are_equal(row.size, size)), None)
    if row is not None:
        row.regions[number] = region
    elif is_new:
        rows.append(_Row(size, {number: region}))

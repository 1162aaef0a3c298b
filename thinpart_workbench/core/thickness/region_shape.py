# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measures of one wall region, and which kind of wall it is."""

from dataclasses import dataclass

import numpy as np
from scipy.sparse.csgraph import connected_components, dijkstra
from scipy.spatial import ConvexHull, cKDTree

from ..columns import cross, dot
from ..descriptors.region_kinds import BAR, BLOCK, PLATE, TAPER, TOOTH, TUBE
from ..mesh.bounds import spread_directions
from ..mesh.dominant_directions import dominant_directions
from ..walls.walls import is_parallel

SLANTED, VARIED = 0.5, 1.5
"""Share of a region over walls at more than 10 degrees, and ratio of its thickness at 95 percent of its points to that at 5
percent, from which it is a taper. The crest of a thread faces a flank, and yet a screw is a bar."""

STUBBY = 3.0
"""A taper on a body whose developed width is under so many thicknesses is a tooth: one of a gear has one to two."""

PLATE_FROM = 2.2
"""Developed width by thickness from which a wall is a plate: 2 of a square bar, all of whose sides count, 1.6 of a round
one; 2.4 of a washer M10."""

BAR_FROM = 2.2
"""Length by the larger side of its section from which what is no plate is a bar, not a block."""

TUBE_AXIS = 0.2
"""Greatest mean squared cosine between a tube's normals and its axis: 0 of a cylinder, 0.2 of a cone with 53 degrees
between its sides."""

TUBE_SECTORS, TUBE_LENGTHS, TUBE_COVERED = 36, 8, 0.9
"""Sectors around its axis and slices along it that a tube's wall has to be in, seen from inside and outside: a slit or
windows of up to a tenth of it are allowed."""

FEWEST_SECTORS = 12
"""Sectors that a tube or a ring of few samples is divided into."""

HOLLOW = 0.6
"""Least distance of a tube's walls from its axis, in thicknesses: of a round one, 0.5 is a bar."""

MOST_FOLDED = 1.25
"""Developed width of a tube by the way about it; a heat sink, whose fins go round too, has a multiple."""

LONG_TUBE = 0.7
"""Length of a bent tube by its way round, from which it is one: an elbow is, a closed box is not."""

BENT = 1.2
"""Way along a region by the diagonal of its box from which it is bent and measured along the way."""

RING_FROM = 9.0
"""Length by width from which what goes round a hole is a ring, as long as its way round; 9.4 of a washer twice as wide as
its hole, while a disc with a bore is a disc, and so is a tab with a screw hole, which has 8."""

FLAT = 0.9
"""Mean squared cosine between a region's normals and one direction from which it is flat, so that only its outline bends."""

BAND, MORE_BANDS = (0.4, 0.6), ((0.3, 0.4), (0.6, 0.7))
"""Shares of the way along a region at which it is looked at across: a ring goes two ways half-way along, and before that or
after it, while arms about a hub do so only at the hub."""

ARMS_APART = 1.5
"""Least distance of the two ways round a ring, in widths, at one of the other bands: round a bolt hole it is less."""

LEAST_ARM, LEAST_FURTHER_ARM = 0.25, 0.1
"""Least share of such a band, the middle one or the others, on either side of a hole that a region goes round."""

FILLED = 0.6
"""Share of its rectangle from which a flat wall is a tab, whatever notches it has: a bent strip fills less."""

_DOMINANT = 3
_DIRECTIONS = spread_directions(150).astype(np.float32)
_ANGLES = np.radians(np.arange(0.0, 90.0, 1.0))
_TURNED = np.concatenate([np.column_stack([np.cos(_ANGLES), np.sin(_ANGLES)]),
                          np.column_stack([-np.sin(_ANGLES), np.cos(_ANGLES)])])
_IN_SECTOR_OF_TUBE, _IN_SECTOR_OF_RING = 6, 20
_FEWEST_OF_TUBE = 4 * FEWEST_SECTORS
_PROBED, _AMONG, _FEWEST_IN_CELL = 40, 1500, 8
_ROUND = 1.0
"""Radius, in thicknesses, in which the sides of a bar are looked at."""


@dataclass(frozen=True)
class RegionShape:
    """Measures of a region.

    Attributes
    ----------
    kind : str
        One of `REGION_KINDS`.
    length : float, mm
        Along a bent region and round a ring, which a short tube is; along the axis of a longer one.
    width : float, mm
        Developed: half of the area by the length.
    volume : float, mm3
    """

    kind: str
    length: float
    width: float
    volume: float


def region_shape(points, links, volume, closer_links=None):
    """Measure a region: RegionShape.

    Parameters
    ----------
    points : WallPoints
        Of the region.
    links : csr_array of shape (n, n)
        Between them, see `wall_links`.
    volume : float or None, mm3
        Of the part.
    closer_links : callable, optional
        Finds links of `WallPoints` without others among them, by which ways are straighter. Called where the region seems
        to be bent or a ring.
    """
    area, thickness = float(points.area.sum()), area_median(points.thickness, points.area)
    length, is_tube = _length(points, links, area, thickness, closer_links)
    width = area / (2.0 * length)
    # Across a wedge, the way along one of its normals is longer than the wedge is thick.
    enclosed = 0.5 * float(np.sum(points.area * points.thickness * np.cos(points.wedge_angle)))
    slanted = ~is_parallel(points.wedge_angle)
    thinner, thicker = np.quantile(points.thickness, [0.05, 0.95])
    if points.area[slanted].sum() > SLANTED * area and thicker > VARIED * thinner:
        is_tooth = volume is not None and enclosed < 0.5 * volume and width < STUBBY * thickness
        return RegionShape(TOOTH if is_tooth else TAPER, length, width, enclosed)
    if is_tube:
        return RegionShape(TUBE, length, width, enclosed)
    if min(width, length) >= PLATE_FROM * thickness:
        return RegionShape(PLATE, length, width, enclosed)
    sides = _sides(points)
    kind = BAR if length >= BAR_FROM * max(thickness, width * sides) else BLOCK
    return RegionShape(kind, length, width, enclosed * sides)


def area_median(value, area):
    """float: the value that half of an area has at most."""
    order = np.argsort(value, kind="stable")
    covered = np.cumsum(area[order])
    return float(value[order[np.searchsorted(covered, 0.5 * covered[-1])]])


def _sides(points):
    """By how much material under the surface is that of other sides too: 1 of a plate, 1/2 of a bar, 1/3 of a ball.

    A plate has half of its thickness for each of two sides, a round or square bar a quarter for all around, a ball or
    cube a sixth: half of the sum of squared shares of the three directions that normals near by have.
    """
    points = points.chosen(_spread(len(points.sample), _AMONG))
    probed = _spread(len(points.sample), _PROBED)
    tree = cKDTree(points.points)
    around = tree.query_ball_point(points.middle[probed], _ROUND * points.thickness[probed])
    counts = np.array([len(near) for near in around])
    near, own = np.concatenate(around).astype(np.int64), np.repeat(np.arange(len(probed)), counts)
    # The sums of area times both coordinates of normals around each place: nine of them.
    normals = points.normals[near].T
    products = points.area[near] * normals[:, None] * normals
    tensor = np.stack([np.bincount(own, row, len(probed)) for row in products.reshape(9, -1)])
    trace = tensor[0] + tensor[4] + tensor[8]
    shares = np.where(counts > 0, np.sum(tensor * tensor, axis=0) / np.where(counts > 0, trace, 1.0) ** 2, 1.0)
    return float(np.average(shares, weights=points.area[probed]))


def _spread(count, most):
    return np.unique(np.linspace(0, count - 1, min(count, most)).astype(np.int64))


def _length(points, links, area, thickness, closer_links):
    """Length of a region, mm, and whether it is a tube."""
    # Of evenly spread points, the outermost are less far apart than what they are spread over.
    count = len(points.sample)
    axis = _tube_axis(points)
    if axis is not None:
        axial = float(np.ptp(points.points @ axis) * (count + 1) / (count - 1))
        if area <= 2.0 * axial * MOST_FOLDED * _way_about(points.points, axis):
            is_tube = axial >= PLATE_FROM * thickness
            return axial if is_tube else _way_about(points.middle, axis), is_tube
    size = _box(points) * (count + 1) / (count - 1)
    bent = _bent_length(points, links, area, size)
    if bent is not None and closer_links is not None:
        bent = _bent_length(points, closer_links(points), area, size)
    return bent or (float(size[0]), False)


def _bent_length(points, links, area, size):
    """Length of a region along its bends, mm, and whether it is a tube; None where it is straight."""
    way = _way_along(points, links)
    along = float(way.max() + np.median(points.spacing))
    band = _band(way, BAND)
    if _arms_apart(points, links, band, LEAST_ARM) > 0.0:
        ring = _way_round(points, along)
        width = area / (2.0 * ring)
        if ring < RING_FROM * width and _flatness(points) >= FLAT:
            return None  # the way along a tab with a hole leads round the hole, as if it were bent
        apart = max(_arms_apart(points, links, _band(way, shares), LEAST_FURTHER_ARM) for shares in MORE_BANDS)
        if ring >= RING_FROM * width and apart >= ARMS_APART * width:
            return ring, False
    if along <= BENT * np.linalg.norm(size) or area >= 2.0 * FILLED * size[0] * size[1] and _flatness(points) >= FLAT:
        return None  # straight, or a tab with a notch, which the way along leads round
    # From end to end of a tube, and half-way round.
    axial = float(np.sqrt(0.5 * (along**2 + np.sqrt(max(along**4 - 0.25 * area**2, 0.0)))))
    if axial >= LONG_TUBE * area / (2.0 * axial) and _tube_axis(points.chosen(band)) is not None:
        return axial, True
    # The longest way over a developed strip is its diagonal.
    return float(np.sqrt(0.5 * (along**2 + np.sqrt(max(along**4 - area**2, 0.0))))), False


def _flatness(points):
    """Share of a region's normals, squared, along one direction: 1 of a flat plate, 1/2 of a tube."""
    return float(np.linalg.eigvalsh(_tensor(points.area, points.normals))[-1] / points.area.sum())


def _tensor(area, vectors):
    return np.einsum("i,ij,ik->jk", area, vectors, vectors)


def _box(points):
    """Sides of a small box around the points, mm, longest first: ndarray of shape (3,)."""
    reach = _DIRECTIONS @ (points.points - points.points[0]).T.astype(np.float32)
    corners = points.points[np.unique([np.argmin(reach, axis=1), np.argmax(reach, axis=1)])]
    centred = points.points - np.average(points.points, axis=0, weights=points.area)
    axes = np.concatenate([*(np.linalg.eigh(_tensor(points.area, rows))[1].T for rows in (centred, points.normals)),
                           dominant_directions(points.normals, points.area, _DOMINANT)])
    # About each axis, the sides at all angles; those across them come a right angle later.
    around = _TURNED @ np.stack(_across(axes), axis=1)
    sides = np.ptp(around.reshape(-1, 3) @ corners.T, axis=1).reshape(len(axes), 2, len(_ANGLES))
    floor, height = sides[:, 0] * sides[:, 1], np.ptp(axes @ corners.T, axis=1)
    angle = np.argmin(floor, axis=1)
    best = np.argmin(floor[np.arange(len(axes)), angle] * height)
    return np.sort([*sides[best, :, angle[best]], height[best]])[::-1]


def _across(axes):
    """Two directions across each axis and each other, two ndarrays of shape (k, 3)."""
    first = cross(axes.T, np.eye(3)[np.argmin(np.abs(axes), axis=1)].T)
    first /= np.sqrt(dot(first, first))
    return first.T, cross(axes.T, first).T


def _tube_axis(points):
    """Axis of a tube, ndarray of shape (3,); None where the region is none."""
    if len(points.sample) < _FEWEST_OF_TUBE:
        return None  # between the parts of a region that has a gap, there may be none at all
    area = points.area / points.area.sum()
    shares, axes = np.linalg.eigh(_tensor(area, points.normals))
    if shares[0] > TUBE_AXIS:
        return None
    flat = np.concatenate(_across(axes[:, :1].T)).T
    middle = points.middle @ flat
    middle -= area @ middle
    radius = np.linalg.norm(middle, axis=1)
    if np.quantile(radius, 0.02) < HOLLOW * area_median(points.thickness, points.area):
        return None
    sectors, sector = _sectors(middle[:, 0], middle[:, 1], _IN_SECTOR_OF_TUBE)
    inward = np.einsum("ij,ij->i", points.normals @ flat, middle) < 0.0
    along = points.points @ axes[:, 0]
    if not np.ptp(along):
        return None  # one row of points about an axis has no length
    slices = int(np.clip(len(along) / (2 * sectors * _FEWEST_IN_CELL), 1, TUBE_LENGTHS))
    cell = np.minimum((along - along.min()) / np.ptp(along) * slices, slices - 1).astype(int) * sectors + sector
    covered = [len(np.unique(cell[side])) for side in (inward, ~inward)]
    return axes[:, 0] if min(covered) >= TUBE_COVERED * sectors * slices else None


def _sectors(x, y, in_each):
    """Into how many sectors points are divided, with about so many in each, and the number of the sector of each point."""
    count = int(np.clip(len(x) / in_each, FEWEST_SECTORS, TUBE_SECTORS))
    return count, ((np.arctan2(y, x) / (2.0 * np.pi) + 0.5) * count).astype(int) % count


def _way_about(points, axis):
    """Way about points, tightly, across an axis, mm: float."""
    flat = points @ np.concatenate(_across(axis[None])).T
    return float(ConvexHull(flat).area)  # of what is flat, scipy calls the perimeter so


def _way_along(points, links):
    """Way through the wall from one of the places farthest from each other, mm: ndarray of shape (n,)."""
    start = int(np.argmax(np.linalg.norm(points.middle - points.middle.mean(axis=0), axis=1)))
    return _ways_from(links, int(np.argmax(_ways_from(links, start))))


def _ways_from(links, start):
    way = dijkstra(links, directed=False, indices=start)
    return np.where(np.isfinite(way), way, 0.0)


def _band(way, shares):
    """Points at some shares of the way along a region: ndarray of int64."""
    return np.flatnonzero((way > shares[0] * way.max()) & (way < shares[1] * way.max()))


def _arms_apart(points, links, band, least_arm):
    """How far apart the two ways on are at a band, mm, each with a share of it; 0 where there is only one."""
    if len(band) < 4:
        return 0.0
    count, arm = connected_components(links[band][:, band], directed=False)
    area = points.area[band]
    shares = np.bincount(arm, area) / area.sum()
    largest = np.argsort(-shares, kind="stable")[:2]
    if count < 2 or shares[largest[1]] < least_arm:
        return 0.0
    one, other = (np.average(points.middle[band[arm == which]], axis=0, weights=area[arm == which]) for which in largest)
    return float(np.linalg.norm(one - other))


def _way_round(points, along):
    """Way round the hole of a ring, mm."""
    centred = points.middle - np.average(points.middle, axis=0, weights=points.area)
    axes = np.linalg.eigh(_tensor(points.area, centred))[1]
    # With few points in each, the way from middle to middle of the sectors would be a zigzag.
    sectors, sector = _sectors(centred @ axes[:, 2], centred @ axes[:, 1], _IN_SECTOR_OF_RING)
    # By radius, not by area, of which there is more outside.
    by_radius = points.area / np.maximum(np.linalg.norm(centred @ axes[:, 1:], axis=1), 1e-9 * along)
    weight = np.bincount(sector, by_radius, sectors)
    if not weight.all():
        return 2.0 * along
    corners = np.stack([np.bincount(sector, by_radius * centred[:, k], sectors) for k in range(3)], axis=1)
    corners /= weight[:, None]
    return float(np.linalg.norm(corners - np.roll(corners, 1, axis=0), axis=1).sum())

# SPDX-License-Identifier: LGPL-2.1-or-later
"""A plane that cuts thickness maps open: the coloured edge of the cut, and the material that fills it."""

from dataclasses import dataclass

import numpy as np

from ..rigid_transform import inverse, transform_directions, transform_points

_MERGED = 1e-6
"""Share of the extent: ends of cut edges that are nearer in height are at the same height."""

_MOST_STRIPS = 200_000
"""Pieces of material between two heights. Where there would be more, heights are rounded."""

_ROUNDED = 500
"""Heights that are left then."""


@dataclass(frozen=True)
class SectionPlane:
    """A plane that removes what lies before it.

    Attributes
    ----------
    normal : tuple of float
        Unit vector towards what is removed.
    offset : float, mm
        Distance of the plane from the origin along the normal.
    """

    normal: tuple
    offset: float

    def heights(self, points):
        """Distance of points in mm, positive where they are removed: ndarray of shape (n,)."""
        return np.asarray(points, dtype=np.float64) @ np.array(self.normal) - self.offset

    def moved(self, matrix):
        """The plane after a rotation and translation, an ndarray of shape (4, 4): SectionPlane."""
        normal = transform_directions(matrix, np.array(self.normal))
        through = transform_points(matrix, self.offset * np.array(self.normal))
        return SectionPlane(tuple(map(float, normal)), float(normal @ through))

    def entry(self, start, direction):
        """Where a ray gets to what is kept, in units of its direction: 0 where it starts there, inf where it never does."""
        height, slope = float(self.heights(start)), float(np.dot(self.normal, direction))
        if height <= 0.0:
            return 0.0
        return -height / slope if slope < 0.0 else np.inf


@dataclass(frozen=True)
class MapSection:
    """Where a plane cuts the map of a part.

    Attributes
    ----------
    ends : ndarray of shape (k, 2, 3), mm
        Of the lines in which the plane cuts facets.
    facet : ndarray of shape (k,)
        The facet that each line lies on.
    thickness : ndarray of shape (k, 2), mm
        At the ends; nan where nothing was measured.
    material : ndarray of shape (t, 4, 3), mm
        Four-sided pieces that fill the cut.
    """

    ends: np.ndarray
    facet: np.ndarray
    thickness: np.ndarray
    material: np.ndarray


def map_section(shown, plane, drawn=None):
    """Cut a thickness map: MapSection.

    Parameters
    ----------
    shown : ThicknessMap
    plane : SectionPlane
        In the coordinates of the map, as are the results.
    drawn : ndarray of shape (m,), bool, optional
        Facets that have an edge where they are cut; the material is that of all facets.
    """
    heights = (plane.heights(shown.points.astype(np.float64) + shown.origin))[shown.facets]
    above = heights > 0.0
    facet = np.flatnonzero(above.any(axis=1) & ~above.all(axis=1))
    heights, above = heights[facet], above[facet]
    # Turn each facet so that its first corner is alone on its side of the plane.
    alone = np.where(above.sum(axis=1) == 1, above.argmax(axis=1), (~above).argmax(axis=1))
    turn = (alone[:, None] + np.arange(3)) % 3
    rows = np.arange(len(facet))[:, None]
    heights, corners = heights[rows, turn], shown.corners[facet][rows, turn]
    values = shown.corner_thickness[facet][rows, turn]
    share = heights[:, :1] / (heights[:, :1] - heights[:, 1:])
    ends = corners[:, :1] + share[..., None] * (corners[:, 1:] - corners[:, :1]) + shown.origin
    thickness = values[:, :1] + share * (values[:, 1:] - values[:, :1])
    # With the removed side up, material lies to the left of each line.
    upward = above[rows[:, 0], alone]
    directed = np.where(upward[:, None, None], ends, ends[:, ::-1])
    material = _material(directed, np.array(plane.normal))
    if drawn is not None:
        kept = drawn[facet]
        ends, thickness, facet = ends[kept], thickness[kept], facet[kept]
    return MapSection(ends, facet, thickness, material)


def section_extent(parts, moved, normal):
    """Least and greatest distance of parts along a direction: (float, float), mm.

    Parameters
    ----------
    parts : list of MappedPart
    moved : ndarray of shape (4, 4)
        From where the parts were measured to where they are.
    normal : array_like of shape (3,)
    """
    lows, highs = [], []
    for part in parts:
        for matrix in part.matrices:
            back = transform_directions(inverse(moved @ matrix), np.asarray(normal, dtype=np.float64))
            along = part.map.points.astype(np.float64) @ back
            base = float(transform_points(moved @ matrix, part.map.origin) @ np.asarray(normal))
            lows.append(base + along.min())
            highs.append(base + along.max())
    return float(min(lows)), float(max(highs))


def _material(ends, normal):
    """Fill the area that directed lines bound with strips between the heights of their ends.

    Strips need no chains of lines, so holes, several areas and gaps in a mesh are no special cases. Material is where more
    lines went up than down, counted from the side.
    """
    if not len(ends):
        return np.empty((0, 4, 3))
    across, up = _axes(normal)
    flat = np.stack([ends @ across, ends @ up], axis=-1)  # line, end, coordinate
    extent = max(float(np.ptp(flat.reshape(-1, 2), axis=0).max()), 1e-12)
    flat[..., 1] = np.round(flat[..., 1] / (_MERGED * extent)) * (_MERGED * extent)
    levels = np.unique(flat[..., 1])
    first, last = _spans(flat, levels)
    if (last - first).sum() > _MOST_STRIPS:
        step = extent / _ROUNDED
        flat[..., 1] = np.round(flat[..., 1] / step) * step
        levels = np.unique(flat[..., 1])
        first, last = _spans(flat, levels)
    count = last - first
    line = np.repeat(np.arange(len(flat)), count)
    level = np.arange(len(line)) - np.repeat(np.cumsum(count) - count, count) + first[line]
    low, high = levels[level], levels[level + 1]
    start, end = flat[line, 0], flat[line, 1]
    slope = (end[:, 0] - start[:, 0]) / (end[:, 1] - start[:, 1])
    at_low, at_high = (start[:, 0] + slope * (edge - start[:, 1]) for edge in (low, high))
    sign = np.sign(end[:, 1] - start[:, 1])
    order = np.lexsort((at_low + at_high, level))
    level, at_low, at_high, low, high, sign = (each[order] for each in (level, at_low, at_high, low, high, sign))
    total = np.cumsum(sign)
    before = np.concatenate([[0.0], total[:-1]])
    starts = np.concatenate([[True], level[1:] != level[:-1]])
    base = before[np.flatnonzero(starts)][np.cumsum(starts) - 1]
    inside = np.flatnonzero((total - base != 0.0)[:-1] & (level[1:] == level[:-1]))
    left, right = inside, inside + 1
    bottom, top = low[left], high[left]
    corners = [(at_low[left], bottom), (at_low[right], bottom), (at_high[right], top), (at_high[left], top)]
    depth = float(np.median(ends.reshape(-1, 3) @ normal))
    return np.stack([x[:, None] * across + y[:, None] * up for x, y in corners], axis=1) + depth * normal


def _spans(flat, levels):
    """The first and the last level of each line: two ndarrays of shape (k,)."""
    return (np.searchsorted(levels, flat[..., 1].min(axis=1)), np.searchsorted(levels, flat[..., 1].max(axis=1)))


def _axes(normal):
    """Two unit vectors in a plane, perpendicular to each other: ndarrays of shape (3,)."""
    across = np.cross(normal, np.eye(3)[np.argmin(np.abs(normal))])
    across /= np.linalg.norm(across)
    return across, np.cross(normal, across)

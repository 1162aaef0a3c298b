# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of a part coloured by thickness: from both sides, and of its thinnest wall."""

from dataclasses import dataclass, field
from typing import Optional

import numpy as np

from ..maps.map_summary import typical_range
from ..maps.mapped_part import MappedPart
from .camera import FROM_BEHIND, ISOMETRIC, Camera, framing, looking_from
from .colour_scale import ColourScale
from .picture import draw

WIDTH, HEIGHT = 900, 600
"""Size of a picture, pixels."""

DARKEST = 0.62
"""Brightness of surface that faces away from the light; its colours must remain distinguishable."""

_AROUND = 9.0
"""Half the height of the picture of the thinnest wall, in thicknesses of that wall."""

_LEAST_AROUND, _MOST_AROUND = 0.12, 0.5
"""Bounds of that half height, as shares of the part's diagonal."""

_FILLED = 0.6
"""Share of each half of the picture that the part covers, if it is large enough."""

_OFF = 1e-4
"""Distance from the surface, as a share of the diagonal, at which a ray to the viewer starts."""


@dataclass(frozen=True)
class ProjectedWall:
    """The ends of a wall in a picture, each as (right, down) in pixels."""

    point: tuple
    opposite: tuple


@dataclass(frozen=True)
class PartView:
    """A picture.

    Attributes
    ----------
    name : str
        ``front``, ``back`` or ``thinnest``.
    pixels : ndarray of shape (height, width, 4), uint8
    thinnest : ProjectedWall or None
        The thinnest wall, if its near end is visible.
    """

    name: str
    pixels: np.ndarray = field(repr=False)
    thinnest: Optional[ProjectedWall] = None


def thickness_scale(thickness_map, record):
    """Choose the colour scale of a part; None where nothing was measured.

    Returns a ColourScale: over the range that most of the surface has, as in the window; see `map_summary.typical_range`.

    Parameters
    ----------
    thickness_map : ThicknessMap
    record : dict
        Part record.
    """
    ends = typical_range([MappedPart(record, thickness_map)])
    return None if ends is None else ColourScale(*ends)


def thinnest_wall(record):
    """Find the witness, in the faces of a record, of the least distance between parallel walls; or None."""
    found = [face["witness"] for face in record["faces"] if face["witness"] is not None]
    return min(found, key=lambda witness: witness["distance"], default=None)


class PartPictures:
    """Draws the pictures of a part.

    Parameters
    ----------
    thickness_map : ThicknessMap
    record : dict
        Part record.
    """

    def __init__(self, thickness_map, record):
        self.scale, self.measure = thickness_scale(thickness_map, record), thickness_map.measure
        self.greatest = 0.0 if thickness_map.ends is None else thickness_map.ends[1]
        self._corners = thickness_map.corners + thickness_map.origin
        self._points = thickness_map.points + thickness_map.origin
        self._middles = self._corners.mean(axis=1)
        self._reach = ((self._corners - self._middles[:, None]) ** 2).sum(axis=2).max(axis=1)
        self._normals = thickness_map.normals
        self._both_sides = not record["descriptors"]["watertight"]
        scale = self.scale or ColourScale(0.0, 1.0)
        self._colours = scale.colours(thickness_map.corner_thickness.ravel()).reshape(-1, 3, 3) / 255.0
        self._diagonal = float(np.linalg.norm(np.ptp(self._points, axis=0)))
        wall = thinnest_wall(record)
        self._wall = None if wall is None else np.array(wall["points"], dtype=np.float64)

    def views(self, width=WIDTH, height=HEIGHT):
        """list of PartView: from two opposite corners, and of the thinnest wall if there is one."""
        views = [self._full_view("front", ISOMETRIC, width, height),
                 self._full_view("back", FROM_BEHIND, width, height)]
        if self._wall is not None:
            camera = self._at_thinnest(self._wall, width, height)
            views.append(PartView("thinnest", self._draw(camera), _projected(camera, self._wall)))
        return views

    def small(self, width, height):
        """ndarray of shape (height, width, 4), uint8: a small picture of the full part."""
        return self._draw(framing(self._points, ISOMETRIC, width, height))

    def _full_view(self, name, axes, width, height):
        camera = framing(self._points, axes, width, height)
        seen = self._wall is not None and self._is_seen(self._wall, axes[2])
        return PartView(name, self._draw(camera), _projected(camera, self._wall) if seen else None)

    def _draw(self, camera):
        return draw(self._corners, self._normals, self._colours, camera, self._both_sides, DARKEST)

    def _at_thinnest(self, wall, width, height):
        point, opposite = wall
        around = np.clip(_AROUND * np.linalg.norm(point - opposite),
                         _LEAST_AROUND * self._diagonal, _MOST_AROUND * self._diagonal)
        axes = looking_from(self._towards_viewer(wall))
        half = around * np.array([width / height, 1.0])
        seen, middle = self._points @ axes.T, axes @ (0.5 * (point + opposite))
        low, high = seen.min(axis=0)[:2] + _FILLED * half, seen.max(axis=0)[:2] - _FILLED * half
        filled = np.clip(middle[:2], low, np.maximum(low, high))
        middle[:2] = np.where(low <= high, filled, 0.5 * (low + high))
        return Camera(axes, middle @ axes, 0.5 * height / float(around), width, height)

    def _towards_viewer(self, wall):
        """Choose the direction from which the thinnest wall is seen best: with both of its ends visible if possible, and
        at an angle close to one of the other views."""
        outward = _outward(wall)
        aside = looking_from(outward)[:2]
        tilts, turns = np.radians([35.0, 60.0, 75.0]), np.radians(np.arange(0.0, 360.0, 30.0))
        candidates = [
            np.cos(tilt) * outward + np.sin(tilt) * (np.cos(turn) * aside[0] + np.sin(turn) * aside[1])
            for tilt in tilts for turn in turns
        ]
        return max(candidates, key=lambda towards: (
            self._is_seen(wall, towards), self._is_seen(wall, towards, 1),
            round(float(max(towards @ ISOMETRIC[2], towards @ FROM_BEHIND[2])), 6)))

    def _is_seen(self, wall, towards, end=0):
        """Whether nothing hides an end of the thinnest wall from the viewer."""
        outward = _outward(wall, end)
        if not self._both_sides and outward @ towards <= 0.0:
            return False
        start = wall[end] + _OFF * self._diagonal * outward
        off = self._middles - start
        aside = np.einsum("ij,ij->i", off, off) - (off @ towards) ** 2
        near = aside <= self._reach * (1.0 + 1e-6) + (1e-6 * self._diagonal) ** 2
        return not _hits_any(start, towards, self._corners[near])


def _projected(camera, wall):
    return ProjectedWall(*(tuple(map(float, point[:2])) for point in camera.project(wall)))


def _outward(wall, end=0):
    """Unit vector from the material to an end of a wall."""
    outward = wall[end] - wall[1 - end]
    length = np.linalg.norm(outward)
    return outward / length if length > 0.0 else ISOMETRIC[2]


def _hits_any(start, direction, corners):
    """Whether a ray meets any triangle (Moeller and Trumbore 1997, doi:10.1080/10867651.1997.10487468)."""
    along, across = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    normal = np.cross(direction, across)
    with np.errstate(divide="ignore", invalid="ignore"):
        scale = 1.0 / np.einsum("ij,ij->i", along, normal)
        off = start - corners[:, 0]
        first = np.einsum("ij,ij->i", off, normal) * scale
        turned = np.cross(off, along)
        second = turned @ direction * scale
        distance = np.einsum("ij,ij->i", turned, across) * scale
        return bool(((first >= 0.0) & (second >= 0.0) & (first + second <= 1.0) & (distance > 0.0)).any())

"""Pictures of a part coloured by thickness: from both sides, and of its thinnest place."""

from dataclasses import dataclass, field
from typing import Optional

import numpy as np

from .camera import FROM_BEHIND, ISOMETRIC, Camera, framing, looking_from
from .colour_scale import ColourScale
from .picture import draw

WIDTH, HEIGHT = 900, 600
"""Pixels of a picture."""

DARKEST = 0.62
"""Brightness of what is turned away from the light: colours must still be told from one another."""

COVERED = 0.95
"""Share of the measured area that the range of the scale covers, from the thinnest wall on."""

_AROUND = 9.0
"""Times the thickness of the thinnest wall that is shown to each side of it."""

_LEAST_AROUND, _MOST_AROUND = 0.12, 0.5
"""Bounds of that, as shares of the part's diagonal."""

_FILLED = 0.6
"""Share of the half of the picture that the part covers on each side, where it is large enough for that."""

_OFF = 1e-4
"""Share of the diagonal by which a ray to the viewer starts outside of the surface."""


@dataclass(frozen=True)
class Place:
    """The ends of a wall in a picture, in pixels: (right, down) each."""

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
    thinnest : Place or None
        The thinnest wall, where its near end is seen.
    """

    name: str
    pixels: np.ndarray = field(repr=False)
    thinnest: Optional[Place] = None


def thickness_scale(shown):
    """The scale that a part is coloured by; None where nothing was measured.

    Parameters
    ----------
    shown : ThicknessMap

    Returns
    -------
    ColourScale
        From the thinnest facet to what `COVERED` of the area lies under.
    """
    measured = np.flatnonzero(shown.measured)
    if not len(measured):
        return None
    order = measured[np.argsort(shown.thickness[measured], kind="stable")]
    area = np.cumsum(shown.areas[order])
    high = order[min(np.searchsorted(area, COVERED * area[-1]), len(order) - 1)]
    return ColourScale(float(shown.thickness[order[0]]), float(shown.thickness[high]))


def thinnest_wall(record):
    """The witness of the least distance of a part between parallel walls, as in its faces; or None."""
    found = [face["witness"] for face in record["faces"] if face["witness"] is not None]
    return min(found, key=lambda witness: witness["distance"], default=None)


class PartPictures:
    """Draws a part.

    Parameters
    ----------
    shown : ThicknessMap
    record : dict
        Part record.
    """

    def __init__(self, shown, record):
        self.scale = thickness_scale(shown)
        self._corners = shown.corners + shown.origin
        self._points = shown.points + shown.origin
        self._middles = self._corners.mean(axis=1)
        self._reach = ((self._corners - self._middles[:, None]) ** 2).sum(axis=2).max(axis=1)
        self._normals = shown.normals
        self._both_sides = not record["descriptors"]["watertight"]
        scale = self.scale or ColourScale(0.0, 1.0)
        self._colours = scale.colours(shown.thickness) / 255.0
        self._diagonal = float(np.linalg.norm(np.ptp(self._points, axis=0)))
        wall = thinnest_wall(record)
        self._wall = None if wall is None else np.array(wall["points"], dtype=np.float64)

    def views(self, width=WIDTH, height=HEIGHT):
        """list of PartView: from two opposite corners, and where there is one, of the thinnest wall."""
        views = [self._whole("front", ISOMETRIC, width, height),
                 self._whole("back", FROM_BEHIND, width, height)]
        if self._wall is not None:
            camera = self._at_thinnest(width, height)
            views.append(PartView("thinnest", self._drawn(camera), self._place(camera)))
        return views

    def small(self, width, height):
        """A small picture of the whole, ndarray of shape (height, width, 4), uint8."""
        return self._drawn(framing(self._points, ISOMETRIC, width, height))

    def _whole(self, name, axes, width, height):
        camera = framing(self._points, axes, width, height)
        seen = self._wall is not None and self._is_seen(axes[2])
        return PartView(name, self._drawn(camera), self._place(camera) if seen else None)

    def _drawn(self, camera):
        return draw(self._corners, self._normals, self._colours, camera, self._both_sides, DARKEST)

    def _place(self, camera):
        return Place(*(tuple(map(float, each[:2])) for each in camera.project(self._wall)))

    def _at_thinnest(self, width, height):
        point, opposite = self._wall
        around = np.clip(_AROUND * np.linalg.norm(point - opposite),
                         _LEAST_AROUND * self._diagonal, _MOST_AROUND * self._diagonal)
        axes = looking_from(self._towards_viewer())
        half = around * np.array([width / height, 1.0])
        seen, middle = self._points @ axes.T, axes @ (0.5 * (point + opposite))
        low, high = seen.min(axis=0)[:2] + _FILLED * half, seen.max(axis=0)[:2] - _FILLED * half
        filled = np.clip(middle[:2], low, np.maximum(low, high))
        middle[:2] = np.where(low <= high, filled, 0.5 * (low + high))
        return Camera(axes, middle @ axes, 0.5 * height / float(around), width, height)

    def _towards_viewer(self):
        """From where the thinnest wall is seen best: both of its ends if that is possible, and aslant, as in
        one of the other views."""
        outward = self._outward()
        aside = looking_from(outward)[:2]
        tilts, turns = np.radians([35.0, 60.0, 75.0]), np.radians(np.arange(0.0, 360.0, 30.0))
        candidates = [
            np.cos(tilt) * outward + np.sin(tilt) * (np.cos(turn) * aside[0] + np.sin(turn) * aside[1])
            for tilt in tilts for turn in turns
        ]
        return max(candidates, key=lambda towards: (
            self._is_seen(towards), self._is_seen(towards, 1),
            round(float(max(towards @ ISOMETRIC[2], towards @ FROM_BEHIND[2])), 6)))

    def _outward(self, end=0):
        outward = self._wall[end] - self._wall[1 - end]
        length = np.linalg.norm(outward)
        return outward / length if length > 0.0 else ISOMETRIC[2]

    def _is_seen(self, towards, end=0):
        """Whether nothing lies between an end of the thinnest wall and the viewer."""
        outward = self._outward(end)
        if not self._both_sides and outward @ towards <= 0.0:
            return False
        start = self._wall[end] + _OFF * self._diagonal * outward
        off = self._middles - start
        aside = np.einsum("ij,ij->i", off, off) - (off @ towards) ** 2
        near = aside <= self._reach * (1.0 + 1e-6) + (1e-6 * self._diagonal) ** 2
        return not _meets_any(start, towards, self._corners[near])


def _meets_any(start, direction, corners):
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

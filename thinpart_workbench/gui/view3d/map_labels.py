# SPDX-License-Identifier: LGPL-2.1-or-later
"""The labels of a thickness map: the thinnest wall, the thickest one, and those that were pinned."""

from dataclasses import dataclass
from typing import Optional

import numpy as np

from ...core.maps.extreme_walls import thickest_wall, thinnest_wall
from ...core.maps.map_sight import MapSight
from ...core.rigid_transform import transform_points
from ..application.qt import translate
from ..application.thread_work import work_in_thread
from ..record.verdict_text import marked_thinnest

_CROWD = 3000
"""Facets whose middles stand for where the part is seen."""

_OFF_SURFACE, _OFF_FACETS = 5e-4, 2.0
"""How far before its place a line of sight begins: a share of the extent of the map, or so many times the distance of its
facets from the surface."""

_TOLERANCE = 2e-3
"""The same for other objects, which are tessellated for display."""

_MOST_AT_ONCE = 120_000
"""Facets of which the walls are found within a quarter of a second."""


@dataclass(frozen=True)
class MapLabel:
    """One label.

    Attributes
    ----------
    text : str
    ends : ndarray of shape (p, 2, 3), mm
        Both ends of the wall wherever it is, in the coordinates of the document. The first end that is seen is labelled.
    has_two_ends : bool
        Whether the second end may be labelled: from there, the wall is as thick.
    rgb : tuple of int or None
        Colour of the wall in the map.
    has_line : bool
        Whether the line through the wall is drawn.
    is_always_shown : bool
        Also where something hides the wall.
    """

    text: str
    ends: np.ndarray
    rgb: Optional[tuple] = None
    has_two_ends: bool = True
    has_line: bool = False
    is_always_shown: bool = False


@dataclass(frozen=True, eq=False)
class LabelContent:
    """What is labelled in a view.

    Attributes
    ----------
    key : tuple
        Equal where all of the content is.
    labels : list of MapLabel
    crowd : ndarray of shape (n, 3), mm
        Points of the parts, which labels cover only where there is no better place.
    covers : callable or None
        For places, unit vectors towards the eye and lengths of lines of sight (ndarray of shape (k, 3), (k, 3), (k,), mm):
        whether the parts hide each of the places.
    section : SectionPlane or None
        What it cuts off is not labelled, and hides nothing.
    tolerance : float, mm
        How far what is drawn may lie from the places.
    has_others : bool
        Whether other objects are shown, which may hide a place.
    """

    key: tuple
    labels: list
    crowd: np.ndarray
    covers: object = None
    section: object = None
    tolerance: float = 0.0
    has_others: bool = False


class LabelledWalls:
    """What labels need to know of a list of MappedPart, found once."""

    def __init__(self, parts):
        self._sight = MapSight(parts)
        self.thinnest, self.thickest = thinnest_wall(parts), thickest_wall(parts, self._sight)
        self._crowd = np.concatenate([_spread(part) for part in parts])
        self._extent = max((float(np.linalg.norm(np.ptp(self._crowd, axis=0))), 1e-9)) if len(self._crowd) else 1.0
        deflection = max((part.record.get("deflection_mm") or 0.0 for part in parts), default=0.0)
        self._off = max(_OFF_SURFACE * self._extent, _OFF_FACETS * deflection)

    def content(self, key, moved, probes, unit, colour_of, section, has_others):
        """The LabelContent of the map.

        Parameters
        ----------
        key : tuple
            See LabelContent.
        moved : ndarray of shape (4, 4)
            From where the parts were measured to where they are.
        colour_of : callable
            Red, green and blue from 0 to 255 for a thickness in mm.
        section, has_others
            See LabelContent.
        """
        labels = []
        for text, wall in ((translate("ThinPart", "min {}"), self.thinnest),
                           (translate("ThinPart", "thickest wall {}"), self.thickest)):
            if wall is not None:
                # What lies far behind a place may see something nearer: only the first end has the colour of the wall.
                value = marked_thinnest(unit.text(wall.value), wall.kind)
                labels.append(MapLabel(text.format(value), _moved(moved, wall.places), colour_of(wall.value),
                                       wall is self.thinnest))
        for number, probe in enumerate(probes):
            ends = np.array([[probe.point, probe.opposite]], dtype=float)
            labels.append(MapLabel(f"{number + 1}: {unit.text(probe.value)}", _moved(moved, ends),
                                   colour_of(probe.value), has_line=True))
        back = np.linalg.inv(moved)

        def covers(points, directions, limits):
            starts = transform_points(back, points + self._off * directions)
            return ~self._sight.are_free(starts, directions @ back[:3, :3].T, np.maximum(limits - self._off, 0.0))

        return LabelContent(key, labels, transform_points(moved, self._crowd), covers, section,
                            _TOLERANCE * self._extent, has_others)


class WallsFoundLater:
    """Finds the LabelledWalls of a map, in a thread where that would block the window for too long.

    Parameters
    ----------
    parts : list of MappedPart
    done : callable
        Called without arguments in the thread of the window when a thread has found them.

    Attributes
    ----------
    found : LabelledWalls or None
        None as long as they are looked for.
    """

    def __init__(self, parts, done):
        self.found = None
        if sum(part.map.count for part in parts) <= _MOST_AT_ONCE:
            self.found = LabelledWalls(parts)
            return
        self._done = done
        work_in_thread(lambda: LabelledWalls(parts), self._keep)

    def _keep(self, found):
        if isinstance(found, Exception):
            raise found
        self.found = found
        self._done()


def _moved(matrix, ends):
    return transform_points(matrix, ends.reshape(-1, 3)).reshape(-1, 2, 3)


def _spread(part):
    """Middles of facets, at all occurrences: ndarray of shape (n, 3), mm."""
    shown = part.map
    total = np.cumsum(shown.areas)
    count = max(_CROWD // len(part.matrices), 50)
    rows = np.minimum(np.searchsorted(total, (np.arange(count) + 0.5) / count * total[-1]), shown.count - 1)
    middles = shown.corners[rows].mean(axis=1) + shown.origin
    return np.concatenate([transform_points(matrix, middles) for matrix in part.matrices])

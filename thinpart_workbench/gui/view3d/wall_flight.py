# SPDX-License-Identifier: LGPL-2.1-or-later
"""Flights of the camera to a wall: it is looked at from where nothing stands before it, and is marked with its thickness."""

from dataclasses import dataclass

import numpy as np

from ...core.rays.line_of_sight import Scene, best_sight
from ..application.front_document import bring_to_front
from ..application.qt import translate
from ..scene.camera_flight import fly_to, look_direction, visible_height
from ..scene.document_views import view_of
from ..scene.drawn_triangles import drawn_triangles
from .label_node import MARK, LabelNode
from .map_labels import LabelContent, MapLabel


@dataclass(frozen=True)
class PlacedWall:
    """A wall that can be flown to.

    Attributes
    ----------
    value : float, mm
        Its thickness, as the mark tells it.
    places : list of pairs of array_like of shape (3,), mm
        Both ends of the line through it, wherever the part stands, in the coordinates of the document.
    """

    value: float
    places: list


class WallFlight:
    """Flies to one wall after the other, in a view that is brought to the front; only the last one is marked.

    Attributes
    ----------
    target : ndarray of shape (3,), mm, or None
        The end of the wall that is looked at.

    Notes
    -----
    The mark is a node of the view's own scene graph: it is neither saved nor picked, and there need not be a map.
    """

    def __init__(self):
        self._mark = self.target = None

    def fly(self, document, wall, diagonal, unit):
        """Fly to a PlacedWall of a part, whose diagonal is in mm, and mark it.

        Returns
        -------
        bool
            False if something stands before the wall from wherever one looks. True also without a 3D view.
        """
        self.clear()
        view = view_of(document)
        if view is None:
            return True
        bring_to_front(document)
        root = view.getSceneGraph()
        sight = best_sight(Scene(drawn_triangles(root)), wall.places, look_direction(view))
        self._mark, text = LabelNode(view, MARK), unit.text(wall.value)
        ends = np.array([[sight.target, sight.other]], dtype=float)
        label = MapLabel(text, ends, has_line=True, is_always_shown=True)
        self._mark.show(LabelContent((text, ends.tobytes()), [label], np.empty((0, 3))))
        fly_to(view, sight.target, sight.direction, visible_height(wall.value, diagonal))
        self.target = sight.target
        return sight.is_free

    def clear(self):
        """Remove the mark."""
        mark, self._mark, self.target = self._mark, None, None
        if mark is not None:
            mark.remove()


def hidden_sentence():
    """What people read where a wall is seen from nowhere."""
    return translate("ThinPart", "Something stands before this wall from every side: the mark shows where it is. Hide what "
                                 "covers it, or cut the view open with the clipping plane of the View menu.")

# SPDX-License-Identifier: LGPL-2.1-or-later
"""What two parts do not have in common, in the 3D views: coloured on the one, the other's as a translucent ghost."""

import numpy as np
from pivy import coin

from ..scene.coin_arrays import fill_colours, fill_points, fill_rows, set_matrix
from ..scene.coin_nodes import (
    add_children,
    colour_per_vertex,
    flat_colours,
    painted,
    put_into,
    take_out_of,
    unpickable,
)
from .soft_light import SoftLight

OWN, OTHERS = (0.90, 0.36, 0.0), (0.0, 0.40, 0.85)
"""Colours of what only the part has, and of what only the other one has; they differ for all who see colours."""

_SAME, _EDGE = (0.72, 0.72, 0.74), (0.2, 0.2, 0.22)
_SAME_OPACITY, _GHOST_OPACITY = 0.4, 0.5


class DifferenceNodes:
    """Nodes in the scene graphs of all views of a document, which are neither saved nor picked.

    Parameters
    ----------
    part, other : dict
        See `shown_difference`.
    matrices : ndarray of shape (p, 4, 4)
        From the coordinates of the part to each of its occurrences.
    is_alone : bool
        Whether the objects of the part are hidden; otherwise they are covered.
    """

    def __init__(self, part, other, matrices, is_alone):
        self._root, content = coin.SoSeparator(), coin.SoSeparator()
        self._light = SoftLight()  # its nodes live as long as Python references them
        surfaces = coin.SoSeparator()
        offset = coin.SoPolygonOffset()
        offset.factor = offset.units = 1.0 if is_alone else -1.0  # edges stay visible
        add_children(surfaces, self._light.root, offset, colour_per_vertex())
        apart = part["is_apart"]
        # What is opaque comes first, so that it is seen through the rest.
        for side, which, rgb, opacity in ((part, apart, OWN, 1.0), (other, other["is_apart"], OTHERS, _GHOST_OPACITY),
                                          (part, ~apart, _SAME, _SAME_OPACITY if is_alone else 1.0)):
            if which.any():
                surfaces.addChild(_surface(side["corners"][which], side["normals"][which], rgb, opacity))
        add_children(content, flat_colours(), surfaces, _edges(part["lines"], _EDGE), _edges(other["lines"], OTHERS))
        self._root.addChild(unpickable())
        for matrix in matrices:
            placed, transform = coin.SoSeparator(), coin.SoMatrixTransform()
            set_matrix(transform, matrix)
            add_children(placed, transform, content)
            self._root.addChild(placed)

    def show_in(self, scenes):
        """Be part of scene graphs: iterable of pivy.coin.SoSeparator."""
        for scene in scenes:
            put_into(scene, self._root)

    def leave(self, scenes):
        """Be part of scene graphs no more."""
        for scene in scenes:
            take_out_of(scene, self._root)


def _surface(corners, normals, rgb, opacity):
    node, packed, directions = coin.SoSeparator(), coin.SoPackedColor(), coin.SoNormal()
    points, facets = coin.SoCoordinate3(), coin.SoIndexedFaceSet()
    count = 3 * len(corners)
    fill_colours(packed.orderedRGBA, np.broadcast_to(np.round(255.0 * np.array(rgb)), (count, 3)), opacity)
    fill_points(directions.vector, normals.reshape(-1, 3))
    fill_points(points.point, corners.reshape(-1, 3))
    fill_rows(facets.coordIndex, np.arange(count).reshape(-1, 3))
    add_children(node, packed, directions, points, facets)
    return node


def _edges(lines, rgb):
    node, style, points, rows = coin.SoSeparator(), coin.SoDrawStyle(), coin.SoCoordinate3(), coin.SoIndexedLineSet()
    style.lineWidth = 1.5
    fill_points(points.point, lines.reshape(-1, 3))
    fill_rows(rows.coordIndex, np.arange(2 * len(lines)).reshape(-1, 2))
    add_children(node, painted(rgb), style, points, rows)
    return node

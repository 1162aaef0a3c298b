# SPDX-License-Identifier: LGPL-2.1-or-later
"""Element sizes on the surface of a part, its poor elements, and its shell, in the 3D views."""

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
from ..view3d.soft_light import SoftLight

_POOR = (0.85, 0.0, 0.35)
_EDGES = (0.15, 0.15, 0.15)
_SIDES = (0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2)


class SizeNodes:
    """Nodes in the scene graphs of all views of a document, which are neither saved nor picked.

    Parameters
    ----------
    matrix : ndarray of shape (4, 4), mm
        From the coordinates of the sizes to those of the document.
    """

    def __init__(self, matrix):
        self._root = coin.SoSeparator()
        transform = coin.SoMatrixTransform()
        set_matrix(transform, matrix)
        add_children(self._root, unpickable(), transform)
        self._facets = self._poor = self._light = None

    def show_in(self, scenes):
        """Be part of scene graphs: iterable of pivy.coin.SoSeparator."""
        for scene in scenes:
            put_into(scene, self._root)

    def leave(self, scenes):
        """Be part of scene graphs no more."""
        for scene in scenes:
            take_out_of(scene, self._root)

    def show_sizes(self, corners, colours, normals, has_edges=False):
        """Colour the surface, or a shell, in the soft light of thickness maps.

        Parameters
        ----------
        corners : ndarray of shape (m, 3, 3), mm
        colours : ndarray of shape (m, 3, 3), uint8
        normals : ndarray of shape (m, 3, 3)
            Unit vectors.
        has_edges : bool
            Whether the edges of the facets are drawn.
        """
        self.hide_sizes()
        node = self._facets = coin.SoSeparator()
        offset = coin.SoPolygonOffset()  # before the surface itself, behind its own edges
        offset.factor = offset.units = 1.0 if has_edges else -1.0
        packed = coin.SoPackedColor()
        fill_colours(packed.orderedRGBA, colours)
        surface, directions = coin.SoSeparator(), coin.SoNormal()
        fill_points(directions.vector, normals.reshape(-1, 3))
        self._light = SoftLight()
        add_children(surface, self._light.root, directions, offset, colour_per_vertex(), packed)
        triangles = np.arange(3 * len(corners)).reshape(-1, 3)
        _add_triangles(surface, corners.reshape(-1, 3), triangles)
        add_children(node, flat_colours(), surface)
        if has_edges:
            style, even = coin.SoDrawStyle(), coin.SoMaterialBinding()
            style.style, even.value = coin.SoDrawStyle.LINES, coin.SoMaterialBinding.OVERALL
            add_children(node, painted(_EDGES), even, style)
            _add_triangles(node, corners.reshape(-1, 3), triangles)
        self._root.addChild(node)

    def hide_sizes(self):
        """Remove the colours."""
        self._remove(self._facets)
        self._facets = None

    def show_poor(self, corners):
        """Show tetrahedra through the surface: ndarray of shape (k, 4, 3), mm; an empty sequence for none."""
        self._remove(self._poor)
        self._poor = None
        if not len(corners):
            return
        node = self._poor = coin.SoAnnotation()
        style = coin.SoDrawStyle()
        style.lineWidth, style.style = 2.0, coin.SoDrawStyle.LINES  # seen also where an element is a pixel wide
        triangles = (4 * np.arange(len(corners))[:, None, None] + np.array(_SIDES)).reshape(-1, 3)
        add_children(node, flat_colours(), painted(_POOR))
        _add_triangles(node, corners.reshape(-1, 3), triangles)
        node.addChild(style)
        _add_triangles(node, corners.reshape(-1, 3), triangles)
        self._root.addChild(node)

    def _remove(self, node):
        if node is not None:
            take_out_of(self._root, node)


def _add_triangles(node, points, triangles):
    coordinates, faces = coin.SoCoordinate3(), coin.SoIndexedFaceSet()
    fill_points(coordinates.point, points)
    fill_rows(faces.coordIndex, triangles)
    add_children(node, coordinates, faces)

"""Element sizes on the surface of a part, its poor elements, and its shell, in the 3D views."""

import numpy as np
from pivy import coin

from ..scene.coin_arrays import fill_numbers, fill_points

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
        unpicked = coin.SoPickStyle()
        unpicked.style = coin.SoPickStyle.UNPICKABLE
        transform = coin.SoMatrixTransform()
        transform.matrix = coin.SbMatrix(*map(float, matrix.T.ravel()))
        for each in (unpicked, transform):
            self._root.addChild(each)
        self._facets = self._poor = None

    def show_in(self, scenes):
        """Be part of scene graphs: iterable of pivy.coin.SoSeparator."""
        for scene in scenes:
            if scene.findChild(self._root) < 0:
                scene.addChild(self._root)

    def leave(self, scenes):
        """Be part of scene graphs no more."""
        for scene in scenes:
            if scene.findChild(self._root) >= 0:
                scene.removeChild(self._root)

    def show_sizes(self, corners, colours, has_edges=False):
        """Colour the surface, or a shell.

        Parameters
        ----------
        corners : ndarray of shape (m, 3, 3), mm
        colours : ndarray of shape (m, 3, 3), uint8
        has_edges : bool
            Whether the edges of the facets are drawn.
        """
        self.hide_sizes()
        node = self._facets = coin.SoSeparator()
        light = coin.SoLightModel()
        light.model = coin.SoLightModel.BASE_COLOR
        offset = coin.SoPolygonOffset()  # before the surface itself, behind its own edges
        offset.factor = offset.units = 1.0 if has_edges else -1.0
        binding = coin.SoMaterialBinding()
        binding.value = coin.SoMaterialBinding.PER_VERTEX_INDEXED
        packed = coin.SoPackedColor()
        red, green, blue = colours.reshape(-1, 3).astype(np.uint32).T
        fill_numbers(packed.orderedRGBA, red << 24 | green << 16 | blue << 8 | np.uint32(255), np.uint32)
        for each in (light, offset, binding, packed):
            node.addChild(each)
        triangles = np.arange(3 * len(corners)).reshape(-1, 3)
        _add_triangles(node, corners.reshape(-1, 3), triangles)
        if has_edges:
            paint, style, even = coin.SoBaseColor(), coin.SoDrawStyle(), coin.SoMaterialBinding()
            paint.rgb, style.style, even.value = _EDGES, coin.SoDrawStyle.LINES, coin.SoMaterialBinding.OVERALL
            for each in (paint, even, style):
                node.addChild(each)
            _add_triangles(node, corners.reshape(-1, 3), triangles)
        self._root.addChild(node)

    def hide_sizes(self):
        """Remove the colours."""
        self._remove(self._facets)
        self._facets = None

    def show_poor(self, corners):
        """Show tetrahedra through the surface: ndarray of shape (k, 4, 3), mm."""
        self.hide_poor()
        if not len(corners):
            return
        node = self._poor = coin.SoAnnotation()
        light = coin.SoLightModel()
        light.model = coin.SoLightModel.BASE_COLOR
        paint = coin.SoBaseColor()
        paint.rgb = _POOR
        style = coin.SoDrawStyle()
        style.lineWidth, style.style = 2.0, coin.SoDrawStyle.LINES  # seen also where an element is a pixel wide
        triangles = (4 * np.arange(len(corners))[:, None, None] + np.array(_SIDES)).reshape(-1, 3)
        for each in (light, paint):
            node.addChild(each)
        _add_triangles(node, corners.reshape(-1, 3), triangles)
        node.addChild(style)
        _add_triangles(node, corners.reshape(-1, 3), triangles)
        self._root.addChild(node)

    def hide_poor(self):
        """Remove them."""
        self._remove(self._poor)
        self._poor = None

    def _remove(self, node):
        if node is not None and self._root.findChild(node) >= 0:
            self._root.removeChild(node)


def _add_triangles(node, points, triangles):
    coordinates, faces = coin.SoCoordinate3(), coin.SoIndexedFaceSet()
    fill_points(coordinates.point, points)
    rows = np.full((len(triangles), 4), -1, dtype=np.int32)
    rows[:, :3] = triangles
    fill_numbers(faces.coordIndex, rows.ravel())
    node.addChild(coordinates)
    node.addChild(faces)

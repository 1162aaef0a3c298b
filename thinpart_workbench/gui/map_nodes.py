"""The facets and edges of thickness maps as nodes of a 3D scene."""

import numpy as np
from pivy import coin

from .array_fields import fill_numbers, fill_points

EDGE_COLOUR = (0.12, 0.12, 0.14)

_CHUNK = 4096
"""Facets that are looked at together when Coin asks what is under the cursor: it does so at every move."""

_AT_ONCE = 8
"""Such chunks that appear together. Coin prepares a node when it draws it first, 30,000 facets in about 25 ms."""


class MapNodes:
    """Nodes of the parts of one thickness object.

    Facets have no corners in common, and each corner has a colour: so Coin draws them out of buffers of the
    graphics card, twice as fast as with a colour per facet. A part at several places is there once.

    Attributes
    ----------
    facets, edges : pivy.coin.SoSeparator
    """

    def __init__(self):
        self.facets, self.edges = coin.SoSeparator(), coin.SoSeparator()
        self._moved = coin.SoMatrixTransform()
        self._parts = []  # (map, its SoPackedColor)
        # Nodes that Python has made live as long as Python knows them, in a scene or not.
        self._groups = []  # (group of a part, its nodes with facets)
        self._withheld = []  # (group, node) of what is still to appear
        self._painted = None
        light = coin.SoLightModel()
        light.model = coin.SoLightModel.BASE_COLOR  # as the colour bar shows them
        behind = coin.SoPolygonOffset()  # the edges
        behind.factor, behind.units = 2.0, 2.0
        binding = coin.SoMaterialBinding()
        binding.value = coin.SoMaterialBinding.PER_VERTEX_INDEXED
        dark = coin.SoBaseColor()
        dark.rgb = EDGE_COLOUR
        style = coin.SoDrawStyle()
        style.lineWidth = 1.5
        unpicked = coin.SoPickStyle()
        unpicked.style = coin.SoPickStyle.UNPICKABLE
        self._content = []
        for root, nodes in ((self.facets, (light, behind, binding)),
                            (self.edges, (light, unpicked, dark, style))):
            for node in (*nodes, self._moved):
                root.addChild(node)
            self._content.append(coin.SoGroup())
            root.addChild(self._content[-1])

    def show(self, parts):
        """Replace what is shown by the maps of parts, without colours yet.

        Parameters
        ----------
        parts : list of MappedPart
        """
        for group in self._content:
            group.removeAllChildren()
        self._parts, self._painted = [], None
        self._groups, self._withheld = [], []
        for part in parts:
            colour, facets, nodes = _facets(part.map)
            lines = _lines(part.map)
            self._groups.append((facets, nodes))
            self._parts.append((part.map, colour))
            for matrix in part.places:
                placed = matrix.copy()
                placed[:3, 3] += matrix[:3, :3] @ part.map.origin
                for group, node in zip(self._content, (facets, lines)):
                    place = coin.SoSeparator()
                    transform = coin.SoMatrixTransform()
                    set_matrix(transform, placed)
                    place.addChild(transform)
                    place.addChild(node)
                    group.addChild(place)

    def withhold(self):
        """Take all facets away, until `show_more` has brought back the last of them."""
        self._withheld = [(group, node) for group, nodes in self._groups for node in nodes]
        for group, node in self._withheld:
            group.removeChild(node)

    def show_more(self):
        """Bring some facets back; whether there are more."""
        some, self._withheld = self._withheld[:_AT_ONCE], self._withheld[_AT_ONCE:]
        for group, node in some:
            group.addChild(node)
        return bool(self._withheld)

    def colour(self, colours, opacity=1.0):
        """Colour all facets.

        Parameters
        ----------
        colours : ThicknessColours
        opacity : float
            From 0 for nothing to be seen to 1.
        """
        if (colours, opacity) == self._painted:
            return  # FreeCAD tells of every property, also of those that did not change
        self._painted = colours, opacity
        alpha = np.uint32(round(255 * opacity))
        for number, (shown, node) in enumerate(self._parts):
            red, green, blue = colours.of_facets(number, shown).astype(np.uint32).T
            packed = red << 24 | green << 16 | blue << 8 | alpha
            fill_numbers(node.orderedRGBA, np.repeat(packed, 3), np.uint32)

    def move(self, matrix):
        """Show everything moved: ndarray of shape (4, 4)."""
        set_matrix(self._moved, matrix)


def set_matrix(transform, matrix):
    """Put a matrix for columns, ndarray of shape (4, 4), into an SoMatrixTransform, which has it for rows."""
    wanted = coin.SbMatrix(*(float(each) for each in matrix.T.ravel()))
    if not transform.matrix.getValue().equals(wanted, 0.0):
        transform.matrix = wanted


def _facets(shown):
    group, colour = coin.SoGroup(), coin.SoPackedColor()
    points = coin.SoCoordinate3()
    fill_points(points.point, np.take(shown.points, shown.facets.ravel(), axis=0, mode="clip"))
    group.addChild(colour)
    group.addChild(points)
    rows = np.full((shown.count, 4), -1, dtype=np.int32)
    rows[:, :3] = np.arange(3 * shown.count).reshape(-1, 3)
    nodes = []
    for first in range(0, shown.count, _CHUNK):
        facets = coin.SoIndexedFaceSet()
        fill_numbers(facets.coordIndex, rows[first:first + _CHUNK].ravel())
        group.addChild(facets)
        nodes.append(facets)
    return colour, group, nodes


def _lines(shown):
    group, points, lines = coin.SoGroup(), coin.SoCoordinate3(), coin.SoIndexedLineSet()
    sides = shown.outline
    used, rows = np.unique(sides, return_inverse=True)
    fill_points(points.point, shown.points[used])
    indices = np.full((len(sides), 3), -1, dtype=np.int32)
    indices[:, :2] = rows.reshape(-1, 2)
    fill_numbers(lines.coordIndex, indices.ravel())
    group.addChild(points)
    group.addChild(lines)
    return group

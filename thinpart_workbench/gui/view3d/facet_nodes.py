# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scene graph nodes for the facets and edges of thickness maps."""

import numpy as np
from pivy import coin

from ...core.maps.level_cuts import cut_at_levels
from ...core.mesh.thinned_facets import thinned_facets
from ...core.rigid_transform import rigid_transform, rotation, transform_points
from ..scene.coin_arrays import fill_colours, fill_points, fill_rows, set_matrix
from ..scene.coin_nodes import add_children, colour_per_vertex, flat_colours, painted, unpickable
from .soft_light import SoftLight

EDGE_COLOUR, CONTEXT_COLOUR = (0.12, 0.12, 0.14), (0.5, 0.5, 0.52)
"""Of edges; and while only some faces are drawn, so that those of the others are seen on any background."""

_CHUNK = 4096
"""Facets per node, which Coin tests together when it picks; it picks at every mouse move."""

MANY = 100_000
"""Facets, those of all placements counted, from which on fewer are drawn while the view moves."""

FEW = 40_000
"""About so many: without a graphics card, a frame then takes 40 ms instead of 100 with 250,000."""

_AT_ONCE = 8
"""Chunks added to the scene together. Coin prepares a node when it first draws it: 30,000 facets take about 25 ms."""


class FacetNodes:
    """Nodes of the parts of one thickness object.

    Facets share no vertices and each vertex has a colour: Coin then draws from vertex buffers, twice as fast as
    with a colour per facet. A part with several placements is stored once.

    Attributes
    ----------
    facets, edges : pivy.coin.SoSeparator

    Parameters
    ----------
    offset : float, optional
        Polygon offset of the facets, behind which the edges stay visible.
    """

    def __init__(self, offset=2.0):
        self.facets, self.edges = coin.SoSeparator(), coin.SoSeparator()
        self._moved = coin.SoMatrixTransform()
        self._parts = []  # (map, its SoPackedColor)
        # Nodes made in Python live as long as Python references them, in a scene or not.
        self._groups = []  # (group of a part, its facet nodes)
        self._withheld = []  # (group, node) of the facet nodes not yet in the scene
        self._details = []  # switch of a part between all facets and few
        self._normals = []  # of the corners of a part with many facets, until few are made of them
        self._few = []  # (facets that are kept, SoPackedColor) of each part, once they are needed
        self._cut = []  # `_CutFacets` of each part
        self._isolated = None  # faces that alone are drawn
        self._current_colours = None
        light = flat_colours()  # the same colours as in the colour bar, before `SoftLight`
        self._light = SoftLight()
        behind = coin.SoPolygonOffset()
        behind.factor, behind.units = offset, offset
        self._edge_colour = painted(EDGE_COLOUR)
        style = coin.SoDrawStyle()
        style.lineWidth = 1.5
        self._content = []
        for root, nodes in ((self.facets, (light, self._light.root, behind, colour_per_vertex())),
                            (self.edges, (light, unpickable(), self._edge_colour, style))):
            content = coin.SoSwitch()
            content.whichChild = coin.SO_SWITCH_ALL
            self._content.append(content)
            add_children(root, *nodes, self._moved, content)

    def show(self, parts):
        """Show the maps of a list of MappedPart instead of the current ones; call `colour` afterwards."""
        for group in self._content:
            group.removeAllChildren()
        self._parts, self._cut, self._current_colours = [], [], None
        self._groups, self._withheld, self._details, self._normals, self._few = [], [], [], [], []
        self._isolated = None
        self._edge_colour.rgb = EDGE_COLOUR
        self._drawn = sum(part.map.count * len(part.matrices) for part in parts)
        for part in parts:
            normals = corner_normals(part.map)
            colour, facets, nodes = _drawn_facets(part.map.points, part.map.facets, normals)
            if self._drawn >= MANY:
                self._normals.append(normals.astype(np.float32))
            lines = _lines(part.map)
            cut = _CutFacets(normals.astype(np.float32))
            facets.addChild(cut.root)
            self._cut.append(cut)
            self._groups.append((facets, nodes))
            self._parts.append((part.map, colour))
            detail = coin.SoSwitch()
            detail.addChild(facets)
            detail.whichChild = 0
            self._details.append(detail)
            for matrix in part.matrices:
                placed = rigid_transform(rotation(matrix), transform_points(matrix, part.map.origin))
                for group, node in zip(self._content, (detail, lines)):
                    separator = coin.SoSeparator()
                    transform = coin.SoMatrixTransform()
                    set_matrix(transform, placed)
                    add_children(separator, transform, node)
                    group.addChild(separator)

    def withhold(self):
        """Remove all facets from the scene; `show_more` adds them again in groups."""
        self._withheld = [(group, node) for group, nodes in self._groups for node in nodes]
        for group, node in self._withheld:
            group.removeChild(node)

    @property
    def withheld(self):
        """Number of groups of facets that `show_more` has yet to add."""
        return len(self._withheld)

    def show_more(self):
        """Add the next withheld facets; return whether there are more."""
        batch, self._withheld = self._withheld[:_AT_ONCE], self._withheld[_AT_ONCE:]
        for group, node in batch:
            group.addChild(node)
        return bool(self._withheld)

    def colour(self, colours, opacity=1.0):
        """Colour all facets.

        Parameters
        ----------
        colours : ThicknessColours
        opacity : float
            From 0 (invisible) to 1.
        """
        if (colours, opacity) == self._current_colours:
            return  # FreeCAD reports properties even when their value did not change
        self._current_colours = colours, opacity
        for number, (shown, node) in enumerate(self._parts):
            of_corners = colours.of_corners(number, shown)
            fill_colours(node.orderedRGBA, of_corners, opacity)
            if self._few:
                kept, few = self._few[number]
                fill_colours(few.orderedRGBA, of_corners[kept], opacity)
            cut = self._cut[number]
            before = cut.facets
            if cut.show(colours.compared(number, shown), colours.levels):
                self._draw_facets(number, np.concatenate([before, cut.facets]))
            if len(cut.facets):
                fill_colours(cut.colour.orderedRGBA, colours.of_corners(number, shown, cut.cuts), opacity)

    def shade(self, is_shaded):
        """Light the facets, or show flat colours."""
        self._light.switch(is_shaded)

    def isolate(self, faces=None):
        """Draw only the facets of some B-Rep faces, and all edges.

        Parameters
        ----------
        faces : dict or None
            Sets of face numbers, by part number; None draws everything again.
        """
        self._edge_colour.rgb = EDGE_COLOUR if faces is None else CONTEXT_COLOUR
        self._isolated = faces
        self.coarsen(False)
        for number, (shown, _) in enumerate(self._parts):
            self._draw_facets(number, np.arange(0, shown.count, _CHUNK))

    def _draw_facets(self, number, changed):
        """Draw the facets of a part that are to be drawn, in those nodes that have one that changed."""
        (shown, _), (_, nodes), cut = self._parts[number], self._groups[number], self._cut[number]
        drawn = np.ones(shown.count, bool) if self._isolated is None else np.isin(
            shown.face, np.fromiter(self._isolated.get(number, ()), dtype=np.int64))
        cut.draw(drawn)
        drawn[cut.facets] = False
        for chunk in np.unique(changed // _CHUNK):
            first = chunk * _CHUNK
            _fill_facets(nodes[chunk], first + np.flatnonzero(drawn[first:first + _CHUNK]))

    def prepare_to_coarsen(self):
        """Make the few facets that are drawn while the view moves, if there are many."""
        if self._few or self._drawn < MANY or self._current_colours is None:
            return
        for (shown, _), detail, normals in zip(self._parts, self._details, self._normals):
            colour, facets, kept = _few_facets(shown, normals, max(1000, FEW * shown.count // self._drawn))
            detail.addChild(facets)
            self._few.append((kept, colour))
        self._normals = []
        now, self._current_colours = self._current_colours, None
        self.colour(*now)

    def coarsen(self, is_coarse):
        """Draw few facets instead of many, or all again. Without effect on a map that is drawn quickly anyway."""
        if is_coarse and self._isolated is None and not self._withheld:
            self.prepare_to_coarsen()
        child = 1 if is_coarse and self._few and self._isolated is None else 0
        for detail in self._details:
            if detail.whichChild.getValue() != child:
                detail.whichChild = child

    @property
    def is_coarse(self):
        """Whether few facets are drawn instead of many."""
        return any(detail.whichChild.getValue() for detail in self._details)

    @property
    def is_covered(self):
        """Whether nothing is drawn; see `cover`."""
        return self._content[0].whichChild.getValue() == coin.SO_SWITCH_NONE

    def cover(self, is_covered):
        """Draw nothing, because something else is drawn in the same place; or draw all again."""
        for content in self._content:
            content.whichChild = coin.SO_SWITCH_NONE if is_covered else coin.SO_SWITCH_ALL

    def move(self, matrix):
        """Set the transform of all parts: ndarray of shape (4, 4)."""
        set_matrix(self._moved, matrix)


class _CutFacets:
    """Facets on which the colour changes in a step, drawn as pieces that each have one colour, or change smoothly.

    Attributes
    ----------
    root : pivy.coin.SoSeparator
    colour : pivy.coin.SoPackedColor
        Of the corners of the pieces.
    facets : ndarray of shape (n,), int64
        The facets that are not to be drawn themselves.
    cuts : LevelCuts or None

    Parameters
    ----------
    normals : ndarray of shape (m, 3, 3)
        Of the corners of all facets, see `corner_normals`.
    """

    def __init__(self, normals):
        self._normals_of_facets = normals
        self.root, self.colour = coin.SoSeparator(), coin.SoPackedColor()
        self._points, self._normals, self._pieces = coin.SoCoordinate3(), coin.SoNormal(), coin.SoIndexedFaceSet()
        add_children(self.root, self.colour, self._points, self._normals, self._pieces)
        self.facets, self.cuts = np.empty(0, dtype=np.int64), None
        self._shown_at = None, ()
        self._pieces.coordIndex.setNum(0)

    def show(self, shown, levels):
        """Cut a map at its levels; returns whether that changed anything. Call `draw` afterwards."""
        if shown is self._shown_at[0] and levels == self._shown_at[1]:
            return False
        had, self._shown_at = len(self.facets), (shown, levels)
        self.cuts = cut_at_levels(shown, levels)
        self.facets = np.unique(self.cuts.facet)
        if not had and not len(self.facets):
            return False
        fill_points(self._points.point, self.cuts.at_corners(shown.corners).reshape(-1, 3))
        fill_points(self._normals.vector, self.cuts.at_corners(self._normals_of_facets).reshape(-1, 3))
        return True

    def draw(self, drawn):
        """Draw the pieces of some facets: ndarray of shape (m,), bool."""
        if self.cuts is not None:
            _fill_facets(self._pieces, np.flatnonzero(drawn[self.cuts.facet]))


def _few_facets(shown, normals, most):
    """SoPackedColor and group of about as many facets of a map as are wanted, and which they are."""
    points, facets, kept = thinned_facets(shown.points, shown.facets.astype(np.int64), most)
    colour, group, _ = _drawn_facets(points, facets, normals[kept])
    return colour, group, kept


def _drawn_facets(places, corners, normals_of_corners):
    """SoPackedColor, group and facet nodes."""
    group, colour = coin.SoGroup(), coin.SoPackedColor()
    points = coin.SoCoordinate3()
    fill_points(points.point, np.take(places, corners.ravel(), axis=0, mode="clip"))
    normals = coin.SoNormal()
    fill_points(normals.vector, normals_of_corners.reshape(-1, 3))
    add_children(group, colour, points, normals)
    nodes = []
    for first in range(0, len(corners), _CHUNK):
        facets = coin.SoIndexedFaceSet()
        _fill_facets(facets, np.arange(first, min(first + _CHUNK, len(corners))))
        group.addChild(facets)
        nodes.append(facets)
    return colour, group, nodes


def _fill_facets(node, facets):
    """Draw facets by their numbers, each with three vertices of its own."""
    fill_rows(node.coordIndex, 3 * facets[:, None] + np.arange(3))


def corner_normals(shown):
    """Normals of the corners of the facets of a ThicknessMap, smooth within each B-Rep face and sharp between faces.

    Returns
    -------
    ndarray of shape (m, 3, 3), float64
        Facet, corner, coordinate: the mean of the face's facets at that point, by area.
    """
    vectors = shown.normals * shown.areas[:, None]
    key = shown.face.astype(np.int64)[:, None] * len(shown.points) + shown.facets
    _, corner = np.unique(key, return_inverse=True)
    corner = corner.reshape(-1)
    sums = np.stack([np.bincount(corner, np.repeat(vectors[:, axis], 3)) for axis in range(3)], axis=1)
    lengths = np.linalg.norm(sums, axis=1)[corner]
    found = sums[corner] / np.maximum(lengths, np.finfo(float).tiny)[:, None]
    return np.where(lengths[:, None] > 0.0, found, np.repeat(shown.normals, 3, axis=0)).reshape(-1, 3, 3)


def _lines(shown):
    group, points, lines = coin.SoGroup(), coin.SoCoordinate3(), coin.SoIndexedLineSet()
    used, rows = np.unique(shown.outline, return_inverse=True)
    fill_points(points.point, shown.points[used])
    fill_rows(lines.coordIndex, rows.reshape(-1, 2))
    add_children(group, points, lines)
    return group

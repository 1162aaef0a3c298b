# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scene graph nodes of a section: what is cut off, the coloured edge of the cut, and the hatched material."""

import numpy as np
from pivy import coin

from ...core.maps.level_cuts import section_at_levels
from ...core.maps.map_section import map_section
from ...core.rigid_transform import inverse, transform_points
from ..scene.coin_arrays import fill_colours, fill_points, fill_rows
from ..scene.coin_nodes import add_children, colour_per_vertex, flat_colours, painted
from ..scene.view_pixels import pixels_drawn

_MATERIAL = (0.86, 0.86, 0.87)
_PITCH = 6.0
"""Pixels from one line of the hatch to the next, measured along the screen; it is kept between this and twice as much while
the view is zoomed, so that the lines stay where they are on the part."""

_SIZE = 32
_EDGE_WIDTH = 5.0


class SectionNodes:
    """Cuts the facets and edges of a map, and draws what is seen in the cut.

    Attributes
    ----------
    clips : list of pivy.coin.SoClipPlane
        To be put before the facets and before the edges.
    root : pivy.coin.SoSwitch
        The cut itself, which the plane does not cut, in the coordinates of the document.
    """

    def __init__(self):
        self.clips = [coin.SoClipPlane(), coin.SoClipPlane()]
        self.root = coin.SoSwitch()
        content = coin.SoSeparator()
        self._edge_points, self._edge_colours = coin.SoCoordinate3(), coin.SoPackedColor()
        self._edges, self._pieces = coin.SoIndexedLineSet(), coin.SoIndexedFaceSet()
        self._points, self._places = coin.SoCoordinate3(), coin.SoTextureCoordinate2()
        edges, material = coin.SoSeparator(), coin.SoSeparator()
        width = coin.SoDrawStyle()
        width.lineWidth = _EDGE_WIDTH
        add_children(edges, width, colour_per_vertex(), self._edge_points, self._edge_colours, self._edges)
        behind, hatch = coin.SoPolygonOffset(), coin.SoTexture2()
        behind.factor, behind.units = 1.0, 1.0  # the edge stays visible
        hatch.model = coin.SoTexture2.MODULATE
        hatch.image.setValue(coin.SbVec2s(_SIZE, _SIZE), 1, _hatch().tobytes())
        fine, self._scale, fit = coin.SoComplexity(), coin.SoTexture2Transform(), coin.SoCallback()
        fine.textureQuality = 1.0  # smooth also where it is drawn smaller
        self._scale.enableNotify(False)  # set during rendering, which must not trigger another rendering
        self._middle, self._fit = None, self._fit_hatch  # pivy does not hold a reference to it
        fit.setCallback(self._fit)
        material.renderCaching = coin.SoSeparator.OFF
        add_children(material, behind, painted(_MATERIAL), fine, hatch, fit, self._scale, self._points, self._places,
                     self._pieces)
        add_children(content, flat_colours(), material, edges)
        self.root.addChild(content)
        self.hide()

    def hide(self):
        """Draw the map whole."""
        self.root.whichChild = coin.SO_SWITCH_NONE
        for clip in self.clips:
            clip.on = False

    def show(self, plane, parts, moved, colours, faces=None):
        """Cut the parts.

        Parameters
        ----------
        plane : SectionPlane
            In the coordinates of the document.
        parts : list of MappedPart
        moved : ndarray of shape (4, 4)
            From where the parts were measured to where they are.
        colours : ThicknessColours
        faces : dict or None
            The B-Rep faces that are drawn, as `FacetNodes.isolate` has them; material is not filled then.
        """
        ends, edge_colours, material = [], [], []
        for number, part in enumerate(parts):
            drawn = None if faces is None else np.isin(part.map.face, np.fromiter(faces.get(number, ()), dtype=np.int64))
            for matrix in part.matrices:
                stands = moved @ matrix
                cut = map_section(colours.compared(number, part.map), plane.moved(inverse(stands)), drawn)
                cut = section_at_levels(cut, colours.levels)
                ends.append(transform_points(stands, cut.ends.reshape(-1, 3)))
                edge_colours.append(colours.of_corners(number, part.map, cut).reshape(-1, 3))
                if faces is None:
                    material.append(transform_points(stands, cut.material.reshape(-1, 3)))
        self._show_edges(np.concatenate(ends), np.concatenate(edge_colours))
        self._show_material(np.concatenate(material or [np.empty((0, 3))]), np.array(plane.normal))
        for clip in self.clips:
            clip.plane = coin.SbPlane(coin.SbVec3f(*(-float(part) for part in plane.normal)), -float(plane.offset))
            clip.on = True
        self.root.whichChild = coin.SO_SWITCH_ALL

    def _fit_hatch(self, _data, action):
        """Make the hatch as fine on the screen at any zoom."""
        size = pixels_drawn(action)
        if size is None or self._middle is None:
            return
        volume = coin.SoViewVolumeElement.get(action.getState())
        # What a circle of this share of the picture's height measures on the part.
        middle = coin.SbVec3f(*map(float, self._middle))
        pitch = volume.getWorldToScreenScale(middle, _PITCH / size[1])
        if not np.isfinite(pitch) or pitch <= 0.0:
            return
        pitch = 2.0 ** np.ceil(np.log2(pitch))
        self._scale.scaleFactor = (1.0 / pitch, 1.0 / pitch)

    def _show_edges(self, points, colours):
        fill_points(self._edge_points.point, points)
        fill_colours(self._edge_colours.orderedRGBA, colours)
        fill_rows(self._edges.coordIndex, np.arange(len(points)).reshape(-1, 2))

    def _show_material(self, points, normal):
        across = np.cross(normal, np.eye(3)[np.argmin(np.abs(normal))])
        across /= np.linalg.norm(across)
        flat = np.stack([points @ across, points @ np.cross(normal, across)], axis=1)
        fill_points(self._points.point, points)
        places = flat - (flat.min(axis=0) if len(flat) else 0.0)
        self._middle = points.mean(axis=0) if len(points) else None
        self._places.point.setNum(0)
        if len(places):
            self._places.point.setValues(0, len(places), places.tolist())
        fill_rows(self._pieces.coordIndex, np.arange(len(points)).reshape(-1, 4))


def _hatch():
    """One square of a hatch at 45 degrees, with soft edges: ndarray of shape (n, n), uint8."""
    row, column = np.mgrid[:_SIZE, :_SIZE]
    off = np.abs((row + column) % _SIZE - 0.5 * (_SIZE - 1)) / _SIZE  # from the middle of the line
    return np.round(255.0 - 125.0 * np.clip(1.0 - (off - 0.07) / 0.06, 0.0, 1.0)).astype(np.uint8)

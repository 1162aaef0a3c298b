# SPDX-License-Identifier: LGPL-2.1-or-later
"""The first, coarse colours of a document's parts, which are seen until their thickness map is there."""

from dataclasses import replace

import FreeCAD as App
from pivy import coin

from ...api.window.open_parts import SourcesState
from ...core.analysis_settings import RAY
from ...core.maps.map_summary import thickness_range, typical_range
from ...core.rendering.colour_scale import ColourScale
from ...freecad_adapter.objects.thickness_object import scale_of
from ...freecad_adapter.preferences import preference
from ..application import lifelong
from ..application.length_unit import length_unit
from ..colour_bar.colour_bar import BarContent
from ..colour_bar.colours import ThicknessColours
from ..scene.coin_nodes import add_children, put_into, take_out_of, unpickable
from ..scene.document_views import views_of
from .facet_nodes import FacetNodes

_IN_FRONT = 0.5
"""Polygon offset: less than that of FreeCAD's own faces, which are seen until all parts of an object are coloured."""


class FirstColours:
    """Draws coarse maps in the 3D views of a document. They are no objects: nothing of them is saved, undone or judged.

    Parameters
    ----------
    document : FreeCAD.Document
    sources : dict
        By the name of each part that is measured, the names of the objects that show it: set of str.
    measure : str
        One of `SHOWN_MEASURES`.
    like : FreeCAD.DocumentObject, optional
        An older map of the same objects, whose place and colours are taken.

    Notes
    -----
    They end by themselves when the map that they gave way to is drawn, when an object changes, and with the document.
    `SceneSync` asks them at each refresh.
    """

    def __init__(self, document, sources, measure=RAY, like=None):
        self._name, self._sources, self._measure = document.Name, sources, measure
        self._stands_for = None if like is None else like.Name
        self._is_giving_way = False
        self._parts, self._nodes, self._root = {}, {}, coin.SoSeparator()
        self._root.addChild(unpickable())
        names = sorted(set().union(*sources.values()))
        self._objects = [document.getObject(name) for name in names]
        self._state = SourcesState(self._objects)

    @property
    def is_shown(self):
        """Whether the colours of any part are in the views."""
        return bool(self._parts) and lifelong.map_events.first_colours.get(self._name) is self

    @property
    def is_giving_way(self):
        """Whether the map is there and only has to be drawn."""
        return self._is_giving_way

    @property
    def coloured(self):
        """The coarse MappedParts that are shown: list."""
        return list(self._parts.values())

    @property
    def covered(self):
        """Names of the objects all of whose parts are coloured: set of str."""
        drawn = set().union(*(self._sources[name] for name in self._parts))
        return drawn - set().union(*(names for part, names in self._sources.items() if part not in self._parts))

    def stands_for(self, name):
        """Whether the facets of a map are left out because these colours are in their place."""
        return bool(self._parts) and name == self._stands_for

    def show(self, part):
        """Show a coarse MappedPart, and that of each part that was shown before."""
        lifelong.map_events.first_colours[self._name] = self
        nodes = self._nodes[part.record["name"]] = FacetNodes(_IN_FRONT)
        self._parts[part.record["name"]] = part
        nodes.show([part])
        nodes.shade(self._is_shaded)
        add_children(self._root, nodes.facets, nodes.edges)
        colours = self.colours
        for shown in self._nodes.values():
            shown.colour(colours)
        lifelong.map_events.refresh_soon()

    def give_way(self, thickness):
        """Stay until a map is drawn that is hidden behind these colours meanwhile."""
        self._stands_for, self._is_giving_way = thickness.Name, True
        lifelong.map_events.refresh_soon()

    def end(self):
        """Take the colours out of the views; without effect where they are not shown."""
        if lifelong.map_events.first_colours.get(self._name) is self:
            del lifelong.map_events.first_colours[self._name]
        for view in views_of(self._name):
            take_out_of(view.getSceneGraph(), self._root)
        lifelong.map_events.refresh_soon()

    def refresh(self):
        """Draw the colours in all views of the document; end them where they are out of date or the map is drawn."""
        if self._is_over():
            self.end()
            return
        for view in views_of(self._name):
            put_into(view.getSceneGraph(), self._root)

    @property
    def colours(self):
        """The ThicknessColours, with the range that the map will have, as far as it can be foreseen."""
        like = self._like
        if like is not None and like.Measure == self._measure and not like.AutomaticRange:
            return ThicknessColours(scale_of(like))
        low, high = typical_range(self.coloured) or (0.0, 0.0)
        if like is not None:
            return ThicknessColours(replace(scale_of(like), low=low, high=high))
        return ThicknessColours(ColourScale(
            low, high, preference("HeatMapColours"), preference("HeatMapReversed"), preference("HeatMapBands"),
            tuple(preference("UnmeasuredColour")[:3]), preference("HeatMapLogarithmic")))

    @property
    def bar(self):
        """BarContent, which says that the colours are coarse."""
        parts = self.coloured
        thinnest, thickest = thickness_range(parts) or (0.0, 0.0)
        return BarContent(self.colours, length_unit(App.getDocument(self._name)), 0.0, thinnest, thickest, 0.0,
                          not all(part.map.measured.all() for part in parts), self._measure, is_coarse=True)

    @property
    def _like(self):
        """The map that these colours are in the place of, or None."""
        return None if self._stands_for is None else App.getDocument(self._name).getObject(self._stands_for)

    @property
    def _is_shaded(self):
        return preference("HeatMapShading") if self._like is None else self._like.Shaded

    def _is_over(self):
        if self._is_giving_way:
            thickness = self._like
            return thickness is None or not thickness.ViewObject.Visibility or thickness.ViewObject.Proxy.is_complete
        try:
            return not self._state.is_unchanged
        except ReferenceError:
            return True  # an object was deleted

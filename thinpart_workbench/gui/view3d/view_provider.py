# SPDX-License-Identifier: LGPL-2.1-or-later
"""View provider of thickness maps: the 3D view and the tree."""

import FreeCAD as App
from pivy import coin

from ...api.document_maps import map_version, parts_of
from ...core.errors import ThinPartError
from ...freecad_adapter.guard import guarded_methods
from ...freecad_adapter.objects.thickness_object import SHARE
from ...freecad_adapter.objects.thickness_probes import moved_matrix, probes_of
from ..application import lifelong
from ..application.icons import ICONS
from ..application.length_unit import length_unit
from ..application.qt import QtCore
from ..application.sentences import translated
from ..colour_bar.colour_bar import BarContent
from ..colour_bar.colours import ThicknessColours
from ..scene.coin_nodes import add_children
from ..section.section_nodes import SectionNodes
from .facet_nodes import FacetNodes
from .map_labels import WallsFoundLater

QT_TRANSLATE_NOOP = App.Qt.QT_TRANSLATE_NOOP
_BATCH_INTERVAL = 15
"""Milliseconds between two batches of facets, so that the view can draw the first one."""

MODES = ("Facets and edges", "Facets", "Edges")
_COLOURING = ("RangeUnit", "Low", "High", "ColourMap", "Reversed", "Bands", "UnmeasuredColour", "Threshold",
              "ThinOnly", "Check", "CheckMost", "Stale", "Diagonal", "Measure", "Logarithmic", "Shaded")


@guarded_methods("attach", "updateData", "onChanged", getIcon="", getDisplayModes=list(MODES),
                 getDefaultDisplayMode=MODES[0], doubleClicked=True)
class ThicknessView:
    """View provider of a thickness object, of a Gui.ViewProviderDocumentObject."""

    def __init__(self, view):
        self._reset()
        if "Transparency" not in view.PropertiesList:
            view.addProperty("App::PropertyPercent", "Transparency", "Display Options",
                             QT_TRANSLATE_NOOP("App::Property", "Transparency of the facets, in percent"))
        # The default selection colour would cover the facets and suggest another thickness.
        view.SelectionStyle = "BoundBox"
        view.Proxy = self
        view.DisplayMode = MODES[0]

    def _reset(self):
        self._view = self._nodes = self._walls = self._shown_version = self._failed_version = None
        self._range = self._faces = self._isolated = self._section = self._cut = self._shown_section = None
        self._has_unmeasured = False

    def dumps(self):
        """Serialise no state; FreeCAD 1.0 calls this."""
        return "ThicknessView"

    def loads(self, _state):
        """Restore after opening a document; FreeCAD 1.0 calls this."""
        self._reset()

    def __getstate__(self):
        return "ThicknessView"

    def __setstate__(self, _state):
        self._reset()

    def attach(self, view):
        """Create the nodes; FreeCAD calls this once, when it adds the object to the window."""
        self._view = view
        self._nodes, self._cut = FacetNodes(), SectionNodes()
        facets, edges = self._nodes.facets, self._nodes.edges
        for nodes, clip in zip((facets, edges), self._cut.clips):
            nodes.insertChild(clip, 0)
        for mode, nodes in zip(MODES, ((facets, edges), (facets,), (edges,))):
            group = coin.SoGroup()
            add_children(group, *nodes, self._cut.root)
            view.addDisplayMode(group, mode)
        self.refresh()

    def getDisplayModes(self, _view):
        """All display modes, the default first."""
        return list(MODES)

    def getDefaultDisplayMode(self):
        """Name of the default display mode."""
        return MODES[0]

    def setDisplayMode(self, mode):
        """Map FreeCAD's name of a mode to ours: they are the same."""
        return mode

    def getIcon(self):
        """Icon in the tree; an outdated map has a different one."""
        stale = self._view is not None and getattr(self._view.Object, "Stale", False)
        return str(ICONS / ("ThinPart_ThicknessStale.svg" if stale else "ThinPart_Thickness.svg"))

    def updateData(self, thickness, name):
        """Handle a changed property of the object; while opening, FreeCAD reports each property in turn."""
        if self._nodes is None or thickness.Document.Restoring:
            return
        if name == "Map":
            self.refresh()
        elif name in _COLOURING:
            self.colour()
        elif name == "ProbeValues":  # the last of the three lists
            lifelong.map_events.refresh_soon()  # the labels
        if name == "Stale":
            self._view.signalChangeIcon()

    def onChanged(self, view, name):
        """Handle a changed property of the view."""
        if self._nodes is None:
            return
        if name == "Transparency":
            self.colour()
        elif name == "Visibility":
            lifelong.map_events.refresh_soon()

    def refresh(self):
        """Show the current map; reload it only if its version has changed."""
        if self._view is None:
            return
        thickness = self._view.Object
        if not hasattr(thickness, "Map") or not thickness.Map:
            return
        if thickness.Document.Restoring:
            lifelong.map_events.refresh_soon()  # FreeCAD sets the file name before it has written the file
            return
        version = map_version(thickness)
        if version not in (self._shown_version, self._failed_version):
            try:
                parts = parts_of(thickness)
                self._nodes.show(parts)
                self._isolated = self._walls = None
                self._shown_version, self._failed_version = version, None
                self._has_unmeasured = not all(part.map.measured.all() for part in parts)
            except ThinPartError as error:
                self._nodes.show([])
                self._shown_version, self._failed_version = None, version
                lifelong.notifications.report_error(f"{thickness.Label}: {translated(error)}", thickness.Document.Label)
            self.colour()
        self.move()

    def show_in_batches(self):
        """Add the facets to the scene in batches, so that the window stays responsive."""
        self._nodes.withhold()
        self._show_next_batch()

    def cover(self, is_covered):
        """Leave out the facets while `FirstColours` are in their place."""
        if self._nodes is not None:
            self._nodes.cover(is_covered)

    def move(self):
        """Move the map to the current position of its sources."""
        if self._shown_version is not None:
            matrix = moved_matrix(self._view.Object)
            self._nodes.move(matrix)
            self._show_section()

    def highlight(self, low, high=None, faces=None):
        """Grey all facets except those over walls from `low` to `high` mm and on `faces`; None ends the highlight."""
        self._range = None if low is None else (low, high)
        self._faces = faces
        self.colour()

    def highlight_faces(self, faces):
        """Grey all but some B-Rep faces: dict of sets of face numbers, by part number."""
        self._range, self._faces = None, faces
        self.colour()

    @property
    def highlighting(self):
        """What is highlighted, for `restore_highlight`."""
        return self._range, self._faces

    def restore_highlight(self, highlighting):
        """Highlight again what was."""
        self._range, self._faces = highlighting
        self.colour()

    def isolate(self, faces=None):
        """Draw only some B-Rep faces, as `FacetNodes.isolate`; they are drawn whole again after the next measurement."""
        self._isolated = faces
        self._nodes.isolate(faces)
        self._show_section()

    @property
    def section(self):
        """The SectionPlane that cuts the map and with it the part, or None. Neither saved nor undone."""
        return self._section

    @section.setter
    def section(self, plane):
        self._section = plane
        self._show_section()
        lifelong.map_events.refresh_soon()  # what is cut off has no label

    @property
    def colours(self):
        """The current ThicknessColours."""
        return ThicknessColours.of(self._view.Object, self._range, self._faces)

    def coarsen(self, is_coarse):
        """Draw fewer facets while the view moves, or all again."""
        if self._nodes is not None:
            self._nodes.coarsen(is_coarse)

    @property
    def is_coarse(self):
        """Whether fewer facets are drawn because the view moves."""
        return self._nodes is not None and self._nodes.is_coarse

    @property
    def is_drawn(self):
        """Whether the map itself is seen, and not `FirstColours` in its place."""
        return self._nodes is not None and not self._nodes.is_covered

    @property
    def is_complete(self):
        """Whether all facets are in the scene: until then, only the sources fill the edges."""
        return not self._nodes.withheld

    @property
    def bar(self):
        """The current BarContent; None if no map is shown."""
        if self._shown_version is None:
            return None
        thickness = self._view.Object
        diagonal = thickness.Diagonal if thickness.RangeUnit == SHARE else 0.0
        return BarContent(self.colours, length_unit(thickness.Document), diagonal, thickness.Thinnest,
                          thickness.Thickest, thickness.Threshold, self._has_unmeasured, thickness.Measure)

    @property
    def labels(self):
        """The current LabelContent; None if no map is shown, or not all of it yet."""
        if self._shown_version is None or not self.is_complete:
            return None
        thickness = self._view.Object
        if self._walls is None:
            self._walls = WallsFoundLater(parts_of(thickness), lifelong.map_events.refresh_soon)
        if self._walls.found is None:
            return None
        moved, unit, probes, colours = (moved_matrix(thickness), length_unit(thickness.Document), probes_of(thickness),
                                        ThicknessColours.of(thickness))
        has_others = _shows_others(thickness)
        key = (self._shown_version, moved.tobytes(), unit, tuple(probes), colours, self._section, has_others)
        return self._walls.found.content(
            key, moved, probes, unit, lambda value: tuple(colours.of_values([value])[0].tolist()), self._section, has_others)

    def doubleClicked(self, view):
        """Open the panel on a double click in the tree."""
        lifelong.map_events.request_panel(view.Object)
        return True

    def _show_next_batch(self):
        if self._nodes.show_more():
            QtCore.QTimer.singleShot(_BATCH_INTERVAL, self._show_next_batch)
        else:
            lifelong.map_events.refresh_soon()  # the sources are drawn until here
            QtCore.QTimer.singleShot(_BATCH_INTERVAL, self._nodes.prepare_to_coarsen)

    def _show_section(self):
        if self._section is None or self._shown_version is None:
            self._cut.hide()
            self._shown_section = None
            return
        thickness = self._view.Object
        key = (self._section, self._shown_version, moved_matrix(thickness).tobytes(), self.colours, self._isolated)
        if key != self._shown_section:
            self._shown_section = key
            self._cut.show(self._section, parts_of(thickness), moved_matrix(thickness), self.colours, self._isolated)

    def colour(self):
        """Colour the facets by what is known now."""
        if self._shown_version is not None and hasattr(self._view.Object, "ProbeValues"):
            opacity = 1.0 - getattr(self._view, "Transparency", 0) / 100.0
            self._nodes.shade(getattr(self._view.Object, "Shaded", False))
            self._nodes.colour(self.colours, opacity)
            self._show_section()
            lifelong.map_events.refresh_soon()  # the colour bar changes with the colours


def _shows_others(thickness):
    """Whether the document shows objects other than a map and its sources, which may hide places of the map."""
    own = {member.Name for member in (thickness, *thickness.Sources) if member.Document == thickness.Document}
    return any(each.Name not in own and (hasattr(each, "Shape") or hasattr(each, "Mesh")) and each.ViewObject.Visibility
               for each in thickness.Document.Objects if getattr(each, "ViewObject", None) is not None)

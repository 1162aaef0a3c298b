"""How a thickness map looks in the 3D view and in the tree."""

from pathlib import Path

import FreeCAD as App
from pivy import coin

from ..core.errors import ThinPartError
from ..freecad_adapter.edge import guarded_methods
from ..freecad_adapter.thickness_object import SHARE
from ..workflow.document_maps import map_version, parts_of
from ..workflow.thickness_probes import moved_matrix, probes_of
from .colour_bar import BarContent
from .length_unit import length_unit
from .map_nodes import MapNodes
from .measure_requests import ask_for_measuring
from .notices import NOTICES
from .probe_nodes import ProbeNodes
from .qt import QtCore
from .sentences import translated
from .thickness_colours import ThicknessColours
from .thickness_watch import look_soon

_ICONS = Path(__file__).resolve().parents[2] / "resources" / "icons"
QT_TRANSLATE_NOOP = App.Qt.QT_TRANSLATE_NOOP
_TURN = 15
"""Milliseconds between two groups of facets that appear: the view draws the first meanwhile."""

MODES = ("Facets and edges", "Facets", "Edges")
_COLOURING = ("RangeUnit", "Low", "High", "ColourMap", "Reversed", "Bands", "UnmeasuredColour", "Threshold",
              "ThinOnly", "Stale", "Diagonal")


@guarded_methods("attach", "updateData", "onChanged", getIcon="", getDisplayModes=list(MODES),
                 getDefaultDisplayMode=MODES[0], doubleClicked=True)
class ThicknessView:
    """View provider of a thickness object.

    Parameters
    ----------
    view : Gui.ViewProviderDocumentObject
    """

    def __init__(self, view):
        self._start()
        if "Transparency" not in view.PropertiesList:
            view.addProperty("App::PropertyPercent", "Transparency", "Display Options",
                             QT_TRANSLATE_NOOP("App::Property", "Of the facets, in percent"))
        # Painting over the facets, as FreeCAD does with what is selected, would show another thickness.
        view.SelectionStyle = "BoundBox"
        view.Proxy = self
        view.DisplayMode = MODES[0]

    def _start(self):
        self._view = self._nodes = self._probes = self._shown = self._failed = None
        self._between = self._faces = None
        self._has_unmeasured = False

    def dumps(self):
        """Nothing is kept here; FreeCAD 1.0 asks so."""
        return "ThicknessView"

    def loads(self, _state):
        """After opening; FreeCAD 1.0 asks so."""
        self._start()

    def __getstate__(self):
        return "ThicknessView"

    def __setstate__(self, _state):
        self._start()

    def attach(self, view):
        """Make the nodes; called once, when the object comes into the window."""
        self._view = view
        self._nodes, self._probes = MapNodes(), ProbeNodes()
        facets, edges = self._nodes.facets, self._nodes.edges
        for mode, nodes in zip(MODES, ((facets, edges), (facets,), (edges,))):
            group = coin.SoGroup()
            for node in (*nodes, self._probes.root):
                group.addChild(node)
            view.addDisplayMode(group, mode)
        self.refresh()

    def getDisplayModes(self, _view):
        """All, the usual one first."""
        return list(MODES)

    def getDefaultDisplayMode(self):
        """The usual one."""
        return MODES[0]

    def setDisplayMode(self, mode):
        """FreeCAD's name of the mode is ours."""
        return mode

    def getIcon(self):
        """In the tree; another one where the map is out of date."""
        stale = self._view is not None and getattr(self._view.Object, "Stale", False)
        return str(_ICONS / ("ThinPart_ThicknessStale.svg" if stale else "ThinPart_Thickness.svg"))

    def updateData(self, thickness, name):
        """A property of the object has changed; while opening, all of them one after the other."""
        if self._nodes is None or thickness.Document.Restoring:
            return
        if name == "Map":
            self.refresh()
        elif name in _COLOURING:
            self._colour()
        elif name == "ProbeValues":  # the last of the three lists
            self._probes.show(probes_of(thickness), length_unit(thickness.Document))
        if name == "Stale":
            self._view.signalChangeIcon()

    def onChanged(self, view, name):
        """A property of the view has changed."""
        if self._nodes is None:
            return
        if name == "Transparency":
            self._colour()
        elif name == "Visibility":
            look_soon()

    def refresh(self):
        """Show the map as it is now; it is loaded only where it is another one than before."""
        if self._view is None:
            return
        thickness = self._view.Object
        if not hasattr(thickness, "Map") or not thickness.Map:
            return
        if thickness.Document.Restoring:
            look_soon()  # FreeCAD names the file before it has written it
            return
        version = map_version(thickness)
        if version not in (self._shown, self._failed):
            try:
                parts = parts_of(thickness)
                self._nodes.show(parts)
                self._shown, self._failed = version, None
                self._has_unmeasured = not all(part.map.measured.all() for part in parts)
            except ThinPartError as error:
                self._nodes.show([])
                self._shown, self._failed = None, version
                NOTICES.complain(f"{thickness.Label}: {translated(error)}", thickness.Document.Label)
            self._colour()
        self._probes.show(probes_of(thickness), length_unit(thickness.Document))
        self.move()

    def appear(self):
        """Have the facets appear one group after the other, as the window may not stand still for all of them."""
        self._nodes.withhold()
        self._appear_more()

    def move(self):
        """Follow the sources to where they stand now."""
        if self._shown is not None:
            matrix = moved_matrix(self._view.Object)
            self._nodes.move(matrix)
            self._probes.move(matrix)

    def highlight(self, low, high=None, faces=None):
        """Grey what lies not over walls from `low` to `high` mm, or not on `faces`; None ends that."""
        self._between = None if low is None else (low, high)
        self._faces = faces
        self._colour()

    def highlight_faces(self, faces):
        """Grey all but some B-Rep faces: dict of sets of their numbers, by the number of the part."""
        self._between, self._faces = None, faces
        self._colour()

    @property
    def colours(self):
        """ThicknessColours of this moment."""
        return ThicknessColours.of(self._view.Object, self._between, self._faces)

    @property
    def bar(self):
        """BarContent of this moment; None where there is no map to be seen."""
        if self._shown is None:
            return None
        thickness = self._view.Object
        diagonal = thickness.Diagonal if thickness.RangeUnit == SHARE else 0.0
        return BarContent(self.colours, length_unit(thickness.Document), diagonal, thickness.Thinnest,
                          thickness.Thickest, thickness.Threshold, self._has_unmeasured)

    def doubleClicked(self, view):
        """In the tree: open the panel."""
        from .show_thickness import show_thickness_map

        show_thickness_map(view.Object)
        return True

    def ask_for_measuring(self):
        """The object was recomputed although it is out of date."""
        ask_for_measuring(self._view.Object)

    def _appear_more(self):
        if self._nodes.show_more():
            QtCore.QTimer.singleShot(_TURN, self._appear_more)

    def _colour(self):
        if self._shown is not None and hasattr(self._view.Object, "ProbeValues"):
            opacity = 1.0 - getattr(self._view, "Transparency", 0) / 100.0
            self._nodes.colour(self.colours, opacity)
            look_soon()  # the colour bar changes with the colours

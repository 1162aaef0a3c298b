"""One thickness map as the boxes of the panel show it, and what they change in it."""

import FreeCADGui as Gui
import numpy as np

from ..core.errors import ThinPartError
from ..core.map_summary import (
    area_by_thickness, between, face_summaries, range_of, share_between, telling_range,
)
from ..workflow.document_maps import parts_of
from ..workflow.thickness_probes import moved_matrix, probes_of
from .face_selection import FaceSelection, face_near
from .fly_to import fly_to
from .length_unit import length_unit
from .object_watch import ObjectWatch
from .part_list import PartRow
from .qt import QtCore, Signal, disconnect, translate
from .sentences import translated
from .thickness_chart import bar_edges
from .thickness_colours import ThicknessColours
from .thickness_picking import ThicknessPicker, probe_ends, remove_probe
from .transaction import transaction
from .unit_watch import UNITS

_SCALE = ("AutomaticRange", "Low", "High", "RangeUnit", "ColourMap", "Reversed", "Bands", "UnmeasuredColour")
_THIN = ("Threshold", "ThinOnly")
_PROBES = ("ProbePoints", "ProbeOpposites", "ProbeValues")

_SURROUNDINGS = 0.15
"""Share of the diagonal that is seen at least where the camera flies to a wall."""

_ON_FACE = 1e-3
"""Share of the diagonal within which a place that was clicked lies on a face: the view rounds it."""

_BEYOND_MOST = 1.25
"""Bars go this far beyond the walls of most of the area; the few that are much thicker share the last one."""

_SETTLED = 200
"""Milliseconds without another threshold until the table of faces follows."""


class ShownThickness(QtCore.QObject):
    """Joins a map object, its view and the boxes; it keeps nothing that is in the document.

    Parameters
    ----------
    thickness : FreeCAD.DocumentObject
    boxes : ThicknessPanel
    profile : Profile
        Has the words for categories.

    Signals
    -------
    removed
        The object is about to go.

    Raises
    ------
    ThinPartError
        When the map cannot be read.
    """

    removed = Signal()

    def __init__(self, thickness, boxes, profile):
        super().__init__(boxes)
        self.thickness, self._boxes, self._profile = thickness, boxes, profile
        self._parts = parts_of(thickness)
        self._chosen = 0 if len(self._parts) == 1 else None  # number of the part that the boxes are about
        self._watch = ObjectWatch(thickness, self)
        self._selection = FaceSelection(
            thickness, [part.record["name"] for part in self._parts], self)
        self._picker = ThicknessPicker(thickness)
        self._is_gone = False
        self._before_dragging = None  # the threshold, while its line is being moved
        self._waiting = set()  # properties that have changed since the boxes were drawn
        self._draw = QtCore.QTimer(self, singleShot=True, interval=0)
        self._draw.timeout.connect(self._follow)
        self._settled = QtCore.QTimer(self, singleShot=True, interval=_SETTLED)
        self._settled.timeout.connect(self._show_faces)
        self._connections = [
            (self._watch.changed, self._note), (self._watch.removed, self._end),
            (self._selection.face_selected, self._face_selected),
            (self._selection.map_selected, self._place_selected),
            (boxes.head.part_chosen, self._choose_part), (boxes.head.all_asked, self._choose_all),
            (boxes.head.fly_asked, self._fly_to_thinnest), (boxes.scale.changed, self._change),
            (boxes.distribution.range_chosen, self._choose_range),
            (boxes.distribution.threshold_changed, self._set_threshold),
            (boxes.distribution.thin_only_changed, lambda on: self._change({"ThinOnly": on})),
            (boxes.faces.face_chosen, self._choose_face),
            (boxes.probes.picking_toggled, self._toggle_picking),
            (boxes.probes.removed, lambda number: remove_probe(self.thickness, number)),
            (boxes.probes.cleared, self._clear_probes), (boxes.probes.visited, self._visit_probe),
            (self._picker.hovered, boxes.probes.show_hovered), (UNITS.changed, self._show_unit),
        ]
        for signal, slot in self._connections:
            signal.connect(slot)
        self._show_all()

    def leave(self):
        """Let go of everything; what only belonged to the panel goes from the view."""
        # FreeCAD calls its observers whether Qt's part of them is there or not: first of all they go.
        self._watch.end()
        self._selection.end()
        for signal, slot in self._connections:
            disconnect(signal, slot)  # FreeCAD may have taken the box away already
        self._draw.stop()
        self._settled.stop()
        self._picker.stop()
        self._picker.deleteLater()
        try:
            if not self._is_gone:
                self._view.highlight(None)
        except (NameError, ReferenceError):
            return  # FreeCAD is closing the document, and knows its window no more

    @property
    def _view(self):
        return self.thickness.ViewObject.Proxy

    @property
    def _unit(self):
        return length_unit(self.thickness.Document)

    @property
    def _told(self):
        """The parts that the boxes are about."""
        return self._parts if self._chosen is None else [self._parts[self._chosen]]

    @property
    def _diagonal(self):
        return max(part.record["descriptors"]["diagonal_mm"] for part in self._told)

    def _end(self):
        self._is_gone = True
        self.removed.emit()

    def _show_all(self):
        self._show_head()
        self._show_bars()
        self._show_scale()
        self._show_faces()
        self._show_probes()

    def _show_unit(self):
        """Lengths are written in another unit, in which bars have other round widths: none of them is chosen."""
        self._show_all()
        face = self._boxes.faces.table.current_row
        if face is None:
            self._highlight_chosen()
        else:
            self._view.highlight_faces({self._chosen: {face.summary.face}})

    def _show_scale(self):
        self._boxes.scale.show_properties({name: getattr(self.thickness, name) for name in _SCALE}, self._unit)

    def _show_head(self):
        rows = [PartRow(part.record["name"], part.record["label"], len(part.places), part.record)
                for part in self._parts]
        shown = None if self._chosen is None else rows[self._chosen].name
        self._boxes.head.show_parts(rows, self._profile, shown, self._unit)
        self._boxes.head.show_stale(self.thickness.Stale)

    def _show_bars(self):
        greatest, last = self._thickness_in_bars()
        edges = bar_edges(last, self._unit)
        shares, _ = area_by_thickness(self._told, np.append(edges[:-1], max(edges[-1], greatest)))
        self._boxes.distribution.show_shares(edges, shares, greatest, self._diagonal, self._unit)
        self._boxes.distribution.show_choice(None, 0.0, 0)
        self._show_colours()
        self._show_threshold()

    def _thickness_in_bars(self):
        """Thickest wall of what is told, and up to where bars of one width go, both in mm."""
        ends = range_of(self._told)
        if ends is None:
            return 1.0, 1.0
        greatest = ends[1]
        told_apart = max(_BEYOND_MOST * telling_range(self._told)[1], 2.0 * self.thickness.Threshold)
        return greatest, greatest if greatest <= 2.0 * told_apart else told_apart

    def _show_colours(self):
        chart = self._boxes.distribution.chart
        middles = 0.5 * (chart.edges[1:] + chart.edges[:-1])
        if chart.greatest > chart.edges[-1]:
            middles[-1] = chart.greatest
        chart.show_colours(ThicknessColours.of(self.thickness).of_values(middles))

    def _show_threshold(self):
        threshold = self.thickness.Threshold
        self._boxes.distribution.show_threshold(
            threshold, share_between(self._told, 0.0, threshold), self.thickness.ThinOnly)

    def _show_faces(self):
        if self._chosen is None:
            self._boxes.faces.show_no_part()
            return
        part = self._parts[self._chosen]
        self._boxes.faces.show_faces(face_summaries(part.map, self.thickness.Threshold), part.features, self._unit)

    def _show_probes(self):
        self._boxes.probes.show_probes([probe.value for probe in probes_of(self.thickness)], self._unit)

    def _note(self, name):
        # FreeCAD tells of every property by itself, and of some several times.
        self._waiting.add(name)
        self._draw.start()

    def _follow(self):
        changed, self._waiting = self._waiting, set()
        if "Map" in changed:
            try:
                self._parts = parts_of(self.thickness)
            except ThinPartError as error:
                self._boxes.head.show_message(translated(error), can_repeat=True)
                return
            self._selection.names = [part.record["name"] for part in self._parts]
            if self._chosen is not None and self._chosen >= len(self._parts):
                self._chosen = None
            self._show_all()
            return
        if changed & set(_SCALE):
            self._show_scale()
            self._show_colours()
        if changed & set(_THIN):
            self._show_threshold()
            self._show_colours()
            self._settled.start()
        if changed & set(_PROBES):
            self._show_probes()
        if "Stale" in changed:
            self._show_colours()
            self._boxes.head.show_stale(self.thickness.Stale)

    def _change(self, values):
        with transaction(self.thickness.Document, translate("ThinPart", "Thickness colours")):
            for name, value in values.items():
                setattr(self.thickness, name, value)

    def _set_threshold(self, threshold, is_final):
        if not is_final:
            if self._before_dragging is None:
                self._before_dragging = self.thickness.Threshold
            self.thickness.Threshold = threshold
            return
        before, self._before_dragging = self._before_dragging, None
        if before is not None:
            self.thickness.Threshold = before  # what Undo goes back to
        self._change({"Threshold": threshold})

    def _choose_part(self, name):
        self._chosen = next(number for number, part in enumerate(self._parts) if part.record["name"] == name)
        self._show_part()
        self._selection.select_part(self._chosen)

    def _choose_all(self):
        self._chosen = None
        self._selection.clear()
        self._show_part()

    def _show_part(self):
        self._show_head()
        self._show_bars()
        self._show_faces()
        self._highlight_chosen()

    def _highlight_chosen(self):
        faces = self._faces_of_chosen()
        if faces is None:
            self._view.highlight(None)
        else:
            self._view.highlight_faces(faces)

    def _faces_of_chosen(self):
        """All faces of the part that was chosen among several, for `highlight`."""
        if len(self._parts) == 1 or self._chosen is None:
            return None
        return {self._chosen: set(np.unique(self._parts[self._chosen].map.face).tolist())}

    def _choose_range(self, chosen):
        if chosen is None:
            self._highlight_chosen()
            self._selection.clear()
            self._boxes.distribution.show_choice(None, 0.0, 0)
            return
        low, high = chosen
        self._view.highlight(low, high, self._faces_of_chosen())
        faces = {}
        for number, part in enumerate(self._parts):
            if self._chosen in (None, number):
                found = np.unique(part.map.face[between(part.map, low, high)])
                faces[number] = found.tolist()
        count = self._selection.select(faces)
        self._boxes.faces.table.select_face(None)
        self._boxes.distribution.show_choice(chosen, share_between(self._told, low, high), count)

    def _choose_face(self, face):
        self._view.highlight_faces({self._chosen: {face}})
        self._selection.select({self._chosen: [face]})

    def _face_selected(self, part, face):
        if self._chosen != part:
            self._chosen = part
            self._show_head()
            self._show_bars()
            self._show_faces()
        self._boxes.faces.table.select_face(face)
        self._view.highlight_faces({part: {face}})

    def _place_selected(self, point):
        found = face_near(self._parts, moved_matrix(self.thickness), np.array(point),
                          _ON_FACE * self.thickness.Diagonal)
        if found is not None:
            self._face_selected(*found)

    def _fly_to_thinnest(self):
        places = [(face["witness"]["distance"], number, face["witness"]["points"])
                  for number, part in enumerate(self._parts) if self._chosen in (None, number)
                  for face in part.record["faces"] if face["witness"] is not None]
        if places:
            _, number, points = min(places)
            matrix = moved_matrix(self.thickness) @ self._parts[number].places[0]
            self._fly(*(matrix[:3, :3] @ np.array(point) + matrix[:3, 3] for point in points))

    def _visit_probe(self, number):
        self._fly(*probe_ends(self.thickness, number))

    def _fly(self, point, opposite):
        document = Gui.getDocument(self.thickness.Document.Name)
        views = document.mdiViewsOfType("Gui::View3DInventor")
        active = document.ActiveView
        if views:
            fly_to(active if hasattr(active, "getCameraNode") else views[0], point, opposite,
                   _SURROUNDINGS * self.thickness.Diagonal)

    def _toggle_picking(self, is_on):
        if is_on:
            self._picker.start()
        else:
            self._picker.stop()
        self._boxes.probes.show_picking(is_on)

    def _clear_probes(self):
        with transaction(self.thickness.Document, translate("ThinPart", "Remove all probes")):
            for name in _PROBES:
                setattr(self.thickness, name, [])

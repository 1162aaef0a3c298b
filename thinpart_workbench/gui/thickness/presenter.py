"""Presents one thickness map in the boxes of the panel and applies the user's changes to it."""

import numpy as np

from ...api.document_maps import parts_of
from ...core.errors import ThinPartError
from ...core.maps.map_summary import (
    area_by_thickness,
    between,
    face_summaries,
    share_between,
    thickness_range,
    typical_range,
)
from ...core.rigid_transform import transform_points
from ...freecad_adapter.objects.thickness_object import OWN_CHECK, unit_in_mm
from ...freecad_adapter.objects.thickness_probes import moved_matrix, probes_of
from ...freecad_adapter.preferences import preference
from ..application import lifelong
from ..application.length_unit import length_unit
from ..application.qt import QtCore, Signal, disconnect, translate
from ..application.sentences import translated
from ..colour_bar.bar_handle import switch as switch_in_view
from ..colour_bar.colours import ThicknessColours
from ..document.object_observer import ObjectObserver
from ..document.transaction import transaction
from ..map_export.export_dialog import export_map
from ..record.parts_table import PartsTableRow
from ..section.section_presenter import SectionPresenter
from ..view3d.face_selection import FaceSelection, face_near
from ..view3d.picking import ThicknessPicker, probe_ends, remove_probe
from ..view3d.wall_flight import PlacedWall, WallFlight, hidden_sentence
from ..widgets.process_field import offered_limits
from .histogram import bar_edges
from .map_check import band_shares, checked_limits, map_check_text
from .region_presenter import RegionPresenter

_SCALE = ("AutomaticRange", "Low", "High", "RangeUnit", "ColourMap", "Reversed", "Bands", "UnmeasuredColour",
          "Logarithmic", "Shaded")
_THIN = ("Threshold", "ThinOnly", "Check", "CheckMost")
_PROBES = ("ProbePoints", "ProbeOpposites", "ProbeValues")

_MOST_PLACES = 8
"""Occurrences of a part among which one is looked for where a wall can be seen."""

_ON_FACE = 1e-3
"""Tolerance for finding the clicked face, as a share of the diagonal: the view rounds coordinates."""

_BEYOND_MOST = 1.25
"""Factor by which the bars extend beyond the walls of most of the area; thicker walls share the last bar."""

_FACE_DELAY = 200
"""Milliseconds after the last threshold change before the table of faces is updated."""


class ThicknessPresenter(QtCore.QObject):
    """Connects a map object, its view and the boxes; it stores no document data.

    Parameters
    ----------
    thickness : FreeCAD.DocumentObject
    boxes : ThicknessPanel
    profile : Profile
        Provides the titles of the categories.

    Attributes
    ----------
    regions : RegionPresenter

    Signals
    -------
    removed
        The object is about to be deleted.

    Raises
    ------
    ThinPartError
        If the map cannot be read.
    """

    removed = Signal()

    def __init__(self, thickness, boxes, profile):
        super().__init__(boxes)
        self.thickness, self._boxes, self._profile = thickness, boxes, profile
        self._parts = parts_of(thickness)
        self._chosen = 0 if len(self._parts) == 1 else None  # number of the part shown in the boxes, None for all
        self._observer = ObjectObserver(thickness, self)
        self._selection = FaceSelection(
            thickness, [part.record["name"] for part in self._parts], self)
        self._picker = ThicknessPicker(thickness)
        self._is_gone = False
        self._flight, self._flown_at = WallFlight(), None  # where the map was at the last flight
        self._tour = None  # the number of the last wall among all of them, the thinnest first
        self._before_dragging = None  # the previous threshold, while its line is dragged
        self._changed = set()  # properties changed since the last update of the boxes
        self._refresh_timer = QtCore.QTimer(self, singleShot=True, interval=0)
        self._refresh_timer.timeout.connect(self._refresh)
        self._face_timer = QtCore.QTimer(self, singleShot=True, interval=_FACE_DELAY)
        self._face_timer.timeout.connect(self._show_faces)
        self._connections = [
            (self._observer.changed, self._on_changed), (self._observer.removed, self._on_removed),
            (self._selection.face_selected, self._on_face_selected),
            (self._selection.map_selected, self._on_map_selected),
            (boxes.head.part_chosen, self._on_part_chosen), (boxes.head.all_requested, self._choose_all),
            (boxes.head.fly_requested, lambda: self._fly_to_wall(0)),
            (boxes.head.export_requested, self._export),
            (boxes.head.step_requested, self._step), (boxes.scale.changed, self._change),
            (boxes.scale.typical_requested, self._show_typical_range), (boxes.scale.switched, switch_in_view),
            (boxes.distribution.range_chosen, self._choose_range),
            (boxes.distribution.threshold_changed, self._set_threshold),
            (boxes.distribution.thin_only_changed, lambda on: self._change({"ThinOnly": on})),
            (boxes.distribution.check.chosen, self._choose_check),
            (boxes.distribution.check.limit_typed, self._check_own_limit),
            (boxes.faces.face_chosen, self._choose_face), (boxes.faces.visited, self._visit_face),
            (boxes.regions.faces_chosen, self._choose_faces), (boxes.regions.visited, self._visit_region),
            (boxes.probes.picking_toggled, self._toggle_picking),
            (boxes.probes.removed, lambda number: remove_probe(self.thickness, number)),
            (boxes.probes.cleared, self._clear_probes), (boxes.probes.visited, self._visit_probe),
            (self._picker.hovered, boxes.probes.show_hovered), (lifelong.units.changed, self._show_unit),
        ]
        for signal, slot in self._connections:
            signal.connect(slot)
        lifelong.map_events.refresh_due.add(self._leave_what_moved)
        lifelong.map_events.refresh_due.add(self._show_in_view)
        self.regions = RegionPresenter(thickness, boxes.regions, self)
        self._section = SectionPresenter(thickness, self._parts, boxes.section, self)
        self._show_all()
        self._picker.start(pins=False)

    def _export(self):
        self._boxes.head.show_export(export_map(self.thickness, self._boxes.head))

    def leave(self):
        """Disconnect everything and remove the panel's highlights from the view."""
        # Remove the observers first: FreeCAD calls them even after Qt has deleted their C++ objects.
        self._observer.end()
        self._selection.end()
        for signal, slot in self._connections:
            disconnect(signal, slot)  # FreeCAD may already have deleted the box
        self._refresh_timer.stop()
        self._face_timer.stop()
        self._end_flight()
        self.regions.leave()
        self._section.leave()
        lifelong.map_events.refresh_due.remove(self._leave_what_moved)
        lifelong.map_events.refresh_due.remove(self._show_in_view)
        self._picker.stop()
        self._picker.deleteLater()
        try:
            if not self._is_gone:
                self._view.highlight(None)
                self._view.isolate()
        except (NameError, ReferenceError):
            return  # FreeCAD is closing the document and has already dropped its view

    @property
    def _view(self):
        return self.thickness.ViewObject.Proxy

    @property
    def _unit(self):
        return length_unit(self.thickness.Document)

    @property
    def _shown_parts(self):
        """The parts shown in the boxes."""
        return self._parts if self._chosen is None else [self._parts[self._chosen]]

    @property
    def _diagonal(self):
        return max(part.record["descriptors"]["diagonal_mm"] for part in self._shown_parts)

    def _on_removed(self):
        self._is_gone = True
        self.removed.emit()

    def _show_all(self):
        self._show_head()
        self._show_bars()
        self._show_scale()
        self._show_in_view()
        self._show_regions()
        self._show_faces()
        self._show_probes()

    def _show_unit(self):
        """Update the boxes after a change of the unit; bar widths change with it, which clears their selection."""
        self._end_flight()  # its mark has the former unit
        self._boxes.head.show_flight("")
        self._show_all()
        self._section.show()
        face = self._boxes.faces.table.current_row
        if face is None:
            self._highlight_chosen()
        else:
            self._view.highlight_faces({self._chosen: {face.summary.face}})

    def _show_scale(self):
        self._boxes.scale.show_properties({name: getattr(self.thickness, name) for name in _SCALE}, self._unit)

    def _show_in_view(self):
        self._boxes.scale.show_in_view({name: preference(name) for name in ("ColourBarShown", "MapLabels")})

    def _show_head(self):
        rows = [PartsTableRow(part.record["name"], part.record["label"], len(part.matrices), part.record)
                for part in self._parts]
        shown = None if self._chosen is None else rows[self._chosen].name
        self._boxes.head.show_parts(rows, self._profile, shown, self._unit, self.thickness.Document.FileName)
        self._boxes.head.show_measure(self.thickness.Measure)
        self._boxes.head.show_stale(self.thickness.Stale)

    def _show_bars(self):
        thickest, last = self._thickness_in_bars()
        edges = bar_edges(last, self._unit)
        shares, _ = area_by_thickness(self._shown_parts, np.append(edges[:-1], max(edges[-1], thickest)))
        self._boxes.distribution.show_shares(
            edges, shares, thickest, self._diagonal, self._unit, self.thickness.Measure)
        self._boxes.distribution.show_choice(None, 0.0, 0)
        self._show_colours()
        self._show_threshold()

    def _thickness_in_bars(self):
        """Thickest wall of the shown parts, and upper end of the bars of equal width, both in mm."""
        ends = thickness_range(self._shown_parts)
        if ends is None:
            return 1.0, 1.0
        thickest = ends[1]
        last = max(_BEYOND_MOST * typical_range(self._shown_parts)[1], 2.0 * self.thickness.Threshold)
        return thickest, thickest if thickest <= 2.0 * last else last

    def _show_colours(self):
        chart = self._boxes.distribution.chart
        middles = 0.5 * (chart.edges[1:] + chart.edges[:-1])
        if chart.thickest > chart.edges[-1]:
            middles[-1] = chart.thickest
        chart.show_colours(ThicknessColours.of(self.thickness).of_values(middles))

    def _show_threshold(self):
        threshold = self.thickness.Threshold
        self._boxes.distribution.show_threshold(
            threshold, share_between(self._shown_parts, 0.0, threshold), self.thickness.ThinOnly)
        name = self.thickness.Check
        records = [part.record for part in self._shown_parts]
        self._boxes.distribution.check.show_check(
            name, threshold, self._unit, band_shares(self._shown_parts, ThicknessColours.of(self.thickness).bands),
            map_check_text(records, checked_limits(self.thickness), self._unit, self.thickness.Measure))
        self._boxes.probes.show_limits(threshold if name else 0.0, self.thickness.CheckMost if name else 0.0)

    def _show_regions(self):
        self.regions.show(self._chosen, None if self._chosen is None else self._parts[self._chosen])

    def _show_faces(self):
        if self._chosen is None:
            self._boxes.faces.show_no_part()
            return
        part = self._parts[self._chosen]
        self._boxes.faces.show_faces(face_summaries(part.map, self.thickness.Threshold), part.features, self._unit,
                                     part.record, self.thickness.Document.FileName)

    def _show_probes(self):
        values = [probe.value for probe in probes_of(self.thickness)]
        self._boxes.probes.show_probes(values, self._unit, self.thickness.Measure, self.thickness.Document.FileName)

    def _on_changed(self, name):
        # FreeCAD reports each property separately, and some of them several times.
        self._changed.add(name)
        self._refresh_timer.start()

    def _refresh(self):
        changed, self._changed = self._changed, set()
        if "Map" in changed:
            try:
                self._parts = parts_of(self.thickness)
            except ThinPartError as error:
                self._boxes.head.show_message(translated(error), can_repeat=True)
                return
            self._end_flight()
            self._boxes.head.show_flight("")
            self.regions.show_whole()
            self._section.show_parts(self._parts)
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
            self._face_timer.start()
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
            self.thickness.Threshold = before  # the value that Undo restores
        own = {"Check": OWN_CHECK, "CheckMost": 0.0} if self.thickness.Check else {}
        self._change({"Threshold": threshold, **own})

    def _choose_check(self, name):
        limits = offered_limits().get(name)
        if limits is None:
            self._change({"Check": name, "CheckMost": 0.0})
        else:
            self._change({"Check": name, "CheckMost": limits.max_mm or 0.0, "Threshold": limits.min_mm or 0.0})

    def _check_own_limit(self, limit):
        self._change({"Check": OWN_CHECK, "CheckMost": 0.0, "Threshold": limit})

    def _show_typical_range(self):
        ends = typical_range(self._shown_parts)
        if ends is not None:
            unit = unit_in_mm(self.thickness)
            self._change({"AutomaticRange": False, "Low": ends[0] / unit, "High": ends[1] / unit})

    def _on_part_chosen(self, name):
        self._chosen = next(number for number, part in enumerate(self._parts) if part.record["name"] == name)
        self._show_part()
        self._selection.select_part(self._chosen)

    def _choose_all(self):
        self._chosen = None
        self._selection.clear()
        self._show_part()

    def _show_part(self):
        self._tour = None
        self._show_head()
        self._show_bars()
        self._show_regions()
        self._show_faces()
        self._highlight_chosen()

    def _highlight_chosen(self):
        faces = self._faces_of_chosen()
        if faces is None:
            self._view.highlight(None)
        else:
            self._view.highlight_faces(faces)

    def _faces_of_chosen(self):
        """All faces of the part chosen among several, for `highlight`; otherwise None."""
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
                in_range = np.unique(part.map.face[between(part.map, low, high)])
                faces[number] = in_range.tolist()
        count = self._selection.select(faces)
        self._boxes.faces.table.select_face(None)
        self._boxes.distribution.show_choice(chosen, share_between(self._shown_parts, low, high), count)

    def _choose_face(self, face):
        self._view.highlight_faces({self._chosen: {face}})
        self._selection.select({self._chosen: [face]})

    def _choose_faces(self, faces):
        self._view.highlight_faces({self._chosen: set(faces)})
        self._selection.select({self._chosen: list(faces)})

        self.regions.keep_highlight()

    def _on_face_selected(self, part, face):
        if self._chosen != part:
            self._chosen = part
            self._tour = None
            self._show_head()
            self._show_bars()
            self._show_regions()
            self._show_faces()
        self._boxes.faces.table.select_face(face)
        self._view.highlight_faces({part: {face}})

    def _on_map_selected(self, point):
        hit = face_near(self._parts, moved_matrix(self.thickness), np.array(point),
                        _ON_FACE * self.thickness.Diagonal)
        if hit is not None:
            self._on_face_selected(*hit)

    def _walls(self):
        """Walls between two faces each, the thinnest first: list of (thickness, number of the part, both ends)."""
        found, known = [], set()
        for number, part in enumerate(self._parts):
            if self._chosen not in (None, number):
                continue
            for face in sorted((face for face in part.record["faces"] if face["witness"] is not None),
                               key=lambda face: face["witness"]["distance"]):
                between = number, frozenset((face["face"], face["witness"]["opposite_face"]))
                if between not in known:  # each of the two sees the other
                    known.add(between)
                    found.append((face["witness"]["distance"], number, face["witness"]["points"]))
        return sorted(found)

    def _step(self, count):
        self._fly_to_wall(0 if self._tour is None else self._tour + count)

    def _fly_to_wall(self, place):
        walls = self._walls()
        if walls:
            self._tour = place % len(walls)
            value, number, points = walls[self._tour]
            self._fly(value, self._places(number, points))

    def _visit_face(self, wall):
        value, summary = wall
        shown = self._parts[self._chosen].map
        middle = shown.corners[summary.thinnest_facet].mean(axis=0) + shown.origin
        _, opposite = shown.wall_at(summary.thinnest_facet, middle)
        self._fly(value, self._places(self._chosen, (middle, opposite)))

    def _visit_region(self, wall):
        value, points = wall
        self._fly(value, self._places(self._chosen, points))

    def _visit_probe(self, number):
        self._fly(probes_of(self.thickness)[number].value, [probe_ends(self.thickness, number)])

    def _places(self, number, points):
        """Both ends of a wall at the occurrences of its part."""
        moved = moved_matrix(self.thickness)
        return [tuple(transform_points(moved @ matrix, points)) for matrix in self._parts[number].matrices[:_MOST_PLACES]]

    def _fly(self, value, places):
        self._boxes.distribution.chart.clear_choice()  # greyed facets would hide the wall that is flown to
        self._flown_at = moved_matrix(self.thickness)
        is_seen = self._flight.fly(self.thickness.Document, PlacedWall(value, places), self.thickness.Diagonal, self._unit)
        if self._flight.target is not None:
            self._section.uncover(self._flight.target)
        self._boxes.head.show_flight("" if is_seen else hidden_sentence())

    def _leave_what_moved(self):
        if self._is_gone or self._flown_at is None:
            return
        if not np.allclose(self._flown_at, moved_matrix(self.thickness)):
            self._end_flight()
            self._boxes.head.show_flight("")

    def _end_flight(self):
        self._flight.clear()
        self._tour = self._flown_at = None

    def _toggle_picking(self, is_on):
        self._picker.start(pins=is_on)
        self._boxes.probes.show_picking(is_on)

    def _clear_probes(self):
        with transaction(self.thickness.Document, translate("ThinPart", "Remove all probes")):
            for name in _PROBES:
                setattr(self.thickness, name, [])

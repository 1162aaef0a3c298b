# SPDX-License-Identifier: LGPL-2.1-or-later
"""Presents the probes of a map, and picks further ones in the view."""

from ...freecad_adapter.objects.thickness_probes import probes_of
from ..application.qt import translate
from ..colour_bar.checked_facets import checked_maps
from ..document.transaction import transaction
from ..view3d.picking import ThicknessPicker, probe_ends, remove_probe
from .map_presenter import MapPresenter
from .map_properties import PROBES, THIN


class ProbePresenter(MapPresenter):
    """Connects the box of probes with a map."""

    def __init__(self, thickness, shown, tour, box, parent):
        super().__init__(thickness, shown, box, parent)
        self._tour, self._picker = tour, ThicknessPicker(thickness)
        self._connect(
            (box.picking_toggled, self._toggle), (box.removed, self._remove), (box.cleared, self._clear),
            (box.visited, self._visit), (self._picker.hovered, lambda found: box.show_hovered(found, self._is_thick(found))))

    def start(self):
        """Show the thickness under the mouse."""
        self._picker.start(pins=False)

    def leave(self):
        """Disconnect everything."""
        super().leave()
        self._picker.stop()
        self._picker.deleteLater()

    def show(self):
        """Show everything."""
        values = [probe.value for probe in probes_of(self._thickness)]
        self._box.show_probes(values, self._shown.unit, self._thickness.Measure, self._thickness.Document.FileName)
        self._show_limits()

    def refresh(self, changed):
        """Show what has changed: set of names of properties."""
        if changed & set(PROBES):
            self.show()
        elif changed & set(THIN):
            self._show_limits()

    def _show_limits(self):
        is_checked = bool(self._thickness.Check)
        self._box.show_limits(self._thickness.Threshold if is_checked else 0.0,
                              self._thickness.CheckMost if is_checked else 0.0)

    def _is_thick(self, wall):
        """Whether a wall of the picker is on a facet that is too thick for what is checked."""
        maps = None if wall is None else checked_maps(self._thickness)
        return maps is not None and maps.has_thick and bool(maps.are_thick(wall["part"])[wall["facet"]])

    def _toggle(self, is_on):
        self._picker.start(pins=is_on)
        self._box.show_picking(is_on)

    def _remove(self, number):
        remove_probe(self._thickness, number)

    def _clear(self):
        with transaction(self._thickness.Document, translate("ThinPart", "Remove all probes")):
            for name in PROBES:
                setattr(self._thickness, name, [])

    def _visit(self, number):
        self._tour.fly(probes_of(self._thickness)[number].value, [probe_ends(self._thickness, number)])

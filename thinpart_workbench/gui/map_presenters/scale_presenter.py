# SPDX-License-Identifier: LGPL-2.1-or-later
"""Presents the colours of a map."""

from ...core.maps.map_summary import typical_range
from ...freecad_adapter.objects.thickness_object import unit_in_mm
from ...freecad_adapter.preferences import preference
from ..application import lifelong
from ..colour_bar.bar_handle import switch
from .map_presenter import MapPresenter
from .map_properties import SCALE, change


class ScalePresenter(MapPresenter):
    """Connects the box of colours with a map."""

    def __init__(self, thickness, shown, box, parent):
        super().__init__(thickness, shown, box, parent)
        self._connect((box.changed, lambda values: change(thickness, values)),
                      (box.typical_requested, self._show_typical), (box.switched, switch))
        lifelong.map_events.refresh_due.add(self._show_in_view)

    def leave(self):
        """Disconnect everything."""
        super().leave()
        lifelong.map_events.refresh_due.remove(self._show_in_view)

    def show(self):
        """Show everything."""
        self._box.show_properties({name: getattr(self._thickness, name) for name in SCALE}, self._shown.unit)
        self._show_in_view()

    def refresh(self, changed):
        """Show what has changed: set of names of properties."""
        if changed & set(SCALE):
            self.show()

    def _show_in_view(self):
        self._box.show_in_view({name: preference(name) for name in ("ColourBarShown", "MapLabels")})

    def _show_typical(self):
        ends = typical_range(self._shown.shown)
        if ends is not None:
            unit = unit_in_mm(self._thickness)
            change(self._thickness, {"AutomaticRange": False, "Low": ends[0] / unit, "High": ends[1] / unit})

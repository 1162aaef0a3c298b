"""Presents the colours of a map."""

from ...core.maps.map_summary import typical_range
from ...freecad_adapter.objects.thickness_object import unit_in_mm
from ...freecad_adapter.preferences import preference
from ..application import lifelong
from ..application.qt import QtCore, disconnect
from ..colour_bar.bar_handle import switch
from .map_properties import SCALE, change


class ScalePresenter(QtCore.QObject):
    """Connects the box of colours with a map; see `ThicknessPresenter` for the parameters."""

    def __init__(self, thickness, shown, box, parent):
        super().__init__(parent)
        self._thickness, self._shown, self._box = thickness, shown, box
        self._connections = [(box.changed, self._change), (box.typical_requested, self._show_typical),
                             (box.switched, switch)]
        for signal, slot in self._connections:
            signal.connect(slot)
        lifelong.map_events.refresh_due.add(self._show_in_view)

    def leave(self):
        """Disconnect everything."""
        for signal, slot in self._connections:
            disconnect(signal, slot)
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

    def _change(self, values):
        change(self._thickness, values)

    def _show_typical(self):
        ends = typical_range(self._shown.shown)
        if ends is not None:
            unit = unit_in_mm(self._thickness)
            change(self._thickness, {"AutomaticRange": False, "Low": ends[0] / unit, "High": ends[1] / unit})

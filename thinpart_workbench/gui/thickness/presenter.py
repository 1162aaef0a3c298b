# SPDX-License-Identifier: LGPL-2.1-or-later
"""Presents one thickness map in the boxes of the panel."""

import FreeCADGui as Gui

from ...api.document_maps import parts_before
from ...api.window.map_values import places_of_wall
from ...core.errors import ThinPartError
from ..application import lifelong
from ..application.qt import QtCore, Signal
from ..application.sentences import translated
from ..document.object_observer import ObjectObserver
from ..map_export.export_dialog import export_map
from ..map_presenters.distribution_presenter import DistributionPresenter
from ..map_presenters.face_highlight import FaceHighlight
from ..map_presenters.face_presenter import FacePresenter
from ..map_presenters.map_presenter import MapPresenter
from ..map_presenters.probe_presenter import ProbePresenter
from ..map_presenters.region_presenter import RegionPresenter
from ..map_presenters.scale_presenter import ScalePresenter
from ..map_presenters.section_presenter import SectionPresenter
from ..map_presenters.shown_parts import ShownParts
from ..map_presenters.wall_tour import WallTour
from ..record.parts_table import PartsTableRow
from .thinner_dialog import ThinnerDialog


class ThicknessPresenter(MapPresenter):
    """Gives each box of the panel its presenter, tells these what has changed, and presents the head itself.

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

    Notes
    -----
    What several presenters need belongs to one object each, whose signals they listen to: which part is shown to
    `ShownParts`, what is highlighted and selected to `FaceHighlight`, flights to `WallTour`. None stores document data.
    """

    removed = Signal()

    def __init__(self, thickness, boxes, profile):
        shown = ShownParts(thickness, boxes)
        super().__init__(thickness, shown, boxes.head, boxes)
        self.thickness, self._profile = thickness, profile
        self._changes = None  # the ThinnerDialog that is open
        self._is_gone, self._changed = False, set()  # properties changed since the last update of the boxes
        self._observer = ObjectObserver(thickness, self)
        self._tour = tour = WallTour(thickness, shown, self)
        self._highlight = highlight = FaceHighlight(thickness, shown, self)
        distribution = DistributionPresenter(thickness, shown, highlight, boxes.distribution, self)
        self.regions = RegionPresenter(thickness, shown, highlight, tour, boxes.regions, self)
        self._faces = FacePresenter(thickness, shown, highlight, tour, boxes.faces, self)
        probes = ProbePresenter(thickness, shown, tour, boxes.probes, self)
        section = SectionPresenter(thickness, shown, boxes.section, self)
        self._presenters = [distribution, ScalePresenter(thickness, shown, boxes.scale, self), self._faces, probes,
                            self.regions, section]
        self._refresh_timer = QtCore.QTimer(self, singleShot=True, interval=0)
        self._refresh_timer.timeout.connect(self._refresh)
        self._connect(
            (self._observer.changed, self._on_changed), (self._observer.removed, self._on_removed),
            (tour.started, distribution.show_whole), (tour.reached, section.uncover),
            (tour.told, self._show_flight), (self._box.part_chosen, self._choose_part),
            (self._box.all_requested, self._choose_all), (self._box.fly_requested, tour.to_thinnest),
            (self._box.step_requested, tour.step), (self._box.export_requested, self._export),
            (self._box.changes_requested, self._show_changes),
            (shown.chosen, self._show_head), (lifelong.units.changed, self._show_unit))
        self.show()
        probes.start()

    def leave(self):
        """Disconnect everything and remove the panel's highlights from the view."""
        # Remove the observer first: FreeCAD calls it even after Qt has deleted its C++ object.
        self._observer.end()
        if self._changes is not None:
            self._changes.close()
        super().leave()
        self._refresh_timer.stop()
        for each in (self._tour, *self._presenters):
            each.leave()
        self._highlight.leave(self._is_gone)

    def show(self):
        """Show everything."""
        self._show_head()
        for presenter in self._presenters:
            presenter.show()

    def _show_flight(self, text):
        # Not a slot of the box: Qt 6 fails to disconnect what FreeCAD has already deleted.
        self._box.show_flight(text)

    def _on_removed(self):
        self._is_gone = True
        self.removed.emit()

    def _on_changed(self, name):
        # FreeCAD reports each property separately, and some of them several times.
        self._changed.add(name)
        self._refresh_timer.start()

    def _refresh(self):
        changed, self._changed = self._changed, set()
        if "Map" in changed:
            self._show_again()
            return
        for presenter in self._presenters:
            presenter.refresh(changed)
        if "Stale" in changed:
            self._box.show_stale(self.thickness.Stale)

    def _show_again(self):
        """The map was replaced."""
        try:
            self._shown.read_again()
        except ThinPartError as error:
            self._box.show_message(translated(error), can_repeat=True)
            return
        self._tour.end()
        self.regions.show_whole()
        self._highlight.show_again()
        self.show()

    def _show_unit(self):
        """Update the boxes after a change of the unit; bar widths change with it, which clears their selection."""
        self._tour.end()  # its mark has the former unit
        self.show()
        self._faces.highlight_again()

    def _show_head(self):
        rows = [PartsTableRow(part.record["name"], part.record["label"], len(part.matrices), part.record)
                for part in self._shown.all]
        shown = None if self._shown.part is None else self._shown.part.record["name"]
        self._box.show_parts(rows, self._profile, shown, self._shown.unit, self.thickness.Document.FileName)
        self._box.show_measure(self.thickness.Measure)
        self._box.show_has_before(bool(self.thickness.MapBefore))
        self._box.show_stale(self.thickness.Stale)

    def _choose_part(self, name):
        self._show_part(self._shown.names.index(name))

    def _choose_all(self):
        self._show_part(None)

    def _show_part(self, number):
        self._shown.choose(number)
        self._highlight.show_part()
        self._highlight.select_part()

    def _show_changes(self):
        if self._changes is not None:
            self._changes.close()
        try:
            dialog = ThinnerDialog(parts_before(self.thickness), self._shown.all, self._shown.unit, Gui.getMainWindow())
        except ThinPartError as error:
            self._box.show_message(translated(error))
            return
        self._changes = dialog
        dialog.visited.connect(lambda part, wall: self._tour.fly(
            wall.least, places_of_wall(self.thickness, part, wall.ends)))
        dialog.destroyed.connect(self._forget_changes)
        dialog.show()

    def _forget_changes(self, *_):
        self._changes = None

    def _export(self):
        self._box.show_export(export_map(self.thickness, self._box))

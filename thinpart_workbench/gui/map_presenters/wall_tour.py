# SPDX-License-Identifier: LGPL-2.1-or-later
"""Flights to the walls of a map, one after the other."""

import numpy as np

from ...api.window.map_values import places_of_wall, wall_under_facet, walls_between_faces
from ...freecad_adapter.objects.thickness_probes import moved_matrix
from ..application import lifelong
from ..application.qt import QtCore, Signal
from ..view3d.wall_flight import PlacedWall, WallFlight, hidden_sentence


class WallTour(QtCore.QObject):
    """Flies to walls and marks the last one, until the map moves.

    Its parameters are those of `MapPresenter`.

    Signals
    -------
    started
        A flight begins; what hides walls is to go.
    reached(object)
        The end of the wall that is looked at: ndarray of shape (3,), mm.
    told(str)
        That the wall cannot be seen; empty if it can, or where there is no flight any more.
    """

    started = Signal()
    reached = Signal(object)
    told = Signal(str)

    def __init__(self, thickness, shown, parent):
        super().__init__(parent)
        self._thickness, self._shown = thickness, shown
        self._flight, self._flown_at = WallFlight(), None  # where the map was at the last flight
        self._number = None  # of the last wall among all of them, the thinnest first
        shown.chosen.connect(self.begin_again)
        lifelong.map_events.refresh_due.add(self._leave_what_moved)

    def leave(self):
        """Remove the mark."""
        self._clear()
        lifelong.map_events.refresh_due.remove(self._leave_what_moved)

    def begin_again(self):
        """The next step is to the thinnest wall."""
        self._number = None

    def end(self):
        """Remove the mark, and what was told of its wall."""
        self._clear()
        self.told.emit("")

    def to_thinnest(self):
        """Fly to the thinnest wall."""
        self._to(0)

    def step(self, count):
        """Fly to a wall that many places further; the first is the thinnest one."""
        self._to(0 if self._number is None else self._number + count)

    def to_face(self, wall):
        """Fly to where a face of the part that is shown is thinnest: value in mm and FaceSummary."""
        value, summary = wall
        self.to_region((value, wall_under_facet(self._shown.part, summary.thinnest_facet)))

    def to_region(self, wall):
        """Fly to a wall of the part that is shown: value in mm and both ends."""
        value, ends = wall
        self.fly(value, places_of_wall(self._thickness, self._shown.part, ends))

    def fly(self, value, places):
        """Fly to a wall: see `PlacedWall`."""
        self.started.emit()
        self._flown_at = moved_matrix(self._thickness)
        is_seen = self._flight.fly(self._thickness.Document, PlacedWall(value, places), self._thickness.Diagonal,
                                   self._shown.unit)
        if self._flight.target is not None:
            self.reached.emit(self._flight.target)
        self.told.emit("" if is_seen else hidden_sentence())

    def _to(self, place):
        walls = walls_between_faces({number: part.record for number, part in self._shown.numbered.items()})
        if walls:
            self._number = place % len(walls)
            value, part, ends = walls[self._number]
            self.fly(value, places_of_wall(self._thickness, self._shown.all[part], ends))

    def _leave_what_moved(self):
        if self._flown_at is not None and not np.allclose(self._flown_at, moved_matrix(self._thickness)):
            self.end()

    def _clear(self):
        self._flight.clear()
        self._number = self._flown_at = None

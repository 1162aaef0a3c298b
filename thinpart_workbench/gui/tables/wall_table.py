# SPDX-License-Identifier: LGPL-2.1-or-later
"""Small tables of walls: one flies to the wall of a row, and by key to the next thicker and the previous one."""

from ..application.qt import QtCore, Signal, translate
from .small_table import SmallTable

_STEPS = {QtCore.Qt.Key_N: 1, QtCore.Qt.Key_P: -1}


def step_of(event):
    """1 for the key of the next wall, -1 for that of the previous one, 0 for any other key event."""
    plain = event.modifiers() in (QtCore.Qt.NoModifier, QtCore.Qt.KeypadModifier)
    return _STEPS.get(event.key(), 0) if plain else 0


def keys_hint():
    """How walls are visited, for people."""
    return translate("ThinPart", "Double-click: fly to its thinnest place. N, P: to the next and the previous one.")


class WallTable(SmallTable):
    """A table whose rows have walls.

    Parameters
    ----------
    name, columns, lines, parent
        As of `SmallTable`.
    walls_of : callable
        Maps a row to its walls, the thinnest first: list of tuples whose first item is the thickness, mm.

    Signals
    -------
    visited(object)
        The user wants to see a wall: one of those tuples.
    """

    visited = Signal(object)

    def __init__(self, name, columns, lines, walls_of, parent=None):
        super().__init__(name, columns, lines, parent)
        self._walls_of = walls_of
        self._visited = None  # the row number and the number among its walls of the last visit
        self.setToolTip(keys_hint())
        self.activated.connect(lambda index: self._visit(index.row(), 0))

    def step(self, count):
        """Visit the wall that is so many places thicker than the last one, or after none the thinnest of the current row."""
        stops = sorted(((wall[0], row, number) for row, shown in enumerate(self.rows)
                        for number, wall in enumerate(self._walls_of(shown))))
        if not stops:
            return
        selected = self.selectionModel().selectedRows()
        row = selected[0].row() if selected else None
        places = [stop[1:] for stop in stops]
        if self._visited in places and row == self._visited[0]:
            at = places.index(self._visited) + count
        elif row is None:
            at = 0
        else:
            at = next((at for at, place in enumerate(places) if place[0] == row), -1) + count
        row, number = places[at % len(places)]
        if not selected or selected[0].row() != row:
            self.selectRow(row)
            self.scrollTo(self.model().index(row, 0))
        self._visit(row, number)

    def event(self, event):
        """Keep the two keys from FreeCAD's shortcuts."""
        if event.type() == QtCore.QEvent.ShortcutOverride and step_of(event):
            event.accept()
            return True
        return super().event(event)

    def keyPressEvent(self, event):
        """Step to the next or previous wall."""
        step = step_of(event)
        if step:
            self.step(step)
        else:
            super().keyPressEvent(event)

    def _visit(self, row, number):
        walls = self._walls_of(self.rows[row])
        if number < len(walls):
            self._visited = row, number
            self.visited.emit(walls[number])

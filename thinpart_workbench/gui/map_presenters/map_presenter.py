# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the presenters of a thickness map have in common."""

from ..application.qt import QtCore, disconnect


class MapPresenter(QtCore.QObject):
    """Connects a box of the panel with a map, until `leave`; subclasses have ``show``, which shows everything.

    Parameters
    ----------
    thickness : FreeCAD.DocumentObject
        The map.
    shown : ShownParts
    box : QWidget
    parent : QObject
    """

    def __init__(self, thickness, shown, box, parent):
        super().__init__(parent)
        self._thickness, self._shown, self._box = thickness, shown, box
        self._connections = []

    def leave(self):
        """Disconnect everything."""
        for signal, slot in self._connections:
            disconnect(signal, slot)  # FreeCAD may already have deleted the box

    def refresh(self, changed):
        """Show what has changed: set of names of properties."""

    def _connect(self, *connections):
        """Connect signals, each with a slot."""
        self._connections += connections
        for signal, slot in connections:
            signal.connect(slot)

    @property
    def _view(self):
        """The ThicknessView of the map."""
        return self._thickness.ViewObject.Proxy

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reports changes of the length unit, caused by FreeCAD's unit system or by that of a document."""

import FreeCAD as App

from ...freecad_adapter.guard import guarded_methods
from .length_unit import PREFERENCES, length_unit
from .qt import QtCore, Signal


@guarded_methods("onChange")
class UnitWatch(QtCore.QObject):
    """Watches the unit preference, the documents' own unit systems, and which document is active.

    Signals
    -------
    changed
        `length_unit` returns another unit for some document, or for the active one.
    """

    changed = Signal()

    def __init__(self, observer):
        super().__init__()
        self._observer = observer
        self._group = App.ParamGet(PREFERENCES)  # it drops its observers once Python no longer references it
        # FreeCAD notifies observers of the preference before it applies it.
        self._delay = QtCore.QTimer(self, singleShot=True, interval=0)
        self._delay.timeout.connect(self._check_units)
        self._units = {}

    def begin(self):
        """Start watching; called once, when FreeCAD starts."""
        self._units = _units_by_document()
        self._group.Attach(self)
        self._observer.activated.add(self._delay.start)
        self._observer.unit_system_changed.add(self._delay.start)

    def onChange(self, _group, _name):
        """Called by FreeCAD when a unit preference has changed."""
        self._delay.start()

    def _check_units(self):
        before, self._units = self._units, _units_by_document()
        if any(unit != before.get(name, unit) for name, unit in self._units.items()):
            self.changed.emit()


def _units_by_document():
    """LengthUnit of every document by its name, and that of the active one by None."""
    units = {name: length_unit(document) for name, document in App.listDocuments().items()}
    units[None] = length_unit()
    return units

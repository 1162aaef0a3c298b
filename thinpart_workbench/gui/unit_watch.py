"""Tells when lengths are written in another unit: FreeCAD's unit system was changed, or that of a document."""

import FreeCAD as App

from ..freecad_adapter.edge import guarded_methods
from .document_observer import OBSERVER
from .length_unit import PREFERENCES, length_unit
from .qt import QtCore, Signal
from .thickness_watch import look_soon


@guarded_methods("onChange")
class UnitWatch(QtCore.QObject):
    """Follows the preference, the documents' own unit systems, and which document is active.

    Signals
    -------
    changed
        `length_unit` is another one for some document, or for the active one.
    """

    changed = Signal()

    def __init__(self):
        super().__init__()
        self._group = App.ParamGet(PREFERENCES)  # lets go of its observers when Python does not hold it
        # FreeCAD tells of the preference before it follows it itself.
        self._soon = QtCore.QTimer(self, singleShot=True, interval=0)
        self._soon.timeout.connect(self._look)
        self._known = {}

    def begin(self):
        """Follow FreeCAD; called once, when it starts."""
        self._known = _units()
        self._group.Attach(self)
        OBSERVER.on_activate(self._soon.start)
        OBSERVER.on_unit_system(self._soon.start)

    def onChange(self, _group, _name):
        """FreeCAD calls it when a preference of units was changed."""
        self._soon.start()

    def _look(self):
        before, self._known = self._known, _units()
        if any(unit != before.get(name, unit) for name, unit in self._known.items()):
            look_soon()  # colour bars and probes
            self.changed.emit()


def _units():
    """LengthUnit of every document by its name, and by None that of the active one."""
    units = {name: length_unit(document) for name, document in App.listDocuments().items()}
    units[None] = length_unit()
    return units


UNITS = UnitWatch()
"""The one of this session."""

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Observes changes and the deletion of one document object."""

import FreeCAD as App

from ...freecad_adapter.guard import guarded_methods
from ..application.qt import QtCore, Signal


@guarded_methods("slot*")
class ObjectObserver(QtCore.QObject):
    """Reports what happens to an object.

    Signals
    -------
    changed(str)
        Name of a property that was changed.
    removed
        The object, or its document, is about to be deleted.
    """

    changed = Signal(str)
    removed = Signal()

    def __init__(self, watched, parent=None):
        super().__init__(parent)
        self._document, self._name = watched.Document.Name, watched.Name
        App.addDocumentObserver(self)

    def end(self):
        """Stop observing."""
        if self._name is not None:
            self._name = None
            App.removeDocumentObserver(self)

    def slotChangedObject(self, changed, name):
        """Called by FreeCAD."""
        if changed.Name == self._name and changed.Document.Name == self._document:
            self.changed.emit(name)

    def slotDeletedObject(self, deleted):
        """Called by FreeCAD."""
        if deleted.Name == self._name and deleted.Document.Name == self._document:
            self.removed.emit()

    def slotDeletedDocument(self, document):
        """Called by FreeCAD."""
        if document.Name == self._document:
            self.removed.emit()

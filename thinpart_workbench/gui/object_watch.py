"""One object of a document, watched for changes and for its end."""

import FreeCAD as App

from ..freecad_adapter.edge import guarded_methods
from .qt import QtCore, Signal


@guarded_methods("slot*")
class ObjectWatch(QtCore.QObject):
    """Tells what happens to an object.

    Signals
    -------
    changed(str)
        Name of a property that was changed.
    removed
        The object, or its document, is about to go.
    """

    changed = Signal(str)
    removed = Signal()

    def __init__(self, watched, parent=None):
        super().__init__(parent)
        self._document, self._name = watched.Document.Name, watched.Name
        App.addDocumentObserver(self)

    def end(self):
        """Watch no longer."""
        if self._name is not None:
            self._name = None
            App.removeDocumentObserver(self)

    def slotChangedObject(self, changed, name):
        """FreeCAD calls it."""
        if changed.Name == self._name and changed.Document.Name == self._document:
            self.changed.emit(name)

    def slotDeletedObject(self, deleted):
        """FreeCAD calls it."""
        if deleted.Name == self._name and deleted.Document.Name == self._document:
            self.removed.emit()

    def slotDeletedDocument(self, document):
        """FreeCAD calls it."""
        if document.Name == self._document:
            self.removed.emit()

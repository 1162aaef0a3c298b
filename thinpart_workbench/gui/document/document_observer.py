# SPDX-License-Identifier: LGPL-2.1-or-later
"""Observes all documents: changes, saving, closing."""

import FreeCAD as App
import FreeCADGui as Gui

from ...core.hook import Hook
from ...freecad_adapter.guard import guarded_methods, report_fault


@guarded_methods("slot*")
class DocumentObserver:
    """Reports what happens to documents, and knows which of them differ from their files.

    Attributes
    ----------
    changed : Hook
        Called after every change of any object, including Undo and Redo, and after documents were opened.
    shape_changed : Hook
        Called with every object whose shape has changed.
    restored : Hook
        Called with every object that is created because its document is being opened.
    save_begun, save_ended : Hook
        Called with the document before and after saving it or a copy of it.
    saved : Hook
        Called with the name of a saved document after `save_ended`; not for copies.
    closed : Hook
        Called with the name of a document that is being closed.
    activated : Hook
        Called when another document becomes the active one.
    unit_system_changed : Hook
        Called when a document gets another unit system; documents have their own since FreeCAD 1.0.

    Notes
    -----
    FreeCAD marks a document as modified even for a change of colour. Measurements depend only on the objects, so only
    changes of objects count here.
    """

    def __init__(self):
        self._differing = set()
        self._revisions = {}
        self.changed, self.shape_changed, self.restored = _hooks(3)
        self.save_begun, self.save_ended, self.saved = _hooks(3)
        self.closed, self.activated, self.unit_system_changed = _hooks(3)

    def begin(self):
        """Start observing; called once, when FreeCAD starts."""
        App.addDocumentObserver(self)

    def differs_from_file(self, document):
        """Whether a document has no file, or its objects differ from those in the file."""
        if not document.FileName:
            return True
        return document.Name in self._differing and Gui.getDocument(document.Name).Modified

    def revision(self, name):
        """Number that increases with every change of the document's objects."""
        return self._revisions.get(name, 0)

    def slotActivateDocument(self, _document):
        """Another document is active."""
        self.activated()

    def slotChangedDocument(self, _document, name):
        """A property of a document itself was changed."""
        if name == "UnitSystem":
            self.unit_system_changed()

    def slotChangedObject(self, changed, name):
        """An object was changed."""
        if name == "Visibility" and changed.TypeId == "App::FeaturePython":
            self.changed()  # a map, which no measurement depends on, is shown or hidden
            return
        self._record_change(changed.Document)
        if name in ("Shape", "Mesh"):
            self.shape_changed(changed)

    def slotCreatedObject(self, created):
        """An object was created."""
        self._record_change(created.Document)
        if created.Document.Restoring:
            self.restored(created)

    def slotDeletedObject(self, deleted):
        """An object is about to be deleted."""
        self._record_change(deleted.Document)

    def slotUndoDocument(self, _document):
        """A transaction was undone."""
        self.changed()

    def slotRedoDocument(self, _document):
        """A transaction was redone."""
        self.changed()

    def slotFinishOpenDocument(self):
        """All documents have been opened."""
        self.changed()

    def slotStartSaveDocument(self, document, _file):
        """A document is about to be saved."""
        self.save_begun(document)

    def slotFinishSaveDocument(self, document, file):
        """A document, or a copy of it, was saved."""
        self.save_ended(document)
        if file == document.FileName:
            self._differing.discard(document.Name)
            self.saved(document.Name)

    def slotDeletedDocument(self, document):
        """A document is about to be closed."""
        name = document.Name
        self._differing.discard(name)
        self.closed(name)

    def _record_change(self, document):
        # Opening a document sets every property of every object once, which is no change.
        if not document.Restoring:
            self._differing.add(document.Name)
            self._revisions[document.Name] = self.revision(document.Name) + 1
        self.changed()


def _hooks(count):
    return [Hook(report_fault) for _ in range(count)]

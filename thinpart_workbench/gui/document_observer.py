"""What ThinPart has to know of every document: that it is changed, saved or closed."""

import FreeCAD as App
import FreeCADGui as Gui

from ..freecad_adapter.edge import guarded_methods
from ..freecad_adapter.wall_measurement import MEASUREMENT
from .face_colours import FACE_COLOURS
from .measurement_watch import revive_soon
from .thickness_watch import forget, look_soon


@guarded_methods("slot*")
class DocumentObserver:
    """Keeps analysis colours out of files, and knows which documents differ from theirs.

    Notes
    -----
    FreeCAD marks a document as modified for a colour too. What is measured depends on the objects
    alone, so it is their changes that count here.
    """

    def __init__(self):
        self._changed = set()
        self._revisions = {}
        self._on_close, self._on_save, self._on_activate, self._on_unit_system = [], [], [], []

    def differs_from_file(self, document):
        """Whether the objects of a document are not those in its file, or it has none."""
        if not document.FileName:
            return True
        return document.Name in self._changed and Gui.getDocument(document.Name).Modified

    def revision(self, name):
        """Number that is another one after every change of the objects of a document."""
        return self._revisions.get(name, 0)

    def on_close(self, call):
        """Have a function called with the name of every document that is closed."""
        self._on_close.append(call)

    def on_save(self, call):
        """Have a function called with the name of every document that was saved; copies do not count."""
        self._on_save.append(call)

    def on_activate(self, call):
        """Have a function called whenever another document becomes the active one."""
        self._on_activate.append(call)

    def on_unit_system(self, call):
        """Have a function called whenever a document gets another unit system, which those of FreeCAD 1.0 have."""
        self._on_unit_system.append(call)

    def slotActivateDocument(self, _document):
        """Another document is active."""
        for call in self._on_activate:
            call()

    def slotChangedDocument(self, _document, name):
        """A property of a document itself was changed."""
        if name == "UnitSystem":
            for call in self._on_unit_system:
                call()

    def slotChangedObject(self, changed, name):
        """An object was changed."""
        self._note(changed.Document)
        if name == "Shape":
            FACE_COLOURS.drop(changed)

    def slotCreatedObject(self, created):
        """An object was made."""
        self._note(created.Document)
        if created.TypeId == MEASUREMENT and created.Document.Restoring:
            revive_soon(created.Document.Name)

    def slotDeletedObject(self, deleted):
        """An object is about to go."""
        self._note(deleted.Document)

    def slotUndoDocument(self, _document):
        """Something was undone."""
        look_soon()

    def slotRedoDocument(self, _document):
        """Something was done again."""
        look_soon()

    def slotFinishOpenDocument(self):
        """All documents that were being opened are there."""
        look_soon()

    def slotStartSaveDocument(self, document, _file):
        """A document is about to be saved."""
        FACE_COLOURS.suspend(document)

    def slotFinishSaveDocument(self, document, file):
        """A document, or a copy of it, was saved."""
        FACE_COLOURS.resume(document)
        if file == document.FileName:
            self._changed.discard(document.Name)
            for call in self._on_save:
                call(document.Name)

    def slotDeletedDocument(self, document):
        """A document is about to be closed."""
        name = document.Name
        FACE_COLOURS.forget(name)
        self._changed.discard(name)
        forget(name)
        for call in self._on_close:
            call(name)

    def _note(self, document):
        # While a document is being opened, every property of every object is set once.
        if not document.Restoring:
            self._changed.add(document.Name)
            self._revisions[document.Name] = self.revision(document.Name) + 1
        look_soon()


OBSERVER = DocumentObserver()
"""The one observer of this session."""


def observe():
    """Start observing; called once, when FreeCAD starts."""
    App.addDocumentObserver(OBSERVER)

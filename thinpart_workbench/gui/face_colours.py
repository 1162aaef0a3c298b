"""Analysis colours on faces: shown, undone, taken back exactly, and never saved."""

from contextlib import contextmanager

import FreeCADGui as Gui

from .appearance import appearance, fingerprint, paint, set_appearance, unrecorded
from .qt import translate
from .transaction import transaction


class FaceColours:
    """Remembers for every coloured object what it looked like before.

    Notes
    -----
    Whether an object is coloured is read off the object itself, because Undo and Redo take colours
    away and bring them back without a word: every look that was painted leads to its original.
    """

    def __init__(self):
        self._originals = {}  # document name -> object name -> fingerprint -> original appearance
        self._suspended = {}  # document name -> object name -> painted appearance

    def show(self, document, painted):
        """Colour faces; what was coloured before on these objects goes.

        Parameters
        ----------
        document : FreeCAD.Document
        painted : list of tuple
            ``(object, {face index: (red, green, blue)})``.
        """
        painted = [(owner, colours) for owner, colours in painted
                   if colours or self._original(document, owner) is not None]
        if not painted:
            return
        with _unsaved_transaction(document, translate("ThinPart", "Colour thin faces")):
            for owner, colours in painted:
                self._paint(document, owner, colours)

    def clear(self, document):
        """Put every object of a document back to what it was before it was coloured."""
        with _unsaved_transaction(document, translate("ThinPart", "Clear thin colours")):
            for owner, original in self._coloured(document):
                set_appearance(owner.ViewObject, original)

    def is_shown(self, document):
        """Whether anything in a document is coloured."""
        return any(True for _ in self._coloured(document))

    def is_coloured(self, owner):
        """Whether an object is coloured."""
        return self._original(owner.Document, owner) is not None

    def drop(self, owner):
        """Put an object back whose shape has changed: its colours tell of faces that were."""
        original = self._original(owner.Document, owner)
        if original is not None:
            with unrecorded(owner.ViewObject):
                set_appearance(owner.ViewObject, original)

    def suspend(self, document):
        """Take the colours away for as long as the document is being saved."""
        suspended = self._suspended[document.Name] = {}
        for owner, original in list(self._coloured(document)):
            view = owner.ViewObject
            suspended[owner.Name] = appearance(view)
            with unrecorded(view):
                set_appearance(view, original)

    def resume(self, document):
        """Bring the colours back after saving."""
        for name, look in self._suspended.pop(document.Name, {}).items():
            view = document.getObject(name).ViewObject
            with unrecorded(view):
                set_appearance(view, look)

    def forget(self, name):
        """Drop the memory of a document that was closed."""
        self._originals.pop(name, None)
        self._suspended.pop(name, None)

    def _paint(self, document, owner, colours):
        view = owner.ViewObject
        original = self._original(document, owner)
        if original is None:
            original = appearance(view)
        else:
            set_appearance(view, original)
        if not colours:
            return
        paint(view, len(owner.Shape.Faces), colours)
        known = self._originals.setdefault(document.Name, {}).setdefault(owner.Name, {})
        known[fingerprint(view)] = original

    def _original(self, document, owner):
        """What a coloured object looked like before; None where it is not coloured."""
        known = self._originals.get(document.Name, {}).get(owner.Name)
        return known.get(fingerprint(owner.ViewObject)) if known else None

    def _coloured(self, document):
        for name in self._originals.get(document.Name, ()):
            owner = document.getObject(name)
            original = self._original(document, owner) if owner is not None else None
            if original is not None:
                yield owner, original


@contextmanager
def _unsaved_transaction(document, name):
    view = Gui.getDocument(document.Name)
    was_modified = view.Modified
    with transaction(document, name):
        yield
    if not was_modified:
        # These colours are never saved, so there is nothing to save. FreeCAD 0.20 does not listen.
        try:
            view.Modified = False
        except AttributeError:
            return


FACE_COLOURS = FaceColours()
"""The one memory of this session, shared by the commands and the document observer."""

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Analysis colours on faces: they can be undone, are removed exactly, and are never saved."""

from contextlib import contextmanager

import FreeCADGui as Gui

from ...core.rendering.alike_colours import is_alike
from ...freecad_adapter.preferences import preference
from ..application.qt import translate
from .face_appearance import appearance, colours_of, fingerprint, paint, set_appearance, unrecorded
from .transaction import transaction

NEUTRAL = (0.78, 0.79, 0.80)
"""Of what is not thin, where its own colours could be taken for analysis colours. No colour that a user would choose."""


class FaceColours:
    """Colours faces, and stores the original appearance of every coloured object.

    Notes
    -----
    Undo and Redo remove colours and bring them back without any notification. So whether an object is coloured is
    determined from the object itself: the fingerprint of each painted appearance maps to the original one.
    """

    def __init__(self):
        self._originals = {}  # document name -> object name -> fingerprint -> original appearance
        self._suspended = {}  # document name -> object name -> painted appearance

    def show(self, document, painted, others=()):
        """Colour faces, replacing earlier analysis colours of these objects.

        Parameters
        ----------
        document : FreeCAD.Document
        painted : list of tuple
            ``(object, {face index: (red, green, blue)})``.
        others : list of FreeCAD.DocumentObject, optional
            Objects that are seen beside these.

        Notes
        -----
        Where an own colour of any of them could be taken for an analysis colour, all that is not coloured is drawn neutral.
        """
        if self._is_misleading(document, [*(owner for owner, _ in painted), *others]):
            neutral = [(owner, {}) for owner in others if self._original(document, owner) is None]
            painted = [(owner, {**dict.fromkeys(range(_count(owner)), NEUTRAL), **colours})
                       for owner, colours in [*painted, *neutral]]
        painted = [(owner, colours) for owner, colours in painted
                   if colours or self._original(document, owner) is not None]
        if not painted:
            return
        with _unsaved_transaction(document, translate("ThinPart", "Colour thin faces")):
            for owner, colours in painted:
                self._paint(document, owner, colours)

    def clear(self, document):
        """Restore the original appearance of every coloured object of a document."""
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
        """Remove the colours of an object whose shape has changed: they belong to faces that no longer exist."""
        original = self._original(owner.Document, owner)
        if original is not None:
            with unrecorded(owner.ViewObject):
                set_appearance(owner.ViewObject, original)

    def suspend(self, document):
        """Remove the colours while the document is being saved."""
        suspended = self._suspended[document.Name] = {}
        for owner, original in list(self._coloured(document)):
            view = owner.ViewObject
            suspended[owner.Name] = appearance(view)
            with unrecorded(view):
                set_appearance(view, original)

    def resume(self, document):
        """Restore the colours after saving."""
        for name, painted in self._suspended.pop(document.Name, {}).items():
            view = document.getObject(name).ViewObject
            with unrecorded(view):
                set_appearance(view, painted)

    def forget(self, name):
        """Discard the stored appearances of a closed document."""
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
        paint(view, _count(owner), colours)
        known = self._originals.setdefault(document.Name, {}).setdefault(owner.Name, {})
        known[fingerprint(view)] = original

    def _is_misleading(self, document, objects):
        """Whether a colour that one of some objects has itself could be taken for an analysis colour."""
        analysis = preference("ThinColour")[:3], preference("PartlyThinColour")[:3]
        own = set()
        for owner in objects:
            own.update(colours_of(self._original(document, owner) or appearance(owner.ViewObject)))
        return any(is_alike(each, thin) for each in own for thin in analysis)

    def _original(self, document, owner):
        """The original appearance of a coloured object; None where it is not coloured."""
        known = self._originals.get(document.Name, {}).get(owner.Name)
        return known.get(fingerprint(owner.ViewObject)) if known else None

    def _coloured(self, document):
        for name in self._originals.get(document.Name, ()):
            owner = document.getObject(name)
            original = self._original(document, owner) if owner is not None else None
            if original is not None:
                yield owner, original


def _count(owner):
    """Number of the faces that an object can have colours on; a mesh has one colour."""
    return len(owner.Shape.Faces) if hasattr(owner, "Shape") else 1


@contextmanager
def _unsaved_transaction(document, name):
    view = Gui.getDocument(document.Name)
    was_modified = view.Modified
    with transaction(document, name):
        yield
    if not was_modified:
        # These colours are never saved, so the document is unmodified. FreeCAD 0.20 refuses to set this.
        try:
            view.Modified = False
        except AttributeError:
            return

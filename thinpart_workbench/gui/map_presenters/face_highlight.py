# SPDX-License-Identifier: LGPL-2.1-or-later
"""The faces that are highlighted in a map and selected in FreeCAD."""

import numpy as np

from ...api.window.map_values import faces_between
from ...freecad_adapter.objects.thickness_probes import moved_matrix
from ..application.qt import QtCore, Signal
from ..view3d.face_selection import FaceSelection, face_near

_ON_FACE = 1e-3
"""Tolerance for finding the clicked face, as a share of the diagonal: the view rounds coordinates."""


class FaceHighlight(QtCore.QObject):
    """Highlights what is chosen in the panel, and tells what the user selects in the view.

    Its parameters are those of `MapPresenter`.

    Signals
    -------
    face_selected(object)
        The user has selected a face of the part that is shown, int; or a range of thickness, and so no face, None.
    """

    face_selected = Signal(object)

    def __init__(self, thickness, shown, parent):
        super().__init__(parent)
        self._thickness, self._shown = thickness, shown
        self._selection = FaceSelection(thickness, shown.names, self)
        self._selection.face_selected.connect(self._on_face)
        self._selection.map_selected.connect(self._on_map)

    def leave(self, is_gone):
        """Observe no more, and highlight nothing; the map may be gone."""
        self._selection.end()
        try:
            if not is_gone:
                self._view.highlight(None)
                self._view.isolate()
        except (NameError, ReferenceError):
            return  # FreeCAD is closing the document and has already dropped its view

    def show_again(self):
        """The map was replaced."""
        self._selection.names = self._shown.names

    def show_part(self):
        """Highlight the part that is shown among several, and nothing else."""
        faces = self._faces_of_part()
        if faces is None:
            self._view.highlight(None)
        else:
            self._view.highlight_faces(faces)

    def select_part(self):
        """Select the part that is shown, or nothing."""
        if self._shown.number is None:
            self._selection.clear()
        else:
            self._selection.select_part(self._shown.number)

    def choose_range(self, low, high):
        """Highlight the walls of a range of thickness, mm, and select their faces; return how many these are."""
        self._view.highlight(low, high, self._faces_of_part())
        count = self._selection.select(
            {number: faces_between(part, low, high) for number, part in self._shown.numbered.items()})
        self.face_selected.emit(None)
        return count

    def clear(self):
        """Highlight the part that is shown, and select nothing."""
        self.show_part()
        self._selection.clear()

    def choose_faces(self, faces):
        """Highlight and select faces of the part that is shown: iterable of int."""
        self.show_faces(faces)
        self._selection.select({self._shown.number: list(faces)})

    def show_faces(self, faces):
        """Highlight faces of the part that is shown: iterable of int."""
        self._view.highlight_faces({self._shown.number: set(faces)})

    @property
    def _view(self):
        return self._thickness.ViewObject.Proxy

    def _faces_of_part(self):
        """All faces of the part that is shown among several; otherwise None."""
        if len(self._shown.all) == 1 or self._shown.number is None:
            return None
        return {self._shown.number: set(np.unique(self._shown.part.map.face).tolist())}

    def _on_face(self, part, face):
        if self._shown.number != part:
            self._shown.choose(part)
        self.face_selected.emit(face)
        self.show_faces([face])

    def _on_map(self, point):
        hit = face_near(self._shown.all, moved_matrix(self._thickness), np.array(point),
                        _ON_FACE * self._thickness.Diagonal)
        if hit is not None:
            self._on_face(*hit)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Synchronises faces of mapped parts with FreeCAD's selection, in both directions."""

from contextlib import contextmanager

import FreeCAD as App
import FreeCADGui as Gui

from ...api.window.open_parts import content_of
from ...core.maps.map_search import MapSearch
from ...core.rigid_transform import inverse, transform_points
from ...freecad_adapter.guard import guarded_methods
from ...freecad_adapter.occurrences.occurrences import face_at, face_paths
from ..application import lifelong
from ..application.qt import QtCore, Signal
from ..document.selection import MAX_FACES


@guarded_methods("addSelection", "removeSelection", "setSelection", "clearSelection")
class FaceSelection(QtCore.QObject):
    """The selection of one document, as faces of parts.

    Parameters
    ----------
    thickness : FreeCAD.DocumentObject
        The map of the parts.
    names : list of str
        Names of the parts, in the order of the map; set it again when the map changes.

    Signals
    -------
    face_selected(int, int)
        The user has selected a face: part number and face number, from 0.
    map_selected(object)
        The user has clicked the map in the 3D view: x, y and z in mm.
    """

    face_selected = Signal(int, int)
    map_selected = Signal(object)

    def __init__(self, thickness, names, parent=None):
        super().__init__(parent)
        self._document, self._map, self.names = thickness.Document.Name, thickness.Name, names
        self._cached_parts, self._is_own_change = (None, None), False
        Gui.Selection.addObserver(self, 0)

    def end(self):
        """Stop observing the selection."""
        Gui.Selection.removeObserver(self)

    def select(self, faces):
        """Replace the selection by faces, in the first occurrence of each part: dict of face numbers by part number.

        Returns the number of selected faces; a mesh has none.
        """
        document, count = App.getDocument(self._document), 0
        with self._own_changes():
            Gui.Selection.clearSelection(self._document)
            for number, part_faces in faces.items():
                part = self._part(number)
                if part is None:
                    continue
                root, paths = face_paths(document, part, sorted(part_faces))
                paths = paths[:MAX_FACES - count]
                count += len(paths)
                if paths:
                    Gui.Selection.addSelection(document.getObject(root), paths)
        return count

    def select_part(self, number):
        """Replace the selection by the first occurrence of a part."""
        part = self._part(number)
        with self._own_changes():
            Gui.Selection.clearSelection(self._document)
            if part is not None:
                occurrence = part.occurrences[0]
                Gui.Selection.addSelection(self._document, occurrence.root, occurrence.path)

    def clear(self):
        """Clear the selection."""
        with self._own_changes():
            Gui.Selection.clearSelection(self._document)

    def addSelection(self, document, name, path, point):
        """FreeCAD calls this when something is added to the selection."""
        if self._is_own_change or document != self._document:
            return
        if name == self._map:
            if any(point):  # otherwise it was selected in the tree
                self.map_selected.emit(point)
            return
        part, face = face_at(self._parts(), App.getDocument(document), name, path)
        if part is not None and part.name in self.names:
            self.face_selected.emit(self.names.index(part.name), face)

    def _part(self, number):
        return next((part for part in self._parts() if part.name == self.names[number]), None)

    def _parts(self):
        revision = lifelong.observer.revision(self._document)
        if self._cached_parts[0] != revision:
            self._cached_parts = revision, content_of(App.getDocument(self._document)).parts
        return self._cached_parts[1]

    @contextmanager
    def _own_changes(self):
        """Context in which selection changes come from this class, not from the user."""
        self._is_own_change = True
        try:
            yield
        finally:
            self._is_own_change = False


def face_near(parts, moved, point, reach):
    """The B-Rep face of a list of MappedPart at a point: part number and face number, from 0, or None.

    Parameters
    ----------
    moved : ndarray of shape (4, 4)
        Transform from the measured position to the current one.
    point : ndarray of shape (3,), mm
    reach : float, mm
        Maximum distance from the point.
    """
    for number, part in enumerate(parts):
        search = MapSearch(part.map)
        for matrix in part.matrices:
            facet = search.nearest_facet(transform_points(inverse(moved @ matrix), point), reach)
            if facet >= 0:
                return number, int(part.map.face[facet])
    return None

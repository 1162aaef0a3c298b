"""Faces of mapped parts in FreeCAD's selection: selected from here, and told when the user selects one."""

from contextlib import contextmanager

import FreeCAD as App
import FreeCADGui as Gui
import numpy as np

from ..core.map_search import MapSearch
from ..freecad_adapter.document_parts import document_parts
from ..freecad_adapter.edge import guarded_methods
from ..freecad_adapter.part_places import face_at, face_paths
from .document_observer import OBSERVER
from .qt import QtCore, Signal

MOST = 2000
"""Faces that are selected at once: FreeCAD takes long for more, and draws each."""


@guarded_methods("addSelection", "removeSelection", "setSelection", "clearSelection")
class FaceSelection(QtCore.QObject):
    """The selection of one document, as faces of parts.

    Parameters
    ----------
    thickness : FreeCAD.DocumentObject
        The map of the parts.
    names : list of str
        Of the parts, in the order of the map; to be set where the map is another one.

    Signals
    -------
    face_selected(int, int)
        The user has selected a face: number of the part and of the face, from 0.
    map_selected(object)
        The user has clicked on the map in the 3D view; the place, x, y and z in mm.
    """

    face_selected = Signal(int, int)
    map_selected = Signal(object)

    def __init__(self, thickness, names, parent=None):
        super().__init__(parent)
        self._document, self._map, self.names = thickness.Document.Name, thickness.Name, names
        self._known, self._is_ours = (None, None), False
        Gui.Selection.addObserver(self, 0)

    def end(self):
        """Look at the selection no longer."""
        Gui.Selection.removeObserver(self)

    def select(self, faces):
        """Select faces where their parts stand first, and nothing else.

        Parameters
        ----------
        faces : dict
            Numbers of faces by the number of the part.

        Returns
        -------
        int
            How many were selected; none of a mesh.
        """
        document, count = App.getDocument(self._document), 0
        with self._ourselves():
            Gui.Selection.clearSelection(self._document)
            for number, wanted in faces.items():
                part = self._part(number)
                if part is None:
                    continue
                root, paths = face_paths(document, part, sorted(wanted))
                paths = paths[:MOST - count]
                count += len(paths)
                if paths:
                    Gui.Selection.addSelection(document.getObject(root), paths)
        return count

    def select_part(self, number):
        """Select a part where it stands first, and nothing else."""
        part = self._part(number)
        with self._ourselves():
            Gui.Selection.clearSelection(self._document)
            if part is not None:
                place = part.occurrences[0]
                Gui.Selection.addSelection(self._document, place.root, place.path)

    def clear(self):
        """Select nothing."""
        with self._ourselves():
            Gui.Selection.clearSelection(self._document)

    def addSelection(self, document, name, path, place):
        """FreeCAD calls it when something was added."""
        if self._is_ours or document != self._document:
            return
        if name == self._map:
            if any(place):  # otherwise it was selected in the tree
                self.map_selected.emit(place)
            return
        part, face = face_at(self._parts(), App.getDocument(document), name, path)
        if part is not None and part.name in self.names:
            self.face_selected.emit(self.names.index(part.name), face)

    def _part(self, number):
        return next((part for part in self._parts() if part.name == self.names[number]), None)

    def _parts(self):
        revision = OBSERVER.revision(self._document)
        if self._known[0] != revision:
            self._known = revision, document_parts(App.getDocument(self._document))
        return self._known[1]

    @contextmanager
    def _ourselves(self):
        """What is selected meanwhile was not selected by the user."""
        self._is_ours = True
        try:
            yield
        finally:
            self._is_ours = False


def face_near(parts, moved, point, reach):
    """The B-Rep face of mapped parts at a point of the 3D view.

    Parameters
    ----------
    parts : list of MappedPart
    moved : ndarray of shape (4, 4)
        From where they were measured to where they stand.
    point : ndarray of shape (3,), mm
    reach : float, mm
        What is further away is not meant.

    Returns
    -------
    tuple of int or None
        Numbers of the part and of the face, from 0.
    """
    for number, part in enumerate(parts):
        search = MapSearch(part.map)
        for matrix in part.places:
            back = np.linalg.inv(moved @ matrix)
            facet = search.at(back[:3, :3] @ point + back[:3, 3], reach)
            if facet >= 0:
                return number, int(part.map.face[facet])
    return None

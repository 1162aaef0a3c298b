"""Presents the faces of the part that is shown."""

from ...core.maps.map_summary import face_summaries
from ..application.qt import QtCore, disconnect
from .map_properties import THIN

_DELAY = 200
"""Milliseconds after the last threshold change before the table is updated."""


class FacePresenter(QtCore.QObject):
    """Connects the box of faces with a map; see `ThicknessPresenter` for the parameters."""

    def __init__(self, thickness, shown, highlight, tour, box, parent):
        super().__init__(parent)
        self._thickness, self._shown, self._highlight, self._box = thickness, shown, highlight, box
        self._timer = QtCore.QTimer(self, singleShot=True, interval=_DELAY)
        self._timer.timeout.connect(self.show)
        self._connections = [(box.face_chosen, lambda face: highlight.choose_faces([face])), (box.visited, tour.to_face),
                             (highlight.face_selected, lambda face: box.table.select_face(face)), (shown.chosen, self.show)]
        for signal, slot in self._connections:
            signal.connect(slot)

    def leave(self):
        """Disconnect everything."""
        self._timer.stop()
        for signal, slot in self._connections:
            disconnect(signal, slot)

    def show(self):
        """Show everything."""
        part = self._shown.part
        if part is None:
            self._box.show_no_part()
        else:
            self._box.show_faces(face_summaries(part.map, self._thickness.Threshold), part.features, self._shown.unit,
                                 part.record, self._thickness.Document.FileName)

    def refresh(self, changed):
        """Show what has changed, a moment later: set of names of properties."""
        if changed & set(THIN):
            self._timer.start()

    def highlight_again(self):
        """Highlight the selected face, or the part that is shown."""
        row = self._box.table.current_row
        if row is None:
            self._highlight.show_part()
        else:
            self._highlight.show_faces([row.summary.face])

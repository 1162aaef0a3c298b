# SPDX-License-Identifier: LGPL-2.1-or-later
"""Presents the faces of the part that is shown."""

from ...core.maps.map_summary import face_summaries
from ..application import lifelong
from ..application.qt import QtCore, translate
from .map_presenter import MapPresenter
from .map_properties import THIN

_DELAY = 200
"""Milliseconds after the last threshold change before the table is updated."""


class FacePresenter(MapPresenter):
    """Connects the box of faces with a map."""

    def __init__(self, thickness, shown, highlight, tour, box, parent):
        super().__init__(thickness, shown, box, parent)
        self._highlight = highlight
        self._timer = QtCore.QTimer(self, singleShot=True, interval=_DELAY)
        self._timer.timeout.connect(self.show)
        self._connect(
            (box.face_chosen, lambda face: highlight.choose_faces([face])), (box.visited, tour.to_face),
            (highlight.face_selected, lambda face: box.table.select_face(face)), (shown.chosen, self.show),
            (box.limited, self._keep), (lifelong.face_limits.answered, self._on_limits))
        if thickness.Document.FileName:
            lifelong.face_limits.read(thickness.Document.FileName)

    def leave(self):
        """Disconnect everything."""
        self._timer.stop()
        super().leave()

    def show(self):
        """Show everything."""
        part = self._shown.part
        if part is None:
            self._box.show_no_part()
        else:
            self._box.show_faces(face_summaries(part.map, self._thickness.Threshold), part.features, self._shown.unit,
                                 part.record, self._thickness.Document.FileName)
            self._show_limits()

    def _show_limits(self, problem=""):
        known, part = lifelong.face_limits.known(self._thickness.Document.FileName), self._shown.part
        if part is not None:
            self._box.show_limits((known or {}).get(part.record["name"], ()), "" if known is not None else translate(
                "ThinPart", "There is no info file to keep this in: press 'Save and write info file' above, or classify the "
                            "document."), problem)

    def _keep(self, face, limits):
        lifelong.face_limits.keep(self._thickness.Document.FileName, self._shown.part.record["name"], [face], **limits)

    def _on_limits(self, document, sentence):
        if document == self._thickness.Document.FileName:
            self._show_limits(sentence)

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

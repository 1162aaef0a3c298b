# SPDX-License-Identifier: LGPL-2.1-or-later
"""Presents the wall regions of a map: what the mouse is over, what is isolated, and what people say of them."""

from ..application import lifelong
from ..application.qt import translate
from .map_presenter import MapPresenter


class RegionPresenter(MapPresenter):
    """Connects the box of wall regions with the view of the map and with the info file."""

    def __init__(self, thickness, shown, highlight, tour, box, parent):
        super().__init__(thickness, shown, box, parent)
        self._highlight = highlight
        # By part name; None while there is no info file.
        self._notes = lifelong.region_notes.known(thickness.Document.FileName)
        self._former = None  # what was highlighted before the mouse was over a region
        self._connect(
            (box.hovered, self._hover), (box.isolated, self._isolate), (box.said, self._keep),
            (box.faces_chosen, self._choose), (box.visited, tour.to_region), (shown.chosen, self.show),
            (lifelong.region_notes.answered, self._on_answered))
        box.show_isolated(False)
        box.show_message("")
        self.read_notes()

    def show(self):
        """Show everything."""
        part = self._shown.part
        if part is None:
            self._box.show_no_part()
            return
        notes = (self._notes or {}).get(part.record["name"], ())
        self._box.show_regions(part.record, self._shown.unit, part.features, notes, self._refusal(),
                               self._thickness.Document.FileName)

    def show_whole(self):
        """The map was replaced, and is drawn whole."""
        self._box.show_isolated(False)

    def read_notes(self):
        """Read what people say of regions, in another process."""
        if self._thickness.Document.FileName:
            lifelong.region_notes.read(self._thickness.Document.FileName)

    def _hover(self, group):
        """Highlight what the mouse is over; afterwards the former highlight is back."""
        if group is None:
            former, self._former = self._former, None
            if former is not None:
                self._view.restore_highlight(former)
            return
        if self._former is None:
            self._former = self._view.highlighting
        self._highlight.show_faces(group.faces)

    def _choose(self, faces):
        self._highlight.choose_faces(faces)
        self._former = None  # what is highlighted stays when the mouse leaves the table

    def _isolate(self, faces):
        self._view.isolate(None if faces is None else {self._shown.number: set(faces)})
        self._box.show_isolated(faces is not None)

    def _refusal(self):
        """Why nothing can be kept of regions, in a sentence; empty if it can."""
        if self._notes is not None:
            return ""
        return translate("ThinPart", "There is no info file to keep this in: press 'Save and write info file' above, or "
                                     "classify the document.")

    def _keep(self, regions, said):
        self._box.show_message("")
        lifelong.region_notes.keep(self._thickness.Document.FileName, self._shown.part.record["name"], regions, **said)

    def _on_answered(self, document, sentence):
        if document != self._thickness.Document.FileName:
            return
        self._box.show_message(sentence)
        if not sentence:
            self._notes = lifelong.region_notes.known(document)
            self._hover(None)
            self.show()

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The element sizes that are wanted on the walls of a part."""

from ...api.window.walls import noted_sizes
from ..application import lifelong
from ..application.qt import QtCore, Signal


class WallSizes(QtCore.QObject):
    """Sizes that people noted in the panel of the thickness map, that worked for a part alike, and that are typed.

    Signals
    -------
    noted
        Notes have come in after the part was measured, and nothing was typed yet.
    """

    noted = Signal()

    def __init__(self, document, parent):
        super().__init__(parent)
        self._document, self._record, self._is_typed = document, None, False
        self._sizes = {}  # mm, or None for none, by number of the listed region
        lifelong.region_notes.answered.connect(self._on_notes)

    def read_notes(self):
        """Read what is noted, which takes a moment."""
        if self._document.FileName:
            lifelong.region_notes.read(self._document.FileName)

    def show_record(self, record):
        """The part was measured: take over what is noted of its walls."""
        self._record = record
        notes = (lifelong.region_notes.known(self._document.FileName) or {}).get(record["name"], ())
        self._sizes.update(noted_sizes(record, notes))

    def wanted(self):
        """list of (number of a region, size in mm or None), in their order."""
        return sorted(self._sizes.items())

    def type(self, sizes):
        """Set what was typed: dict."""
        self._is_typed = True
        self._sizes.update(sizes)

    def take_over(self, sizes):
        """Set sizes that worked: list of pairs."""
        self._sizes.update(map(tuple, sizes))

    def leave(self):
        """Listen no more."""
        lifelong.region_notes.answered.disconnect(self._on_notes)

    def _on_notes(self, document, _sentence):
        if document == self._document.FileName and self._record is not None and not self._is_typed:
            self.show_record(self._record)
            self.noted.emit()

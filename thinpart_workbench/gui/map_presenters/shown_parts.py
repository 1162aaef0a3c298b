# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parts of a map, and which of them the panel shows."""

from ...api.document_maps import parts_of
from ..application.length_unit import length_unit
from ..application.qt import QtCore, Signal


class ShownParts(QtCore.QObject):
    """All parts, or one of them; a single part is always shown as one.

    Attributes
    ----------
    all : list of MappedPart
    number : int or None
        Of the one that is shown; None for all.

    Signals
    -------
    chosen
        Another part is shown, or all are.

    Raises
    ------
    ThinPartError
        If the map cannot be read.
    """

    chosen = Signal()

    def __init__(self, thickness, parent):
        super().__init__(parent)
        self._thickness = thickness
        self.all = parts_of(thickness)
        self.number = 0 if len(self.all) == 1 else None

    @property
    def part(self):
        """MappedPart or None: the one that is shown."""
        return None if self.number is None else self.all[self.number]

    @property
    def numbered(self):
        """dict of int to MappedPart: those that are shown."""
        return {number: part for number, part in enumerate(self.all) if self.number in (None, number)}

    @property
    def shown(self):
        """list of MappedPart"""
        return list(self.numbered.values())

    @property
    def names(self):
        """list of str: names of all parts."""
        return [part.record["name"] for part in self.all]

    @property
    def unit(self):
        """LengthUnit of the document."""
        return length_unit(self._thickness.Document)

    def choose(self, number):
        """Show one part by its number, or all with None."""
        self.number = number
        self.chosen.emit()

    def read_again(self):
        """The map was replaced; raises like the constructor."""
        self.all = parts_of(self._thickness)
        if self.number is not None and self.number >= len(self.all):
            self.number = None

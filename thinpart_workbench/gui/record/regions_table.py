# SPDX-License-Identifier: LGPL-2.1-or-later
"""Table of the wall regions of a part, equal ones in one row."""

from ...api.window.walls import grouped_walls
from ...core.descriptors.region_kinds import BAR, BLOCK, PLATE, RIB, TAPER, THREAD, TOOTH, TUBE
from ...core.length_unit import MILLIMETRE
from ..application.qt import Signal, translate
from ..tables.column import Column, area, count, figures, length
from ..tables.wall_table import WallTable

_LINES = 6


class RegionsTable(WallTable):
    """Thickness, area, length and feature of each region, excluded ones struck through; hidden where there are none.

    Signals
    -------
    faces_chosen(object)
        The user has made a row the current one: tuple of the face numbers of its regions, from 0.
    visited(object)
        The user wants to see where a region is thinnest: an item of `RegionGroup.walls`. A click does, too.
    hovered(object)
        The mouse is over a row: its `RegionGroup`; None where it has left the rows.
    """

    faces_chosen = Signal(object)
    hovered = Signal(object)

    def __init__(self, parent=None):
        # The other columns have the unit in their titles.
        super().__init__("ThinPart_RegionsTable", _columns()[:1], _LINES, lambda group: group.walls, parent)
        self.setToolTip(translate("ThinPart", "Click: fly to its thinnest place. N, P: to the next and the previous one."))
        self.row_chosen.connect(lambda group: self.faces_chosen.emit(group.faces))
        self.clicked.connect(self.activated)
        self.setMouseTracking(True)
        self.entered.connect(lambda index: self.hovered.emit(self.rows[index.row()]))
        self.viewportEntered.connect(lambda: self.hovered.emit(None))
        self.hide()

    def show_regions(self, record, unit, features=(), notes=None, file=""):
        """Show the regions of a part record; none is selected.

        Parameters
        ----------
        record : PartRecord
        unit : LengthUnit
        features : list of str
            The feature that made each face, by face number; empty where that is not known.
        notes : list of dict, optional
            What people say of regions; by default what the record has.
        file : str, optional
            Path of the part's document.
        """
        found = grouped_walls(record, notes, features)
        groups = [group for group, _ in found]
        made_by = {id(group): ", ".join(made) for group, made in found} if features else {}
        self.show_rows(groups, _columns(made_by), unit, subject=(file, record["name"], record["label"]))
        self.setVisible(bool(groups))

    def leaveEvent(self, event):
        """The mouse is over no row any more."""
        super().leaveEvent(event)
        self.hovered.emit(None)


def notes_text(groups, unit):
    """What people say of groups of regions: list of str, a line for each of which they say something."""
    return [translate("ThinPart", "{}, {}: {}").format(_kind_text(group), unit.text(group.least), _said_of(group, unit))
            for group in groups if group.excluded or group.mesh_size]


def _said_of(group, unit):
    """What people say of a group of regions, in words."""
    said = []
    if group.excluded:
        said.append(translate("ThinPart", "excluded: {}").format(group.excluded))
    if group.mesh_size:
        said.append(translate("ThinPart", "element size {}").format(unit.text(group.mesh_size)))
    return ", ".join(said)


def _columns(made_by=None):
    def add(make, *of_column, **more):
        columns.append(make(*of_column, is_struck=lambda group: bool(group.excluded), **more))

    columns = []
    add(Column, "wall", translate("ThinPart", "Wall"), lambda group: group.word, lambda group, unit: _kind_text(group),
        stretches=True, meaning=translate("ThinPart", "Connected walls of like thickness"))
    add(Column, "thinnest_mm", translate("ThinPart", "Thick, {}"), lambda group: group.least, _thickness, is_number=True,
        has_unit=True, least=9, meaning=translate("ThinPart", "Least and median thickness of the wall"))
    add(figures, "area_mm2", translate("ThinPart", "Area, {}\u00b2"), lambda group: group.area, area,
        meaning=translate("ThinPart", "Area of both of its sides"))
    add(figures, "length_mm", translate("ThinPart", "Long, {}"), lambda group: group.length, length,
        meaning=translate("ThinPart", "Length of the wall"))
    if made_by:
        add(Column, "made_by", translate("ThinPart", "Made by"), lambda group: made_by.get(id(group), ""), least=5)
    add(figures, "count", translate("ThinPart", "Instances"), lambda group: group.count, count, is_hidden=True)
    add(figures, "median_mm", translate("ThinPart", "Median, {}"), lambda group: group.median, length, is_hidden=True)
    add(Column, "notes", translate("ThinPart", "Notes"), lambda group: _said_of(group, MILLIMETRE), _said_of, is_hidden=True)
    add(Column, "faces", translate("ThinPart", "Faces"),
        lambda group: " ".join(f"Face{face + 1}" for face in group.faces), is_hidden=True)
    return columns


def _kind_text(group):
    return counted_kind(group.word, group.count)


def counted_kind(word, count):
    """So many equal regions, by what people call them: "18 x tooth"."""
    return kind_word(word) if count == 1 else f"{count} \u00d7 {kind_word(word)}"


def kind_word(kind):
    """What people call a kind of region."""
    words = {
        PLATE: translate("ThinPart", "plate"), TUBE: translate("ThinPart", "tube"), BAR: translate("ThinPart", "bar"),
        BLOCK: translate("ThinPart", "block"), TAPER: translate("ThinPart", "taper"),
        TOOTH: translate("ThinPart", "tooth"), THREAD: translate("ThinPart", "thread"),
        RIB: translate("ThinPart", "rib"),
    }
    return words.get(kind, kind)


def _thickness(group, unit):
    least, median = unit.number(group.least), unit.number(group.median)
    return least if least == median else f"{least}\u2013{median}"

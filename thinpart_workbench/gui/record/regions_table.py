"""Table of the wall regions of a part, equal ones in one row."""

from dataclasses import replace

from ...core.descriptors.region_kinds import BAR, BLOCK, PLATE, TAPER, TOOTH, TUBE
from ...core.length_unit import MILLIMETRE
from ...core.record.region_groups import features_of, region_groups
from ..application.numbers import number
from ..application.qt import Signal, translate
from ..widgets.record_table_view import RecordColumn
from ..widgets.wall_table_view import WallTableView

_LINES = 6


class RegionsTable(WallTableView):
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
        super().__init__("ThinPart_RegionsTable", _columns(MILLIMETRE)[:1], _LINES, lambda group: group.walls, parent)
        self.setToolTip(translate("ThinPart", "Click: fly to its thinnest place. N, P: to the next and the previous one."))
        self.row_chosen.connect(lambda group: self.faces_chosen.emit(group.faces))
        self.clicked.connect(self.activated)
        self.setMouseTracking(True)
        self.entered.connect(lambda index: self.hovered.emit(self.rows[index.row()]))
        self.viewportEntered.connect(lambda: self.hovered.emit(None))
        self.hide()

    def show_regions(self, record, unit, features=(), notes=None):
        """Show the regions of a part record; none is selected.

        Parameters
        ----------
        record : PartRecord
        unit : LengthUnit
        features : list of str
            The feature that made each face, by face number; empty where that is not known.
        notes : list of dict, optional
            What people say of regions; by default what the record has.
        """
        groups = region_groups(record, notes)
        made_by = {id(group): ", ".join(features_of(group, record, features)) for group in groups} if features else {}
        self.set_columns(_columns(unit, made_by))
        self.set_rows(groups)
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


def _columns(unit, made_by=None):
    columns = [
        RecordColumn(translate("ThinPart", "Wall"), _kind_text, lambda group: group.kind, stretches=True,
                     meaning=translate("ThinPart", "Connected walls of like thickness")),
        RecordColumn(translate("ThinPart", "Thick, {}").format(unit.symbol), lambda group: _thickness(group, unit),
                     lambda group: group.least, is_number=True,
                     meaning=translate("ThinPart", "Least and median thickness of the wall")),
        RecordColumn(translate("ThinPart", "Area, {}\u00b2").format(unit.symbol),
                     lambda group: number(group.area / unit.millimetres ** 2), lambda group: group.area, is_number=True,
                     meaning=translate("ThinPart", "Area of both of its sides")),
        RecordColumn(translate("ThinPart", "Long, {}").format(unit.symbol), lambda group: unit.number(group.length),
                     lambda group: group.length, is_number=True, meaning=translate("ThinPart", "Length of the wall")),
    ]
    if made_by:
        columns.append(RecordColumn(translate("ThinPart", "Made by"), lambda group: made_by.get(id(group), ""),
                                    lambda group: made_by.get(id(group), "").casefold() or None))
    return [replace(column, is_struck=lambda group: bool(group.excluded)) for column in columns]


def _kind_text(group):
    text = kind_word(group.kind)
    return text if group.count == 1 else f"{group.count} \u00d7 {text}"


def kind_word(kind):
    """What people call a kind of region."""
    words = {
        PLATE: translate("ThinPart", "plate"), TUBE: translate("ThinPart", "tube"), BAR: translate("ThinPart", "bar"),
        BLOCK: translate("ThinPart", "block"), TAPER: translate("ThinPart", "taper"),
        TOOTH: translate("ThinPart", "tooth"),
    }
    return words.get(kind, kind)


def _thickness(group, unit):
    least, median = unit.number(group.least), unit.number(group.median)
    return least if least == median else f"{least}\u2013{median}"

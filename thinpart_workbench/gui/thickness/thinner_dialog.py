# SPDX-License-Identifier: LGPL-2.1-or-later
"""The window that shows what became thinner: the map of before beside that of now, and the walls that changed."""

from dataclasses import dataclass

from ...core.maps.map_changes import ThinnerWall, thinner_walls
from ...core.maps.map_summary import typical_range
from ...core.maps.mapped_part import MappedPart
from ...core.rendering.map_picture import VIEWS, MapLook, map_picture
from ..application.numbers import percent
from ..application.qt import QtCore, QtGui, QtWidgets, Signal, named, translate
from ..record.record_view import show_text, text_line
from ..tables.column import Column, area, figures, length
from ..tables.wall_table import WallTable

_LINES = 8
_WIDTH, _HEIGHT = 440, 360
"""Size of each picture, pixels."""


@dataclass(frozen=True)
class _ThinnerRow:
    """A wall, and the part that has it."""

    part: MappedPart
    wall: ThinnerWall


class ThinnerDialog(QtWidgets.QDialog):
    """Non-modal window of a comparison.

    Parameters
    ----------
    before, now : list of MappedPart
        Parts are the same where they have the same name.
    unit : LengthUnit
    parent : QWidget

    Signals
    -------
    visited(object, object)
        The user wants to see a wall: the MappedPart of now, and the ThinnerWall.
    """

    visited = Signal(object, object)

    def __init__(self, before, now, unit, parent):
        super().__init__(parent)
        self.setObjectName("ThinPart_ThinnerWalls")
        self.setWindowTitle(translate("ThinPart", "What became thinner"))
        self.setAttribute(QtCore.Qt.WA_DeleteOnClose)
        self._unit = unit
        was = {part.record["name"]: part for part in before}
        self._pairs = [(was[part.record["name"]], part) for part in now if part.record["name"] in was and
                       part.map.measure == was[part.record["name"]].map.measure]
        rows = [_ThinnerRow(part, wall) for old, part in self._pairs for wall in thinner_walls(old.map, part.map)]
        self._shown = next(((old, part) for old, part in self._pairs if rows and part is rows[0].part), None) or (
            self._pairs[0] if self._pairs else None)
        column = QtWidgets.QVBoxLayout(self)
        self._add_pictures(column)
        self._told = text_line(self, column, "ThinPart_ThinnerText")
        self.table = WallTable("ThinPart_ThinnerTable", _columns(len(now) > 1), _LINES,
                               lambda row: [(row.wall.least, row)], self)
        self.table.row_chosen.connect(self._visit)
        self.table.visited.connect(lambda found: self._visit(found[1]))
        column.addWidget(self.table)
        self.table.show_rows(rows, unit=unit)
        show_text(self._told, self._sentence(rows))
        self._draw()

    def _sentence(self, rows):
        if not self._pairs:
            return translate("ThinPart", "The map of before is of other parts, or was measured in another way.")
        if not rows:
            return translate("ThinPart", "No wall became thinner.")
        return translate("ThinPart", "Walls that became thinner, the one that lost most first. Click: fly to it.")

    def _add_pictures(self, column):
        row = QtWidgets.QHBoxLayout()
        self._pictures = []
        for name, title in (("Before", translate("ThinPart", "Before")), ("Now", translate("ThinPart", "Now"))):
            side = QtWidgets.QVBoxLayout()
            side.addWidget(QtWidgets.QLabel(title, self))
            picture = named(QtWidgets.QLabel(self), f"ThinPart_Thinner{name}")
            picture.setFixedSize(_WIDTH, _HEIGHT)
            side.addWidget(picture)
            row.addLayout(side)
            self._pictures.append(picture)
        column.addLayout(row)
        self._view = named(QtWidgets.QComboBox(self), "ThinPart_ThinnerView", translate("ThinPart", "From where it is seen"))
        for name, title in zip(VIEWS, (
                translate("ThinPart", "Isometric"), translate("ThinPart", "From behind and below"),
                translate("ThinPart", "Front"), translate("ThinPart", "Rear"), translate("ThinPart", "Left"),
                translate("ThinPart", "Right"), translate("ThinPart", "Top"), translate("ThinPart", "Bottom"))):
            self._view.addItem(title, name)
        self._view.currentIndexChanged.connect(lambda _: self._draw())
        column.addWidget(self._view)

    def _visit(self, row):
        pair = next((pair for pair in self._pairs if pair[1] is row.part), self._shown)
        if pair is not self._shown:
            self._shown = pair
            self._draw()
        self.visited.emit(row.part, row.wall)

    def _draw(self):
        """Draw both maps of the part that is shown, in the colours of one range."""
        ends = typical_range(list(self._shown)) if self._shown else None
        if ends is None:
            return
        look = MapLook(low=ends[0], high=ends[1], unit=self._unit.symbol, view=self._view.currentData(), width=_WIDTH,
                       height=_HEIGHT)
        for label, part in zip(self._pictures, self._shown):
            pixels = map_picture(part, look)
            image = QtGui.QImage(pixels.tobytes(), _WIDTH, _HEIGHT, 4 * _WIDTH, QtGui.QImage.Format_RGBA8888)
            label.setPixmap(QtGui.QPixmap.fromImage(image.copy()))


def _columns(has_parts):
    columns = [Column("part", translate("ThinPart", "Part"), lambda row: row.part.record["label"], stretches=True,
                      is_path=True, least=8)] if has_parts else []
    return columns + [
        figures("before_mm", translate("ThinPart", "Before, {}"), lambda row: row.wall.before, length,
                meaning=translate("ThinPart", "Median thickness of the wall")),
        figures("now_mm", translate("ThinPart", "Now, {}"), lambda row: row.wall.now, length,
                meaning=translate("ThinPart", "Median thickness of the wall")),
        figures("least_mm", translate("ThinPart", "Thinnest, {}"), lambda row: row.wall.least, length),
        figures("lost", translate("ThinPart", "Lost"), lambda row: 1.0 - row.wall.now / row.wall.before,
                lambda share, unit: percent(share)),
        figures("area_mm2", translate("ThinPart", "Area, {}\u00b2"), lambda row: row.wall.area, area,
                meaning=translate("ThinPart", "Area of both of its sides")),
        Column("faces", translate("ThinPart", "Faces"), lambda row: " ".join(f"Face{face + 1}" for face in row.wall.faces)),
    ]

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The part of the panel that makes a shell: settings, the walls of the mid-surface, and what is left solid."""

from typing import NamedTuple, Optional

from ...core.shells.shell_settings import ShellSettings
from ..application.length_unit import MILLIMETRE
from ..application.numbers import percent
from ..application.qt import QtWidgets, Signal, grouped, named, translate
from ..application.sentences import translated
from ..record.record_view import show_text, text_line
from ..record.regions_table import kind_word
from ..tables.column import Column, area, figures, length, square
from ..widgets.buttons import add_button
from .mesh_fields import number_field, order_combo
from .scale_bar import ScaleBar
from .wall_table import WALL, CheckedWalls


class _Wall(NamedTuple):
    """A wall: its word, thickness and area, mm and mm2, its faces, its colour or None, and whether it is in the shell, None
    where it cannot be."""

    word: str
    thickness: float
    area: Optional[float]
    faces: tuple
    rgb: Optional[tuple]
    is_in: Optional[bool]


class ShellBox(QtWidgets.QWidget):
    """The widgets, without logic.

    Signals
    -------
    changed
        A setting was changed.
    shell_requested, shown_changed
        The button was pressed; what the view is to show was changed.
    faces_chosen(object)
        Tuple of face numbers of the part, from 0, of the selected rows.
    """

    changed = Signal()
    shell_requested = Signal()
    shown_changed = Signal()
    faces_chosen = Signal(object)

    def __init__(self, parent=None):
        super().__init__(parent)
        self.setObjectName("ThinPart_ShellBox")
        self._unit = MILLIMETRE
        self._walls, self._solid = [], set()  # those that a shell could have; the faces of those that stay solid
        rows = QtWidgets.QVBoxLayout(self)
        rows.setContentsMargins(0, 0, 0, 0)
        form = QtWidgets.QFormLayout()
        form.setRowWrapPolicy(QtWidgets.QFormLayout.WrapLongRows)
        rows.addLayout(form)
        self._order = order_combo("ThinPart_ShellOrder", self)
        self._order.setCurrentIndex(ShellSettings.order - 1)
        self._order.setToolTip(translate("ThinPart", "Linear triangles are far too stiff in CalculiX."))
        self._order.currentIndexChanged.connect(lambda *_: self.changed.emit())
        self._size = number_field("ThinPart_ShellSize", self, 0.0, 0.0, 1e6)
        self._size.changed.connect(self.changed)
        form.addRow(translate("ThinPart", "Elements"), self._order)
        form.addRow(translate("ThinPart", "Largest size"), self._size)
        self.button = add_button(rows, self, "ThinPart_ShellButton", translate("ThinPart", "Make shell"),
                                 self.shell_requested.emit)
        self.walls = CheckedWalls("ThinPart_ShellWalls", _columns(), lambda wall: wall.faces, self)
        self.walls.setToolTip(translate(
            "ThinPart", "Without the check mark, a wall stays solid and is not in the shell."))
        self.walls.faces_chosen.connect(self.faces_chosen)
        self.walls.model().edited.connect(self._on_edited)
        rows.addWidget(self.walls)
        self.preview = named(
            QtWidgets.QCheckBox(translate("ThinPart", "Show the shell by its thickness"), self), "ThinPart_ShellPreview")
        self.preview.setChecked(True)
        self.preview.toggled.connect(lambda *_: self.shown_changed.emit())
        rows.addWidget(self.preview)
        self._bar = ScaleBar("ThinPart_ShellBar", self)
        rows.addWidget(self._bar)
        self._figures = text_line(self, rows, "ThinPart_ShellFigures")
        self.show_shell(None, None)

    def settings(self):
        """The fields as arguments of `ShellSettings`: dict."""
        size = self._size.exact()
        return {"order": 1 + self._order.currentIndex(), "size": size if size > 0.0 else None,
                "solid_walls": sorted(self._solid)}

    def show_walls(self, walls):
        """Show the walls that a shell could have, all of them as shells: list of dict, see `PartSizes.shell_walls`."""
        self._walls, self._solid = [{**wall, "faces": tuple(wall["faces"])} for wall in walls], set()
        self.show_shell(None, None)

    def show_unit(self, unit):
        """Show lengths in a unit."""
        self._unit = unit
        self._size.set_form(1.0 / unit.millimetres, "\u00a0" + unit.symbol, unit.decimals, 0.0)
        self._size.setSpecialValueText(translate("ThinPart", "automatic"))
        self.show_shell(None, None)

    def show_shell(self, found, scale):
        """Show a shell, see `PartSizes.shell`, with the colours of its thickness; None for none."""
        unit = self._unit
        self.walls.setVisible(found is not None or bool(self._walls))
        self.preview.setVisible(found is not None)
        self._bar.show_scale(scale, unit)
        if found is None:
            show_text(self._figures, "")
            self._fill(self._walls, (), None)
            return
        thick = [wall["thickness"] for wall in found["walls"]]
        lines = [translate("ThinPart", "{} triangles of up to {}; walls {} thick, {} of the part's volume.").format(
            grouped(found["elements"]), unit.text(found["size"]), _range(thick, unit), percent(found["volume_share"]))]
        if found["left_solid"]:
            lines.append(translate("ThinPart", "Left solid, not in the shell: {} walls, last in the table.").format(
                len(found["left_solid"])))
        show_text(self._figures, "\n".join(lines + [translated(each, unit) for each in found["warnings"]]))
        if not self._size.exact():
            self._size.setSpecialValueText(translate("ThinPart", "automatic: {}").format(unit.text(found["size"])))
        self._fill(found["walls"], found["left_solid"], scale)

    def _fill(self, walls, left_solid, scale):
        could = {wall["faces"] for wall in self._walls}
        rows = []
        for wall in walls:
            faces, is_in = tuple(wall["faces"]), tuple(wall["faces"]) not in self._solid
            rgb = None if scale is None else tuple(scale.colours([wall["thickness"]])[0] / 255.0)
            rows.append(_Wall(translate("ThinPart", "shell") if is_in else translate("ThinPart", "solid"), wall["thickness"],
                              wall["area"], faces, rgb, is_in if faces in could else None))
        for each in left_solid:
            faces = tuple(each["faces"])
            rows.append(_Wall(translate("ThinPart", "left solid: {}").format(kind_word(each["kind"])), each["thickness"],
                              None, faces, None, faces not in self._solid if faces in could else None))
        self.walls.show_rows(rows, _columns(), self._unit, lambda one, other: one.faces == other.faces, self.walls.subject)

    def _on_edited(self, _key, number, is_in):
        rows, could = self.walls.rows, {wall["faces"] for wall in self._walls}
        faces = {rows[each].faces for each in self.walls.selected(number)} & could
        self._solid = self._solid - faces if is_in else self._solid | faces
        self.changed.emit()


def _columns():
    return [
        Column("wall", translate("ThinPart", "Wall"), lambda wall: wall.word, stretches=True, most=WALL,
               picture=lambda wall: wall.rgb and square(wall.rgb), is_checked=lambda wall: wall.is_in),
        figures("thickness_mm", translate("ThinPart", "Thick, {}"), lambda wall: wall.thickness, length),
        figures("area_mm2", translate("ThinPart", "Area, {}\u00b2"), lambda wall: wall.area, area),
    ]


def _range(thick, unit):
    least, most = unit.number(min(thick)), unit.text(max(thick))
    return most if least == unit.number(max(thick)) else f"{least}\u2013{most}"

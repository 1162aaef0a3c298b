# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tables of walls with check marks: what is edited holds for all selected rows."""

from ...core.sizing.sizing_settings import divisions_of
from ..application.numbers import marked
from ..application.qt import QtWidgets, Signal, grouped, translate
from ..record.regions_table import counted_kind
from ..tables.column import Column, count, figures, length, square
from ..tables.small_table import SmallTable

WALL = 32
"""Greatest width of the column of walls, in characters, of which the check mark and the colour take some."""

_LINES = 7


class CheckedWalls(SmallTable):
    """A row for each wall of a part.

    Parameters
    ----------
    name : str
        Object name.
    columns : list of Column
    faces_of : callable
        Maps a row to the numbers of its faces, from 0.

    Signals
    -------
    faces_chosen(object)
        Tuple of face numbers of the part, from 0, of the selected rows.
    """

    faces_chosen = Signal(object)

    def __init__(self, name, columns, faces_of, parent=None):
        super().__init__(name, columns, _LINES, parent)
        self._faces_of = faces_of
        self.setSelectionMode(QtWidgets.QAbstractItemView.ExtendedSelection)
        self.setSortingEnabled(False)
        self.selectionModel().selectionChanged.connect(lambda *_: self.faces_chosen.emit(self.faces))

    @property
    def faces(self):
        """Tuple of int: the faces of the selected walls."""
        return tuple(face for number in self.selected() for face in self._faces_of(self.rows[number]))

    def selected(self, meant=None):
        """Numbers of the selected rows, or only `meant` where that is not one of them: list of int."""
        chosen = sorted({index.row() for index in self.selectedIndexes()})
        return chosen if meant is None or meant in chosen else [meant]


class WallSizesTable(CheckedWalls):
    """Walls, equal ones in one row, on or off, with their element sizes and layers.

    Signals
    -------
    edited(object)
        dict: size in mm, or None for off, by number of the region.
    """

    edited = Signal(object)

    def __init__(self, parent=None):
        super().__init__("ThinPart_WallSizes", self._columns(), lambda wall: wall["faces"], parent)
        self._colours = {}  # by number of the region
        self.setToolTip(translate(
            "ThinPart", "Double-click a size or a number of layers to change it, for all selected walls. Without "
                        "the check mark, a wall asks for no small elements."))
        self.model().edited.connect(self._on_edited)

    def show_walls(self, walls, unit, colours):
        """Show walls.

        Parameters
        ----------
        walls : list of dict
            As ``regions`` of `PartSizing.proposed`.
        unit : LengthUnit
        colours : list of tuple
            Red, green and blue from 0 to 1 of each wall.
        """
        self._colours = {wall["region"]: rgb for wall, rgb in zip(walls, colours)}
        self.show_rows(walls, self._columns(), unit, lambda one, other: one["region"] == other["region"], self.subject)

    def _columns(self):
        def is_on(wall):
            return wall["size"] is not None

        def if_on(key, title, shown, **more):
            return Column(key, title, lambda wall: wall[key],
                          lambda wall, unit: shown(wall[key]) if is_on(wall) else "\u2013", is_number=True, **more)

        return [
            Column("wall", translate("ThinPart", "Wall"), lambda wall: wall["kind"],
                   lambda wall, unit: _wall_text(wall, unit), stretches=True, most=WALL,
                   picture=lambda wall: square(self._colours[wall["region"]]), is_checked=is_on),
            Column("size_mm", translate("ThinPart", "Size, {}"), lambda wall: wall["size"],
                   lambda wall, unit: unit.number(wall["size"]), is_number=True, has_unit=True, is_editable=is_on),
            if_on("layers", translate("ThinPart", "Layers"), lambda layers: marked(f"{layers:.3g}"), is_editable=is_on),
            if_on("elements", translate("ThinPart", "Elements"), grouped),
            figures("count", translate("ThinPart", "Instances"), lambda wall: wall["count"], count, is_hidden=True),
            figures("thickness_mm", translate("ThinPart", "Thick, {}"), lambda wall: wall["thickness"], length,
                    is_hidden=True),
        ]

    def _on_edited(self, key, number, value):
        chosen = [self.rows[each] for each in self.selected(number)]
        if key == "wall":
            self.edited.emit({number: wall["proposed_size"] if value else None for wall in chosen
                              for number in wall["regions"]})
            return
        value = _number(value)
        if value is not None:
            self.edited.emit({number: value * self.model().unit.millimetres if key == "size_mm"
                              else wall["thickness"] / divisions_of(value) for wall in chosen for number in wall["regions"]})


def _wall_text(wall, unit):
    return f"{counted_kind(wall['word'], wall['count'])} {unit.text(wall['thickness'])}"


def _number(text):
    try:
        value = float(text.strip().replace(",", "."))
    except ValueError:
        return None
    return value if 1e-6 <= value <= 1e6 else None

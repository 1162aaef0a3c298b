"""The part of the panel that makes a shell: settings, the walls of the mid-surface, and what is left solid."""

from ...core.shells.shell_settings import ShellSettings
from ..application.length_unit import MILLIMETRE
from ..application.numbers import number, percent
from ..application.qt import QtCore, QtGui, QtWidgets, Signal, colour, grouped, translate
from ..application.sentences import translated
from ..record.record_view import show_text, text_line
from ..record.regions_table import kind_word
from ..widgets.exact_field import ExactField
from ..widgets.push_button import add_button
from .scale_bar import ScaleBar

_LINES = 7


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
        self._unit, self._faces = MILLIMETRE, []
        self._walls, self._solid = [], set()  # those that a shell could have; the faces of those that stay solid
        rows = QtWidgets.QVBoxLayout(self)
        rows.setContentsMargins(0, 0, 0, 0)
        form = QtWidgets.QFormLayout()
        form.setRowWrapPolicy(QtWidgets.QFormLayout.WrapLongRows)
        rows.addLayout(form)
        self._order = QtWidgets.QComboBox(self)
        self._order.setObjectName("ThinPart_ShellOrder")
        self._order.addItems([translate("ThinPart", "linear (first order)"),
                              translate("ThinPart", "quadratic (second order)")])
        self._order.setCurrentIndex(ShellSettings.order - 1)
        self._order.setToolTip(translate("ThinPart", "Linear triangles are far too stiff in CalculiX."))
        self._order.currentIndexChanged.connect(lambda *_: self.changed.emit())
        self._size = ExactField("ThinPart_ShellSize", self)
        self._size.set_form(least=0.0, most=1e6)
        self._size.show_exact(0.0)
        self._size.setKeyboardTracking(False)
        self._size.changed.connect(self.changed)
        form.addRow(translate("ThinPart", "Elements"), self._order)
        form.addRow(translate("ThinPart", "Largest size"), self._size)
        self.button = add_button(rows, self, "ThinPart_ShellButton", translate("ThinPart", "Make shell"),
                                 self.shell_requested.emit)
        self._figures = text_line(self, rows, "ThinPart_ShellFigures")
        self.walls = QtWidgets.QTableWidget(0, 3, self)
        self.walls.setObjectName("ThinPart_ShellWalls")
        self.walls.setSelectionBehavior(QtWidgets.QAbstractItemView.SelectRows)
        self.walls.setEditTriggers(QtWidgets.QAbstractItemView.NoEditTriggers)
        self.walls.verticalHeader().hide()
        self.walls.setSizePolicy(QtWidgets.QSizePolicy.Expanding, QtWidgets.QSizePolicy.Fixed)
        self.walls.setToolTip(translate(
            "ThinPart", "Without the check mark, a wall stays solid and is not in the shell."))
        self.walls.itemSelectionChanged.connect(self._on_selected)
        self.walls.itemChanged.connect(self._on_changed)
        rows.addWidget(self.walls)
        self.preview = QtWidgets.QCheckBox(translate("ThinPart", "Show the shell by its thickness"), self)
        self.preview.setObjectName("ThinPart_ShellPreview")
        self.preview.setChecked(True)
        self.preview.toggled.connect(lambda *_: self.shown_changed.emit())
        rows.addWidget(self.preview)
        self._bar = ScaleBar("ThinPart_ShellBar", self)
        rows.addWidget(self._bar)
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
        unit, shell, could = self._unit, translate("ThinPart", "shell"), {wall["faces"] for wall in self._walls}
        blocked = self.walls.blockSignals(True)
        self.walls.setHorizontalHeaderLabels([
            translate("ThinPart", "Wall"), translate("ThinPart", "Thick, {}").format(unit.symbol),
            translate("ThinPart", "Area, {}\u00b2").format(unit.symbol)])
        solid = translate("ThinPart", "left solid: {}")
        rows = [(shell if tuple(wall["faces"]) not in self._solid else translate("ThinPart", "solid"), wall["thickness"],
                 number(wall["area"] / unit.millimetres ** 2), scale) for wall in walls]
        rows += [(solid.format(kind_word(each["kind"])), each["thickness"], "\u2013", None) for each in left_solid]
        self._faces = [tuple(each["faces"]) for each in (*walls, *left_solid)]
        self.walls.setRowCount(len(rows))
        for row, (text, thickness, area, own) in enumerate(rows):
            for column, cell in enumerate((text, unit.number(thickness), area)):
                item = QtWidgets.QTableWidgetItem(cell)
                if column:
                    item.setTextAlignment(QtCore.Qt.AlignRight | QtCore.Qt.AlignVCenter)
                elif self._faces[row] in could:
                    item.setFlags(item.flags() | QtCore.Qt.ItemIsUserCheckable)
                    item.setCheckState(QtCore.Qt.Unchecked if self._faces[row] in self._solid else QtCore.Qt.Checked)
                if not column and own is not None:
                    square = QtGui.QPixmap(12, 12)
                    square.fill(colour(tuple(own.colours([thickness])[0] / 255.0)))
                    item.setIcon(QtGui.QIcon(square))
                self.walls.setItem(row, column, item)
        self.walls.blockSignals(blocked)
        line = self.fontMetrics().height() + 8
        self.walls.verticalHeader().setDefaultSectionSize(line)
        self.walls.setFixedHeight(min(max(2, len(rows)), _LINES) * line + self.walls.horizontalHeader().sizeHint().height()
                                  + 2 * self.walls.frameWidth() + 2)
        self.walls.resizeColumnsToContents()
        self.walls.horizontalHeader().setSectionResizeMode(0, QtWidgets.QHeaderView.Stretch)

    def _on_changed(self, cell):
        chosen = {index.row() for index in self.walls.selectedIndexes()}
        chosen = chosen if cell.row() in chosen else {cell.row()}
        could = {wall["faces"] for wall in self._walls}
        faces = {self._faces[row] for row in chosen} & could
        self._solid = self._solid - faces if cell.checkState() == QtCore.Qt.Checked else self._solid | faces
        # The table is filled anew, which an item that reports its change does not survive.
        QtCore.QTimer.singleShot(0, self.changed.emit)

    def _on_selected(self):
        chosen = sorted({index.row() for index in self.walls.selectedIndexes()})
        self.faces_chosen.emit(tuple(face for row in chosen for face in self._faces[row]))


def _range(thick, unit):
    least, most = unit.number(min(thick)), unit.text(max(thick))
    return most if least == unit.number(max(thick)) else f"{least}\u2013{most}"

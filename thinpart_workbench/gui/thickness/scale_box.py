# SPDX-License-Identifier: LGPL-2.1-or-later
"""Edits the colour scale of a thickness map: range, colours and bands."""

from ...core.rendering.colour_scale import colour_table
from ...freecad_adapter.objects.thickness_object import MILLIMETRES, SHARE
from ...freecad_adapter.preferences import PREFERENCES
from ..application.length_unit import MILLIMETRE
from ..application.qt import QtCore, QtGui, QtWidgets, Signal, blocked, colour, named, translate, translated_mark
from ..widgets.flow_layout import FlowLayout
from ..widgets.narrow_fields import LengthField, narrow_combo, new_form


class ScaleBox(QtWidgets.QWidget):
    """Fields for the properties of the colour scale.

    Signals
    -------
    changed(object)
        Properties of the map that the user has changed: dict by name.
    typical_requested
        The user wants the range that most of the surface has.
    switched(str, bool)
        What is shown in the view, by the name of its preference.
    """

    changed = Signal(object)
    switched = Signal(str, bool)
    typical_requested = Signal()

    def __init__(self, parent=None):
        super().__init__(parent)
        self.setObjectName("ThinPart_ScaleBox")
        form = new_form(self)
        self._add_range(form)
        self._add_colours(form)
        self._add_in_view(form)

    def show_in_view(self, states):
        """Show what is shown in the view: dict of bool by the name of the preference."""
        with blocked(self):
            for name, is_on in states.items():
                self._in_view[name].setChecked(is_on)

    def show_properties(self, values, unit):
        """Show properties of a map.

        Parameters
        ----------
        values : dict
            By name: AutomaticRange, Low, High, RangeUnit, ColourMap, Reversed, Bands, UnmeasuredColour,
            Logarithmic, Shaded.
        unit : LengthUnit
            Unit of Low and High if they are lengths; the properties are in mm.
        """
        with blocked(self):
            self._automatic.setChecked(values["AutomaticRange"])
            self._unit.setItemText(self._unit.findData(MILLIMETRES), unit.symbol)
            self._unit.setCurrentIndex(max(0, self._unit.findData(values["RangeUnit"])))
            for field, name in ((self._low, "Low"), (self._high, "High")):
                if values["RangeUnit"] == SHARE:
                    field.show_length(values[name], 1.0, 4)
                else:
                    field.show_length(values[name], unit.millimetres, unit.decimals)
                field.setEnabled(not values["AutomaticRange"])
            self._map.setCurrentIndex(self._map.findData(values["ColourMap"]))
            self._reversed.setChecked(values["Reversed"])
            self._bands.setValue(values["Bands"])
            self._logarithmic.setChecked(values["Logarithmic"])
            self._shaded.setChecked(values["Shaded"])
            self._unmeasured = tuple(values["UnmeasuredColour"][:3])
            self._paint_button()

    def _add_range(self, form):
        self._automatic = named(QtWidgets.QCheckBox(translate("ThinPart", "&Whole range"), self), "ThinPart_AutomaticRange",
                                translate("ThinPart", "From the thinnest to the thickest wall"))
        self._automatic.toggled.connect(lambda on: self.changed.emit({"AutomaticRange": on}))
        typical = named(QtWidgets.QPushButton(translate("ThinPart", "Range of &most walls"), self), "ThinPart_TypicalRange",
                        translate("ThinPart", "From the thinnest confirmed wall to the thickness below which 98\u00a0% of "
                                  "the surface lies, without rims, whose rays run along the wall"))
        typical.clicked.connect(lambda: self.typical_requested.emit())
        form.addRow(self._automatic, typical)
        row = QtWidgets.QHBoxLayout()
        self._low, self._high = (LengthField(f"ThinPart_{end}", self) for end in ("Low", "High"))
        self._low.changed.connect(lambda: self.changed.emit({"Low": self._low.exact()}))
        self._high.changed.connect(lambda: self.changed.emit({"High": self._high.exact()}))
        row.addWidget(self._low, 1)
        row.addWidget(QtWidgets.QLabel("\u2013", self))
        row.addWidget(self._high, 1)
        form.addRow(translate("ThinPart", "Range"), row)
        self._unit = narrow_combo(self, "ThinPart_RangeUnit")
        self._unit.addItem(MILLIMETRE.symbol, MILLIMETRES)
        self._unit.addItem(translate("ThinPart", "share of the diagonal"), SHARE)
        self._unit.currentIndexChanged.connect(lambda _: self.changed.emit({"RangeUnit": self._unit.currentData()}))
        form.addRow(translate("ThinPart", "in"), self._unit)

    def _add_colours(self, form):
        self._map = narrow_combo(self, "ThinPart_ColourMap")
        self._map.setIconSize(QtCore.QSize(48, 12))
        for name, title in PREFERENCES["HeatMapColours"].choices:
            self._map.addItem(_colour_map_icon(name), translated_mark(title), name)
        self._map.currentIndexChanged.connect(lambda _: self.changed.emit({"ColourMap": self._map.currentData()}))
        form.addRow(translate("ThinPart", "Colours"), self._map)
        self._reversed = self._check(form, "Reversed", translate("ThinPart", "Reversed"))
        self._logarithmic = self._check(form, "Logarithmic", translate("ThinPart", "&Logarithmic"), translate(
            "ThinPart", "Equal ratios of thickness are equally far apart, so that thin walls get more of the colours"))
        self._shaded = self._check(form, "Shaded", translate("ThinPart", "&Shaded"), translate(
            "ThinPart", "The map is lit, so that its shape is seen: colours get darker away from the light. Off: flat "
            "colours, exactly those of the colour bar"))
        self._bands = named(QtWidgets.QSpinBox(self), "ThinPart_Bands")
        self._bands.setRange(0, PREFERENCES["HeatMapBands"].range[1])
        self._bands.setSpecialValueText(translate("ThinPart", "smooth"))
        self._bands.valueChanged.connect(lambda value: self.changed.emit({"Bands": value}))
        form.addRow(translate("ThinPart", "Bands"), self._bands)
        self._button = named(QtWidgets.QPushButton(self), "ThinPart_UnmeasuredColour",
                             translate("ThinPart", "Colour where no wall could be measured"))
        self._button.clicked.connect(self._ask_colour)
        form.addRow(translate("ThinPart", "Unmeasured"), self._button)

    def _add_in_view(self, form):
        row = QtWidgets.QWidget(self)
        self._in_view, flow = {}, FlowLayout(row)  # PySide2 loses the items of one that is within another layout
        for name, title, meaning in (
                ("ColourBarShown", translate("ThinPart", "Colour bar"), translate(
                    "ThinPart", "Drag it in the view to move it, a corner of it to size it; a right click has more")),
                ("MapLabels", translate("ThinPart", "Thickness labels"), translate(
                    "ThinPart", "The thinnest wall, the thickest one and pinned ones; those behind the part are hidden"))):
            box = self._in_view[name] = named(QtWidgets.QCheckBox(title, self), f"ThinPart_{name}", meaning)
            box.toggled.connect(lambda on, name=name: self.switched.emit(name, on))
            flow.addWidget(box)
        form.addRow(translate("ThinPart", "In the view"), row)

    def _check(self, form, name, title, meaning=""):
        """A check box for a property of this name, in a row of its own."""
        box = named(QtWidgets.QCheckBox(title, self), f"ThinPart_{name}", meaning)
        box.toggled.connect(lambda on: self.changed.emit({name: on}))
        form.addRow("", box)
        return box

    def _ask_colour(self):
        chosen = QtWidgets.QColorDialog.getColor(
            colour(self._unmeasured), self, translate("ThinPart", "Unmeasured"))
        if chosen.isValid():
            self.changed.emit({"UnmeasuredColour": chosen.getRgbF()[:3]})

    def _paint_button(self):
        square = QtGui.QPixmap(32, 12)
        square.fill(colour(self._unmeasured))
        self._button.setIcon(QtGui.QIcon(square))
        self._button.setIconSize(square.size())


def _colour_map_icon(name):
    table = colour_table(name)
    image = QtGui.QImage(48, 1, QtGui.QImage.Format_RGB32)
    for x in range(48):
        rgb = table[round(x / 47 * (len(table) - 1))]
        image.setPixel(x, 0, QtGui.QColor(*map(int, rgb)).rgb())
    return QtGui.QIcon(QtGui.QPixmap.fromImage(image.scaled(48, 12)))

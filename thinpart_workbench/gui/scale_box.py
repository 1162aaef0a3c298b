"""The scale of a thickness map: its range, colours and steps."""

from ..core.colour_scale import COLOUR_MAPS, colour_table
from ..freecad_adapter.settings import PREFERENCES
from ..freecad_adapter.thickness_object import MILLIMETRES, SHARE
from .length_unit import MILLIMETRE
from .qt import QtCore, QtGui, QtWidgets, Signal, colour, translate
from .wheel import keep_from_wheel


class ScaleBox(QtWidgets.QWidget):
    """Fields for everything that gives thickness a colour.

    Signals
    -------
    changed(object)
        dict of the map's properties that the user has changed, by name.
    """

    changed = Signal(object)

    def __init__(self, parent=None):
        super().__init__(parent)
        self.setObjectName("ThinPart_ScaleBox")
        self._is_set, self._length = False, MILLIMETRE
        form = new_form(self)
        self._add_range(form)
        self._add_colours(form)

    def show_properties(self, values, unit):
        """Show properties of a map.

        Parameters
        ----------
        values : dict
            By name: AutomaticRange, Low, High, RangeUnit, ColourMap, Reversed, Bands, UnmeasuredColour.
        unit : LengthUnit
            Low and High are shown in it where they are lengths; the properties are in mm.
        """
        self._is_set, self._length = True, unit
        try:
            self._automatic.setChecked(values["AutomaticRange"])
            self._unit.setItemText(self._unit.findData(MILLIMETRES), unit.symbol)
            self._unit.setCurrentIndex(max(0, self._unit.findData(values["RangeUnit"])))
            for field, name in ((self._low, "Low"), (self._high, "High")):
                value = values[name] / self._unit_length
                field.setDecimals(4 if values["RangeUnit"] == SHARE else unit.decimals)
                if not field.hasFocus() or abs(field.value() - value) > 10.0 ** -field.decimals():
                    field.setValue(value)
                field.setEnabled(not values["AutomaticRange"])
            self._map.setCurrentIndex(self._map.findData(values["ColourMap"]))
            self._reversed.setChecked(values["Reversed"])
            self._bands.setValue(values["Bands"])
            self._unmeasured = tuple(values["UnmeasuredColour"][:3])
            self._paint_button()
        finally:
            self._is_set = False

    def _add_range(self, form):
        self._automatic = QtWidgets.QCheckBox(translate("ThinPart", "&Whole range"), self)
        self._automatic.setObjectName("ThinPart_AutomaticRange")
        self._automatic.setToolTip(translate("ThinPart", "From the thinnest to the thickest wall"))
        self._automatic.toggled.connect(lambda on: self._tell(AutomaticRange=on))
        form.addRow(self._automatic)
        row = QtWidgets.QHBoxLayout()
        self._low, self._high = (self._number(f"ThinPart_{end}") for end in ("Low", "High"))
        self._low.valueChanged.connect(lambda value: self._tell(Low=value * self._unit_length))
        self._high.valueChanged.connect(lambda value: self._tell(High=value * self._unit_length))
        row.addWidget(self._low, 1)
        row.addWidget(QtWidgets.QLabel("\u2013", self))
        row.addWidget(self._high, 1)
        form.addRow(translate("ThinPart", "Range"), row)
        self._unit = narrow_combo(self, "ThinPart_RangeUnit")
        self._unit.addItem(self._length.symbol, MILLIMETRES)
        self._unit.addItem(translate("ThinPart", "share of the diagonal"), SHARE)
        self._unit.currentIndexChanged.connect(lambda _: self._tell(RangeUnit=self._unit.currentData()))
        form.addRow(translate("ThinPart", "in"), self._unit)

    @property
    def _unit_length(self):
        """What 1 in the fields is of the properties, which are in mm or shares."""
        return 1.0 if self._unit.currentData() == SHARE else self._length.millimetres

    def _add_colours(self, form):
        self._map = narrow_combo(self, "ThinPart_ColourMap")
        self._map.setIconSize(QtCore.QSize(48, 12))
        for name in COLOUR_MAPS:
            self._map.addItem(_stripe(name), name, name)
        self._map.currentIndexChanged.connect(lambda _: self._tell(ColourMap=self._map.currentData()))
        form.addRow(translate("ThinPart", "Colours"), self._map)
        self._reversed = QtWidgets.QCheckBox(translate("ThinPart", "Reversed"), self)
        self._reversed.setObjectName("ThinPart_Reversed")
        self._reversed.toggled.connect(lambda on: self._tell(Reversed=on))
        form.addRow("", self._reversed)
        self._bands = QtWidgets.QSpinBox(self)
        self._bands.setObjectName("ThinPart_Bands")
        keep_from_wheel(self._bands)
        self._bands.setRange(0, PREFERENCES["HeatMapBands"].range[1])
        self._bands.setSpecialValueText(translate("ThinPart", "smooth"))
        self._bands.valueChanged.connect(lambda value: self._tell(Bands=value))
        form.addRow(translate("ThinPart", "Bands"), self._bands)
        self._button = QtWidgets.QPushButton(self)
        self._button.setObjectName("ThinPart_UnmeasuredColour")
        self._button.setToolTip(translate("ThinPart", "Colour where no wall could be measured"))
        self._button.clicked.connect(self._ask_colour)
        form.addRow(translate("ThinPart", "Unmeasured"), self._button)

    def _number(self, name):
        field = NumberField(self)
        field.setObjectName(name)
        return field

    def _ask_colour(self):
        chosen = QtWidgets.QColorDialog.getColor(
            colour(self._unmeasured), self, translate("ThinPart", "Unmeasured"))
        if chosen.isValid():
            self._tell(UnmeasuredColour=chosen.getRgbF()[:3])

    def _paint_button(self):
        square = QtGui.QPixmap(32, 12)
        square.fill(colour(self._unmeasured))
        self._button.setIcon(QtGui.QIcon(square))
        self._button.setIconSize(square.size())

    def _tell(self, **values):
        if not self._is_set:
            self.changed.emit(values)


class NumberField(QtWidgets.QDoubleSpinBox):
    """A number that counts when it is typed to its end, and is no wider than it needs to be."""

    def __init__(self, parent=None):
        super().__init__(parent)
        self.setRange(0.0, 1e6)
        self.setDecimals(3)
        self.setStepType(QtWidgets.QAbstractSpinBox.AdaptiveDecimalStepType)
        self.setKeyboardTracking(False)
        keep_from_wheel(self)

    def minimumSizeHint(self):
        """Room for some digits, not for a million with decimals."""
        hint = super().minimumSizeHint()
        return QtCore.QSize(min(hint.width(), 11 * self.fontMetrics().averageCharWidth() + 20), hint.height())

    def sizeHint(self):
        """See `minimumSizeHint`."""
        return self.minimumSizeHint()

    def textFromValue(self, value):
        """Without zeros at the end."""
        text = super().textFromValue(value)
        point = self.locale().decimalPoint()
        return text.rstrip("0").rstrip(point) if point in text else text


def new_form(parent):
    """A form whose fields go under their titles where it is narrow."""
    form = QtWidgets.QFormLayout(parent)
    form.setContentsMargins(6, 6, 6, 6)
    form.setRowWrapPolicy(QtWidgets.QFormLayout.WrapLongRows)
    form.setFieldGrowthPolicy(QtWidgets.QFormLayout.AllNonFixedFieldsGrow)
    return form


def narrow_combo(parent, name):
    """A combo box that may be narrower than its longest text."""
    combo = QtWidgets.QComboBox(parent)
    combo.setObjectName(name)
    combo.setSizeAdjustPolicy(QtWidgets.QComboBox.AdjustToMinimumContentsLengthWithIcon)
    combo.setMinimumContentsLength(6)
    keep_from_wheel(combo)
    return combo


def _stripe(name):
    table = colour_table(name)
    image = QtGui.QImage(48, 1, QtGui.QImage.Format_RGB32)
    for x in range(48):
        rgb = table[round(x / 47 * (len(table) - 1))]
        image.setPixel(x, 0, QtGui.QColor(*(int(part) for part in rgb)).rgb())
    return QtGui.QIcon(QtGui.QPixmap.fromImage(image.scaled(48, 12)))

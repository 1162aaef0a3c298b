"""Widgets for single preferences, made from their declarations."""

import math

from ..freecad_adapter.settings import MILLIMETRES
from .folder_field import FolderField
from .length_unit import length_unit
from .profile_box import ProfileBox
from .qt import QtGui, QtWidgets, Signal, colour, translate, translated_mark
from .unit_watch import UNITS

_PREFIX = "ThinPart_Preference"


def new_field(declared, parent):
    """A widget for a preference.

    Parameters
    ----------
    declared : Preference
    parent : QWidget

    Returns
    -------
    QWidget
        With ``value()``, ``show_value(value)`` and the signal ``changed``.
    """
    field = _new_field(declared, parent)
    field.setToolTip(translated_mark(declared.meaning))
    # FreeCAD from 0.21 on takes a page back to its defaults by these.
    field.setProperty("prefPath", "Mod/ThinPart")
    field.setProperty("prefEntry", declared.name)
    return field


def _new_field(declared, parent):
    name = _PREFIX + declared.name
    if declared.names == "folder":
        return FolderField(name, translated_mark(declared.zero), parent)
    kinds = {tuple: ColourField, bool: CheckField, int: WholeField, float: NumberField, str: ChoiceField}
    kind = ProfileField if declared.names == "profile" else kinds[type(declared.default)]
    if declared.unit == MILLIMETRES:
        kind = LengthField
    field = kind(declared, parent)
    if not field.objectName():
        field.setObjectName(name)
    return field


class CheckField(QtWidgets.QCheckBox):
    """For what is either so or not."""

    changed = Signal()

    def __init__(self, declared, parent):
        super().__init__(translated_mark(declared.title), parent)
        self.toggled.connect(lambda _: self.changed.emit())

    def value(self):
        """bool."""
        return self.isChecked()

    def show_value(self, value):
        """Show a value."""
        self.setChecked(value)


class WholeField(QtWidgets.QSpinBox):
    """For whole numbers; the one below the range stands for 0 where that means something of its own."""

    changed = Signal()

    def __init__(self, declared, parent):
        super().__init__(parent)
        least, most = declared.range
        self._zero = least - 1 if declared.zero else None
        self.setRange(least - 1 if declared.zero else least, most)
        _dress(self, declared)
        self.valueChanged.connect(lambda *_: self.changed.emit())

    def value(self):
        """int."""
        value = super().value()
        return 0 if value == self._zero else value

    def show_value(self, value):
        """Show a value."""
        self.setValue(self._zero if value == 0 and self._zero is not None else value)


class NumberField(QtWidgets.QDoubleSpinBox):
    """For numbers, with as many digits as the least of them needs."""

    changed = Signal()

    def __init__(self, declared, parent):
        super().__init__(parent)
        least, most = declared.range
        self.setDecimals(_decimals(least))
        self.setRange(0.0 if declared.zero else least, most)
        self.setSingleStep(_step(declared.default))
        _dress(self, declared)
        self.valueChanged.connect(lambda *_: self.changed.emit())

    def show_value(self, value):
        """Show a value."""
        self.setValue(value)

    def textFromValue(self, value):
        """Without zeros at the end."""
        text = super().textFromValue(value)
        point = str(self.locale().decimalPoint())
        return text.rstrip("0").rstrip(point) if point in text else text


class LengthField(NumberField):
    """For lengths, which are shown and taken in the unit of the active document.

    A value that nobody has changed stays what it is, however it is rounded in that unit.
    """

    def __init__(self, declared, parent):
        super().__init__(declared, parent)
        self._declared, self._given = declared, None
        self._show_unit()
        UNITS.changed.connect(self._show_unit)

    def value(self):
        """float, mm."""
        shown = super().value()
        if self._given is not None and shown == self._given[1]:
            return self._given[0]
        if shown == 0.0 and self._declared.zero:
            return 0.0
        least, most = self._declared.range
        return min(max(shown * self._unit.millimetres, least), most)

    def show_value(self, value):
        """Show a value, mm."""
        super().show_value(self._unit.value(value))
        self._given = value, super().value()

    def _show_unit(self):
        value = None if self._given is None else self.value()
        self._unit = length_unit()
        least, most = map(self._unit.value, self._declared.range)
        self.setDecimals(_decimals(least))
        self.setRange(0.0 if self._declared.zero else least, most)
        self.setSingleStep(_step(self._unit.value(self._declared.default)))
        self.setSuffix(f" {self._unit.symbol}")
        if value is not None:
            self.show_value(value)


class ChoiceField(QtWidgets.QComboBox):
    """For one of some texts."""

    changed = Signal()

    def __init__(self, declared, parent):
        super().__init__(parent)
        for value, title in declared.choices:
            self.addItem(translated_mark(title), value)
        self.currentIndexChanged.connect(lambda *_: self.changed.emit())

    def value(self):
        """str."""
        return self.currentData()

    def show_value(self, value):
        """Show a value."""
        self.setCurrentIndex(self.findData(value))


class ColourField(QtWidgets.QPushButton):
    """For a colour: a button that has it."""

    changed = Signal()

    def __init__(self, declared, parent):
        super().__init__(parent)
        self._title, self._rgb = translated_mark(declared.title), declared.default
        self.setAutoDefault(False)
        letter = self.fontMetrics().averageCharWidth()
        self.setFixedWidth(12 * letter)
        self.clicked.connect(lambda *_: self._ask())

    def value(self):
        """Red, green and blue from 0 to 1."""
        return self._rgb

    def show_value(self, value):
        """Show a value."""
        self._rgb = value
        height = self.fontMetrics().height()
        swatch = QtGui.QPixmap(5 * height, height)
        swatch.fill(colour(value))
        self.setIconSize(swatch.size())
        self.setIcon(QtGui.QIcon(swatch))
        self.setAccessibleName(f"{self._title}: {colour(value).name()}")
        self.changed.emit()

    def _ask(self):
        chosen = QtWidgets.QColorDialog.getColor(colour(self._rgb), self, self._title)
        if chosen.isValid():
            self.show_value((chosen.redF(), chosen.greenF(), chosen.blueF()))


class ProfileField(QtWidgets.QWidget):
    """For thresholds: shipped ones, or a file."""

    changed = Signal()

    def __init__(self, declared, parent):
        super().__init__(parent)
        row = QtWidgets.QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        self._box = ProfileBox(self)
        self._box.setObjectName(_PREFIX + declared.name)
        self._box.currentIndexChanged.connect(lambda *_: self.changed.emit())
        self.setObjectName(f"{_PREFIX}{declared.name}Row")
        self.setFocusProxy(self._box)
        button = QtWidgets.QPushButton(translate("ThinPart", "From file\u2026"), self)
        button.setObjectName(f"{_PREFIX}{declared.name}Choose")
        button.setAutoDefault(False)
        button.clicked.connect(lambda *_: self._box.ask_for_file())
        row.addWidget(self._box, 1)
        row.addWidget(button)

    def value(self):
        """A shipped profile's name, or a file."""
        return self._box.currentData()

    def show_value(self, value):
        """Show a value."""
        self._box.choose(value)


def _decimals(least):
    """As many as the least value needs."""
    return max(1, math.ceil(-math.log10(least)))


def _step(usual):
    """A step of a field, by the size of its usual value."""
    return 0.5 * 10.0 ** math.floor(math.log10(usual or 1.0))


def _dress(spin, declared):
    if declared.unit:
        space = "" if declared.unit == "\u00b0" else " "
        spin.setSuffix(space + translated_mark(declared.unit))
    if declared.zero:
        spin.setSpecialValueText(translated_mark(declared.zero))

"""Widgets for single preferences, created from their declarations."""

import math

from ...freecad_adapter.preferences import MILLIMETRES
from ..application import lifelong
from ..application.length_unit import length_unit
from ..application.qt import QtGui, QtWidgets, Signal, colour, translate, translated_mark
from ..widgets.edit_profile_button import edit_profile_button
from ..widgets.folder_field import FolderField
from ..widgets.process_field import ProcessField
from ..widgets.profile_combo import ProfileCombo

_PREFIX = "ThinPart_Preference"


def new_field(declared, parent):
    """Create the widget of a preference.

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
    # FreeCAD 0.21 and later uses these properties to reset a page to its defaults.
    field.setProperty("prefPath", "Mod/ThinPart")
    field.setProperty("prefEntry", declared.name)
    return field


def _new_field(declared, parent):
    name = _PREFIX + declared.name
    if declared.names == "folder":
        return FolderField(name, translated_mark(declared.zero), parent)
    if declared.names == "person":
        return TextField(declared, parent)
    if declared.names == "processes":
        return ProcessField(name, parent)
    kinds = {tuple: ColourField, bool: CheckField, int: IntegerField, float: NumberField, str: ChoiceField}
    kind = ProfileField if declared.names == "profile" else kinds[type(declared.default)]
    if declared.unit == MILLIMETRES:
        kind = LengthField
    field = kind(declared, parent)
    if not field.objectName():
        field.setObjectName(name)
    return field


class CheckField(QtWidgets.QCheckBox):
    """Check box for a preference of type bool."""

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


class IntegerField(QtWidgets.QSpinBox):
    """Spin box for integers; if 0 has a special meaning, the value below the range stands for it."""

    changed = Signal()

    def __init__(self, declared, parent):
        super().__init__(parent)
        minimum, maximum = declared.range
        self._zero = minimum - 1 if declared.zero else None
        self.setRange(minimum - 1 if declared.zero else minimum, maximum)
        _set_texts(self, declared)
        self.valueChanged.connect(lambda *_: self.changed.emit())

    def value(self):
        """int."""
        value = super().value()
        return 0 if value == self._zero else value

    def show_value(self, value):
        """Show a value."""
        self.setValue(self._zero if value == 0 and self._zero is not None else value)


class NumberField(QtWidgets.QDoubleSpinBox):
    """Spin box for floats, with as many decimals as the smallest value needs."""

    changed = Signal()

    def __init__(self, declared, parent):
        super().__init__(parent)
        minimum, maximum = declared.range
        self.setDecimals(_decimals(minimum))
        self.setRange(0.0 if declared.zero else minimum, maximum)
        self.setSingleStep(_step(declared.default))
        _set_texts(self, declared)
        self.valueChanged.connect(lambda *_: self.changed.emit())

    def show_value(self, value):
        """Show a value."""
        self.setValue(value)

    def textFromValue(self, value):
        """Format a value without trailing zeros."""
        text = super().textFromValue(value)
        point = str(self.locale().decimalPoint())
        return text.rstrip("0").rstrip(point) if point in text else text


class LengthField(NumberField):
    """Spin box for lengths, in the unit of the active document.

    A value that the user has not changed keeps its exact value, even if the display rounds it.
    """

    def __init__(self, declared, parent):
        super().__init__(declared, parent)
        self._declared, self._shown_value = declared, None
        self._show_unit()
        lifelong.units.changed.connect(self._show_unit)

    def value(self):
        """float, mm."""
        shown = super().value()
        if self._shown_value is not None and shown == self._shown_value[1]:
            return self._shown_value[0]
        if shown == 0.0 and self._declared.zero:
            return 0.0
        minimum, maximum = self._declared.range
        return min(max(shown * self._unit.millimetres, minimum), maximum)

    def show_value(self, value):
        """Show a value, mm."""
        super().show_value(self._unit.value(value))
        self._shown_value = value, super().value()

    def _show_unit(self):
        value = None if self._shown_value is None else self.value()
        self._unit = length_unit()
        minimum, maximum = map(self._unit.value, self._declared.range)
        self.setDecimals(_decimals(minimum))
        self.setRange(0.0 if self._declared.zero else minimum, maximum)
        self.setSingleStep(_step(self._unit.value(self._declared.default)))
        self.setSuffix(f" {self._unit.symbol}")
        if value is not None:
            self.show_value(value)


class TextField(QtWidgets.QLineEdit):
    """Line edit for a text, which may stay empty."""

    changed = Signal()

    def __init__(self, declared, parent):
        super().__init__(parent)
        self.setObjectName(_PREFIX + declared.name)
        self.setPlaceholderText(translated_mark(declared.zero))
        self.setMaxLength(100)
        self.textChanged.connect(lambda _: self.changed.emit())

    def value(self):
        """str."""
        return self.text()

    def show_value(self, value):
        """Show a value."""
        self.setText(value)


class ChoiceField(QtWidgets.QComboBox):
    """Combo box for one of several texts."""

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
    """Button that shows a colour and opens a colour dialog."""

    changed = Signal()

    def __init__(self, declared, parent):
        super().__init__(parent)
        self._title, self._rgb = translated_mark(declared.title), declared.default
        self.setAutoDefault(False)
        letter = self.fontMetrics().averageCharWidth()
        self.setFixedWidth(12 * letter)
        self.clicked.connect(lambda *_: self._ask())

    def value(self):
        """tuple of float: red, green and blue from 0 to 1."""
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
    """Combo box for a shipped profile or a profile file."""

    changed = Signal()

    def __init__(self, declared, parent):
        super().__init__(parent)
        row = QtWidgets.QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        self._box = ProfileCombo(self)
        self._box.setObjectName(_PREFIX + declared.name)
        self._box.currentIndexChanged.connect(lambda *_: self.changed.emit())
        self.setObjectName(f"{_PREFIX}{declared.name}Row")
        self.setFocusProxy(self._box)
        button = QtWidgets.QPushButton(translate("ThinPart", "From file\u2026"), self)
        button.setObjectName(f"{_PREFIX}{declared.name}Choose")
        button.setAutoDefault(False)
        button.clicked.connect(lambda *_: self._box.ask_for_file())
        lifelong.profile_signals.used.connect(self._box.choose)
        row.addWidget(self._box, 1)
        row.addWidget(button)
        row.addWidget(edit_profile_button(self, f"{_PREFIX}{declared.name}Edit", self.value))

    def value(self):
        """str: name of a shipped profile, or a path."""
        return self._box.currentData()

    def show_value(self, value):
        """Show a value."""
        self._box.choose(value)


def _decimals(minimum):
    """Number of decimals that the smallest value needs."""
    return max(1, math.ceil(-math.log10(minimum)))


def _step(typical):
    """Single step for a field with a typical value."""
    return 0.5 * 10.0 ** math.floor(math.log10(typical or 1.0))


def _set_texts(spin, declared):
    if declared.unit:
        space = "" if declared.unit == "\u00b0" else " "
        spin.setSuffix(space + translated_mark(declared.unit))
    if declared.zero:
        spin.setSpecialValueText(translated_mark(declared.zero))

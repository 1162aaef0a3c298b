# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fields for single preferences, created from their declarations: FreeCAD's own widgets where they serve.

Notes
-----
What FreeCAD 0.20 and 1.1 were seen to do from Python decides which:

- ``Gui::PrefCheckBox``, ``PrefSpinBox``, ``PrefComboBox``, ``PrefLineEdit`` and ``PrefColorButton`` hold values as
  they are set, follow a parameter that changes elsewhere, and are reset with their page by FreeCAD 0.21 and later. On
  a page made in Python, FreeCAD neither fills nor stores them, so the form does, with the checks of the declaration.
- ``Gui::PrefDoubleSpinBox`` rounds 2/3 to 0.67, and lengths need a unit: see `ExactField`.
- ``Gui::PrefFileChooser`` asks the file system for the folder in the window's thread, which a server that does not
  answer holds up: see `FolderField`.
"""

import math
from collections.abc import Callable
from typing import Any, NamedTuple

import FreeCADGui as Gui

from ...freecad_adapter.preferences import MILLIMETRES
from ..application import lifelong
from ..application.length_unit import length_unit
from ..application.qt import QtWidgets, colour, translate, translated_mark
from ..widgets.buttons import add_button
from ..widgets.edit_profile_button import edit_profile_button
from ..widgets.exact_field import ExactField
from ..widgets.folder_field import FolderField
from ..widgets.process_field import ProcessField
from ..widgets.profile_combo import ProfileCombo

_PREFIX = "ThinPart_Preference"


class Field(NamedTuple):
    """The field of one preference.

    Attributes
    ----------
    widget : QWidget
    value : callable
        Returns the value, of the type of the preference.
    show_value : callable
        Shows a value.
    changed : Signal
    """

    widget: QtWidgets.QWidget
    value: Callable[[], Any]
    show_value: Callable[[Any], None]
    changed: Any


def new_field(declared, parent):
    """Create the Field of a Preference."""
    of_type = {tuple: _colour, bool: _switch, int: _whole_number, float: _number, str: _choice}[type(declared.default)]
    of_text = {"folder": _folder, "person": _text, "processes": _processes, "profile": _profile}
    field = of_text.get(declared.names, of_type)(declared, parent)
    field.widget.setToolTip(translated_mark(declared.meaning))
    field.widget.setProperty("prefPath", "Mod/ThinPart")
    field.widget.setProperty("prefEntry", declared.name)
    return field


class NumberField(ExactField):
    """For a float, with as many decimals as the least value needs; a length is in the unit of the active document."""

    def __init__(self, declared, parent):
        super().__init__(_PREFIX + declared.name, parent)
        self._declared = declared
        self.setSpecialValueText(translated_mark(declared.zero))
        self._show_unit()
        if declared.unit == MILLIMETRES:
            lifelong.units.changed.connect(self._show_unit)

    def within_range(self):
        """float: the exact value; what is rounded as it is shown may lie just outside of the range."""
        least, most = self._declared.range
        return 0.0 if self._declared.zero and not self.value() else min(max(self.exact(), least), most)

    def stepBy(self, steps):
        """Change the value by half of the first digit that is typical of it."""
        QtWidgets.QDoubleSpinBox.stepBy(self, steps)

    def _show_unit(self):
        declared, (least, most), factor, suffix = self._declared, self._declared.range, 1.0, _suffix(self._declared)
        if declared.unit == MILLIMETRES:
            factor, suffix = 1.0 / length_unit().millimetres, f" {length_unit().symbol}"
        self.set_form(factor, suffix, max(1, math.ceil(-math.log10(least * factor))), 0.0 if declared.zero else least, most)
        self.setSingleStep(0.5 * 10.0 ** math.floor(math.log10(declared.default * factor or 1.0)))


def _made(kind, declared, parent):
    """A widget of FreeCAD for a preference."""
    widget = Gui.UiLoader().createWidget(f"Gui::Pref{kind}", parent)
    widget.setObjectName(_PREFIX + declared.name)
    return widget


def _switch(declared, parent):
    box = _made("CheckBox", declared, parent)
    box.setText(translated_mark(declared.title))
    return Field(box, box.isChecked, box.setChecked, box.toggled)


def _text(declared, parent):
    line = _made("LineEdit", declared, parent)
    line.setPlaceholderText(translated_mark(declared.zero))
    line.setMaxLength(100)
    return Field(line, line.text, line.setText, line.textChanged)


def _choice(declared, parent):
    box = _made("ComboBox", declared, parent)
    for value, title in declared.choices:
        box.addItem(translated_mark(title), value)
    return Field(box, box.currentData, lambda value: box.setCurrentIndex(box.findData(value)), box.currentIndexChanged)


def _colour(declared, parent):
    button = _made("ColorButton", declared, parent)
    title = translated_mark(declared.title)
    button.setAutoDefault(False)
    button.setFixedWidth(12 * button.fontMetrics().averageCharWidth())

    def show(rgb):
        button.setProperty("color", colour(rgb))
        say()

    def say():
        button.setAccessibleName(f"{title}: {button.property('color').name()}")

    button.changed.connect(say)
    return Field(button, lambda: tuple(button.property("color").getRgbF()[:3]), show, button.changed)


def _whole_number(declared, parent):
    """If 0 has a special meaning, the value below the range stands for it."""
    spin = _made("SpinBox", declared, parent)
    least, most = declared.range
    zero = least - 1 if declared.zero else None
    spin.setRange(least if zero is None else zero, most)
    spin.setSuffix(_suffix(declared))
    spin.setSpecialValueText(translated_mark(declared.zero))
    return Field(spin, lambda: 0 if spin.value() == zero else spin.value(),
                 lambda value: spin.setValue(zero if value == 0 and declared.zero else value), spin.valueChanged)


def _number(declared, parent):
    field = NumberField(declared, parent)
    return Field(field, field.within_range, field.show_exact, field.changed)


def _folder(declared, parent):
    field = FolderField(_PREFIX + declared.name, translated_mark(declared.zero), parent)
    return Field(field, field.value, field.show_value, field.changed)


def _processes(declared, parent):
    field = ProcessField(_PREFIX + declared.name, parent)
    return Field(field, field.value, field.show_value, field.changed)


def _profile(declared, parent):
    """A shipped profile or a profile file."""
    name = _PREFIX + declared.name
    whole = QtWidgets.QWidget(parent)
    row = QtWidgets.QHBoxLayout(whole)
    row.setContentsMargins(0, 0, 0, 0)
    box = ProfileCombo(whole)
    box.setObjectName(name)
    whole.setObjectName(f"{name}Row")
    whole.setFocusProxy(box)
    lifelong.profile_signals.used.connect(box.choose)
    row.addWidget(box, 1)
    add_button(row, whole, f"{name}Choose", translate("ThinPart", "From file\u2026"), box.ask_for_file, is_for_enter=False)
    row.addWidget(edit_profile_button(whole, f"{name}Edit", box.currentData))
    return Field(whole, box.currentData, box.choose, box.currentIndexChanged)


def _suffix(declared):
    """The unit, apart from the number but for degrees."""
    return translated_mark(declared.unit) if declared.unit in ("", "\u00b0") else f" {translated_mark(declared.unit)}"

# SPDX-License-Identifier: LGPL-2.1-or-later
"""A range of a quantity, set with a slider or typed as numbers."""

from ...core.length_unit import MILLIMETRE
from ..application.numbers import marked
from ..application.qt import QtCore, QtGui, QtWidgets, Signal
from .range_slider import LEAST, MOST, RangeSlider

_TYPING_DELAY = 300
"""Milliseconds from the last key press to applying the typed bounds."""

_DIGITS = 6
"""Significant digits of a bound in its field: enough to convert typed numbers between units without visible rounding."""

_NUMBER = r"\d{0,12}([.,]\d{0,12})?(e[+-]?\d{0,2})?"
"""What can be typed: with a point or with a comma, whichever FreeCAD shows."""


class RangeFilter(QtWidgets.QWidget):
    """A title, two number fields, and a `RangeSlider`. Lengths are in mm everywhere except in the fields.

    Parameters
    ----------
    name : str
        Part of the widgets' object names.
    title : str
        With a placeholder for the unit where the quantity is a length.

    Signals
    -------
    changed
        The user has chosen another range.
    """

    changed = Signal()

    def __init__(self, name, title, parent=None):
        super().__init__(parent)
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(2)
        row = QtWidgets.QHBoxLayout()
        self._title, self._unit, self._ends = title, MILLIMETRE, (None, None)
        self._label = label = QtWidgets.QLabel(title.format(self._unit.symbol), self)
        label.setWordWrap(True)
        row.addWidget(label, 3)
        self._fields = [self._field(f"ThinPart_{name}{end}") for end in ("Least", "Most")]
        label.setBuddy(self._fields[LEAST])
        row.addWidget(self._fields[LEAST], 1)
        row.addWidget(QtWidgets.QLabel("\u2013", self))
        row.addWidget(self._fields[MOST], 1)
        column.addLayout(row)
        self.slider = RangeSlider(self)
        self.slider.setObjectName(f"ThinPart_{name}Slider")
        self.slider.changed.connect(self._on_slider_changed)
        column.addWidget(self.slider)
        self._typing_timer = QtCore.QTimer(self, singleShot=True, interval=_TYPING_DELAY)
        self._typing_timer.timeout.connect(self._apply_fields)

    @property
    def bounds(self):
        """(float or None, float or None)"""
        return self.slider.bounds

    def show_histogram(self, scale, counts):
        """See `RangeSlider.show_histogram`."""
        self.slider.show_histogram(scale, counts)
        self._ends = scale if any(counts) else (None, None)
        self._show_ends()

    def show_unit(self, unit):
        """Show and read lengths in a LengthUnit; the chosen range stays the same."""
        if unit != self._unit:
            if self._typing_timer.isActive():
                self._typing_timer.stop()
                self._apply_fields()  # typed in the previous unit
            self._unit = unit
            self._label.setText(self._title.format(unit.symbol))
            self._show_ends()
            self._show_bounds()

    def clear(self):
        """Reset to the full range without emitting a signal."""
        self.slider.set_bounds(None, None)
        self._show_bounds()

    def _field(self, name):
        field = QtWidgets.QLineEdit(self)
        field.setObjectName(name)
        # The default width is for a dozen digits, more than anybody types; let the layout make the field narrower.
        field.setMinimumWidth(5 * self.fontMetrics().averageCharWidth() + 8)
        field.setValidator(QtGui.QRegularExpressionValidator(QtCore.QRegularExpression(_NUMBER), field))
        field.textEdited.connect(lambda _: self._typing_timer.start())
        return field

    def _on_slider_changed(self):
        self._show_bounds()
        self.changed.emit()

    def _apply_fields(self):
        self.slider.set_bounds(*map(self._value, self._fields))
        self.changed.emit()

    def _show_bounds(self):
        for field, value in zip(self._fields, self.bounds):
            field.setText("" if value is None else marked(f"{self._unit.value(value):.{_DIGITS}g}"))

    def _show_ends(self):
        for field, end in zip(self._fields, self._ends):
            field.setPlaceholderText("" if end is None else marked(f"{self._unit.value(end):.3g}"))

    def _value(self, field):
        try:
            return float(field.text().replace(",", ".")) * self._unit.millimetres
        except ValueError:
            return None  # empty, or an incomplete number

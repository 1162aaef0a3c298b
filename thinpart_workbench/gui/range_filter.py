"""A range of a quantity, chosen by hand or written as numbers."""

from .length_unit import MILLIMETRE
from .qt import QtCore, QtGui, QtWidgets, Signal
from .range_slider import LEAST, MOST, RangeSlider

_TYPING = 300
"""Milliseconds after the last key until what was typed counts."""

_DIGITS = 6
"""Of a bound in its field: what was typed in one unit is found again in another, and no rounding is seen."""


class RangeFilter(QtWidgets.QWidget):
    """A title, two fields for numbers, and a `RangeSlider`. Lengths are in mm everywhere but in the fields.

    Parameters
    ----------
    name : str
        For the names of the widgets.
    title : str
        With a field for the unit where it is a length.

    Signals
    -------
    changed
        Another range is chosen.
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
        self.slider.changed.connect(self._take_slider)
        column.addWidget(self.slider)
        self._typed = QtCore.QTimer(self, singleShot=True, interval=_TYPING)
        self._typed.timeout.connect(self._take_fields)

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
        """Write and take a length in a LengthUnit from now on; what is chosen stays."""
        if unit != self._unit:
            if self._typed.isActive():
                self._typed.stop()
                self._take_fields()  # what was typed is in the unit of before
            self._unit = unit
            self._label.setText(self._title.format(unit.symbol))
            self._show_ends()
            self._show_bounds()

    def clear(self):
        """Choose everything, without a signal."""
        self.slider.set_bounds(None, None)
        self._show_bounds()

    def _field(self, name):
        field = QtWidgets.QLineEdit(self)
        field.setObjectName(name)
        # A dozen digits are more than anybody writes; the layout may make it narrower.
        field.setMinimumWidth(5 * self.fontMetrics().averageCharWidth() + 8)
        validator = QtGui.QDoubleValidator(0.0, 1e12, 6, field)
        validator.setLocale(QtCore.QLocale.c())
        field.setValidator(validator)
        field.textEdited.connect(lambda _: self._typed.start())
        return field

    def _take_slider(self):
        self._show_bounds()
        self.changed.emit()

    def _take_fields(self):
        self.slider.set_bounds(*map(self._value, self._fields))
        self.changed.emit()

    def _show_bounds(self):
        for field, value in zip(self._fields, self.bounds):
            field.setText("" if value is None else f"{self._unit.value(value):.{_DIGITS}g}")

    def _show_ends(self):
        for field, end in zip(self._fields, self._ends):
            field.setPlaceholderText("" if end is None else f"{self._unit.value(end):.3g}")

    def _value(self, field):
        try:
            return float(field.text()) * self._unit.millimetres
        except ValueError:
            return None  # empty, or not yet a number

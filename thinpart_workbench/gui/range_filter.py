"""A range of a quantity, chosen by hand or written as numbers."""

from .qt import QtCore, QtGui, QtWidgets, Signal
from .range_slider import LEAST, MOST, RangeSlider

_TYPING = 300
"""Milliseconds after the last key until what was typed counts."""


class RangeFilter(QtWidgets.QWidget):
    """A title, two fields for numbers, and a `RangeSlider`.

    Parameters
    ----------
    name : str
        For the names of the widgets.
    title : str

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
        label = QtWidgets.QLabel(title, self)
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
        for field, end in zip(self._fields, scale):
            field.setPlaceholderText(f"{end:.3g}" if any(counts) else "")

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
        self.slider.set_bounds(*map(_value, self._fields))
        self.changed.emit()

    def _show_bounds(self):
        for field, value in zip(self._fields, self.bounds):
            field.setText("" if value is None else f"{value:g}")


def _value(field):
    try:
        return float(field.text())
    except ValueError:
        return None  # empty, or not yet a number

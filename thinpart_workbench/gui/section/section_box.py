# SPDX-License-Identifier: LGPL-2.1-or-later
"""The fields of the section plane."""

from ..application.length_unit import MILLIMETRE
from ..application.qt import QtCore, QtWidgets, Signal, blocked, named, translate
from ..widgets.narrow_fields import new_form

AXES = {"x": (1.0, 0.0, 0.0), "y": (0.0, 1.0, 0.0), "z": (0.0, 0.0, 1.0)}
FROM_VIEW = "view"

_STEPS = 1000


class SectionBox(QtWidgets.QWidget):
    """Switches the section on, and sets its direction, position and side.

    Signals
    -------
    switched(bool)
    direction_chosen(str)
        A key of `AXES`, or `FROM_VIEW`.
    moved(float)
        Position in mm.
    flipped
    """

    switched = Signal(bool)
    direction_chosen = Signal(str)
    moved = Signal(float)
    flipped = Signal()

    def __init__(self, parent=None):
        super().__init__(parent)
        self.setObjectName("ThinPart_SectionBox")
        self._unit, self._ends = MILLIMETRE, (0.0, 1.0)
        form = new_form(self)
        self._on = named(QtWidgets.QCheckBox(translate("ThinPart", "Cut open"), self), "ThinPart_SectionOn", translate(
            "ThinPart", "Cuts the map and the part; the edge of the cut has the colours of the walls"))
        self._on.toggled.connect(self.switched)
        form.addRow(self._on)
        self._direction = named(QtWidgets.QComboBox(self), "ThinPart_SectionDirection", translate(
            "ThinPart", "What faces you is cut off. Choose the current view again after turning the part"))
        for name in AXES:
            self._direction.addItem(name.upper(), name)
        self._direction.addItem(translate("ThinPart", "the current view"), FROM_VIEW)
        self._direction.activated.connect(lambda _: self.direction_chosen.emit(self._direction.currentData()))
        form.addRow(translate("ThinPart", "Across"), self._direction)
        row = QtWidgets.QHBoxLayout()
        self._slider = named(QtWidgets.QSlider(QtCore.Qt.Horizontal, self), "ThinPart_SectionSlider")
        self._slider.setRange(0, _STEPS)
        self._slider.valueChanged.connect(
            lambda step: self.moved.emit(self._ends[0] + step / _STEPS * (self._ends[1] - self._ends[0])))
        row.addWidget(self._slider, 2)
        self._place = named(QtWidgets.QDoubleSpinBox(self), "ThinPart_SectionPlace")
        self._place.setKeyboardTracking(False)
        self._place.valueChanged.connect(lambda value: self.moved.emit(value * self._unit.millimetres))
        row.addWidget(self._place, 1)
        form.addRow(translate("ThinPart", "Position"), row)
        self._flip = named(QtWidgets.QPushButton(translate("ThinPart", "Other side"), self), "ThinPart_SectionFlip",
                           translate("ThinPart", "Shows the half that is cut off now"))
        self._flip.clicked.connect(lambda: self.flipped.emit())
        form.addRow("", self._flip)
        self.show_section(None, (0.0, 1.0), 0.0, MILLIMETRE)

    def show_section(self, direction, ends, place, unit):
        """Show the section.

        Parameters
        ----------
        direction : str or None
            A key of `AXES` or `FROM_VIEW`; None where the map is not cut.
        ends : (float, float), mm
            Least and greatest position.
        place : float, mm
        unit : LengthUnit
        """
        self._unit, self._ends = unit, ends
        with blocked(self):
            self._on.setChecked(direction is not None)
            if direction is not None:
                self._direction.setCurrentIndex(self._direction.findData(direction))
            self._place.setDecimals(unit.decimals)
            self._place.setSuffix("\u00a0" + unit.symbol)
            self._place.setRange(*(unit.value(end) for end in ends))
            self._place.setSingleStep(unit.value(ends[1] - ends[0]) / 100.0)
            self._place.setValue(unit.value(place))
            self._slider.setValue(round(_STEPS * (place - ends[0]) / max(ends[1] - ends[0], 1e-12)))
            for field in (self._direction, self._slider, self._place, self._flip):
                field.setEnabled(direction is not None)

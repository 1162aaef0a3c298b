"""The fields of the section plane."""

from ..application.length_unit import MILLIMETRE
from ..application.qt import QtCore, QtWidgets, Signal, translate
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
        self._unit, self._ends, self._is_updating = MILLIMETRE, (0.0, 1.0), False
        form = new_form(self)
        self._on = QtWidgets.QCheckBox(translate("ThinPart", "Cut open"), self)
        self._on.setObjectName("ThinPart_SectionOn")
        self._on.setToolTip(translate(
            "ThinPart", "Cuts the map and the part; the edge of the cut has the colours of the walls"))
        self._on.toggled.connect(lambda on: self._is_updating or self.switched.emit(on))
        form.addRow(self._on)
        self._direction = QtWidgets.QComboBox(self)
        self._direction.setObjectName("ThinPart_SectionDirection")
        for name in AXES:
            self._direction.addItem(name.upper(), name)
        self._direction.addItem(translate("ThinPart", "the current view"), FROM_VIEW)
        self._direction.setToolTip(translate(
            "ThinPart", "What faces you is cut off. Choose the current view again after turning the part"))
        self._direction.activated.connect(lambda _: self.direction_chosen.emit(self._direction.currentData()))
        form.addRow(translate("ThinPart", "Across"), self._direction)
        row = QtWidgets.QHBoxLayout()
        self._slider = QtWidgets.QSlider(QtCore.Qt.Horizontal, self)
        self._slider.setObjectName("ThinPart_SectionSlider")
        self._slider.setRange(0, _STEPS)
        self._slider.valueChanged.connect(self._on_slider)
        row.addWidget(self._slider, 2)
        self._place = QtWidgets.QDoubleSpinBox(self)
        self._place.setObjectName("ThinPart_SectionPlace")
        self._place.setKeyboardTracking(False)
        self._place.valueChanged.connect(self._on_place)
        row.addWidget(self._place, 1)
        form.addRow(translate("ThinPart", "Position"), row)
        self._flip = QtWidgets.QPushButton(translate("ThinPart", "Other side"), self)
        self._flip.setObjectName("ThinPart_SectionFlip")
        self._flip.setToolTip(translate("ThinPart", "Shows the half that is cut off now"))
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
        self._is_updating, self._unit, self._ends = True, unit, ends
        try:
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
        finally:
            self._is_updating = False

    def _on_slider(self, step):
        if not self._is_updating:
            self.moved.emit(self._ends[0] + step / _STEPS * (self._ends[1] - self._ends[0]))

    def _on_place(self, value):
        if not self._is_updating:
            self.moved.emit(value * self._unit.millimetres)

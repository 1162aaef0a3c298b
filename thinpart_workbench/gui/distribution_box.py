"""How much of the surface lies over which walls, and how much under a threshold."""

from ..freecad_adapter.thickness_object import MILLIMETRES, SHARE
from .flow_layout import FlowLayout
from .length_unit import MILLIMETRE
from .qt import QtCore, QtWidgets, Signal, translate
from .result_view import show_text, text_line
from .scale_box import NumberField
from .thickness_chart import ThicknessChart
from .verdict_text import percent
from .wheel import keep_from_wheel

_STEP = 30
"""Milliseconds between two thresholds while the line is being moved: the colours follow, no faster."""


class DistributionBox(QtWidgets.QWidget):
    """The histogram, the threshold, and sentences about both.

    Signals
    -------
    range_chosen(object)
        See `ThicknessChart`.
    threshold_changed(float, bool)
        mm, and whether that is final: not while the line is being moved.
    thin_only_changed(bool)
    """

    range_chosen = Signal(object)
    threshold_changed = Signal(float, bool)
    thin_only_changed = Signal(bool)

    def __init__(self, parent=None):
        super().__init__(parent)
        self.setObjectName("ThinPart_DistributionBox")
        self._is_set, self._diagonal, self._length = False, 1.0, MILLIMETRE
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(6, 6, 6, 6)
        self.chart = ThicknessChart(self)
        self.chart.range_chosen.connect(self.range_chosen)
        self.chart.threshold_moved.connect(self._line_moved)
        self.chart.threshold_set.connect(self._line_set)
        column.addWidget(self.chart)
        self._chosen = text_line(self, column, "ThinPart_ChosenShare")
        self._add_threshold(column)
        self._under = text_line(self, column, "ThinPart_ThinShare")
        self._thin_only = QtWidgets.QCheckBox(translate("ThinPart", "&Only thin walls in colour"), self)
        self._thin_only.setObjectName("ThinPart_ThinOnly")
        self._thin_only.toggled.connect(lambda on: self._is_set or self.thin_only_changed.emit(on))
        column.addWidget(self._thin_only)
        self._step = QtCore.QTimer(self, singleShot=True, interval=_STEP)
        self._step.timeout.connect(lambda: self.threshold_changed.emit(self.chart.threshold, False))
        self.show_choice(None, 0.0, 0)

    def show_shares(self, edges, shares, greatest, diagonal, unit):
        """See `ThicknessChart.show_shares`; the unit is that of all that follows."""
        self._diagonal, self._length = diagonal, unit
        self.chart.show_shares(edges, shares, greatest, diagonal, unit)
        self._unit.setItemText(self._unit.findData(MILLIMETRES), unit.symbol)
        self._show_field()

    def show_threshold(self, threshold, share, thin_only):
        """Show a threshold in mm, the share of the area under it, and whether only that is coloured."""
        self._is_set = True
        try:
            self.chart.show_threshold(threshold)
            self._show_field()
            self._thin_only.setChecked(thin_only)
        finally:
            self._is_set = False
        show_text(self._under, translate(
            "ThinPart", "{} of the area lies over walls thinner than {}").format(
                percent(share), self._length.text(threshold)))

    def show_choice(self, chosen, share, faces):
        """Say what is chosen in the histogram.

        Parameters
        ----------
        chosen : tuple of float, mm, or None
        share : float
            Of the area.
        faces : int
            Number of B-Rep faces that were selected.
        """
        if chosen is None:
            show_text(self._chosen, translate(
                "ThinPart", "Click or drag over bars to see where those walls are."))
            return
        text = translate("ThinPart", "{} to {}: {} of the area")
        if faces == 1:
            text = translate("ThinPart", "{} to {}: {} of the area, on 1 face")
        elif faces:
            text = translate("ThinPart", "{} to {}: {} of the area, on {} faces")
        show_text(self._chosen, text.format(
            self._length.number(chosen[0]), self._length.text(chosen[1]), percent(share), faces))

    def _add_threshold(self, column):
        row = QtWidgets.QWidget(self)
        flow = FlowLayout(row)
        label = QtWidgets.QLabel(translate("ThinPart", "&Thin below"), row)
        flow.addWidget(label)
        self._field = NumberField(row)
        self._field.setObjectName("ThinPart_Threshold")
        self._field.valueChanged.connect(self._field_changed)
        label.setBuddy(self._field)
        flow.addWidget(self._field)
        self._unit = QtWidgets.QComboBox(row)
        self._unit.setObjectName("ThinPart_ThresholdUnit")
        self._unit.setSizeAdjustPolicy(QtWidgets.QComboBox.AdjustToContents)  # the row wraps where it is too wide
        keep_from_wheel(self._unit)
        self._unit.addItem(self._length.symbol, MILLIMETRES)
        self._unit.addItem(translate("ThinPart", "of the diagonal"), SHARE)
        self._unit.currentIndexChanged.connect(lambda _: self._show_field())
        flow.addWidget(self._unit)
        column.addWidget(row)

    @property
    def _unit_length(self):
        """Millimetres that 1 in the field stands for."""
        return self._diagonal if self._unit.currentData() == SHARE else self._length.millimetres

    def _show_field(self):
        was_set, self._is_set = self._is_set, True
        self._field.setDecimals(4 if self._unit.currentData() == SHARE else self._length.decimals)
        self._field.setValue(self.chart.threshold / self._unit_length)
        self._is_set = was_set

    def _field_changed(self, value):
        if not self._is_set:
            self.threshold_changed.emit(value * self._unit_length, True)

    def _line_moved(self, _threshold):
        if not self._step.isActive():
            self._step.start()

    def _line_set(self, threshold):
        self._step.stop()
        self.threshold_changed.emit(threshold, True)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The thickness distribution of the surface, with the threshold and the share below it."""

from ...freecad_adapter.objects.thickness_object import MILLIMETRES, SHARE
from ..application.length_unit import MILLIMETRE
from ..application.numbers import percent
from ..application.qt import QtCore, QtWidgets, Signal, blocked, named, translate
from ..record.kept_room import keep_room
from ..record.measure_text import share_sentence
from ..record.record_view import show_text, text_line
from ..widgets.flow_layout import FlowLayout
from ..widgets.narrow_fields import LengthField
from .check_box import CheckBox
from .histogram import ThicknessHistogram

_UPDATE_INTERVAL = 30
"""Minimum interval in milliseconds between colour updates while the threshold line is dragged."""


class DistributionBox(QtWidgets.QWidget):
    """The histogram, the threshold, and texts about both.

    Signals
    -------
    range_chosen(object)
        See `ThicknessHistogram`.
    threshold_changed(float, bool)
        Threshold in mm, and whether it is final; it is not while the line is dragged.
    thin_only_changed(bool)
    """

    range_chosen = Signal(object)
    threshold_changed = Signal(float, bool)
    thin_only_changed = Signal(bool)

    def __init__(self, parent=None):
        super().__init__(parent)
        self.setObjectName("ThinPart_DistributionBox")
        self._diagonal, self._length = 1.0, MILLIMETRE
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(6, 6, 6, 6)
        self.chart = ThicknessHistogram(self)
        self.chart.range_chosen.connect(self.range_chosen)
        self.chart.threshold_moved.connect(self._line_moved)
        self.chart.threshold_set.connect(self._line_set)
        column.addWidget(self.chart)
        self._chosen = text_line(self, column, "ThinPart_ChosenShare")
        keep_room(self._chosen, 2)
        self._add_threshold(column)
        self._under = text_line(self, column, "ThinPart_ThinShare")
        keep_room(self._under, 2)
        self._thin_only = named(
            QtWidgets.QCheckBox(translate("ThinPart", "&Only thin walls in colour"), self), "ThinPart_ThinOnly")
        self._thin_only.toggled.connect(self.thin_only_changed)
        column.addWidget(self._thin_only)
        self.check = CheckBox(self)
        column.addWidget(self.check)
        self._update_timer = QtCore.QTimer(self, singleShot=True, interval=_UPDATE_INTERVAL)
        self._update_timer.timeout.connect(lambda: self.threshold_changed.emit(self.chart.threshold, False))
        self.show_choice(None, 0.0, 0)

    def show_shares(self, edges, shares, thickest, diagonal, unit, measure):
        """See `ThicknessHistogram.show_shares`; the box uses the unit from then on."""
        self._diagonal, self._length = diagonal, unit
        self.chart.show_shares(edges, shares, thickest, diagonal, unit, measure)
        self._unit.setItemText(self._unit.findData(MILLIMETRES), unit.symbol)
        self._show_field()

    def show_threshold(self, threshold, share, thin_only):
        """Show a threshold in mm, the share of the area below it, and whether only that area is coloured."""
        self.chart.show_threshold(threshold)
        self._show_field()
        with blocked(self):
            self._thin_only.setChecked(thin_only)
        show_text(self._under, share_sentence(self.chart.measure, percent(share), self._length.text(threshold)))

    def show_choice(self, chosen, share, faces):
        """Describe the range chosen in the histogram.

        Parameters
        ----------
        chosen : tuple of float, mm, or None
        share : float
            Share of the area.
        faces : int
            Number of selected B-Rep faces.
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
        self._field = LengthField("ThinPart_Threshold", row)
        self._field.changed.connect(lambda: self.threshold_changed.emit(self._field.exact(), True))
        label.setBuddy(self._field)
        flow.addWidget(self._field)
        self._unit = named(QtWidgets.QComboBox(row), "ThinPart_ThresholdUnit")
        self._unit.setSizeAdjustPolicy(QtWidgets.QComboBox.AdjustToContents)  # the row wraps if it is too wide
        self._unit.addItem(self._length.symbol, MILLIMETRES)
        self._unit.addItem(translate("ThinPart", "of the diagonal"), SHARE)
        self._unit.currentIndexChanged.connect(lambda _: self._show_field())
        flow.addWidget(self._unit)
        column.addWidget(row)

    def _show_field(self):
        if self._unit.currentData() == SHARE:
            self._field.show_length(self.chart.threshold, self._diagonal, 4)
        else:
            self._field.show_length(self.chart.threshold, self._length.millimetres, self._length.decimals)

    def _line_moved(self, _threshold):
        if not self._update_timer.isActive():
            self._update_timer.start()

    def _line_set(self, threshold):
        self._update_timer.stop()
        self.threshold_changed.emit(threshold, True)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The thickness distribution of a part as a bar chart."""

from ...core.descriptors.bins import BINS
from ...core.descriptors.distribution_bars import bars, round_up
from ...core.length_unit import MILLIMETRE
from ..application.numbers import marked, number, percent
from ..application.qt import QtCore, QtGui, QtWidgets, translate
from ..application.theme import plot_background, readable, text_colour
from ..widgets.chart_axes import ChartAxes

_THIN, _THICK = QtGui.QColor(214, 38, 31), QtGui.QColor(95, 130, 170)
_LIMIT_COLOURS = QtGui.QColor(150, 20, 20), QtGui.QColor(255, 130, 120)
"""Colour of the thin limit, on a light and on a dark background."""


class DistributionChart(ChartAxes):
    """Share of the area over thickness, with the thin limit."""

    def __init__(self, parent=None):
        super().__init__(parent)
        self.setObjectName("ThinPart_DistributionChart")
        self.setMouseTracking(True)
        self.bars, self._thin_limit_x, self._diagonal_mm, self._unit = [], 0.0, 1.0, MILLIMETRE

    def show_distribution(self, bins, area, thin_limit_x, diagonal_mm, unit=MILLIMETRE):
        """Draw a distribution.

        Parameters
        ----------
        bins, area : list
            As in a part record.
        thin_limit_x : float
            Walls thinner than this are thin, as a share of the diagonal.
        diagonal_mm : float
            Diagonal of the part.
        unit : LengthUnit
        """
        self._thin_limit_x, self._diagonal_mm, self._unit = thin_limit_x, diagonal_mm, unit
        self.bars = bars(bins, area, thin_limit_x)
        self.update()

    def bar_text(self, bar):
        """Tool tip of a bar."""
        low, high = bar.low / BINS, bar.high / BINS
        return translate("ThinPart", "{} to {} thick ({} to {} of the diagonal): {} of the area"
                         ).format(self._unit.number(low * self._diagonal_mm), self._unit.text(high * self._diagonal_mm),
                                  number(low), number(high), percent(bar.area))

    def bar_at(self, x):
        """The bar at an x coordinate of the widget, or None."""
        plot = self.plot()
        if not self.bars or not plot.left() <= x <= plot.right():
            return None
        index = int((x - plot.left()) / plot.width() * len(self.bars))
        return self.bars[min(index, len(self.bars) - 1)]

    def event(self, event):
        """Show a tool tip for each bar."""
        if event.type() == QtCore.QEvent.ToolTip:
            bar = self.bar_at(event.pos().x())
            QtWidgets.QToolTip.showText(event.globalPos(), self.bar_text(bar) if bar else "", self)
            return True
        return super().event(event)

    def paintEvent(self, _event):
        """Draw bars, axes and the limit."""
        if not self.bars:
            return
        painter = QtGui.QPainter(self)
        plot = self.plot()
        painter.fillRect(plot, plot_background(self))
        top = round_up(max(bar.area for bar in self.bars) or 1.0)
        self.draw_heights(painter, plot, top)
        self._draw_bars(painter, plot, top)
        self._draw_widths(painter, plot)
        self._draw_limit(painter, plot)
        painter.end()

    @property
    def _span(self):
        return self.bars[-1].high / BINS

    def _draw_bars(self, painter, plot, top):
        width = plot.width() / len(self.bars)
        for index, bar in enumerate(self.bars):
            if bar.area <= 0.0:
                continue
            # Even the smallest share has to be visible.
            height = max(2.0, plot.height() * bar.area / top)
            thin = bar.high <= round(self._thin_limit_x * BINS)
            painter.fillRect(
                QtCore.QRectF(plot.left() + index * width, plot.bottom() - height,
                              max(1.0, width - 1.0), height), _THIN if thin else _THICK)

    def _draw_widths(self, painter, plot):
        """Draw two scales under the bars: thickness, and thickness as a share of the diagonal."""
        painter.setPen(text_colour(self))
        painter.drawLine(plot.bottomLeft(), plot.bottomRight())
        line = self.fontMetrics().height()
        diagonal = self._unit.value(self._diagonal_mm)
        step = round_up(self._span * diagonal / 4.0)
        for tick in range(int(self._span * diagonal / step) + 1):
            thickness = tick * step
            x = plot.left() + plot.width() * thickness / (self._span * diagonal)
            painter.drawLine(QtCore.QPointF(x, plot.bottom()), QtCore.QPointF(x, plot.bottom() + 4))
            self.centred(painter, plot, x, plot.bottom() + 5, number(thickness))
            self.centred(painter, plot, x, plot.bottom() + 5 + line,
                          marked(f"{thickness / diagonal:.2f}"))
        painter.drawText(QtCore.QRectF(0, plot.bottom() + 5 + 2 * line, self.width(), line + 2),
                         QtCore.Qt.AlignCenter,
                         translate("ThinPart", "thickness: {}, and share of the diagonal").format(self._unit.symbol))

    def _draw_limit(self, painter, plot):
        x = plot.left() + plot.width() * self._thin_limit_x / self._span
        limit_colour = readable(self, *_LIMIT_COLOURS)
        painter.setPen(QtGui.QPen(limit_colour, 1.5, QtCore.Qt.DashLine))
        painter.drawLine(QtCore.QPointF(x, plot.top() - 2), QtCore.QPointF(x, plot.bottom()))
        painter.setPen(limit_colour)
        text = translate("ThinPart", "limit {}").format(self._unit.text(self._thin_limit_x * self._diagonal_mm))
        self.centred(painter, plot, x, 1, text)

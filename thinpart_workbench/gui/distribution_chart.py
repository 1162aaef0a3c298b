"""The thickness distribution of a part as a bar chart."""

from ..core.distribution import BINS
from ..core.distribution_bars import bars, round_up
from .chart_axes import ChartAxes
from .length_unit import MILLIMETRE
from .qt import QtCore, QtGui, QtWidgets, translate
from .theme import plot_ground, readable, text_colour
from .verdict_text import number, percent

_THIN, _THICK = QtGui.QColor(214, 38, 31), QtGui.QColor(95, 130, 170)
_LIMITS = QtGui.QColor(150, 20, 20), QtGui.QColor(255, 130, 120)
"""Colour of the limit, on light and on dark."""


class DistributionChart(ChartAxes):
    """Share of the area over thickness, with the thin limit."""

    def __init__(self, parent=None):
        super().__init__(parent)
        self.setObjectName("ThinPart_DistributionChart")
        self.setMouseTracking(True)
        self.bars, self._limit, self._diagonal, self._unit = [], 0.0, 1.0, MILLIMETRE

    def show_distribution(self, bins, area, limit, diagonal, unit=MILLIMETRE):
        """Draw a distribution.

        Parameters
        ----------
        bins, area : list
            As in a part record.
        limit : float
            x under which a wall is thin.
        diagonal : float, mm
            Length that x = 1 stands for.
        unit : LengthUnit
        """
        self._limit, self._diagonal, self._unit = limit, diagonal, unit
        self.bars = bars(bins, area, limit)
        self.update()

    def bar_text(self, bar):
        """What a bar says about itself."""
        low, high = bar.low / BINS, bar.high / BINS
        return translate("ThinPart", "{} to {} thick ({} to {} of the diagonal): {} of the area"
                         ).format(self._unit.number(low * self._diagonal), self._unit.text(high * self._diagonal),
                                  number(low), number(high), percent(bar.area))

    def bar_at(self, x):
        """The bar at a place of the widget, or None."""
        plot = self.plot()
        if not self.bars or not plot.left() <= x <= plot.right():
            return None
        place = int((x - plot.left()) / plot.width() * len(self.bars))
        return self.bars[min(place, len(self.bars) - 1)]

    def event(self, event):
        """Show each bar's own tool tip."""
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
        painter.fillRect(plot, plot_ground(self))
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
        for place, bar in enumerate(self.bars):
            if bar.area <= 0.0:
                continue
            # What is there must be seen, small as it is.
            height = max(2.0, plot.height() * bar.area / top)
            thin = bar.high <= round(self._limit * BINS)
            painter.fillRect(
                QtCore.QRectF(plot.left() + place * width, plot.bottom() - height,
                              max(1.0, width - 1.0), height), _THIN if thin else _THICK)

    def _draw_widths(self, painter, plot):
        """Two scales under the bars: thickness, and as a share of the diagonal."""
        painter.setPen(text_colour(self))
        painter.drawLine(plot.bottomLeft(), plot.bottomRight())
        line = self.fontMetrics().height()
        diagonal = self._unit.value(self._diagonal)
        step = round_up(self._span * diagonal / 4.0)
        for count in range(int(self._span * diagonal / step) + 1):
            thickness = count * step
            x = plot.left() + plot.width() * thickness / (self._span * diagonal)
            painter.drawLine(QtCore.QPointF(x, plot.bottom()), QtCore.QPointF(x, plot.bottom() + 4))
            self.centred(painter, plot, x, plot.bottom() + 5, number(thickness))
            self.centred(painter, plot, x, plot.bottom() + 5 + line,
                          f"{thickness / diagonal:.2f}")
        painter.drawText(QtCore.QRectF(0, plot.bottom() + 5 + 2 * line, self.width(), line + 2),
                         QtCore.Qt.AlignCenter,
                         translate("ThinPart", "thickness: {}, and share of the diagonal").format(self._unit.symbol))

    def _draw_limit(self, painter, plot):
        x = plot.left() + plot.width() * self._limit / self._span
        limit = readable(self, *_LIMITS)
        painter.setPen(QtGui.QPen(limit, 1.5, QtCore.Qt.DashLine))
        painter.drawLine(QtCore.QPointF(x, plot.top() - 2), QtCore.QPointF(x, plot.bottom()))
        painter.setPen(limit)
        text = translate("ThinPart", "thin below {}").format(self._unit.text(self._limit * self._diagonal))
        self.centred(painter, plot, x, 1, text)

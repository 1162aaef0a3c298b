# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compares the thickness distributions of two parts in a chart."""

from ...core.descriptors.bins import BINS
from ...core.descriptors.distribution_bars import round_up
from ..application.numbers import marked
from ..application.qt import QtCore, QtGui, flags_as_int, translate
from ..application.theme import plot_background, readable, text_colour
from ..widgets.chart_axes import ChartAxes

_LINES = (
    (QtGui.QColor(32, 74, 135), QtGui.QColor(114, 159, 207), 2.5, QtCore.Qt.SolidLine),
    (QtGui.QColor(206, 92, 0), QtGui.QColor(252, 175, 62), 2.0, QtCore.Qt.DashLine),
)
"""Colour on light and on dark, width and style of a line: reference part first, compared part second."""


class DistributionComparison(ChartAxes):
    """Cumulative share of the area over walls thinner than x, a share of the diagonal, for two parts."""

    def __init__(self, parent=None):
        super().__init__(parent)
        self.setObjectName("ThinPart_DistributionComparison")
        self.names, self.steps, self._span = [], [], 1.0

    def show_parts(self, named):
        """Draw up to two distributions.

        Parameters
        ----------
        named : list of (str, dict)
            Name and ``distribution`` of each part, the reference part first.
        """
        self.names = [name for name, _ in named]
        self.steps = [_steps(content) for _, content in named]
        end = max((steps[-1][0] for steps in self.steps), default=1.0)
        self._span = min(1.0, round_up(end))
        self.update()

    def paintEvent(self, _event):
        """Draw axes, lines and legend."""
        if not self.steps:
            return
        painter = QtGui.QPainter(self)
        plot = self.plot()
        painter.fillRect(plot, plot_background(self))
        self.draw_heights(painter, plot, 1.0)
        self._draw_widths(painter, plot)
        painter.setRenderHint(QtGui.QPainter.Antialiasing)
        for steps, pen in zip(self.steps, self._pens()):
            painter.setPen(pen)
            painter.drawPath(self._path(plot, steps))
        self._draw_legend(painter, plot)
        painter.end()

    def _pens(self):
        return [QtGui.QPen(readable(self, on_light, on_dark), width, style)
                for on_light, on_dark, width, style in _LINES]

    def _path(self, plot, steps):
        path = QtGui.QPainterPath(plot.bottomLeft())
        for x, share in steps:
            point = QtCore.QPointF(plot.left() + plot.width() * min(1.0, x / self._span),
                                   plot.bottom() - plot.height() * min(1.0, share))
            path.lineTo(point)
        path.lineTo(plot.right(), path.currentPosition().y())
        return path

    def _draw_widths(self, painter, plot):
        painter.setPen(text_colour(self))
        painter.drawLine(plot.bottomLeft(), plot.bottomRight())
        line = self.fontMetrics().height()
        for count in range(5):
            x = plot.left() + plot.width() * count / 4
            painter.drawLine(QtCore.QPointF(x, plot.bottom()), QtCore.QPointF(x, plot.bottom() + 4))
            self.centred(painter, plot, x, plot.bottom() + 5, marked(f"{self._span * count / 4:.3g}"))
        painter.drawText(QtCore.QRectF(0, plot.bottom() + 5 + line, self.width(), 2 * line + 2),
                         flags_as_int(QtCore.Qt.AlignHCenter) | flags_as_int(QtCore.Qt.TextWordWrap),
                         translate("ThinPart", "area with walls thinner than this share of the diagonal"))

    def _draw_legend(self, painter, plot):
        """Draw the line style and name of each part above the plot."""
        line, room = self.fontMetrics().height(), self.width() / len(self.names)
        for number, (name, pen) in enumerate(zip(self.names, self._pens())):
            left = 4 + number * room
            painter.setPen(pen)
            y = 2 + line / 2
            painter.drawLine(QtCore.QPointF(left, y), QtCore.QPointF(left + 2.2 * line, y))
            painter.setPen(text_colour(self))
            width = room - 2.6 * line - 8
            painter.drawText(QtCore.QRectF(left + 2.6 * line, 2, width, line),
                             QtCore.Qt.AlignLeft | QtCore.Qt.AlignVCenter,
                             self.fontMetrics().elidedText(name, QtCore.Qt.ElideMiddle, int(width)))


def _steps(content):
    """Vertices of the cumulative distribution as (x, share up to x)."""
    total, steps = 0.0, []
    for index, area in zip(content["bins"], content["area"]):
        steps.append((index / BINS, total))
        total += area
        steps.append(((index + 1) / BINS, total))
    return steps or [(1.0, 0.0)]

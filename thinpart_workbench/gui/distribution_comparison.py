"""The distributions of two parts over each other."""

from ..core.distribution import BINS
from ..core.distribution_bars import round_up
from .chart_axes import ChartAxes
from .qt import QtCore, QtGui, number_of, translate
from .theme import plot_ground, readable, text_colour

_LINES = (
    (QtGui.QColor(32, 74, 135), QtGui.QColor(114, 159, 207), 2.5, QtCore.Qt.SolidLine),
    (QtGui.QColor(206, 92, 0), QtGui.QColor(252, 175, 62), 2.0, QtCore.Qt.DashLine),
)
"""Colours on light and on dark, width and style: of the part that others are compared with, and of the other one."""


class DistributionComparison(ChartAxes):
    """Share of the area over walls thinner than x, a share of the diagonal, for two parts."""

    def __init__(self, parent=None):
        super().__init__(parent)
        self.setObjectName("ThinPart_DistributionComparison")
        self.names, self.steps, self._span = [], [], 1.0

    def show_parts(self, named):
        """Draw up to two distributions.

        Parameters
        ----------
        named : list of (str, dict)
            Name and ``distribution`` of each part, the one that is compared with first.
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
        painter.fillRect(plot, plot_ground(self))
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
            place = QtCore.QPointF(plot.left() + plot.width() * min(1.0, x / self._span),
                                   plot.bottom() - plot.height() * min(1.0, share))
            path.lineTo(place)
        path.lineTo(plot.right(), path.currentPosition().y())
        return path

    def _draw_widths(self, painter, plot):
        painter.setPen(text_colour(self))
        painter.drawLine(plot.bottomLeft(), plot.bottomRight())
        line = self.fontMetrics().height()
        for count in range(5):
            x = plot.left() + plot.width() * count / 4
            painter.drawLine(QtCore.QPointF(x, plot.bottom()), QtCore.QPointF(x, plot.bottom() + 4))
            self.centred(painter, plot, x, plot.bottom() + 5, f"{self._span * count / 4:.3g}")
        painter.drawText(QtCore.QRectF(0, plot.bottom() + 5 + line, self.width(), 2 * line + 2),
                         number_of(QtCore.Qt.AlignHCenter) | number_of(QtCore.Qt.TextWordWrap),
                         translate("ThinPart", "area over walls thinner than this share of the diagonal"))

    def _draw_legend(self, painter, plot):
        """A line of its own style before each name, over the plot."""
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
    """Corners of the cumulative distribution: x at the end of each bin, and the share up to it."""
    total, steps = 0.0, []
    for index, area in zip(content["bins"], content["area"]):
        steps.append((index / BINS, total))
        total += area
        steps.append(((index + 1) / BINS, total))
    return steps or [(1.0, 0.0)]

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The quality of the elements before and after, as a histogram."""

from ...core.descriptors.distribution_bars import round_up
from ...core.mesh.tetrahedra import POOR
from ..application.numbers import marked
from ..application.qt import QtCore, QtGui, translate
from ..application.theme import plot_background, text_colour
from ..widgets.chart_axes import ChartAxes

BEFORE, AFTER = QtGui.QColor(235, 145, 50), QtGui.QColor(60, 125, 200)


class QualityChart(ChartAxes):
    """Share of the elements over gamma: at one size, and with the sizes of the walls."""

    def __init__(self, parent=None):
        super().__init__(parent)
        self.setObjectName("ThinPart_QualityChart")
        self.before, self.after = [], []
        self.setToolTip(translate("ThinPart", "gamma: three times the inscribed by the circumscribed radius; 1 for regular "
                                              "tetrahedra, under 0.3 poor"))

    def show_histograms(self, before, after):
        """Show shares by bin of gamma, from 0 to 1; an empty list for a mesh that there is not."""
        self.before, self.after = before, after
        self.update()

    def paintEvent(self, _event):
        """Draw both."""
        painter, plot = QtGui.QPainter(self), self.plot()
        painter.fillRect(plot, plot_background(self))
        top = round_up(max([*self.before, *self.after], default=1.0) or 1.0)
        self.draw_heights(painter, plot, top)
        for side, shares, paint in ((0, self.before, BEFORE), (1, self.after, AFTER)):
            width = plot.width() / max(1, len(shares))
            for number, share in enumerate(shares):
                if share > 0.0:
                    height = max(1.5, plot.height() * share / top)
                    painter.fillRect(QtCore.QRectF(plot.left() + (number + 0.5 * side) * width, plot.bottom() - height,
                                                   max(1.0, 0.5 * width - 0.5), height), paint)
        line = self.fontMetrics().height()
        painter.setPen(text_colour(self))
        painter.drawLine(plot.bottomLeft(), plot.bottomRight())
        for tick in (0.0, POOR, 0.5, 1.0):
            self.centred(painter, plot, plot.left() + tick * plot.width(), plot.bottom() + 5, marked(f"{tick:g}"))
        painter.drawText(QtCore.QRectF(0, plot.bottom() + 5 + line, self.width(), line + 2), QtCore.Qt.AlignCenter,
                         translate("ThinPart", "quality of the elements (gamma)"))
        left = plot.left()
        for paint, text in ((BEFORE, translate("ThinPart", "one size")), (AFTER, translate("ThinPart", "as proposed"))):
            painter.fillRect(QtCore.QRectF(left, 4, 10, 10), paint)
            painter.drawText(QtCore.QRectF(left + 14, 0, 200, line + 2), QtCore.Qt.AlignVCenter, text)
            left += 30 + self.fontMetrics().boundingRect(text).width()
        painter.end()

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Base class of the charts of a thickness distribution: plot area, vertical axis and labels."""

from ..application.numbers import marked
from ..application.qt import QtCore, QtWidgets
from ..application.theme import text_colour


class ChartAxes(QtWidgets.QWidget):
    """A plot of shares of the area over thickness."""

    def __init__(self, parent=None):
        super().__init__(parent)
        self.setMinimumSize(180, 180)
        self.setSizePolicy(QtWidgets.QSizePolicy.Expanding, QtWidgets.QSizePolicy.Fixed)

    def sizeHint(self):
        """Wider than high."""
        return QtCore.QSize(300, 180)

    def plot(self):
        """QRectF of the plot within the widget."""
        line = self.fontMetrics().height()
        left = self.fontMetrics().boundingRect("100 %").width() + 10
        top = 1.5 * line + 4
        return QtCore.QRectF(left, top, max(1, self.width() - left - 12),
                             max(1, self.height() - top - 3 * line - 8))

    def draw_heights(self, painter, plot, top):
        """Draw grid lines and labels at 0, half and all of `top`, the share of the area at the plot's upper edge."""
        text, faint = text_colour(self), text_colour(self, 50)
        height = self.fontMetrics().height()
        for share in (0.0, top / 2.0, top):
            y = plot.bottom() - plot.height() * share / top
            painter.setPen(faint)
            painter.drawLine(QtCore.QPointF(plot.left(), y), QtCore.QPointF(plot.right(), y))
            painter.setPen(text)
            painter.drawText(QtCore.QRectF(0, y - height / 2, plot.left() - 5, height),
                             QtCore.Qt.AlignRight | QtCore.Qt.AlignVCenter, marked(f"{100 * share:.3g} %"))

    def centred(self, painter, plot, x, y, text):
        """Draw a text centred at `x` with its upper edge at `y`, moved sideways to stay within the widget."""
        width = self.fontMetrics().boundingRect(text).width() + 4
        left = max(0.0, min(x - width / 2, self.width() - width))
        painter.drawText(QtCore.QRectF(left, y, width, self.fontMetrics().height()),
                         QtCore.Qt.AlignCenter, text)

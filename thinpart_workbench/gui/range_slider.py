"""A histogram with two handles that choose a range on a logarithmic scale."""

import math

from .qt import QtCore, QtGui, QtWidgets, Signal, mouse_place
from .theme import plot_ground, readable, text_colour

LEAST, MOST = 0, 1
_HANDLES = QtGui.QColor(240, 240, 240), QtGui.QColor(70, 70, 70)
"""Colour of a handle, on light and on dark."""
_CHOSEN = QtGui.QColor(52, 116, 186), QtGui.QColor(110, 165, 225)
"""Colour of the bars between the handles, on light and on dark: a theme's own highlight may be pale."""

_STEP = 0.02
"""Share of the scale that an arrow key moves a handle by."""


class RangeSlider(QtWidgets.QWidget):
    """Two handles over a histogram.

    Signals
    -------
    changed
        The user has moved a handle.
    """

    changed = Signal()

    def __init__(self, parent=None):
        super().__init__(parent)
        self.setFocusPolicy(QtCore.Qt.StrongFocus)
        self.setSizePolicy(QtWidgets.QSizePolicy.Expanding, QtWidgets.QSizePolicy.Fixed)
        self._scale, self._counts = (1.0, 1.0), []
        self._bounds = [None, None]
        self._held = LEAST

    @property
    def bounds(self):
        """tuple of float or None: the values at the handles, None at the end of the scale."""
        return tuple(self._bounds)

    def set_bounds(self, least, most):
        """Put the handles somewhere, without a signal."""
        self._bounds = [least, most]
        self.update()

    def show_histogram(self, scale, counts):
        """Show how many parts there are along the scale.

        Parameters
        ----------
        scale : (float, float)
            Its ends, above 0.
        counts : list of int
            In intervals of equal ratios.
        """
        self._scale, self._counts = tuple(scale), counts
        self.update()

    def sizeHint(self):
        """Wide rather than high."""
        line = self.fontMetrics().height()
        return QtCore.QSize(8 * line, 3 * line)

    def minimumSizeHint(self):
        """Still wide enough for a hand."""
        line = self.fontMetrics().height()
        return QtCore.QSize(5 * line, 3 * line)

    def place_of(self, which):
        """Where a handle stands, in pixels from the left."""
        low, high = self._scale
        value, share = self._bounds[which], float(which)
        if value is not None and high > low:
            share = math.log(max(value, low) / low) / math.log(high / low)
        plot = self._plot()
        return plot.left() + min(1.0, max(0.0, share)) * plot.width()

    def mousePressEvent(self, event):
        """Take the nearer handle."""
        x = mouse_place(event).x()
        places = self.place_of(LEAST), self.place_of(MOST)
        nearest_least = abs(x - places[LEAST]) < abs(x - places[MOST])
        if places[LEAST] == places[MOST]:
            nearest_least = x < places[LEAST]
        self._held = LEAST if nearest_least else MOST
        self._move_to(x)

    def mouseMoveEvent(self, event):
        """Move the handle that is held."""
        if event.buttons() & QtCore.Qt.LeftButton:
            self._move_to(mouse_place(event).x())

    def mouseDoubleClickEvent(self, _event):
        """Choose everything again."""
        self.set_bounds(None, None)
        self.changed.emit()

    def keyPressEvent(self, event):
        """Arrows move the handle that was held last; with Shift the other one."""
        step = {QtCore.Qt.Key_Left: -_STEP, QtCore.Qt.Key_Right: _STEP}.get(event.key())
        if step is None:
            super().keyPressEvent(event)
            return
        if event.modifiers() & QtCore.Qt.ShiftModifier:
            self._held = MOST - self._held
        self._move_to(self.place_of(self._held) + step * self._plot().width())

    def paintEvent(self, _event):
        """Draw bars, what is chosen of them, and the handles."""
        painter = QtGui.QPainter(self)
        painter.setRenderHint(QtGui.QPainter.Antialiasing)
        plot = self._plot()
        painter.fillRect(plot, plot_ground(self))
        left, right = self.place_of(LEAST), self.place_of(MOST)
        chosen, other = readable(self, *_CHOSEN), text_colour(self, 80)
        top, width = max([*self._counts, 1]), plot.width() / max(1, len(self._counts))
        for number, count in enumerate(self._counts):
            if count:
                # What is there must be seen; roots show the few beside the many.
                height = max(2.0, plot.height() * math.sqrt(count / top))
                x = plot.left() + number * width
                inside = left - 1 <= x + width / 2 <= right + 1
                painter.fillRect(QtCore.QRectF(x, plot.bottom() - height, max(1.0, width - 1.0), height),
                                 chosen if inside else other)
        painter.setPen(text_colour(self))
        painter.drawLine(plot.bottomLeft(), plot.bottomRight())
        for which, x in ((LEAST, left), (MOST, right)):
            self._draw_handle(painter, x, plot, which)
        painter.end()

    def _draw_handle(self, painter, x, plot, which):
        radius = self._radius()
        held = self.hasFocus() and which == self._held
        painter.setPen(QtGui.QPen(text_colour(self), 2.0 if held else 1.0))
        painter.drawLine(QtCore.QPointF(x, plot.top()), QtCore.QPointF(x, plot.bottom()))
        painter.setBrush(readable(self, *_HANDLES))
        painter.drawEllipse(QtCore.QPointF(x, plot.bottom()), radius, radius)

    def _radius(self):
        return 0.35 * self.fontMetrics().height()

    def _plot(self):
        edge = self._radius() + 2.0
        return QtCore.QRectF(edge, 1.0, max(1.0, self.width() - 2 * edge),
                             max(1.0, self.height() - edge - 2.0))

    def _move_to(self, x):
        plot, (low, high) = self._plot(), self._scale
        share = min(1.0, max(0.0, (x - plot.left()) / plot.width()))
        other = self._bounds[MOST - self._held]
        value = low * (high / low) ** share
        if other is not None:
            value = min(value, other) if self._held == LEAST else max(value, other)
        at_end = share <= 0.0 if self._held == LEAST else share >= 1.0
        before = self._bounds[self._held]
        self._bounds[self._held] = None if at_end else float(f"{value:.3g}")
        self.update()
        if before != self._bounds[self._held]:
            self.changed.emit()

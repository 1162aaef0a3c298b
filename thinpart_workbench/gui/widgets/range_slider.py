# SPDX-License-Identifier: LGPL-2.1-or-later
"""A histogram with two handles that select a range on a logarithmic scale."""

import math

from ..application.qt import QtCore, QtGui, QtWidgets, Signal, mouse_position
from ..application.theme import plot_background, readable, text_colour

LEAST, MOST = 0, 1
_HANDLES = QtGui.QColor(240, 240, 240), QtGui.QColor(70, 70, 70)
"""Colour of a handle, on a light and on a dark background."""
_CHOSEN = QtGui.QColor(52, 116, 186), QtGui.QColor(110, 165, 225)
"""Colour of the bars between the handles, on a light and on a dark background: a theme's highlight may be pale."""

_STEP = 0.02
"""Share of the scale by which an arrow key moves a handle."""


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
        self._active = LEAST

    @property
    def bounds(self):
        """tuple of float or None: the values at the handles; None for a handle at its end of the scale."""
        return tuple(self._bounds)

    def set_bounds(self, least, most):
        """Move the handles without emitting a signal."""
        self._bounds = [least, most]
        self.update()

    def show_histogram(self, scale, counts):
        """Show the numbers of parts along the scale.

        Parameters
        ----------
        scale : (float, float)
            Its ends, greater than 0.
        counts : list of int
            Per interval; all intervals have the same ratio of bounds.
        """
        self._scale, self._counts = tuple(scale), counts
        self.update()

    def sizeHint(self):
        """Wider than high."""
        line = self.fontMetrics().height()
        return QtCore.QSize(8 * line, 3 * line)

    def minimumSizeHint(self):
        """Wide enough to operate with the mouse."""
        line = self.fontMetrics().height()
        return QtCore.QSize(5 * line, 3 * line)

    def handle_x(self, handle):
        """x coordinate of a handle (`LEAST` or `MOST`), in pixels."""
        low, high = self._scale
        value, share = self._bounds[handle], float(handle)
        if value is not None and high > low:
            share = math.log(max(value, low) / low) / math.log(high / low)
        plot = self._plot()
        return plot.left() + min(1.0, max(0.0, share)) * plot.width()

    def mousePressEvent(self, event):
        """Grab the nearer handle."""
        x = mouse_position(event).x()
        positions = self.handle_x(LEAST), self.handle_x(MOST)
        nearest_least = abs(x - positions[LEAST]) < abs(x - positions[MOST])
        if positions[LEAST] == positions[MOST]:
            nearest_least = x < positions[LEAST]
        self._active = LEAST if nearest_least else MOST
        self._move_to(x)

    def mouseMoveEvent(self, event):
        """Drag the grabbed handle."""
        if event.buttons() & QtCore.Qt.LeftButton:
            self._move_to(mouse_position(event).x())

    def mouseDoubleClickEvent(self, _event):
        """Reset to the full range."""
        self.set_bounds(None, None)
        self.changed.emit()

    def keyPressEvent(self, event):
        """Arrow keys move the handle that was grabbed last; with Shift, the other one."""
        step = {QtCore.Qt.Key_Left: -_STEP, QtCore.Qt.Key_Right: _STEP}.get(event.key())
        if step is None:
            super().keyPressEvent(event)
            return
        if event.modifiers() & QtCore.Qt.ShiftModifier:
            self._active = MOST - self._active
        self._move_to(self.handle_x(self._active) + step * self._plot().width())

    def paintEvent(self, _event):
        """Draw the bars, with those in the range highlighted, and the handles."""
        painter = QtGui.QPainter(self)
        painter.setRenderHint(QtGui.QPainter.Antialiasing)
        plot = self._plot()
        painter.fillRect(plot, plot_background(self))
        left, right = self.handle_x(LEAST), self.handle_x(MOST)
        chosen, other = readable(self, *_CHOSEN), text_colour(self, 80)
        top, width = max([*self._counts, 1]), plot.width() / max(1, len(self._counts))
        for number, count in enumerate(self._counts):
            if count:
                # Every non-empty bar has to be visible; square roots keep small counts visible beside large ones.
                height = max(2.0, plot.height() * math.sqrt(count / top))
                x = plot.left() + number * width
                inside = left - 1 <= x + width / 2 <= right + 1
                painter.fillRect(QtCore.QRectF(x, plot.bottom() - height, max(1.0, width - 1.0), height),
                                 chosen if inside else other)
        painter.setPen(text_colour(self))
        painter.drawLine(plot.bottomLeft(), plot.bottomRight())
        for handle, x in ((LEAST, left), (MOST, right)):
            self._draw_handle(painter, x, plot, handle)
        painter.end()

    def _draw_handle(self, painter, x, plot, handle):
        radius = self._radius()
        is_active = self.hasFocus() and handle == self._active
        painter.setPen(QtGui.QPen(text_colour(self), 2.0 if is_active else 1.0))
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
        other = self._bounds[MOST - self._active]
        value = low * (high / low) ** share
        if other is not None:
            value = min(value, other) if self._active == LEAST else max(value, other)
        at_end = share <= 0.0 if self._active == LEAST else share >= 1.0
        before = self._bounds[self._active]
        self._bounds[self._active] = None if at_end else float(f"{value:.3g}")
        self.update()
        if before != self._bounds[self._active]:
            self.changed.emit()

# SPDX-License-Identifier: LGPL-2.1-or-later
"""An interactive histogram of area by wall thickness, with selectable bars and a threshold line."""

import numpy as np

from ...core.analysis_settings import RAY
from ...core.descriptors.distribution_bars import round_up
from ..application.length_unit import MILLIMETRE
from ..application.numbers import marked, number, percent
from ..application.qt import QtCore, QtGui, QtWidgets, Signal, mouse_position, translate
from ..application.theme import plot_background, readable, text_colour
from ..record.measure_text import axis_title
from ..widgets.chart_axes import ChartAxes

_GRAB_DISTANCE = 5
"""Distance in pixels within which the mouse grabs the threshold line."""

_LINE_COLOURS = QtGui.QColor(20, 20, 20), QtGui.QColor(235, 235, 235)
"""Colours of the threshold line on a light and on a dark background."""


class ThicknessHistogram(ChartAxes):
    """A histogram whose bars can be selected and whose threshold line can be dragged.

    Signals
    -------
    range_chosen(object)
        ``(low, high)`` in mm, or None.
    threshold_moved(float)
        The line is being dragged; threshold in mm.
    threshold_set(float)
        The line was released; threshold in mm.
    """

    range_chosen = Signal(object)
    threshold_moved = Signal(float)
    threshold_set = Signal(float)

    def __init__(self, parent=None):
        super().__init__(parent)
        self.setObjectName("ThinPart_ThicknessChart")
        self.setMouseTracking(True)
        self.setFocusPolicy(QtCore.Qt.StrongFocus)
        self.edges, self.shares, self.colours = np.zeros(1), np.zeros(0), np.zeros((0, 3), np.uint8)
        self.threshold, self._diagonal, self._unit, self.measure = 0.0, 1.0, MILLIMETRE, RAY
        self.thickest = 0.0  # the last bar extends to it
        self.bars = None  # first and last selected bar
        self._anchor = None  # bar where the selection started
        self._is_repeated = False  # whether the selection starts at the only selected bar: a click clears it
        self._is_dragging_line = False
        self._pressed = None  # where the line was grabbed, until it is moved

    @property
    def chosen(self):
        """``(low, high)`` of the selected bars in mm, or None."""
        if self.bars is None:
            return None
        first, last = self.bars
        if last < self.count - 1:
            return float(self.edges[first]), float(self.edges[last + 1])
        # The last bar includes its upper edge; maps store float32.
        end = np.float32(max(self.edges[-1], self.thickest))
        return float(self.edges[first]), float(np.nextafter(end, np.float32(np.inf)))

    @property
    def count(self):
        """Number of bars."""
        return len(self.shares)

    def show_shares(self, edges, shares, thickest, diagonal, unit=MILLIMETRE, measure=RAY):
        """Replace the bars and clear the selection.

        Parameters
        ----------
        edges : ndarray of shape (k + 1,), mm
            Starting at 0.
        shares : ndarray of shape (k,)
        thickest : float, mm
            Thickest wall; if it exceeds the last edge, the last bar extends to it.
        diagonal : float, mm
            Reference of the second scale.
        unit : LengthUnit
        measure : str
            One of `SHOWN_MEASURES`.
        """
        self.edges, self.shares, self.thickest, self._diagonal = edges, shares, thickest, diagonal
        self._unit, self.measure = unit, measure
        self.bars = None
        self.update()

    def show_colours(self, colours):
        """Set the colours of the bars: ndarray of shape (k, 3), uint8."""
        self.colours = colours
        self.update()

    def show_threshold(self, threshold):
        """Move the threshold line, mm; ignored while the user drags it."""
        if not self._is_dragging_line:
            self.threshold = threshold
            self.update()

    def clear_choice(self):
        """Clear the selection; emits `range_chosen` if a bar was selected."""
        self._choose(None)

    def x_of(self, thickness):
        """Horizontal position of a thickness, in pixels from the left."""
        plot = self.plot()
        return plot.left() + plot.width() * min(1.0, thickness / self.edges[-1])

    def bar_at(self, x):
        """Number of the bar at a horizontal position, None beside the plot."""
        plot = self.plot()
        if not self.count or not plot.left() <= x <= plot.right():
            return None
        thickness = (x - plot.left()) / plot.width() * self.edges[-1]
        return min(int(np.searchsorted(self.edges, thickness, side="right")) - 1, self.count - 1)

    def bar_text(self, bar):
        """Tool tip of a bar."""
        if bar == self.count - 1 and self.thickest > self.edges[-1]:
            return translate("ThinPart", "{} and more: {} of the area").format(
                self._unit.text(float(self.edges[bar])), percent(float(self.shares[bar])))
        return translate("ThinPart", "{} to {}: {} of the area").format(
            self._unit.number(float(self.edges[bar])), self._unit.text(float(self.edges[bar + 1])),
            percent(float(self.shares[bar])))

    def sizeHint(self):
        """Preferred size; the height leaves room for the texts at any font size."""
        return QtCore.QSize(300, max(180, int(10.5 * self.fontMetrics().height())))

    def minimumSizeHint(self):
        """See `sizeHint`."""
        return QtCore.QSize(180, self.sizeHint().height())

    def event(self, event):
        """Show a tool tip per bar, and override FreeCAD's shortcuts for the keys used here."""
        if event.type() == QtCore.QEvent.ShortcutOverride and (
                event.key() in (QtCore.Qt.Key_Left, QtCore.Qt.Key_Right)
                or event.key() == QtCore.Qt.Key_Escape and self.bars is not None):
            event.accept()
            return True
        if event.type() == QtCore.QEvent.ToolTip:
            bar = self.bar_at(event.pos().x())
            QtWidgets.QToolTip.showText(event.globalPos(), "" if bar is None else self.bar_text(bar), self)
            return True
        return super().event(event)

    def mousePressEvent(self, event):
        """Grab the line or start a selection; beside the plot, clear the selection."""
        if event.button() != QtCore.Qt.LeftButton or not self.count:
            return
        position = mouse_position(event)
        if self._is_near_line(position):
            self._is_dragging_line, self._pressed = True, position
            return
        self._start_selection(position)

    def _start_selection(self, position):
        """Start a selection at a position; beside the plot, clear the selection."""
        inside = self.plot().adjusted(0, 0, 0, 1).contains(QtCore.QPointF(position))
        self._anchor = self.bar_at(position.x()) if inside else None
        self._is_repeated = self._anchor is not None and self.bars == (self._anchor, self._anchor)
        self._choose(None if self._anchor is None else (self._anchor, self._anchor))

    def mouseMoveEvent(self, event):
        """Drag the line or extend the selection."""
        position = mouse_position(event)
        x = position.x()
        if self._is_dragging_line:
            self._pressed = None
            self.threshold = self._thickness_at(x)
            self.update()
            self.threshold_moved.emit(self.threshold)
        elif self._anchor is not None:
            plot = self.plot()
            bar = self.bar_at(min(max(x, plot.left()), plot.right()))
            self._choose((min(self._anchor, bar), max(self._anchor, bar)))
        self.setCursor(QtCore.Qt.SplitHCursor if self._is_dragging_line or self._is_near_line(position)
                       else QtCore.Qt.ArrowCursor)

    def mouseReleaseEvent(self, _event):
        """Release the line or end the selection; a click on the line without dragging selects the bar under it.

        A second click on a bar clears the selection.
        """
        if self._is_dragging_line and self._pressed is not None:
            self._start_selection(self._pressed)
        if self._is_repeated and self._anchor is not None and self.bars == (self._anchor, self._anchor):
            self._choose(None)
        self._is_repeated = False
        is_moved = self._is_dragging_line and self._pressed is None
        self._anchor = self._pressed = None
        self._is_dragging_line = False
        if is_moved:
            self.threshold_set.emit(self.threshold)

    def keyPressEvent(self, event):
        """Arrow keys select the next bar, with Shift they extend the selection; Esc clears it."""
        step = {QtCore.Qt.Key_Left: -1, QtCore.Qt.Key_Right: 1}.get(event.key())
        if event.key() == QtCore.Qt.Key_Escape and self.bars is not None:
            self._choose(None)
        elif step is None or not self.count:
            super().keyPressEvent(event)  # without a selection, Esc closes the panel as usual
        else:
            self._move_selection(step, bool(event.modifiers() & QtCore.Qt.ShiftModifier))

    def paintEvent(self, _event):
        """Draw the bars, the scales and the threshold line."""
        if not self.count:
            return
        painter = QtGui.QPainter(self)
        plot = self.plot()
        painter.fillRect(plot, plot_background(self))
        top = round_up(float(self.shares.max()) or 1.0)
        self.draw_heights(painter, plot, top)
        self._draw_bars(painter, plot, top)
        self._draw_scales(painter, plot)
        self._draw_line(painter, plot)
        if self.hasFocus():
            painter.setPen(QtGui.QPen(self.palette().highlight().color(), 1, QtCore.Qt.DotLine))
            painter.drawRect(plot.adjusted(-2, -2, 2, 2))
        painter.end()

    def _move_selection(self, step, extend):
        if self.bars is None:
            bar = 0 if step > 0 else self.count - 1
            self._choose((bar, bar))
            return
        first, last = self.bars
        moved = min(max((last if step > 0 else first) + step, 0), self.count - 1)
        if extend:
            self._choose((first, moved) if step > 0 else (moved, last))
        else:
            self._choose((moved, moved))

    def _choose(self, bars):
        if bars != self.bars:
            self.bars = bars
            self.update()
            self.range_chosen.emit(self.chosen)

    def _is_near_line(self, position):
        plot = self.plot()
        return (self.count and abs(position.x() - self.x_of(self.threshold)) <= _GRAB_DISTANCE
                and plot.top() - self.fontMetrics().height() * 1.5 <= position.y() <= plot.bottom())

    def _thickness_at(self, x):
        plot = self.plot()
        share = min(1.0, max(0.0, (x - plot.left()) / plot.width()))
        return self._unit.millimetres * float(f"{self._unit.value(share * self.edges[-1]):.3g}")

    def _draw_bars(self, painter, plot, top):
        frame = text_colour(self)
        for bar, share in enumerate(self.shares):
            left = self.x_of(self.edges[bar])
            width = self.x_of(self.edges[bar + 1]) - left
            is_chosen = self.bars is not None and self.bars[0] <= bar <= self.bars[1]
            if is_chosen:
                back = QtGui.QColor(self.palette().highlight().color())
                back.setAlpha(70)
                painter.fillRect(QtCore.QRectF(left, plot.top(), width, plot.height()), back)
            if share <= 0.0:
                continue
            # Keep even the smallest share visible.
            height = max(2.0, plot.height() * share / top)
            box = QtCore.QRectF(left, plot.bottom() - height, max(1.0, width - 1.0), height)
            painter.fillRect(box, QtGui.QColor(*map(int, self.colours[bar])))
            # Yellow bars need a frame on a white background.
            frame.setAlpha(255 if is_chosen else 90)
            painter.setPen(frame)
            painter.drawRect(box)

    def _draw_scales(self, painter, plot):
        """Draw two scales under the bars: thickness, and share of the diagonal."""
        painter.setPen(text_colour(self))
        painter.drawLine(plot.bottomLeft(), plot.bottomRight())
        line, span = self.fontMetrics().height(), self._unit.value(float(self.edges[-1]))
        step = round_up(span / max(1.0, plot.width() / (7.5 * self.fontMetrics().averageCharWidth()) - 1.0))
        for count in range(int(span / step * (1.0 + 1e-9)) + 1):
            thickness = self._unit.millimetres * count * step
            x = self.x_of(thickness)
            painter.drawLine(QtCore.QPointF(x, plot.bottom()), QtCore.QPointF(x, plot.bottom() + 4))
            self.centred(painter, plot, x, plot.bottom() + 5, number(count * step))
            self.centred(painter, plot, x, plot.bottom() + 5 + line, marked(f"{thickness / self._diagonal:.2g}"))
        painter.drawText(QtCore.QRectF(0, plot.bottom() + 5 + 2 * line, self.width(), line + 2),
                         QtCore.Qt.AlignCenter, self.fontMetrics().elidedText(
                             axis_title(self.measure, self._unit.symbol), QtCore.Qt.ElideRight, self.width()))

    def _draw_line(self, painter, plot):
        x = self.x_of(self.threshold)
        width = 2.0 if self._is_dragging_line else 1.5
        painter.setPen(QtGui.QPen(readable(self, *_LINE_COLOURS), width, QtCore.Qt.DashLine))
        painter.drawLine(QtCore.QPointF(x, plot.top() - 2), QtCore.QPointF(x, plot.bottom()))
        painter.setPen(text_colour(self))
        self.centred(painter, plot, x, 1, translate("ThinPart", "thin below {}").format(
            self._unit.text(self.threshold)))

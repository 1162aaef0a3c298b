"""Area over ranges of thickness, in the colours of the scale: ranges and a threshold are chosen by hand."""

import numpy as np

from ..core.distribution_bars import round_up
from .chart_axes import ChartAxes
from .length_unit import MILLIMETRE
from .qt import QtCore, QtGui, QtWidgets, Signal, mouse_place, translate
from .theme import plot_ground, readable, text_colour
from .verdict_text import number, percent

BARS = 40
_NEAR = 5
"""Pixels within which the mouse takes the line of the threshold."""

_LINES = QtGui.QColor(20, 20, 20), QtGui.QColor(235, 235, 235)
"""Of the threshold, on light and on dark."""


def bar_edges(last, unit=MILLIMETRE):
    """Edges of bars from 0 to a thickness, ndarray of shape (k + 1,), mm.

    The bars lie around multiples of a width that people like in their unit, so that a wall of 3 mm, which is 2.999 mm
    at some places, is in one bar; the first is half as wide.
    """
    width = unit.millimetres * round_up(unit.value(last) / BARS)
    return np.concatenate([[0.0], width * (np.arange(int(np.ceil(last / width + 0.5 - 1e-6))) + 0.5)])


class ThicknessChart(ChartAxes):
    """A histogram in which bars are chosen and a line is moved.

    Signals
    -------
    range_chosen(object)
        ``(low, high)`` in mm, None for none.
    threshold_moved(float)
        The line is being moved; mm.
    threshold_set(float)
        It was let go.
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
        self.threshold, self._diagonal, self._unit = 0.0, 1.0, MILLIMETRE
        self.greatest = 0.0  # the last bar goes on to it
        self.bars = None  # first and last of those that are chosen
        self._begun = None  # bar at which choosing began
        self._holds_line = False
        self._pressed = None  # where the line was taken, until it is moved

    @property
    def chosen(self):
        """``(low, high)`` of the bars that are chosen, mm; None for none."""
        if self.bars is None:
            return None
        first, last = self.bars
        if last < self.count - 1:
            return float(self.edges[first]), float(self.edges[last + 1])
        # What is as thick as the last edge is in the last bar; maps hold float32.
        end = np.float32(max(self.edges[-1], self.greatest))
        return float(self.edges[first]), float(np.nextafter(end, np.float32(np.inf)))

    @property
    def count(self):
        """Number of bars."""
        return len(self.shares)

    def show_shares(self, edges, shares, greatest, diagonal, unit=MILLIMETRE):
        """Show other bars; none of them is chosen.

        Parameters
        ----------
        edges : ndarray of shape (k + 1,), mm
            From 0 on.
        shares : ndarray of shape (k,)
        greatest : float, mm
            Thickest wall; where that is beyond the last edge, the last bar holds all up to it.
        diagonal : float, mm
            The second scale tells shares of it.
        unit : LengthUnit
        """
        self.edges, self.shares, self.greatest, self._diagonal = edges, shares, greatest, diagonal
        self._unit = unit
        self.bars = None
        self.update()

    def show_colours(self, colours):
        """Paint the bars: ndarray of shape (k, 3), uint8."""
        self.colours = colours
        self.update()

    def show_threshold(self, threshold):
        """Put the line somewhere, mm; while it is being moved by hand it stays there."""
        if not self._holds_line:
            self.threshold = threshold
            self.update()

    def clear_choice(self):
        """Choose no bar, with a signal where one was."""
        self._choose(None)

    def x_of(self, thickness):
        """Where a thickness stands, in pixels from the left."""
        plot = self.plot()
        return plot.left() + plot.width() * min(1.0, thickness / self.edges[-1])

    def bar_at(self, x):
        """Number of the bar at a place of the widget, None beside the plot."""
        plot = self.plot()
        if not self.count or not plot.left() <= x <= plot.right():
            return None
        thickness = (x - plot.left()) / plot.width() * self.edges[-1]
        return min(int(np.searchsorted(self.edges, thickness, side="right")) - 1, self.count - 1)

    def bar_text(self, bar):
        """What a bar says about itself."""
        if bar == self.count - 1 and self.greatest > self.edges[-1]:
            return translate("ThinPart", "{} and more: {} of the area").format(
                self._unit.text(float(self.edges[bar])), percent(float(self.shares[bar])))
        return translate("ThinPart", "{} to {}: {} of the area").format(
            self._unit.number(float(self.edges[bar])), self._unit.text(float(self.edges[bar + 1])),
            percent(float(self.shares[bar])))

    def sizeHint(self):
        """High enough for the texts over and under the plot, however large the letters are."""
        return QtCore.QSize(300, max(180, int(10.5 * self.fontMetrics().height())))

    def minimumSizeHint(self):
        """See `sizeHint`."""
        return QtCore.QSize(180, self.sizeHint().height())

    def event(self, event):
        """Show each bar's own tool tip, and keep the keys that FreeCAD has commands for."""
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
        """Take the line, or begin to choose; beside the plot: choose nothing."""
        if event.button() != QtCore.Qt.LeftButton or not self.count:
            return
        place = mouse_place(event)
        if self._is_near_line(place):
            self._holds_line, self._pressed = True, place
            return
        self._begin(place)

    def _begin(self, place):
        """Begin to choose at a place; beside the plot: choose nothing."""
        inside = self.plot().adjusted(0, 0, 0, 1).contains(QtCore.QPointF(place))
        self._begun = self.bar_at(place.x()) if inside else None
        self._choose(None if self._begun is None else (self._begun, self._begun))

    def mouseMoveEvent(self, event):
        """Move the line or choose more bars."""
        place = mouse_place(event)
        x = place.x()
        if self._holds_line:
            self._pressed = None
            self.threshold = self._thickness_at(x)
            self.update()
            self.threshold_moved.emit(self.threshold)
        elif self._begun is not None:
            plot = self.plot()
            bar = self.bar_at(min(max(x, plot.left()), plot.right()))
            self._choose((min(self._begun, bar), max(self._begun, bar)))
        self.setCursor(QtCore.Qt.SplitHCursor if self._holds_line or self._is_near_line(place)
                       else QtCore.Qt.ArrowCursor)

    def mouseReleaseEvent(self, _event):
        """Let go; a line that was not moved was not meant, but the bar under it."""
        if self._holds_line and self._pressed is not None:
            self._begin(self._pressed)
        is_moved = self._holds_line and self._pressed is None
        self._begun = self._pressed = None
        self._holds_line = False
        if is_moved:
            self.threshold_set.emit(self.threshold)

    def keyPressEvent(self, event):
        """Arrows choose the next bar, with Shift one more; Esc none."""
        step = {QtCore.Qt.Key_Left: -1, QtCore.Qt.Key_Right: 1}.get(event.key())
        if event.key() == QtCore.Qt.Key_Escape and self.bars is not None:
            self._choose(None)
        elif step is None or not self.count:
            super().keyPressEvent(event)  # an Esc for nothing closes the panel, as everywhere
        else:
            self._step(step, bool(event.modifiers() & QtCore.Qt.ShiftModifier))

    def paintEvent(self, _event):
        """Draw bars, scales and the line."""
        if not self.count:
            return
        painter = QtGui.QPainter(self)
        plot = self.plot()
        painter.fillRect(plot, plot_ground(self))
        top = round_up(float(self.shares.max()) or 1.0)
        self.draw_heights(painter, plot, top)
        self._draw_bars(painter, plot, top)
        self._draw_scales(painter, plot)
        self._draw_line(painter, plot)
        if self.hasFocus():
            painter.setPen(QtGui.QPen(self.palette().highlight().color(), 1, QtCore.Qt.DotLine))
            painter.drawRect(plot.adjusted(-2, -2, 2, 2))
        painter.end()

    def _step(self, step, extend):
        if self.bars is None:
            wanted = 0 if step > 0 else self.count - 1
            self._choose((wanted, wanted))
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

    def _is_near_line(self, place):
        plot = self.plot()
        return (self.count and abs(place.x() - self.x_of(self.threshold)) <= _NEAR
                and plot.top() - self.fontMetrics().height() * 1.5 <= place.y() <= plot.bottom())

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
            # What is there must be seen, small as it is.
            height = max(2.0, plot.height() * share / top)
            box = QtCore.QRectF(left, plot.bottom() - height, max(1.0, width - 1.0), height)
            painter.fillRect(box, QtGui.QColor(*(int(part) for part in self.colours[bar])))
            # Yellow on white has hardly an edge of its own.
            frame.setAlpha(255 if is_chosen else 90)
            painter.setPen(frame)
            painter.drawRect(box)

    def _draw_scales(self, painter, plot):
        """Two scales under the bars: thickness, and as a share of the diagonal."""
        painter.setPen(text_colour(self))
        painter.drawLine(plot.bottomLeft(), plot.bottomRight())
        line, span = self.fontMetrics().height(), self._unit.value(float(self.edges[-1]))
        step = round_up(span / max(1.0, plot.width() / (7.5 * self.fontMetrics().averageCharWidth()) - 1.0))
        for count in range(int(span / step * (1.0 + 1e-9)) + 1):
            thickness = self._unit.millimetres * count * step
            x = self.x_of(thickness)
            painter.drawLine(QtCore.QPointF(x, plot.bottom()), QtCore.QPointF(x, plot.bottom() + 4))
            self.centred(painter, plot, x, plot.bottom() + 5, number(count * step))
            self.centred(painter, plot, x, plot.bottom() + 5 + line, f"{thickness / self._diagonal:.2g}")
        painter.drawText(QtCore.QRectF(0, plot.bottom() + 5 + 2 * line, self.width(), line + 2),
                         QtCore.Qt.AlignCenter, self.fontMetrics().elidedText(translate(
                             "ThinPart", "{}, and share of the diagonal").format(self._unit.symbol),
                             QtCore.Qt.ElideRight, self.width()))

    def _draw_line(self, painter, plot):
        x = self.x_of(self.threshold)
        painter.setPen(QtGui.QPen(readable(self, *_LINES), 2.0 if self._holds_line else 1.5, QtCore.Qt.DashLine))
        painter.drawLine(QtCore.QPointF(x, plot.top() - 2), QtCore.QPointF(x, plot.bottom()))
        painter.setPen(text_colour(self))
        self.centred(painter, plot, x, 1, translate("ThinPart", "thin below {}").format(
            self._unit.text(self.threshold)))

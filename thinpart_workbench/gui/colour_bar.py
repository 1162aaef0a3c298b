"""The colour bar of a thickness map as a picture, at any size."""

import math
from dataclasses import dataclass

import numpy as np

from .length_unit import LengthUnit
from .qt import QtCore, QtGui, colour, translate
from .thickness_colours import ThicknessColours

_INK = (0.1, 0.1, 0.1)
_WARNING = (0.75, 0.0, 0.0)
_PLATE = (255, 255, 255, 225)  # so that it can be read before any background
_TICKS = 6


@dataclass(frozen=True)
class BarContent:
    """What a colour bar tells.

    Attributes
    ----------
    colours : ThicknessColours
    unit : LengthUnit
    diagonal : float, mm
        What 1 on a bar of shares is; 0 for a bar of lengths.
    thinnest, thickest : float, mm
        Of the map, which may lie beyond the ends of the bar.
    threshold : float, mm
        0 for none.
    has_unmeasured : bool
    """

    colours: ThicknessColours
    unit: LengthUnit
    diagonal: float
    thinnest: float
    thickest: float
    threshold: float
    has_unmeasured: bool


def tick_text(value):
    """A number at a tick of a scale, with as many digits as tell it from the next."""
    return f"{value:.4g}"


def round_values(low, high, most=_TICKS):
    """Round numbers from `low` to `high`, no more than `most`: list of float."""
    if not high > low:
        return [low]
    rough = (high - low) / most
    power = 10.0 ** math.floor(math.log10(rough))
    step = next(power * each for each in (1, 2, 5, 10) if power * each >= rough * (1 - 1e-9))
    first, last = math.ceil(low / step - 1e-9), math.floor(high / step + 1e-9)
    return [number * step for number in range(first, last + 1)]


def bar_image(content, height):
    """Draw a colour bar that is about half as high as a picture.

    Parameters
    ----------
    content : BarContent
    height : int
        Of the picture or view, pixels.

    Returns
    -------
    QImage
    """
    return _Drawing(content, height).image


class _Drawing:
    def __init__(self, content, height):
        self._content = content
        em = self._em = max(11, round(height / 52))
        font = QtGui.QFont(QtGui.QGuiApplication.font().family())
        font.setPixelSize(em)
        self._font, self._bold = font, QtGui.QFont(font)
        self._bold.setBold(True)
        self._metrics = QtGui.QFontMetrics(self._bold)
        ticks = self._ticks(max(4 * em, round(0.42 * height)))
        above, below = self._lines()
        widest = max([self._width(text) for text, _ in (*above, *below)]
                     + [2.9 * em + self._width(text) for _, text in ticks])
        self._line = round(1.45 * em)
        length = max(4 * em, round(0.42 * height))
        size = (round(widest + 2.2 * em), round(length + 1.9 * em + self._line * (len(above) + len(below))))
        self.image = QtGui.QImage(*size, QtGui.QImage.Format_RGBA8888)
        self.image.fill(QtCore.Qt.transparent)
        painter = QtGui.QPainter(self.image)
        try:
            self._draw(painter, above, below, ticks, length)
        finally:
            painter.end()

    @property
    def _ends(self):
        scale = self._content.colours.scale
        return scale.low, scale.high

    def _width(self, text):
        return self._metrics.boundingRect(text).width()

    def _lines(self):
        """Texts over and under the bar, each with what is drawn beside it."""
        content, above, below = self._content, [], []
        if not content.diagonal:
            above.append((translate("ThinPart", "Wall thickness, {}").format(content.unit.symbol), "bold"))
        else:
            above.append((translate("ThinPart", "Wall thickness"), "bold"))
            above.append((translate("ThinPart", "share of the diagonal ({})").format(content.unit.symbol), ""))
        if content.colours.stale:
            above.append((translate("ThinPart", "Out of date: recompute"), "warning"))
        if content.threshold > 0.0:
            text = translate("ThinPart", "thin below {}").format(content.unit.text(content.threshold))
            below.append(("     " + text, "threshold"))
        if content.has_unmeasured:
            below.append(("     " + translate("ThinPart", "not measured"), "unmeasured"))
        return above, below

    def _ticks(self, length):
        """Places on the bar in mm, each with its text: the ends, and round values that keep off them."""
        low, high = self._ends
        content, one = self._content, self._content.diagonal or self._content.unit.millimetres
        ends = [("\u2264 " if content.thinnest < low * (1 - 1e-6) else "") + self._tick_text(low),
                ("\u2265 " if content.thickest > high * (1 + 1e-6) else "") + self._tick_text(high)]
        ticks = list(zip((low, high), ends)) if high > low else [(low, ends[0])]
        gap = 1.3 * self._em / length * (high - low)
        inner = [value * one for value in round_values(low / one, high / one)]
        ticks += [(value, self._tick_text(value)) for value in inner
                  if low + gap < value < high - gap]
        return ticks

    def _tick_text(self, value):
        diagonal, text = self._content.diagonal, tick_text(self._content.unit.value(value))
        return f"{tick_text(value / diagonal)}  ({text})" if diagonal else text

    def _draw(self, painter, above, below, ticks, length):
        em, line = self._em, self._line
        painter.setRenderHint(QtGui.QPainter.Antialiasing)
        painter.setPen(QtGui.QPen(QtGui.QColor(120, 120, 120, 160)))
        painter.setBrush(QtGui.QColor(*_PLATE))
        painter.drawRoundedRect(self.image.rect().adjusted(0, 0, -1, -1), 0.5 * em, 0.5 * em)
        painter.setRenderHint(QtGui.QPainter.Antialiasing, False)
        top = round(0.4 * em)
        for text, kind in above:
            painter.setFont(self._bold if kind else self._font)
            painter.setPen(colour(_WARNING if kind == "warning" else _INK))
            painter.drawText(em, top + round(1.1 * em), text)
            top += line
        top += round(0.6 * em)
        bar = QtCore.QRect(2 * em, top, round(1.3 * em), length)
        self._draw_bar(painter, bar)
        painter.setFont(self._font)
        painter.setPen(colour(_INK))
        for value, text in ticks:
            row = self._row(bar, value)
            painter.drawLine(bar.right() + 1, row, bar.right() + round(0.4 * em), row)
            painter.drawText(bar.right() + round(0.7 * em), row + round(0.37 * em), text)
        low, high = self._ends
        if low <= self._content.threshold <= high and self._content.threshold > 0.0:
            row = self._row(bar, self._content.threshold)
            painter.drawLine(bar.left() - 1, row, bar.right() + 1, row)
            self._draw_mark(painter, bar.left() - 2, row)
        top = bar.bottom() + round(0.7 * em)
        for text, kind in below:
            if kind == "threshold":
                self._draw_mark(painter, round(1.9 * em), top + round(0.75 * em))
            else:
                swatch = QtCore.QRect(em, top + round(0.25 * em), em, em)
                rgb = self._content.colours.of_values([np.nan])[0].tolist()
                painter.setBrush(QtGui.QColor(*rgb))
                painter.drawRect(swatch)
            painter.drawText(em, top + round(1.1 * em), text)
            top += line

    def _draw_bar(self, painter, bar):
        low, high = self._ends
        share = 1.0 - (np.arange(bar.height()) + 0.5) / bar.height()
        rows = self._content.colours.of_values(low + share * (high - low)).tolist()
        for number, rgb in enumerate(rows):
            painter.fillRect(bar.left(), bar.top() + number, bar.width(), 1, QtGui.QColor(*rgb))
        painter.setBrush(QtCore.Qt.NoBrush)
        painter.setPen(colour(_INK))
        painter.drawRect(bar.adjusted(-1, -1, 0, 0))

    def _row(self, bar, value):
        low, high = self._ends
        share = (value - low) / (high - low) if high > low else 0.5
        return round(bar.bottom() - share * (bar.height() - 1))

    def _draw_mark(self, painter, tip, row):
        """A triangle that points to the right."""
        em = self._em
        painter.setRenderHint(QtGui.QPainter.Antialiasing)
        painter.setBrush(colour(_INK))
        painter.drawPolygon(QtGui.QPolygonF([
            QtCore.QPointF(tip, row), QtCore.QPointF(tip - 0.7 * em, row - 0.45 * em),
            QtCore.QPointF(tip - 0.7 * em, row + 0.45 * em)]))
        painter.setRenderHint(QtGui.QPainter.Antialiasing, False)

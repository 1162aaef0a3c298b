# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draws the colour bar of a thickness map as an image of any size."""

import math
from dataclasses import dataclass

import numpy as np

from ...core.analysis_settings import RAY
from ...core.judging.limit_bands import ABOVE, FAILS, JUST_ABOVE, TOO_THICK
from ...core.number_text import number
from ..application.length_unit import LengthUnit
from ..application.numbers import marked, percent
from ..application.qt import QtCore, QtGui, colour, translate
from ..record.measure_text import plain_title, value_title_in
from .colours import ThicknessColours

_INK = (0.1, 0.1, 0.1)
_WARNING = (0.75, 0.0, 0.0)
_PLATE = (255, 255, 255, 225)  # keeps the text readable on any background
_TICKS = 6
_WIDE = 1.1  # ratio of the ends


@dataclass(frozen=True)
class BarContent:
    """What a colour bar shows.

    Attributes
    ----------
    colours : ThicknessColours
    unit : LengthUnit
    diagonal : float, mm
        Length that 1 stands for on a bar of shares; 0 for a bar of lengths.
    thinnest, thickest : float, mm
        Extremes of the map; they may lie beyond the ends of the bar.
    threshold : float, mm
        0 for no threshold.
    has_unmeasured : bool
    measure : str
        One of `SHOWN_MEASURES`.
    is_coarse : bool
        Whether these are first colours, which is said above the bar.
    """

    colours: ThicknessColours
    unit: LengthUnit
    diagonal: float
    thinnest: float
    thickest: float
    threshold: float
    has_unmeasured: bool
    measure: str = RAY
    is_coarse: bool = False


def tick_text(value, digits=4):
    """Text of a tick, with enough digits to distinguish it from the next."""
    text = number(value, digits)
    return marked(f"{value:.8f}".rstrip("0") if "e" in text else text)


def round_values(low, high, max_count=_TICKS):
    """Round numbers from `low` to `high`, no more than `max_count`: list of float."""
    if not high > low:
        return [low]
    rough = (high - low) / max_count
    power = 10.0 ** math.floor(math.log10(rough))
    step = next(power * factor for factor in (1, 2, 5, 10) if power * factor >= rough * (1 - 1e-9))
    first, last = math.ceil(low / step - 1e-9), math.floor(high / step + 1e-9)
    return [number * step for number in range(first, last + 1)]


def round_ratios(low, high):
    """Round numbers from `low` to `high`, each about twice the one before: list of float."""
    decades = range(math.floor(math.log10(low)), math.ceil(math.log10(high)) + 1)
    numbers = [factor * 10.0 ** decade for decade in decades for factor in (1, 2, 5)]
    return [number for number in numbers if low <= number <= high]


def _band_text(band, unit):
    """What a colour means where limits are checked."""
    if band.name == FAILS:
        return translate("ThinPart", "under {}: fails").format(unit.text(band.limit))
    if band.name == JUST_ABOVE:
        return translate("ThinPart", "up to {} above it").format(percent(ABOVE))
    if band.name == TOO_THICK:
        return translate("ThinPart", "largest ball over {}: too thick").format(unit.text(band.limit))
    return translate("ThinPart", "passes")


def bar_image(content, height):
    """QImage of a BarContent, about half as high as the view or the saved image, whose height is given in pixels."""
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
        """Lines above and below the bar: lists of (text, style or symbol beside it)."""
        content, above, below = self._content, [], []
        if not content.diagonal:
            above.append((value_title_in(content.measure, content.unit.symbol), "bold"))
        else:
            above.append((plain_title(content.measure), "bold"))
            above.append((translate("ThinPart", "share of the diagonal ({})").format(content.unit.symbol), ""))
        if content.is_coarse:
            above.append((translate("ThinPart", "first, coarse colours"), ""))
        if content.colours.stale:
            above.append((translate("ThinPart", "Out of date: recompute"), "warning"))
        for band in content.colours.bands:
            below.append(("     " + _band_text(band, content.unit), band.name))
        # Beyond the end of the bar, all that it shows is thin.
        if 0.0 < content.threshold <= self._ends[1] and not content.colours.bands:
            text = translate("ThinPart", "thin below {}").format(content.unit.text(content.threshold))
            below.append(("     " + text, "threshold"))
        if content.has_unmeasured:
            below.append(("     " + translate("ThinPart", "not measured"), "unmeasured"))
        return above, below

    def _ticks(self, length):
        """Ticks as (value in mm, text): the ends of the bar, and round values at a distance from them."""
        low, high = self._ends
        content, unit_length = self._content, self._content.diagonal or self._content.unit.millimetres
        # As everywhere, where that tells them from each other.
        digits = 3 if high > _WIDE * low else 4
        ends = [("\u2264 " if content.thinnest < low * (1 - 1e-6) else "") + self._tick_text(low, digits),
                ("\u2265 " if content.thickest > high * (1 + 1e-6) else "") + self._tick_text(high, digits)]
        ticks = list(zip((low, high), ends)) if high > low else [(low, ends[0])]
        gap, scale = 1.3 * self._em / length, content.colours.scale
        rounded = round_ratios if scale.is_logarithmic else round_values
        inner = [value * unit_length for value in rounded(low / unit_length, high / unit_length)]
        last = gap
        for value, place in zip(inner, scale.positions(inner)):
            if last < place < 1.0 - gap:
                ticks.append((value, self._tick_text(value)))
                last = place + gap
        return ticks

    def _tick_text(self, value, digits=4):
        diagonal, text = self._content.diagonal, tick_text(self._content.unit.value(value), digits)
        return f"{tick_text(value / diagonal, digits)}  ({text})" if diagonal else text

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
                middle = {band.name: min(0.5 * (band.low + band.high), band.low + 1.0)
                          for band in self._content.colours.bands}
                rgb = self._content.colours.of_values([middle.get(kind, np.nan)], np.array([kind == TOO_THICK]))[0].tolist()
                painter.setBrush(QtGui.QColor(*rgb))
                painter.drawRect(swatch)
            painter.drawText(em, top + round(1.1 * em), text)
            top += line

    def _draw_bar(self, painter, bar):
        share = 1.0 - (np.arange(bar.height()) + 0.5) / bar.height()
        rows = self._content.colours.of_values(self._content.colours.scale.thickness_at(share)).tolist()
        for row, rgb in enumerate(rows):
            painter.fillRect(bar.left(), bar.top() + row, bar.width(), 1, QtGui.QColor(*rgb))
        painter.setBrush(QtCore.Qt.NoBrush)
        painter.setPen(colour(_INK))
        painter.drawRect(bar.adjusted(-1, -1, 0, 0))

    def _row(self, bar, value):
        low, high = self._ends
        share = self._content.colours.scale.positions([value])[0] if high > low else 0.5
        return round(bar.bottom() - share * (bar.height() - 1))

    def _draw_mark(self, painter, tip, row):
        """Draw a triangle that points to the right."""
        em = self._em
        painter.setRenderHint(QtGui.QPainter.Antialiasing)
        painter.setBrush(colour(_INK))
        painter.drawPolygon(QtGui.QPolygonF([
            QtCore.QPointF(tip, row), QtCore.QPointF(tip - 0.7 * em, row - 0.45 * em),
            QtCore.QPointF(tip - 0.7 * em, row + 0.45 * em)]))
        painter.setRenderHint(QtGui.QPainter.Antialiasing, False)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The map of a library: a point for each part, by how thin it is and how much of its box it fills."""

import math
from dataclasses import dataclass

from .html_elements import element
from .library_counts import categories_of

WIDTH, HEIGHT = 1000, 600
_LEFT, _RIGHT, _TOP, _BOTTOM = 74, 980, 40, 530
"""Edges of the area with the points."""

_MOST_DECADES = 5
"""Decades of thickness: what is still thinner lies at the left edge."""

MANY = 2000
"""Points from which on they are drawn finer, so that those below others are seen."""

_MARKS = {"thin": "h0", "normal": "m-4 -4l8 8m0 -8l-8 8", "thin_features": "m-4 -4h8v8h-8z"}
_OTHER_MARK = "m-5 0h10m-5 -5v10"
"""What is drawn from a point on, so that categories are told without colours: a dot, a cross, a square, a plus."""


@dataclass(frozen=True)
class LogAxis:
    """A logarithmic axis.

    Attributes
    ----------
    low, high : float
    """

    low: float
    high: float

    @classmethod
    def of(cls, values):
        """The axis on which positive values lie, with round ends."""
        high = _round_up(max(values, default=1.0))
        least = max(min(values, default=0.1), high / 10.0 ** _MOST_DECADES)
        return cls(min(1.0 / _round_up(1.0 / least), high / 10.0), high)

    def place(self, value):
        """Where a value lies, as a share of the axis from 0 to 1; smaller ones lie at its start."""
        share = math.log(max(value, self.low) / self.low) / math.log(self.high / self.low)
        return min(share, 1.0)

    @property
    def ticks(self):
        """Round values on the axis: list of float."""
        first, last = math.floor(math.log10(self.low) + 1e-9), math.ceil(math.log10(self.high) - 1e-9)
        steps = (1, 2, 5) if last - first <= 3 else (1,)
        found = [float(f"{step}e{exponent}") for exponent in range(first, last + 1) for step in steps]
        return [value for value in found if self.low * 0.999 <= value <= self.high * 1.001]


def _round_up(value):
    """The next of 1, 2, 5, 10, ... times a power of ten."""
    power = 10.0 ** math.floor(math.log10(value) + 1e-9)
    return next(step * power for step in (1.0, 2.0, 5.0, 10.0) if step * power >= value * (1.0 - 1e-9))


def _relative(part):
    return part.median_mm and part.median_mm / part.diagonal_mm


def _thinnest(part):
    return part.thinnest_mm


def _axis(parts, value):
    return LogAxis.of([value(part) for part in parts if value(part)])


def map_places(parts):
    """Places of parts on the map: yields (by median, by thinnest, height), whole numbers; None where one is unknown.

    Parameters
    ----------
    parts : list of LibraryPart
    """
    axes = [(_axis(parts, value), value) for value in (_relative, _thinnest)]
    for part in parts:
        across = [round(_LEFT + (_RIGHT - _LEFT) * axis.place(value(part))) if value(part) else None
                  for axis, value in axes]
        yield *across, None if part.volume_ratio is None else _height(part.volume_ratio)


def _height(share):
    return round(_BOTTOM - (_BOTTOM - _TOP) * min(max(share, 0.0), 1.0))


def map_section(words, parts):
    """The section with the map, which the script makes answer to pointer and keys."""
    _ = words.text
    places = list(map_places(parts))
    names = categories_of(parts)
    points = {name: "".join(f"M{x} {y}{_mark(name)}" for part, (x, _other, y) in zip(parts, places)
                            if part.category == name and x is not None and y is not None) for name in names}
    missing = sum(x is None or y is None for x, _other, y in places)
    said = _("Map of {count} parts: across, the median wall as a share of the diagonal of the box; upwards, the share of "
             "its box that a part fills", count=len(parts) - missing)
    drawing = element(
        "svg", _fill_lines(words),
        _across(words, _axis(parts, _relative), words.number, _("median wall / diagonal of the box"), "by_median"),
        _across(words, _axis(parts, _thinnest), words.length.number,
                _("thinnest wall, {unit}", unit=words.length.symbol), "by_thinnest", hidden=True),
        _legend(words, names),
        *(element("path", d=drawn, class_=f"points {name}", data_category=name, data_mark=_mark(name))
          for name, drawn in points.items()),
        viewBox=f"0 0 {WIDTH} {HEIGHT}", role="img", aria_label=said)
    return element(
        "section", element("h2", _("Map"), id="map"), _controls(words),
        element("div", _area(words, drawing, len(parts) > MANY), class_="wide"),
        element("p", _missing(words, missing), class_="small faint") if missing else None, aria_labelledby="map")


def _controls(words):
    """What only helps where the script runs, which shows it."""
    _ = words.text
    choice = element(
        "label", _("Across:"), " ", element(
            "select", element("option", _("median wall / diagonal of the box"), value="by_median"),
            element("option", _("thinnest wall"), value="by_thinnest"), id="across"), class_="noprint", hidden="")
    said = _("Point at a part to see it, click to find it in the table. With the keyboard: arrow keys go from part to part, "
             "Enter finds it in the table.")
    return element("p", choice, " ", element("span", said, class_="small faint noprint", id="map-keys", hidden=""))


def _area(words, drawing, is_dense):
    """The map with the ring and the picture that the script puts at a part."""
    _ = words.text
    return element(
        "div", drawing, element("span", id="ring", hidden=""), element("div", id="tip", role="status", hidden=""),
        id="map-area", data_name=_("Map of the parts"), data_picture=_("Picture of {part}"), data_unit=words.length.symbol,
        class_="dense" if is_dense else None,
        data_said=_("{category}, thinnest wall {thinnest}, median {median}, fill {fill}"))


def _missing(words, count):
    _ = words.text
    if count == 1:
        return _("1 part is not on the map: no wall was found opposite, or its surface is not closed.")
    return _("{count} parts are not on the map: no wall was found opposite, or their surface is not closed.", count=count)


def _mark(name):
    return _MARKS.get(name, _OTHER_MARK)


def _fill_lines(words):
    _ = words.text
    drawn = []
    for tenth in range(0, 11, 2):
        y = _height(tenth / 10)
        drawn += [element("line", x1=_LEFT, x2=_RIGHT, y1=y, y2=y, class_="grid"),
                  element("text", words.percent(tenth / 10), x=_LEFT - 8, y=y + 6, text_anchor="end")]
    drawn.append(element("text", _("fill, V/VBB"), x=6, y=_TOP - 16))
    return element("g", drawn)


def _across(words, axis, number, title, name, hidden=False):
    drawn = []
    for value in axis.ticks:
        x = round(_LEFT + (_RIGHT - _LEFT) * axis.place(value))
        drawn += [element("line", x1=x, x2=x, y1=_TOP, y2=_BOTTOM, class_="grid"),
                  element("text", number(value), x=x, y=_BOTTOM + 24, text_anchor="middle")]
    drawn.append(element("text", title, x=(_LEFT + _RIGHT) / 2, y=_BOTTOM + 54, text_anchor="middle"))
    return element("g", drawn, data_axis=name, visibility="hidden" if hidden else None)


def _legend(words, names):
    """The marks of the categories, in a row above the points."""
    drawn, x = [], 220
    for name in names:
        said = words.category_word(name)
        drawn += [element("path", d=f"M{x} {_TOP - 22}{_mark(name)}", class_=f"points {name}"),
                  element("text", said, x=x + 14, y=_TOP - 16)]
        x += 50 + 10 * len(said)
    return element("g", drawn)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The figures of a part's page: its views, the distribution of its thickness, and the scale of the colours."""

from ...core.rendering.part_views import HEIGHT, WIDTH
from .html_elements import element

_MARK = "#d0006f"
"""Colour of what stands at the thinnest wall."""


def view_figure(words, view, label, thinnest, shown):
    """One view of a part.

    Parameters
    ----------
    words : PageWords
    view : dict
        ``name``, ``png`` (base64), ``ends`` of the thinnest wall or None, and the place of its ``label``.
    label : str
        Of the part.
    thinnest : dict or None
        The thinnest wall.
    shown : str
        One of `SHOWN_MEASURES`.
    """
    _ = words.text
    title = _view_title(words, view, thinnest)
    colours = {"sphere": _("colours stand for the largest ball inside that touches the surface"),
               "local": _("colours stand for the local thickness")}.get(
                   shown, _("colours stand for the thickness of the wall below the surface"))
    drawing = element(
        "svg", element("title", title),
        element("image", href=f"data:image/png;base64,{view['png']}", width=WIDTH, height=HEIGHT),
        _mark(words, view, thinnest) if view["ends"] else None,
        viewBox=f"0 0 {WIDTH} {HEIGHT}", role="img", aria_label=f"{label}, {title}; {colours}")
    ring = view["name"] != "thinnest" and view["ends"]
    return element("figure", drawing, element(
        "figcaption", title, [" ", _("(the ring is at the thinnest wall)")] if ring else None))


def _view_title(words, view, thinnest):
    _ = words.text
    if view["name"] == "front":
        return _("From the front, above")
    if view["name"] == "back":
        return _("From behind, below")
    return _("At the thinnest wall, {thickness} between {face} and {opposite}",
             thickness=words.length.text(thinnest["distance"]), face=thinnest["face"], opposite=thinnest["opposite_face"])


def _mark(words, view, thinnest):
    a, b = view["ends"]
    if view["name"] != "thinnest":
        return [element("circle", cx=a[0], cy=a[1], r=17, fill="none", stroke=colour, stroke_width=width)
                for colour, width in (("#fff", 8), (_MARK, 4))]
    x, y = view["label"]
    return [
        element("g",
                *(_line(a[0], a[1], b[0], b[1], stroke=colour, stroke_width=width)
                  for colour, width in (("#fff", 9), (_MARK, 4))),
                *(element("circle", cx=end[0], cy=end[1], r=8, fill=_MARK, stroke="#fff", stroke_width=3)
                  for end in (a, b)),
                stroke_linecap="round"),
        element("g",
                element("rect", x=x - 62, y=y - 29, width=124, height=40, rx=6, fill="#fff", stroke=_MARK, stroke_width=2),
                _text(x, y, words.length.text(thinnest["distance"]), text_anchor="middle"),
                font_size=26, font_weight=600, style="color: #000")]


def distribution(words, chart, limit):
    """The bar chart of the share of the surface over walls of each thickness; `limit` in mm is where thin ends."""
    _ = words.text
    length, percent = words.length, words.percent
    below = _("thin below {limit}", limit=length.text(limit))
    drawn = []
    for y, share in chart["heights"]:
        drawn += [_line(90, y, 880, y, stroke="currentColor", stroke_opacity=".25"),
                  _text(82, y + 6, percent(share), text_anchor="end")]
    for bar in chart["bars"]:
        said = _("{low} to {high}: {share}", low=length.number(bar["low"]), high=length.text(bar["high"]),
                 share=percent(bar["share"]))
        drawn.append(element("rect", element("title", said), x=bar["x"], y=bar["y"], width=bar["width"],
                             height=bar["height"], style=f"fill: var({'--thin-bar' if bar['is_thin'] else '--bar'})"))
    drawn.append(_line(90, 530, 880, 530, stroke="currentColor"))
    for x, value in chart["widths"]:
        drawn += [_line(x, 530, x, 537, stroke="currentColor"), _text(x, 558, length.number(value), text_anchor="middle")]
    drawn += [
        _text(485, 588, _("thickness, {unit}", unit=length.symbol), text_anchor="middle"),
        _line(chart["limit"], 34, chart["limit"], 530, style="stroke: var(--thin-bar)", stroke_width=2.5,
              stroke_dasharray="7 5"),
        _text(chart["limit_text"], 24, below, text_anchor="middle")]
    return element(
        "svg", element("g", drawn, font_size=19), viewBox="0 0 900 600", role="img",
        aria_label=_("Bar chart: share of the surface over walls of each thickness, up to {end}; walls under {limit} "
                     "count as thin", end=length.text(chart["end"]), limit=length.text(limit)))


def colour_scale(words, scale, limit):
    """The colours of the views and what they stand for; `limit` in mm is where thin ends."""
    _ = words.text
    length = words.length
    stops = [element("stop", offset=share, stop_color=colour) for share, colour in scale["stops"]]
    marks = []
    for number, (x, value) in enumerate(scale["ticks"]):
        said = length.text(value) if number == 0 else length.number(value)
        if number == len(scale["ticks"]) - 1 and scale["more"]:
            said = _("{thickness} and more", thickness=length.text(value))
        marks += [_line(x, 40, x, 46, stroke="currentColor"), _text(x, 62, said)]
    if scale["limit"] is not None:
        marks += [_line(scale["limit"], 14, scale["limit"], 44, stroke="currentColor", stroke_width=2,
                        stroke_dasharray="4 3"),
                  _text(scale["limit_text"], 11, _("thin below {limit}", limit=length.text(limit)))]
    edge = {"stroke": "currentColor", "stroke_width": ".6"}
    return element(
        "svg", element("defs", element("linearGradient", stops, id="scale")),
        element("rect", x=20, y=20, width=640, height=20, fill="url(#scale)", **edge),
        element("g", marks, font_size=14, text_anchor="middle"),
        element("rect", x=800, y=20, width=26, height=20, fill=scale["unmeasured"], **edge),
        _text(813, 62, _("not measured"), font_size=14, text_anchor="middle"),
        viewBox="-20 -4 940 82", role="img",
        aria_label=_("Colours from {low} to {high} and more; grey where nothing was measured",
                     low=length.text(scale["low"]), high=length.text(scale["high"])))


def _line(x1, y1, x2, y2, **attributes):
    return element("line", x1=x1, y1=y1, x2=x2, y2=y2, **attributes)


def _text(x, y, said, **attributes):
    return element("text", said, x=x, y=y, **attributes)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The table of all parts of a library: a page of it at a time, from rows of text that the page's script reads.

Ten thousand rows of a table would take a browser seconds. So all rows are one text, in the order of `FIELDS`, with tabs
between; the script only ever puts them on the page as texts.
"""

from ...core.foreign_text import printable, url_path
from .html_elements import element
from .library_content import numbered_lists
from .library_counts import categories_of
from .library_map import map_places
from .table_elements import heading, number_heading, table

FIELDS = ("label", "instances", "file", "address", "picture", "category", "verdict", "thinnest", "place", "median", "fill",
          "box", "risk", "by_median", "by_thinnest", "height", "groups", "families")
"""Fields of a row. ``address`` is empty where it follows from ``file``, and ``-`` where there is no document; ``category``
is a number in the list of counts, and ``verdict`` what is said instead where it is unsure; ``by_median``, ``by_thinnest``
and ``height`` are places on the map."""

ROWS = 100
"""Rows of the table that are shown at a time."""


def parts_section(words, content):
    """The section of the table, which the script fills."""
    _ = words.text
    search = element(
        "div",
        element("label", _("Search"), " ", element("input", type="search", id="search", autocomplete="off",
                                                   placeholder=_("words of names and folders"))),
        element("span", id="matches", role="status", class_="small faint"),
        element("span", element("button", "\u2039", type="button", id="previous", aria_label=_("Previous parts")), " ",
                element("button", "\u203a", type="button", id="next", aria_label=_("Next parts")), class_="pager"),
        class_="search noprint", hidden="")
    caption = _("Thickness and box: {unit}. The fill is the share of its box that a part fills, V/VBB.",
                unit=words.length.symbol)
    headings = [heading(element("span", _("Picture"), class_="small")), heading(_("Part"), data_sort="label"),
                heading(_("Category"), data_sort="category"),
                number_heading(_("Thinnest"), data_sort="thinnest"), number_heading(_("Median"), data_sort="median"),
                number_heading(_("Fill"), data_sort="fill"), number_heading(_("Box"), data_sort="box"),
                number_heading(_("Risk"), data_sort="risk"), heading(_("Belongs to"))]
    shown = table(caption, headings, [], class_="parts", id="parts-table",
                  data_group=_("group {number}"), data_family=_("family {number}"),
                  data_matches=_("{first} to {last} of {count} parts"), data_none=_("No part has all of these words."),
                  data_picture=_("Picture of {part}"), data_rows=ROWS)
    return element("section", element("h2", _("All parts"), id="parts"),
                   element("noscript", element("p", _("The table and the search need JavaScript."))),
                   search, element("div", shown, class_="wide"), aria_labelledby="parts")


def rows_element(words, content):
    """The rows, hidden, each a line of fields with tabs between."""
    names = {name: number for number, name in enumerate(categories_of(content.parts))}
    groups, families = numbered_lists(content.groups), numbered_lists(content.families)
    lines = []
    for number, (part, places) in enumerate(zip(content.parts, map_places(content.parts))):
        lines.append("\t".join(map(_field, (
            part.label, part.instances, part.file, _address(part, content.base), part.picture or "", names[part.category],
            _unsure(words, part), words.length.number(part.thinnest_mm), words.place(part.place),
            words.length.number(part.median_mm),
            words.percent(part.volume_ratio), words.box(part.box_mm), words.percent(part.risk),
            *("" if place is None else place for place in places),
            " ".join(map(str, groups.get(number, ()))), " ".join(map(str, families.get(number, ())))))))
    return element("pre", "\n".join(lines), id="rows", hidden="", data_fields=" ".join(FIELDS), data_base=content.base)


def _unsure(words, part):
    _ = words.text
    if part.between:
        return words.headline_word(part.category, part.between)
    return _("{category} (unsure)", category=words.category_word(part.category)) if part.borderline else ""


def _field(value):
    return printable(value)  # without tabs and line breaks


def _address(part, base):
    """The address of a document, or what stands for it."""
    if part.address is None:
        return "-"
    follows = printable(part.file) == part.file and part.address == base + url_path(part.file)
    return "" if follows else part.address

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tables of pages."""

from .html_elements import element


def heading(*content, scope="col", **attributes):
    """A heading of a column, or with ``scope`` of a row."""
    return element("th", *content, scope=scope, **attributes)


def number_heading(*content, **attributes):
    """A heading of a column of numbers."""
    return heading(*content, class_="n", **attributes)


def cell(*content, **attributes):
    """A cell."""
    return element("td", *content, **attributes)


def number_cell(*content, **attributes):
    """A cell with a number."""
    return cell(*content, class_="n", **attributes)


def row(*cells, **attributes):
    """A row."""
    return element("tr", *cells, **attributes)


def table(caption, headings, rows, **attributes):
    """A table with its caption; `rows` are rows, or bodies of them."""
    bodies = rows if rows and rows[0].tag == "tbody" else [element("tbody", *rows)]
    return element("table", element("caption", caption), element("thead", row(*headings)), *bodies, **attributes)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""A table as text: for the terminal, and as Markdown."""

from collections import namedtuple

Table = namedtuple("Table", "title columns rows notes", defaults=((),))
"""Columns are headings, rows are lists of text, notes are sentences below."""

MISSING = "-"


def plain(table):
    """The table in columns without its title, str. Numbers stand on the right."""
    cells = [list(table.columns), *table.rows]
    widths = [max(len(str(row[column])) for row in cells) for column in range(len(table.columns))]
    right = [all(_is_number(row[column]) for row in table.rows) for column in range(len(table.columns))]
    lines = ["  ".join(str(cell).rjust(width) if is_right else str(cell).ljust(width)
                       for cell, width, is_right in zip(row, widths, right)).rstrip() for row in cells]
    return "\n".join([*lines, *table.notes])


def markdown(table):
    """The table in Markdown without its title, str."""
    rows = [table.columns, ["---"] * len(table.columns), *table.rows]
    lines = ["| " + " | ".join(map(str, row)) + " |" for row in rows]
    return "\n".join([*lines, *(["", *table.notes] if table.notes else [])])


def titled(table, of):
    """The table under its title, str.

    Parameters
    ----------
    table : Table
    of : callable
        `plain` or `markdown`.
    """
    return f"{table.title}\n\n{of(table)}"


def number(value, digits=3):
    """A number to so many digits, or `MISSING`."""
    if value is None:
        return MISSING
    return f"{value:,.0f}" if abs(value) >= 10 ** digits else f"{value:.{digits}g}"


def percent(value, digits=1):
    """A share in per cent, or `MISSING`."""
    return MISSING if value is None else f"{100 * value:.{digits}f} %"


def _is_number(text):
    return text == MISSING or str(text).lstrip("< ")[:1].isdigit()

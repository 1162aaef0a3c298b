# SPDX-License-Identifier: LGPL-2.1-or-later
"""Print tables, on a terminal in colours."""

import os
import shutil
from collections import namedtuple
from itertools import chain

from ..core.foreign_text import printable, terminal_cell
from .plain_table import styled, table_lines, text_width

CATEGORY_STYLES = {"thin": "red", "thin_features": "yellow", "normal": "green", "unknown": "magenta"}
OTHER_CATEGORY, FAILURE = "cyan", "bold red"

_NARROWEST = 12
"""Least width of a column of text, in characters, on a terminal that is too narrow."""

TableColumn = namedtuple("TableColumn", "title value is_right style", defaults=(False, None))
"""Title; a function from a row to its text; whether it is right-aligned; a function from a row to its style,
or None."""


def category_style(category):
    """The style of a category."""
    return CATEGORY_STYLES.get(category, OTHER_CATEGORY)


def _shows_colours(stream):
    """Whether what reads a stream understands the codes of colours.

    ``FORCE_COLOR`` and ``NO_COLOR``, as other programs have them, go before. Windows's older console prints the codes; its
    Terminal, which says so, understands them.
    """
    if "FORCE_COLOR" in os.environ:
        return True
    if "NO_COLOR" in os.environ or not stream.isatty():
        return False
    return "WT_SESSION" in os.environ or os.environ.get("TERM", "") not in ("", "dumb")


def print_remark(stream, text):
    """Print a dimmed line."""
    text = printable(text.replace("\u00a0", " "))  # terminals that cannot show the space before a unit print its code
    stream.write(styled(text, "dim" if _shows_colours(stream) else None) + "\n")


def print_table(stream, columns, rows):
    """Print a table of any length.

    Parameters
    ----------
    stream : text stream
    columns : list of TableColumn
    rows : callable
        Returns an iterator over all rows; called twice, so that not all cells are in memory at once.
    """
    in_colours = _shows_colours(stream)
    # A file or a pipe has no width of its own, and what reads it looks for whole words.
    widths = _widths(columns, rows, shutil.get_terminal_size().columns if stream.isatty() else None)
    titles = [(column.title, "bold" if in_colours else None) for column in columns]
    cells = ([(_text(column, row), column.style(row) if in_colours and column.style else None) for column in columns]
             for row in rows())
    for line in table_lines(widths, [column.is_right for column in columns], chain([titles], cells)):
        stream.write(line + "\n")


def _widths(columns, rows, available):
    widths = [len(column.title) for column in columns]
    # Numbers are never cut, wherever a line ends.
    least = [_longest_word(column.title) if column.is_right else _NARROWEST for column in columns]
    for row in rows():
        for number, column in enumerate(columns):
            text = _text(column, row)
            widths[number] = max(widths[number], text_width(text))
            if column.is_right:
                least[number] = max(least[number], _longest_word(text))
    if available is not None:
        _fit(widths, least, available - 2 * (len(widths) - 1))
    return widths


def _longest_word(text):
    return max(map(text_width, text.split(" ")))


def _text(column, row):
    return terminal_cell(column.value(row))


def _fit(widths, least, available):
    """Narrow the widest columns until all fit, or none may be narrower."""
    while sum(widths) > available:
        wide = [number for number, width in enumerate(widths) if width > least[number]]
        if not wide:
            break
        widths[max(wide, key=lambda number: widths[number])] -= 1

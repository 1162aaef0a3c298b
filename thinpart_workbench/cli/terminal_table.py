"""Print tables, on a terminal in colours if rich is installed."""

import importlib.util
import os
import shutil
import sys
from collections import namedtuple
from itertools import chain, islice

from ..core.foreign_text import printable, terminal_cell
from .plain_table import plain_lines, text_width

CATEGORY_STYLES = {"thin": "red", "thin_features": "yellow", "normal": "green", "unknown": "magenta"}
OTHER_CATEGORY, FAILURE = "cyan", "bold red"

WIDTH_WITHOUT_TERMINAL = 220
"""Width for a file or a pipe, which has none of its own; large enough that cells are not folded."""

_ROWS_AT_ONCE = 1000
"""Rows that are laid out together: a table holds some kilobytes per row until it is printed."""

_NARROWEST = 8
"""Least width of a column, in characters, on a terminal that is too narrow."""

TableColumn = namedtuple("TableColumn", "title value is_right style", defaults=(False, None))
"""Title; a function from a row to its text; whether it is right-aligned; a function from a row to a rich style,
or None."""


def category_style(category):
    """The rich style of a category."""
    return CATEGORY_STYLES.get(category, OTHER_CATEGORY)


def has_rich():
    """Whether rich, the library for colours, is installed."""
    return importlib.util.find_spec("rich") is not None


def _shows_colours(stream):
    """Whether tables are printed by rich: on a terminal. Importing it takes a tenth of the time for a small part."""
    return (stream.isatty() or "FORCE_COLOR" in os.environ) and has_rich()


def prepare_tables():
    """Import what printing a table takes, while there is nothing else to do."""
    if _shows_colours(sys.stdout):
        import rich.console
        import rich.table  # noqa: F401


def print_remark(stream, text):
    """Print a dimmed line."""
    text = printable(text.replace("\u00a0", " "))  # terminals that cannot show the space before a unit print its code
    if _shows_colours(stream):
        _console(stream).print(text, style="dim", markup=False)
    else:
        stream.write(text + "\n")


def _console(stream):
    """A rich.console.Console that writes to a stream."""
    from rich.console import Console

    console = Console(file=stream, highlight=False)
    if not console.is_terminal:
        console = Console(file=stream, highlight=False, width=WIDTH_WITHOUT_TERMINAL)
    return console


def print_table(stream, columns, rows):
    """Print a table of any length.

    Parameters
    ----------
    stream : text stream
    columns : list of TableColumn
    rows : callable
        Returns an iterator over all rows; called twice, so that not all cells are in memory at once.
    """
    (_print_in_colours if _shows_colours(stream) else _print_plainly)(stream, columns, rows)


def _print_in_colours(stream, columns, rows):
    from rich.cells import cell_len
    from rich.table import Table
    from rich.text import Text

    console = _console(stream)
    widths = _widths(columns, rows, console.width, cell_len)
    left, is_first = iter(rows()), True
    while block := list(islice(left, _ROWS_AT_ONCE)):
        table = Table(box=None, pad_edge=False, header_style="bold", show_header=is_first)
        for column, width in zip(columns, widths):
            table.add_column(column.title, justify="right" if column.is_right else "left",
                             overflow="fold", width=width)
        for row in block:
            table.add_row(*(Text(_text(column, row), (column.style and column.style(row)) or "")
                            for column in columns))
        console.print(table)
        is_first = False


def _print_plainly(stream, columns, rows):
    available = shutil.get_terminal_size().columns if stream.isatty() else WIDTH_WITHOUT_TERMINAL
    widths = _widths(columns, rows, available, text_width)
    cells = ([_text(column, row) for column in columns] for row in rows())
    titles = [column.title for column in columns]
    for line in plain_lines(widths, [column.is_right for column in columns], chain([titles], cells)):
        stream.write(line + "\n")


def _widths(columns, rows, available, width_of):
    widths = [len(column.title) for column in columns]
    for row in rows():
        for number, column in enumerate(columns):
            widths[number] = max(widths[number], width_of(_text(column, row)))
    _fit(widths, available - 2 * (len(widths) - 1))
    return widths


def _text(column, row):
    return terminal_cell(column.value(row))


def _fit(widths, available):
    """Narrow the widest columns until all fit."""
    while sum(widths) > available and max(widths) > _NARROWEST:
        widths[widths.index(max(widths))] -= 1

"""Tables as they are printed for people: in colours where rich is there, else without."""

import importlib.util
import shutil
from collections import namedtuple
from itertools import chain, islice

from .plain_table import plain_lines, text_width

CATEGORY_STYLES = {"thin": "red", "thin_features": "yellow", "normal": "green", "unknown": "magenta"}
OTHER_CATEGORY, FAILURE = "cyan", "bold red"

WIDTH_WITHOUT_TERMINAL = 220
"""A file or a pipe has no width to fit into; cut cells would lose what was asked for."""

_ROWS_AT_ONCE = 1000
"""Rows that are laid out together: a table keeps some kilobytes for each until it is printed."""

_NARROWEST = 8
"""Characters that a column keeps on a terminal that is too narrow for all."""

TableColumn = namedtuple("TableColumn", "title value is_right style", defaults=(False, None))
"""Title; a function from a row to its text; whether it lines up on the right; a function from a row to a
rich style, or None."""


def has_rich():
    """Whether there is the library that brings colours."""
    return importlib.util.find_spec("rich") is not None


def print_remark(stream, text):
    """Print a line of less weight."""
    if has_rich():
        _console(stream).print(printable(text), style="dim", markup=False)
    else:
        stream.write(printable(text) + "\n")


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
        Goes through all rows; is called twice, so that not all cells are kept at once.
    """
    (_print_in_colours if has_rich() else _print_plainly)(stream, columns, rows)


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
    room = shutil.get_terminal_size().columns if stream.isatty() else WIDTH_WITHOUT_TERMINAL
    widths = _widths(columns, rows, room, text_width)
    cells = ([_text(column, row) for column in columns] for row in rows())
    titles = [column.title for column in columns]
    for line in plain_lines(widths, [column.is_right for column in columns], chain([titles], cells)):
        stream.write(line + "\n")


def _widths(columns, rows, room, width_of):
    widths = [len(column.title) for column in columns]
    for row in rows():
        for number, column in enumerate(columns):
            widths[number] = max(widths[number], width_of(_text(column, row)))
    _fit(widths, room - 2 * (len(widths) - 1))
    return widths


def printable(text):
    """A text for a line on a terminal: a file's name may hold line breaks and terminal commands."""
    if text.isprintable():
        return text
    return "".join(each if each.isprintable() else each.encode("unicode_escape").decode()
                   for each in text)


def _text(column, row):
    return printable(str(column.value(row)))


def _fit(widths, room):
    """Narrow the widest columns until all fit."""
    while sum(widths) > room and max(widths) > _NARROWEST:
        widths[widths.index(max(widths))] -= 1

"""Tables as they are printed for people."""

from collections import namedtuple
from itertools import islice

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


def terminal_console(stream):
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
    from rich.cells import cell_len
    from rich.table import Table
    from rich.text import Text

    console = terminal_console(stream)
    widths = [len(column.title) for column in columns]
    for row in rows():
        for number, column in enumerate(columns):
            widths[number] = max(widths[number], cell_len(_text(column, row)))
    _fit(widths, console.width - 2 * (len(widths) - 1))
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

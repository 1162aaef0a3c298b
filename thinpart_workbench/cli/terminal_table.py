"""Tables as they are printed for people."""

CATEGORY_STYLES = {"thin": "red", "thin_features": "yellow", "normal": "green", "unknown": "magenta"}
OTHER_CATEGORY, FAILURE = "cyan", "bold red"

WIDTH_WITHOUT_TERMINAL = 220
"""A file or a pipe has no width to fit into; cut cells would lose what was asked for."""


def terminal_console(stream):
    """A rich.console.Console that writes to a stream."""
    from rich.console import Console

    console = Console(file=stream, highlight=False)
    if not console.is_terminal:
        console = Console(file=stream, highlight=False, width=WIDTH_WITHOUT_TERMINAL)
    return console


def print_rows(stream, columns, rows):
    """Print a table.

    Parameters
    ----------
    stream : text stream
    columns : list of (title, is_right, value, style)
        Title; whether it lines up on the right; functions from a row to its text and to a rich style or
        None, the latter may be None for all.
    rows : iterable
    """
    from rich.table import Table
    from rich.text import Text

    table = Table(box=None, pad_edge=False, header_style="bold")
    for title, is_right, _, _ in columns:
        table.add_column(title, justify="right" if is_right else "left", overflow="fold")
    for row in rows:
        table.add_row(*(Text(str(value(row)), style=(style and style(row)) or "")
                        for _, _, value, style in columns))
    terminal_console(stream).print(table)

"""Tables without colours, which take no library."""

import unicodedata


def plain_lines(widths, rights, rows):
    """Lines of a table whose cells are folded where they are wider than their column.

    Parameters
    ----------
    widths : list of int
        Of the columns, in characters of a terminal.
    rights : list of bool
        Columns that line up on the right.
    rows : iterable of list of str

    Yields
    ------
    str
    """
    for row in rows:
        cells = [_folded(cell, width) for cell, width in zip(row, widths)]
        for number in range(max(map(len, cells))):
            parts = (cell[number] if number < len(cell) else "" for cell in cells)
            yield "  ".join(_filled(*each) for each in zip(parts, widths, rights)).rstrip()


def text_width(text):
    """Characters of a terminal that a text takes: some take two, and marks above others take none."""
    return sum(map(_width, text))


def _width(character):
    if unicodedata.combining(character):
        return 0
    return 2 if unicodedata.east_asian_width(character) in "WF" else 1


def _folded(text, width):
    lines, taken = [""], 0
    for each in text:
        if taken + _width(each) > width and lines[-1]:
            lines.append("")
            taken = 0
        lines[-1] += each
        taken += _width(each)
    return lines


def _filled(text, width, is_right):
    space = " " * (width - text_width(text))
    return space + text if is_right else text + space

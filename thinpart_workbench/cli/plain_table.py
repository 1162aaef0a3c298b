"""Tables without colours, which need no library."""

import unicodedata


def plain_lines(widths, rights, rows):
    """Yields lines of a table; cells that are wider than their column are folded.

    Parameters
    ----------
    widths : list of int
        Column widths in characters of a terminal.
    rights : list of bool
        Whether each column is right-aligned.
    rows : iterable of list of str
    """
    for row in rows:
        cells = [_folded(cell, width) for cell, width in zip(row, widths)]
        for number in range(max(map(len, cells))):
            parts = (cell[number] if number < len(cell) else "" for cell in cells)
            yield "  ".join(_filled(*entry) for entry in zip(parts, widths, rights)).rstrip()


def text_width(text):
    """Width of a text in characters of a terminal: wide characters take two, combining marks none."""
    return sum(map(_width, text))


def _width(character):
    if unicodedata.combining(character):
        return 0
    return 2 if unicodedata.east_asian_width(character) in "WF" else 1


def _folded(text, width):
    lines, used = [""], 0
    for character in text:
        if used + _width(character) > width and lines[-1]:
            lines.append("")
            used = 0
        lines[-1] += character
        used += _width(character)
    return lines


def _filled(text, width, is_right):
    space = " " * (width - text_width(text))
    return space + text if is_right else text + space

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tables of text, laid out for a terminal."""

import unicodedata

_CODES = {"bold": "1", "dim": "2", "red": "31", "green": "32", "yellow": "33", "magenta": "35", "cyan": "36"}
"""Of ECMA-48 (SGR), by the words of styles."""


def styled(text, style):
    """A text in a style, such as "bold red"; None leaves it as it is."""
    if not (text and style):
        return text
    return f"\x1b[{';'.join(_CODES[word] for word in style.split())}m{text}\x1b[0m"


def table_lines(widths, rights, rows):
    """Yields lines of a table; cells that are wider than their column are folded, between words where that is enough.

    Parameters
    ----------
    widths : list of int
        Column widths in characters of a terminal.
    rights : list of bool
        Whether each column is right-aligned.
    rows : iterable of list of (str, str or None)
        Cells with their styles, None for those in no style.
    """
    for row in rows:
        cells = [(_folded(text, width), style) for (text, style), width in zip(row, widths)]
        for number in range(max(len(lines) for lines, _ in cells)):
            parts = ((lines[number] if number < len(lines) else "", style) for lines, style in cells)
            yield "  ".join(_filled(*part, *form) for part, *form in zip(parts, widths, rights)).rstrip()


def text_width(text):
    """Width of a text in characters of a terminal: wide characters take two, combining marks none."""
    return sum(map(_width, text))


def _width(character):
    if unicodedata.combining(character):
        return 0
    return 2 if unicodedata.east_asian_width(character) in "WF" else 1


def _folded(text, width):
    lines: list = []
    for word in text.split(" "):
        if lines and text_width(lines[-1]) + 1 + text_width(word) <= width:
            lines[-1] += f" {word}"
        else:
            lines += _cut(word, width)
    return lines


def _cut(word, width):
    lines, used = [""], 0
    for character in word:
        if used + _width(character) > width and lines[-1]:
            lines.append("")
            used = 0
        lines[-1] += character
        used += _width(character)
    return lines


def _filled(text, style, width, is_right):
    space = " " * (width - text_width(text))
    return space + styled(text, style) if is_right else styled(text, style) + space

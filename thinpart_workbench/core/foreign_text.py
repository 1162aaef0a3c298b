# SPDX-License-Identifier: LGPL-2.1-or-later
"""The rules for foreign text, such as names, labels, notes and paths, in every language that is written: one for each.

Each function takes any str, also with line breaks, control characters and bytes of file names that are not valid text (as
`os.fsdecode` gives them), and returns what a reader of the language takes for one datum. What a language cannot hold becomes
an escape as in Python (``\\x1b``, ``\\udce9``); a string of Gmsh, which may name a file, is a ValueError instead.
"""

import csv
import html
import io
import json
import os
import re
import unicodedata
from urllib.parse import quote

LONGEST_HEAD = 80
"""Characters of a text in the head of a file: readers split longer lines, and take the rest for a new line."""

LONGEST_CELL = 300
"""Characters of a cell of a printed table; JSON and CSV have all."""

LONGEST_GMSH = 1000
"""Bytes of a string for Gmsh, which reads 1,023 and takes the rest for commands."""

_ODD = re.compile(r"[^\x20-\x7e]")

_UNSEEN = ("Cc", "Cf", "Cs", "Zl", "Zp")
"""Unicode categories that command terminals, change the direction of writing, break lines, or are no characters."""

_FORMULA_STARTS = ("=", "+", "-", "@", "\t", "\r")
"""First characters of cells that spreadsheets evaluate, and may send elsewhere (OWASP, CSV injection)."""

_NOT_IN_XML = re.compile("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")
"""XML 1.0, 2.2: characters that no document may contain, in no spelling."""


def printable(text, kept=""):
    """A text whose unseen characters are escapes: what a terminal shows, in one line.

    Parameters
    ----------
    text : str
    kept : str, optional
        Characters that stay, such as a line break.
    """
    return _ODD.sub(lambda found: found[0] if found[0] in kept or not _is_unseen(found[0]) else _escape(found[0]), str(text))


def _is_unseen(character):
    return unicodedata.category(character) in _UNSEEN


def _escape(character):
    return character.encode("unicode_escape").decode()


def shortened(text, longest):
    """A text of at most so many characters, the last three of them dots where it is cut."""
    return text if len(text) <= longest else text[:longest - 3] + "..."


def terminal_cell(text):
    """A cell of a table on a terminal: `printable`, and not longer than a few lines."""
    text = str(text)
    return shortened(printable(text[:LONGEST_CELL + 1]), LONGEST_CELL)


def head_text(text):
    """A text in a line of the head of a file, such as a comment of CalculiX, Gmsh, PLY or an I-DEAS universal file.

    One line, printable and short; the writer puts words of its own in front, so that no line begins with it.
    """
    words = " ".join(str(text)[:4 * LONGEST_HEAD].split())
    return shortened(printable(words), LONGEST_HEAD)


def csv_text(rows):
    """Rows, tuples of str, numbers and None, as lines of a CSV file that no spreadsheet computes and no terminal obeys: str.

    Without characters that UTF-8 cannot hold.
    """
    text = io.StringIO(newline="")
    csv.writer(text).writerows(map(_csv_cell, row) for row in rows)
    return text.getvalue()


def _csv_cell(value):
    if not isinstance(value, str):
        return value
    return csv_form("'" + value if value.startswith(_FORMULA_STARTS) else value)


def csv_form(text):
    """A text as a reader finds it in a CSV file that was written here, with escapes for unseen characters."""
    return printable(text, "\n\r\t")


def csv_value(cell):
    """The text of a cell that `csv_text` has written and `csv.reader` has read; escapes of unseen characters stay."""
    return cell[1:] if cell[:1] == "'" and cell[1:].startswith(_FORMULA_STARTS) else cell


def json_text(content, indent=None):
    """JSON without numbers that are none, whose strings no terminal obeys: unseen characters are escapes of JSON.

    Parameters
    ----------
    content : object
    indent : int, optional
        Spaces; by default all is in one line.
    """
    text = json.dumps(content, ensure_ascii=False, allow_nan=False, indent=indent)
    # Outside of strings, JSON has none of these but the breaks between its lines.
    return _ODD.sub(lambda found: json.dumps(found[0])[1:-1] if found[0] != "\n" and _is_unseen(found[0]) else found[0],
                    text)


def html_text(text):
    """Text for a page, before the templates escape its marks; line breaks and tabs stay."""
    return printable(text, "\n\t")


def xml_text(text):
    """Text of an element of XML."""
    return html.escape(_NOT_IN_XML.sub(lambda found: _escape(found[0]), text), quote=False).replace("\r", "&#13;")


def url_path(path):
    """The address of a path, with ``/`` as separator, that a page in the same folder links to."""
    return quote(os.fsencode(path))


def sql_text(text):
    """A text that SQLite stores and compares: bytes of a file name that are not valid text become question marks."""
    return (text if text.isascii() else text.encode("utf-8", "replace").decode()).replace("\0", "?")


def sql_like(text):
    """A text as a part of a pattern of LIKE, with ``ESCAPE '!'``, that matches itself alone."""
    return re.sub("[!%_]", r"!\g<0>", sql_text(text))


def is_gmsh_text(text):
    """Whether Gmsh can read a text as one string: its strings end at the next quotation mark, and know no escapes."""
    return printable(text) == text and not set(text) & set('"\\') and len(text.encode()) <= LONGEST_GMSH


def gmsh_text(text):
    """A string of Gmsh with its quotation marks; a ValueError for a text that none can hold: ask `is_gmsh_text` before."""
    if not is_gmsh_text(text):
        raise ValueError(text)
    return f'"{text}"'


def safe_name(text, longest=60):
    """A name of a file that is plain in every language and on every system; empty for some texts."""
    return re.sub(r"[^A-Za-z0-9._-]", "-", text)[:longest].lstrip(".")

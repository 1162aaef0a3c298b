# SPDX-License-Identifier: LGPL-2.1-or-later
"""Labels of people, and files of them: CSV tables of the categories that people gave to parts."""

import csv
import io
import os
from contextlib import contextmanager
from typing import NamedTuple

from ..core.errors import ThinPartError
from ..core.foreign_text import csv_text, csv_value
from ..core.kinds.file_marks import LABELS
from ..core.message import message
from ..core.regular_file import read_regular
from .output_file import check_output, write_output

REQUIRED, OPTIONAL = ("file", "category"), ("part", "person", "sure", "second", "group")
"""Columns. Others are ignored, so that a table may hold remarks."""

_TITLES = ("file", "part", "category", "person", "sure", "second", "group")
"""First columns of the files that are written here."""

LARGEST = 64 * 1024 * 1024
"""Size in bytes above which a file is not accepted."""

_ANSWERS = {"": True, "yes": True, "true": True, "1": True, "sure": True,
            "no": False, "false": False, "0": False, "unsure": False}

_NO_TEXT = message("it is not text in UTF-8: save the table as CSV")


class Label(NamedTuple):
    """What a person says a part is: a row of a file of labels, or kept in an info file.

    Attributes
    ----------
    place : Message
        File and line, or part, for messages.
    file, part : str
        The document, and the name or label of the part; this is empty where the document has one part only.
    category : str
    second : str
        A second answer that is right too; empty where there is none.
    is_sure : bool
    person : str
        Who gave it: by default the name of the file of labels.
    group : str or None
        What is left out together with the part in a validation; None where the table does not say.
    is_kept : bool
        Whether it is kept in an info file.
    """

    place: str
    file: str
    part: str
    category: str
    second: str
    is_sure: bool
    person: str
    group: object
    is_kept: bool = False

    def answers_as(self, other):
        """Whether it says the same as another label, second answers apart."""
        return (self.category, self.is_sure) == (other.category, other.is_sure)


def read_labels(path, categories):
    """Read a file of labels: list of Label.

    Raises ThinPartError: one sentence with file, line and reason; kind ``usage``, ``missing`` or ``unreadable``.

    Parameters
    ----------
    path : str or Path
        CSV in UTF-8 with a header, separated by commas or semicolons.
    categories : sequence of str
        Those that may be given.
    """
    name = os.path.basename(path)
    lines = io.StringIO(_text(path, name), newline="")
    header = lines.readline()
    lines.seek(0)
    rows = csv.reader(lines, delimiter=";" if header.count(";") > header.count(",") else ",", strict=True)
    labels = []
    try:
        columns = [title.strip().lower() for title in next(rows, [])]
        _check_columns(columns, name)
        for row in rows:
            if any(cell.strip() for cell in row):
                labels.append(_label(row, columns, categories, _place(name, rows.line_num), _stem(name)))
    except csv.Error as error:
        raise refused_label(_place(name, rows.line_num), message("it is not a CSV table ({problem})", problem=error),
                            "unreadable") from None
    if not labels:
        raise ThinPartError(message("{file} holds no labels: write a row per part below the header.", file=name), "usage")
    return labels


def _text(path, name):
    try:
        data = read_regular(path, LARGEST)
    except FileNotFoundError:
        raise ThinPartError(message("There is no file of labels {file}.", file=path), "missing") from None
    except OSError as error:
        raise ThinPartError(message("The file of labels {file} cannot be read ({problem}).",
                                    file=name, problem=error.strerror), "unreadable") from None
    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = data[:error.start].count(b"\n") + 1
        raise refused_label(_place(name, line), _NO_TEXT, "unreadable") from None
    if "\0" in text:
        line = text[:text.index("\0")].count("\n") + 1
        raise refused_label(_place(name, line), _NO_TEXT, "unreadable")
    return text


def _check_columns(columns, name):
    columns[:] = ["person" if title == "user" else title for title in columns]
    missing = [title for title in REQUIRED if title not in columns]
    if missing:
        raise refused_label(_place(name, 1), message(
            "the column {columns} is missing; there have to be {required}, and there may be {optional}",
            columns=", ".join(missing), required=", ".join(REQUIRED), optional=", ".join(OPTIONAL)))
    twice = [title for title in (*REQUIRED, *OPTIONAL) if columns.count(title) > 1]
    if twice:
        raise refused_label(_place(name, 1), message("the column {columns} is there twice", columns=", ".join(twice)))


def _label(row, columns, categories, place, stem):
    if len(row) > len(columns):
        raise refused_label(place, message("it has {count} cells, and the header has {columns}: put quotes around what "
                                           "holds a comma", count=len(row), columns=len(columns)))
    cells = dict(zip(columns, map(csv_value, map(str.strip, row))))
    if not cells.get("file"):
        raise refused_label(place, message("it names no file"))
    category, second = cells.get("category", ""), cells.get("second", "")
    for each in (category, *filter(None, [second])):
        if each not in categories:
            raise refused_label(place, message("{category!r} is no category: there are {known}",
                                               category=each, known=", ".join(categories)))
    if second == category:
        raise refused_label(place, message("its second answer is the first one"))
    sure = cells.get("sure", "").lower()
    if sure not in _ANSWERS:
        raise refused_label(place, message("{answer!r} in the column sure is neither yes nor no", answer=cells["sure"]))
    return Label(place, cells["file"], cells.get("part", ""), category, second, _ANSWERS[sure],
                 cells.get("person") or stem, cells.get("group") or None)


def write_labels(path, labels, more=(), overwrite=False, inputs=()):
    """Write a file of labels, which `read_labels` reads; raises ThinPartError of kind ``usage`` or ``failed``.

    Parameters
    ----------
    path : str or Path
        A file that was not written here, or that somebody has changed since then, is not overwritten.
    labels : list of Label
    more : sequence of (str, callable), optional
        Titles of further columns, and functions of a label's number for their cells.
    overwrite, inputs
        See `check_output`.
    """
    rows = [(label.file, label.part, label.category, label.person, "yes" if label.is_sure else "no", label.second,
             label.group or "", *(cell(number) for _, cell in more)) for number, label in enumerate(labels)]
    text = csv_text([(*_TITLES, *(title for title, _ in more)), *rows])
    with _writing(path):
        write_output(path, LABELS.sealed(text).encode(), LABELS, overwrite, inputs)


def check_labels_output(path, overwrite=False, inputs=()):
    """Raise a ThinPartError where `write_labels` would not write; see `check_output`."""
    with _writing(path):
        check_output(path, LABELS, overwrite, inputs)


@contextmanager
def _writing(path):
    try:
        yield
    except OSError as error:
        raise ThinPartError(message("The labels could not be written to {file} ({problem}): choose another place for them.",
                                    file=os.fspath(path), problem=error.strerror)) from None


def _stem(name):
    return os.path.splitext(name)[0]


def _place(name, line):
    return message("{file}, line {line}", file=name, line=line)


def refused_label(place, reason, kind="usage"):
    """The error for a row that cannot be used: ThinPartError.

    Parameters
    ----------
    place : Message
    reason : Message
        Without a full stop.
    kind : str
    """
    return ThinPartError(message("{place}: {reason}.", place=place, reason=reason), kind)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""CSV tables, and that of classified parts: a row per part and per failure."""

import json
from typing import Any, Callable, NamedTuple, Optional

from ..core.foreign_text import csv_text
from ..core.kinds.file_marks import TABLE
from .output_file import write_output
from .record_columns import TITLED, labels_text, row_class

_Row: Any = row_class("_Row", ("file", *(column.title for column in TITLED), "error_kind", "error"))


class PartRow(_Row):
    """A row: ``file`` as named in the table, and the quantities of a part or the kind and message of a failure.

    Cells that do not apply are None: a failure has no category, a part no ``error_kind``.
    """

    __slots__ = ()


class CheckedRow(PartRow):
    """A PartRow with what is not a cell.

    Attributes
    ----------
    checks : tuple of dict
        Results of checks, each as `WallCheck.content` has it.
    said : tuple of dict
        What people say of the part: its ``labels``.
    thumbnail : str or None
        The path of its picture, whether or not it exists.
    """

    checks: tuple = ()
    said: tuple = ()
    thumbnail: Optional[str] = None

    def relabelled(self, labels):
        """The same row with other labels."""
        row = self._replace(labels=labels_text(labels))
        row.checks, row.said, row.thumbnail = self.checks, tuple(labels), self.thumbnail
        return row


def measured_row(file, record):
    """PartRow of a part record."""
    measured = record["descriptors"]
    return PartRow(file, *((column.cell or column.value)(record, measured) for column in TITLED), None, None)


def checked_row(file, record):
    """CheckedRow of a part record with its ``checks``, ``labels`` and ``thumbnail``, if it has some."""
    row = CheckedRow(*measured_row(file, record))
    row.checks, row.said = tuple(record.get("checks", ())), tuple(record.get("labels", ()))
    row.thumbnail = record.get("thumbnail")
    return row


def failed_row(file, name, label, error):
    """PartRow of a failure: of the part `name`, or of the file if `name` is None."""
    empty_cells = [None] * (len(TITLED) - 2)
    return PartRow(file, name, label, *empty_cells, error["kind"], error["message"])


class TableForm(NamedTuple):
    """What a CSV table contains.

    Attributes
    ----------
    titles : tuple of str
        Those of the first columns are `SUBJECT`.
    cells : callable
        Maps a row to its cells: tuple of str, numbers and None.
    """

    titles: tuple
    cells: Callable

    def text(self, rows):
        """Rows as lines of the table: str."""
        return csv_text(map(self.cells, rows))


SUBJECT = ("file", "part", "label")
"""Titles of the first columns of every table."""


def part_table(names=()):
    """TableForm of PartRows, and of CheckedRows that were checked against processes of these names."""
    titles = tuple(title for name in names for title in (f"check {name}", f"check {name} sentence"))
    return TableForm((*PartRow._fields, *titles), _part_cells)


def _part_cells(row):
    checks = (cell for check in getattr(row, "checks", ())
              for cell in (_PASSES[check["passes"]], check["sentence"].replace("\u00a0", " ")))
    return (*row, *checks)


_PASSES = {True: "passes", False: "fails", None: "unknown"}


def _stored_cells(part):
    own = {"part": part.name, "criteria": " ".join(part.criteria or ()), "error": part.error_message,
           "labels": labels_text(json.loads(part.labels)) if part.labels else None}
    return tuple(own[title] if title in own else getattr(part, title, None) for title in PartRow._fields)


STORED_PARTS = TableForm(PartRow._fields, _stored_cells)
"""Of StoredParts, or what has their fields; an index has no warnings."""


def write_table(path, form, blocks, overwrite=False, inputs=()):
    """Write a CSV file as `write_output` does: a line of titles, then blocks, iterable of str, from `TableForm.text`."""
    text = csv_text([form.titles]) + "".join(blocks)
    write_output(path, text.encode(), TABLE, overwrite, inputs)

"""The CSV table of classified parts: a row per part and per failure."""

from typing import Any

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
    """

    checks: tuple = ()
    said: tuple = ()

    def relabelled(self, labels):
        """The same row with other labels."""
        row = self._replace(labels=labels_text(labels))
        row.checks, row.said = self.checks, tuple(labels)
        return row


def measured_row(file, record):
    """PartRow of a part record."""
    measured = record["descriptors"]
    return PartRow(file, *((column.cell or column.value)(record, measured) for column in TITLED), None, None)


def checked_row(file, record):
    """CheckedRow of a part record with its ``checks`` and ``labels``, if it has some."""
    row = CheckedRow(*measured_row(file, record))
    row.checks, row.said = tuple(record.get("checks", ())), tuple(record.get("labels", ()))
    return row


def failed_row(file, name, label, error):
    """PartRow of a failure: of the part `name`, or of the file if `name` is None."""
    empty_cells = [None] * (len(TITLED) - 2)
    return PartRow(file, name, label, *empty_cells, error["kind"], error["message"])


def check_titles(names):
    """Titles of the columns of `check_cells`, for names of processes: tuple of str."""
    return tuple(title for name in names for title in (f"check {name}", f"check {name} sentence"))


def check_cells(checks):
    """Cells for the ``checks`` of a part: tuple of str.

    Parameters
    ----------
    checks : list of dict
        See `WallCheck.content`.
    """
    return tuple(cell for check in checks
                 for cell in (_PASSES[check["passes"]], check["sentence"].replace("\u00a0", " ")))


_PASSES = {True: "passes", False: "fails", None: "unknown"}


def write_part_table(path, blocks, more_titles=(), overwrite=False, inputs=()):
    """Write a CSV file atomically: a line of titles, then the rows.

    Parameters
    ----------
    path : str or Path
    blocks : iterable of str
        From `csv_text`, of PartRows.
    more_titles : tuple of str, optional
        Titles of further columns, after those of a PartRow.
    overwrite, inputs
        See `check_output`.

    Raises
    ------
    ThinPartError, OSError
        See `write_output`.
    """
    text = csv_text([(*PartRow._fields, *more_titles)]) + "".join(blocks)
    write_output(path, text.encode(), TABLE, overwrite, inputs)

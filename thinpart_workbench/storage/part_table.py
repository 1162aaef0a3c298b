"""The table of classified parts as a CSV file: a row per part and per failure."""

import csv
import io
from collections import namedtuple

from .atomic_file import write_atomically

PART_COLUMNS = {
    "part": lambda part: part["name"],
    "label": lambda part: part["label"],
    "instances": lambda part: part["instances"],
    "category": lambda part: part["category"],
    "criteria": lambda part: " ".join(map(str, part["criteria"])),
    "margin": lambda part: part["margin"],
    "borderline": lambda part: int(part["borderline"]),
    "d1_mm": lambda part: part["descriptors"]["box_mm"][0],
    "d2_mm": lambda part: part["descriptors"]["box_mm"][1],
    "d3_mm": lambda part: part["descriptors"]["box_mm"][2],
    "volume_mm3": lambda part: part["descriptors"]["volume_mm3"],
    "area_mm2": lambda part: part["descriptors"]["area_mm2"],
    "volume_ratio": lambda part: part["descriptors"]["volume_ratio"],
    "thinnest_mm": lambda part: part["descriptors"]["thickness_mm"]["min"],
    "median_mm": lambda part: part["descriptors"]["thickness_mm"]["median"],
    "error_bound_mm": lambda part: part["descriptors"]["thickness_mm"]["error_bound"],
    "triangles": lambda part: part["triangles"],
    "warnings": lambda part: " ".join(part["warnings"]),
}
"""What a part's row takes from its record."""

PartRow = namedtuple("PartRow", ("file", *PART_COLUMNS, "error_kind", "error"))
"""A row: ``file`` as it is named in the table, a part's quantities or a failure's kind and message.

What does not apply is None: a failure has no category, a part no ``error_kind``.
"""

FIRST_COLUMNS = ",".join(PartRow._fields[:3]).encode()
"""How every table that was written starts; what starts otherwise is not overwritten."""


def measured_row(file, record):
    """PartRow of a part record."""
    return PartRow(file, *(value(record) for value in PART_COLUMNS.values()), None, None)


def failed_row(file, name, label, error):
    """PartRow of a failure: of a part with a name, or of the whole file where that is None."""
    blank = [None] * (len(PART_COLUMNS) - 2)
    return PartRow(file, name, label, *blank, error["kind"], error["message"])


def csv_text(rows):
    """Rows as lines of a CSV file.

    Parameters
    ----------
    rows : iterable of tuple
    """
    text = io.StringIO(newline="")
    csv.writer(text).writerows(map(_harmless, row) for row in rows)
    return text.getvalue()


_COMPUTED = ("=", "+", "-", "@", "\t", "\r")
"""What a cell begins with that spreadsheets compute, and may send elsewhere (OWASP, CSV injection)."""


def _harmless(value):
    """A value that no spreadsheet takes for a formula: names of files and parts are other people's."""
    return "'" + value if isinstance(value, str) and value.startswith(_COMPUTED) else value


def write_part_table(path, texts):
    """Write a CSV file, atomically: a line of titles, then the rows.

    Parameters
    ----------
    path : str or Path
    texts : iterable of str
        From `csv_text`, of PartRows.

    Raises
    ------
    OSError
    """
    text = csv_text([PartRow._fields]) + "".join(texts)
    write_atomically(path, text.encode("utf-8", "backslashreplace"))

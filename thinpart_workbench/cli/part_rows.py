"""Part records as rows of a table for people, and of a CSV file."""

import json
import os
from collections import namedtuple

from ..core.errors import ThinPartError
from ..storage.part_table import csv_text, failed_row, measured_row, write_part_table
from .terminal_table import (
    CATEGORY_STYLES, FAILURE, OTHER_CATEGORY, TableColumn, print_remark, print_table,
)

def _box(part):
    return " x ".join(f"{side:.4g}" for side in part["descriptors"]["box_mm"])


def _ratio(part):
    value = part["descriptors"]["volume_ratio"]
    return "-" if value is None else f"{value:.3f}"


def _thinnest(part):
    value = part["descriptors"]["thickness_mm"]["min"]
    return "-" if value is None else f"{value:.4g}"


def _name(part):
    count = f" ({part['instances']}x)" if part["instances"] > 1 else ""
    return part["label"] + count


def _category(part):
    return part["category"] + (" (borderline)" if part["borderline"] else "")


TABLE = (
    ("Part", _name, False),
    ("Category", _category, False),
    ("Criteria", lambda part: ", ".join(map(str, part["criteria"])) or "none", False),
    ("D1 x D2 x D3 mm", _box, True),
    ("V/VBB", _ratio, True),
    ("Thinnest mm", _thinnest, True),
)
"""Title, function from a part record to a text, whether it lines up on the right."""

_CATEGORY = 1
"""Place of the category in `TABLE`, which has a colour."""

_Row = namedtuple("_Row", "file table csv")


class PartRows:
    """Rows of all files of a run, as text.

    A part record is a hundred times as large as its rows, so records are not kept.

    Parameters
    ----------
    tree : str or Path
        Folder that holds all files: they are named by their places in it.
    table, csv : bool
        Which rows are going to be asked for.
    """

    def __init__(self, tree, table=True, csv=True):
        self._tree = tree
        self._table = table
        self._csv = csv
        self._rows = []

    def __bool__(self):
        return bool(self._rows)

    def add(self, outcome):
        """Take the parts and failures of one file, from `analyse_files`."""
        place = os.path.relpath(outcome["file"], self._tree)
        self._rows.append(_Row(
            outcome["file"],
            json.dumps(_table_rows(outcome, place)) if self._table else None,
            _csv_rows(outcome, place) if self._csv else None,
        ))

    def print_table(self, stream):
        """Print a row per part and per failure, and what there is to say about parts below."""
        self._rows.sort(key=lambda row: row.file)
        several = len({row.file for row in self._rows}) > 1
        print_table(stream, list(_columns(several)), self._shown)
        for row in self._shown():
            whose = f"{row['place']}: {row['cells'][0]}" if several else row["cells"][0]
            for text in row["remarks"]:
                print_remark(stream, f"{whose}: {text}")

    def _shown(self):
        return (each for row in self._rows for each in json.loads(row.table))

    def write_csv(self, path):
        """Write a row per part and per failure to a CSV file.

        Raises
        ------
        ThinPartError
            When there is no room for it. The table that was there is then still whole.
        """
        self._rows.sort(key=lambda row: row.file)
        try:
            write_part_table(path, (row.csv for row in self._rows))
        except OSError as error:
            raise ThinPartError(
                f"The table {path} could not be written ({error.strerror}): make room, or give another "
                "file to --csv.", "failed",
            ) from None


def _table_rows(outcome, place):
    rows = []
    for part in outcome.get("parts", ()):
        rows.append({
            "place": place, "cells": [value(part) for _, value, _ in TABLE], "failed": False,
            "style": CATEGORY_STYLES.get(part["category"], OTHER_CATEGORY),
            "remarks": [text for text in [part["reason"], *part["warnings"]] if text],
        })
    for error in _errors(outcome):
        rows.append({"place": place, "failed": True, "style": FAILURE, "remarks": [],
                     "cells": [error.get("label") or "", f"failed: {error['kind']}"]})
    return rows


def _columns(several):
    """Columns of the rows that `_table_rows` makes."""
    if several:
        yield TableColumn("File", lambda row: row["place"])
    for number, (title, _, is_right) in enumerate(TABLE):
        def value(row, number=number):
            if row["failed"] and number == 0 and not several:
                return row["cells"][0] or row["place"]
            return row["cells"][number] if number < len(row["cells"]) else ""

        style = (lambda row: row["style"]) if number == _CATEGORY else None
        yield TableColumn(title, value, is_right, style)


def _csv_rows(outcome, place):
    rows = [measured_row(place, part) for part in outcome.get("parts", ())]
    rows += [failed_row(place, error.get("part"), error.get("label"), error)
             for error in _errors(outcome)]
    return csv_text(rows)


def _errors(outcome):
    return [outcome["error"]] if "error" in outcome else outcome["failures"]

"""Part records as rows of a table for people, and of a CSV file."""

import csv
import io
import json
import os
from collections import namedtuple
from dataclasses import dataclass

from ..core.errors import ThinPartError
from ..storage.atomic_file import write_atomically
from .run_report import printable

_COLOURS = {"thin": "red", "thin_features": "yellow", "normal": "green", "unknown": "magenta"}


@dataclass(frozen=True)
class Column:
    """A column of the table.

    Attributes
    ----------
    title : str
    value : callable
        From a part record to a text.
    right : bool
        Whether numbers line up on the right.
    """

    title: str
    value: object
    right: bool = False


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
    Column("Part", _name),
    Column("Category", _category),
    Column("Criteria", lambda part: ", ".join(map(str, part["criteria"])) or "none"),
    Column("D1 x D2 x D3 mm", _box, right=True),
    Column("V/VBB", _ratio, right=True),
    Column("Thinnest mm", _thinnest, right=True),
)

CSV_COLUMNS = {
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


FIRST_COLUMNS = b"file,part,label"
"""How every table that was written starts; what starts otherwise is not overwritten."""


_LINES_AT_ONCE = 1000
"""Rows that are laid out together: a table keeps some kilobytes for each until it is printed."""

_NARROWEST = 8
"""Characters that a column keeps on a terminal that is too narrow for all."""

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
        from rich.console import Console

        console = Console(file=stream, highlight=False)
        if not console.is_terminal:
            # A file or a pipe has no width to fit into; cut cells would lose what was asked for.
            console = Console(file=stream, highlight=False, width=220)
        self._rows.sort(key=lambda row: row.file)
        several = len({row.file for row in self._rows}) > 1
        columns = [Column("File", None), *TABLE] if several else TABLE
        _print_rows(console, columns, self._shown(several))
        for row in self._rows:
            for cells in json.loads(row.table):
                whose = f"{cells['place']}: {cells['cells'][0]}" if several else cells["cells"][0]
                for text in cells["remarks"]:
                    console.print(printable(f"{whose}: {text}"), style="dim", markup=False)

    def _shown(self, several):
        """A function that goes through all (cells, colour) again: they are read more than once."""
        def rows():
            for row in self._rows:
                for each in json.loads(row.table):
                    cells = list(map(printable, each["cells"]))
                    if several:
                        cells.insert(0, printable(each["place"]))
                    elif each["failed"] and not cells[0]:
                        cells[0] = printable(each["place"])
                    yield cells, each["colour"]

        return rows

    def write_csv(self, path):
        """Write a row per part and per failure to a CSV file.

        Raises
        ------
        ThinPartError
            When there is no room for it. The table that was there is then still whole.
        """
        self._rows.sort(key=lambda row: row.file)
        text = _csv_text([["file", *CSV_COLUMNS, "error_kind", "error"]])
        text += "".join(row.csv for row in self._rows)
        try:
            write_atomically(path, text.encode("utf-8", "backslashreplace"))
        except OSError as error:
            raise ThinPartError(
                f"The table {path} could not be written ({error.strerror}): make room, or give another "
                "file to --csv.", "failed",
            ) from None


def _table_rows(outcome, place):
    rows = []
    for part in outcome.get("parts", ()):
        rows.append({
            "place": place, "cells": [column.value(part) for column in TABLE], "failed": False,
            "colour": _COLOURS.get(part["category"], "cyan"),
            "remarks": [text for text in [part["reason"], *part["warnings"]] if text],
        })
    for error in _errors(outcome):
        rows.append({"place": place, "failed": True, "colour": "bold red", "remarks": [],
                     "cells": [error.get("label") or "", f"failed: {error['kind']}"]})
    return rows


def _print_rows(console, columns, rows):
    """Lay out rows a thousand at a time, all in the same columns."""
    from itertools import islice

    from rich.cells import cell_len
    from rich.table import Table

    widths = [len(column.title) for column in columns]
    for cells, _ in rows():
        for number, cell in enumerate(cells):
            widths[number] = max(widths[number], cell_len(cell))
    _fit(widths, console.width - 2 * (len(widths) - 1))
    category = [column.title for column in columns].index("Category")
    left, is_first = rows(), True
    while block := list(islice(left, _LINES_AT_ONCE)):
        table = Table(box=None, pad_edge=False, header_style="bold", show_header=is_first)
        for column, width in zip(columns, widths):
            table.add_column(column.title, justify="right" if column.right else "left",
                             overflow="fold", width=width)
        for cells, colour in block:
            table.add_row(*(_cell(cell, colour if number == category else "")
                            for number, cell in enumerate(cells)))
        console.print(table)
        is_first = False


def _cell(text, style):
    from rich.text import Text

    return Text(text, style)


def _fit(widths, room):
    """Narrow the widest columns until all fit."""
    while sum(widths) > room and max(widths) > _NARROWEST:
        widths[widths.index(max(widths))] -= 1


def _csv_rows(outcome, place):
    rows = [[place, *(value(part) for value in CSV_COLUMNS.values()), "", ""]
            for part in outcome.get("parts", ())]
    for error in _errors(outcome):
        named = [error.get("part") or "", error.get("label") or ""]
        blank = [""] * (len(CSV_COLUMNS) - len(named))
        rows.append([place, *named, *blank, error["kind"], error["message"]])
    return _csv_text(rows)


def _csv_text(rows):
    text = io.StringIO(newline="")
    csv.writer(text).writerows(rows)
    return text.getvalue()


def _errors(outcome):
    return [outcome["error"]] if "error" in outcome else outcome["failures"]

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Part records as rows of a printed table and of a CSV file."""

import json
import os
from collections import namedtuple
from itertools import zip_longest

from ..core.errors import ThinPartError
from ..core.judging.paper_verdict import paper_sentence
from ..core.judging.verdict_sentence import verdict_sentence
from ..core.number_text import percent
from ..core.record.thinnest_sentence import thinnest_figure, thinnest_kind, thinnest_sentence
from ..core.record.verdict_chances import named_between, open_between
from ..core.risk.risk_sentence import risk_sentence
from ..storage.part_table import checked_row, failed_row, part_table, write_table
from .check_options import check_columns, check_remarks
from .terminal_table import FAILURE, TableColumn, category_style, print_remark, print_table


def _box(part):
    return " x ".join(f"{side:.4g}" for side in part["descriptors"]["box_mm"])


def _ratio(part):
    value = part["descriptors"]["volume_ratio"]
    return "-" if value is None else f"{value:.3f}"


def thinnest_cell(thinnest, kind, walls, places):
    """The cell of the thinnest wall, str.

    Parameters
    ----------
    thinnest, walls : float or None, mm
        Of all walls, and apart from sharp edges.
    kind : str or None
        See `thinnest_kind`.
    places : int or None
        How many there are about as thin.
    """
    if thinnest is None:
        return "-"
    # Beside a sharp edge any part is thin: what it is compared by with others is its walls.
    more = f", wall {walls:.4g}" if thinnest < (walls or thinnest) else ""
    several = f" ({places}x)" if places and places > 1 else ""
    return f"{thinnest:.4g} {kind or ''}".rstrip() + several + more


def _thinnest(part):
    return thinnest_cell(part["descriptors"]["thickness_mm"]["min"], thinnest_kind(part),
                         thinnest_figure(part, "walls_mm"), thinnest_figure(part, "places"))


def _between(part):
    """Between which categories an unsure verdict is, the likelier first; empty where it is sure, or has no probabilities."""
    between = open_between(part)
    if between is None:
        return ""
    words = (f"{category.replace('_', ' ')} ({percent(chance)})" for category, chance in between)
    return f"Unsure: {' or '.join(words)}."


def _risk(part):
    value = part.get("mesh_risk", {}).get("risk")
    return "-" if value is None else f"{100 * value:.0f} %"


def _name(part):
    count = f" ({part['instances']}x)" if part["instances"] > 1 else ""
    return part["label"] + count


def category_cell(category, borderline, between):
    """The cell of the category, str.

    Parameters
    ----------
    category : str
    borderline : bool
    between : sequence of str
        See `named_between`.
    """
    if between:
        return f"unsure: {' or '.join(between)}"
    return category + (" (unsure)" if borderline else "")


def _category(part):
    return category_cell(part["category"], part["borderline"], named_between(part))


TABLE = (
    ("Part", _name, False),
    ("Category", _category, False),
    ("Mesh risk", _risk, True),
    ("Criteria", lambda part: ", ".join(map(str, part["criteria"])) or "none", False),
    ("D1 x D2 x D3 mm", _box, True),
    ("V/VBB", _ratio, True),
    ("Thinnest mm", _thinnest, True),
)
"""Title, function from a part record to a text, whether the column is right-aligned."""

_CATEGORY = 1
"""Index in `TABLE` of the category, which is shown in colour."""

_MOST_FACES = 6

_Row = namedtuple("_Row", "file table csv")


class PartRows:
    """Table and CSV rows of all files of a run, stored as text.

    Records are not stored, except those of a single file, because a part record is a hundred times as large as its rows.

    Parameters
    ----------
    tree : str or Path
        Folder that holds all files; files are named by their paths relative to it.
    profile : Profile
        That the parts are judged by. Where the paper would say something else of the parts of a single file, a line below
        the table says it.
    table, csv, regions : bool
        Which kinds of rows are needed; regions are lines below the table.
    limits : tuple of WallLimits
        What the parts were checked against: their ``checks`` get columns of their own.
    """

    def __init__(self, tree, profile, table=True, csv=True, regions=False, limits=()):
        self._profile, self._limits = profile, limits
        self._form = part_table(each.name for each in limits)
        self._tree = tree
        self._table = table
        self._csv = csv
        self._regions = regions
        self._rows, self._single = [], None

    def __bool__(self):
        return bool(self._rows)

    def add(self, outcome):
        """Add the parts and failures of one file, an outcome of `analyse_files`."""
        path = os.path.relpath(outcome["file"], self._tree)
        self._single = None if self._rows else outcome
        self._rows.append(_Row(
            outcome["file"],
            json.dumps(_table_rows(outcome, path, self._regions)) if self._table else None,
            self._form.text(_csv_rows(outcome, path)) if self._csv else None,
        ))

    def print_table(self, stream):
        """Print a row per part and per failure, and below it the remarks on the parts."""
        self._rows.sort(key=lambda row: row.file)
        several = len({row.file for row in self._rows}) > 1
        columns = [*_columns(several), *check_columns(self._limits, lambda row: row.get("checks"))]
        print_table(stream, columns, self._loaded_rows)
        parts = self._single.get("parts", ()) if self._single else ()
        for row, part in zip_longest(self._loaded_rows(), parts):
            prefix = f"{row['path']}: {row['cells'][0]}" if several else row["cells"][0]
            between = _between(part) if part else ""
            paper = paper_sentence(part, self._profile) if part else ""
            alone = row if len(parts) == 1 else {}
            said = filter(None, [between, alone.get("why"), paper, alone.get("thinnest"), alone.get("risk")])
            checks = check_remarks(row.get("checks") or (), several)
            for text in [*said, *row["remarks"], *checks, *row.get("regions", ())]:
                print_remark(stream, f"{prefix}: {text}")

    def _loaded_rows(self):
        return (table_row for row in self._rows for table_row in json.loads(row.table))

    def write_csv(self, path, overwrite=False, inputs=()):
        """Write a row per part and per failure to a CSV file, with `overwrite` and `inputs` as in `write_output`.

        Raises ThinPartError if it cannot be written. An existing table is then left intact.
        """
        self._rows.sort(key=lambda row: row.file)
        try:
            write_table(path, self._form, (row.csv for row in self._rows), overwrite, inputs)
        except OSError as error:
            raise ThinPartError(
                f"The table {path} could not be written ({error.strerror}): free some disk space, or give another "
                "file to --csv.", "failed",
            ) from None


def _table_rows(outcome, path, with_regions=False):
    rows = []
    for part in outcome.get("parts", ()):
        rows.append({
            "path": path, "cells": [value(part) for _, value, _ in TABLE], "failed": False,
            "style": category_style(part["category"]),
            "remarks": [text for text in [part["reason"], *part["warnings"]] if text],
            "regions": list(_region_lines(part)) if with_regions else [],
            "checks": part.get("checks"), "risk": risk_sentence(part),
            "thinnest": thinnest_sentence(part), "why": verdict_sentence(part),
        })
    for error in _errors(outcome):
        rows.append({"path": path, "failed": True, "style": FAILURE, "remarks": [],
                     "cells": [error.get("label") or "", f"failed: {error['kind']}"]})
    return rows


def _region_lines(part):
    """A line for each kind of equal wall regions, and one for those that are left out."""
    from ..core.record.region_groups import region_groups  # imports numpy

    for group in region_groups(part):
        times = f"{group.count} x " if group.count > 1 else ""
        to = f" to {group.median:.3g}" if f"{group.median:.3g}" != f"{group.least:.3g}" else ""
        volume = "" if group.volume_share is None else f", {percent(group.volume_share)} of the volume"
        faces = ", ".join(f"Face{face + 1}" for face in group.faces[:_MOST_FACES])
        excluded = f" (excluded: {group.excluded})" if group.excluded else ""
        more = f" and {len(group.faces) - _MOST_FACES} more" if len(group.faces) > _MOST_FACES else ""
        yield (f"{times}{group.word}, {group.least:.3g}{to} mm thick, {group.length:.4g} mm long, {group.width:.4g} mm wide"
               f"{volume}: {faces}{more}{excluded}")
    if part.get("regions", {}).get("others"):
        others, share = part["regions"]["others"], part["regions"]["others_share"]
        yield f"{others} smaller region{'s' if others > 1 else ''}, {percent(share)} of the surface"


def _columns(several):
    """Columns for the rows of `_table_rows`."""
    if several:
        yield TableColumn("File", lambda row: row["path"])
    for number, (title, _, is_right) in enumerate(TABLE):
        def value(row, number=number):
            if row["failed"] and number == 0 and not several:
                return row["cells"][0] or row["path"]
            return row["cells"][number] if number < len(row["cells"]) else ""

        style = (lambda row: row["style"]) if number == _CATEGORY else None
        yield TableColumn(title, value, is_right, style)


def _csv_rows(outcome, path):
    yield from (checked_row(path, part) for part in outcome.get("parts", ()))
    yield from (failed_row(path, error.get("part"), error.get("label"), error) for error in _errors(outcome))


def _errors(outcome):
    return [outcome["error"]] if "error" in outcome else outcome["failures"]

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts from the index as rows of a printed table."""

import json
import os

from ..storage.record_columns import labels_text
from .part_rows import category_cell, thinnest_cell
from .terminal_table import FAILURE, TableColumn, category_style, print_table


def print_stored(parts, stream, folder, more_columns=()):
    """Print a row per StoredPart, with paths relative to a folder; `more_columns` come before the others."""
    if parts:
        file_column = TableColumn("File", lambda part: os.path.relpath(part.file, folder))
        print_table(stream, [*more_columns, file_column, *_COLUMNS], lambda: parts)


def _category(part):
    if part.error_kind:
        return f"failed: {part.error_kind}"
    return category_cell(part.category, part.borderline, (part.unsure_between or "").split())


def _style(part):
    return FAILURE if part.error_kind else category_style(part.category)


def _ratio(part):
    return "-" if part.volume_ratio is None else f"{part.volume_ratio:.3f}"


def _risk(part):
    return "-" if part.risk is None else f"{100 * part.risk:.0f} %"


def _label(part):
    count = f" ({part.instances}x)" if part.instances and part.instances > 1 else ""
    return (part.label or "") + count


def _box(part):
    if part.d1_mm is None:
        return "-"
    return " x ".join(f"{side:.4g}" for side in (part.d1_mm, part.d2_mm, part.d3_mm))


def _notes(part):
    labels = labels_text(json.loads(part.labels)) if part.labels else ""
    annotations = [labels and f"labelled {labels}", part.notes, "mesh settings" if part.mesh else "", part.link or ""]
    text = part.error_message or "; ".join(annotation for annotation in annotations if annotation)
    return " ".join(text.split())


_COLUMNS = (
    TableColumn("Part", _label),
    TableColumn("Category", _category, style=_style),
    TableColumn("Mesh risk", _risk, True),
    TableColumn("Criteria", lambda part: ", ".join(part.criteria) or "none"),
    TableColumn("D1 x D2 x D3 mm", _box, True),
    TableColumn("V/VBB", _ratio, True),
    TableColumn("Thinnest mm", lambda part: thinnest_cell(part.thinnest_mm, part.thinnest_at, part.walls_mm, part.places),
                True),
    TableColumn("Notes", _notes),
)

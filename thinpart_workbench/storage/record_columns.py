# SPDX-License-Identifier: LGPL-2.1-or-later
"""The table of columns that the search index and the CSV table take from a part record.

Every quantity of `core/descriptors/descriptor_table` that a record contains is a column here. This module must not
import numpy: the command line writes tables without it.
"""

import json
from collections import namedtuple
from typing import Any, Callable, NamedTuple, Optional

from ..core.descriptors.descriptor_table import QUANTITIES, STATED_FLOOR
from ..core.kinds.value_kinds import Number, OrNull, Text, Whole
from ..core.message import joined
from ..core.record.record_types import PART
from ..core.record.thinnest_sentence import thinnest_figure, thinnest_kind
from ..core.record.verdict_chances import named_between


class RecordColumn(NamedTuple):
    """A column.

    Attributes
    ----------
    name : str
    type : str or None
        SQL type in the index; None if the index does not have the column.
    value : callable
        Function of a part record and its ``descriptors``; returns the value, or None if there is none.
    title : str or None
        Title in the CSV table; None if the table does not have the column.
    cell : callable or None
        Function for the cell of the CSV table, if that differs from the value.
    absent : float or None
        Value that the index stores for None.
    """

    name: str
    type: Optional[str]
    value: Callable
    title: Optional[str] = None
    cell: Optional[Callable] = None
    absent: Optional[float] = None


def _text(part, measured):
    """The text in which words are searched, besides the path."""
    return "\n".join(str(part.get(key) or "") for key in ("name", "label", "notes", "link", "mesh")).casefold()


def _mesh(part, measured):
    mesh = part.get("mesh")
    return None if mesh is None else json.dumps(mesh, ensure_ascii=False)


def _labels(part, measured):
    labels = part.get("labels")
    return json.dumps(labels, ensure_ascii=False) if labels else None


def _said(part, measured):
    """The categories that people say the part has, for searches."""
    return "".join(f",{category}" for category in sorted({label["category"] for label in part.get("labels", ())})) + ","


def labels_text(labels):
    """What people say of a part, ``labels`` of its record, in a line: "thin (Anna); normal (Bert, unsure)"."""
    return "; ".join(f"{label['category']} ({label['person']}{'' if label['sure'] else ', unsure'})" for label in labels)


def _quantity_column(quantity):
    def value(part, measured):
        try:
            return quantity.recorded(measured)
        except KeyError:
            # An earlier version wrote the record: compute the missing quantity from the others.
            from ..core.record.part_record import descriptors_of

            return quantity.evaluate(descriptors_of(part), STATED_FLOOR)

    return RecordColumn(quantity.name, "REAL", value, quantity.name if quantity.in_table else None,
                        absent=quantity.absent_means)


def _of_record(key, title=None):
    """The column of a key of a part record, with the SQL type of its kind."""
    kind = PART.kinds[key]
    type_ = _SQL_TYPES[type(kind.kind if isinstance(kind, OrNull) else kind)]
    return RecordColumn(key, type_, lambda part, measured: part.get(key), title)


_SQL_TYPES: dict[type, str] = {Text: "TEXT", Whole: "INTEGER", Number: "REAL"}


def _is_no_length(quantity):
    return quantity.unit != "mm"


COLUMNS = (
    _of_record("name", "part"),
    *(_of_record(key, key) for key in ("label", "instances", "category")),
    RecordColumn("criteria", "TEXT", lambda part, measured: f",{','.join(map(str, part['criteria']))},", "criteria",
                 lambda part, measured: " ".join(map(str, part["criteria"]))),
    _of_record("margin", "margin"),
    RecordColumn("risk", "REAL", lambda part, measured: part.get("mesh_risk", {}).get("risk"), "risk"),
    RecordColumn("borderline", "INTEGER", lambda part, measured: int(part["borderline"]), "borderline"),
    RecordColumn("unsure_between", "TEXT", lambda part, measured: " ".join(named_between(part)), "unsure_between"),
    *(_quantity_column(quantity) for quantity in sorted(QUANTITIES, key=_is_no_length) if quantity.keys),
    RecordColumn("thinnest_mm", "REAL", lambda part, measured: measured["thickness_mm"]["min"], "thinnest_mm"),
    RecordColumn("thinnest_at", "TEXT", lambda part, measured: thinnest_kind(part), "thinnest_at"),
    RecordColumn("places", "INTEGER", lambda part, measured: thinnest_figure(part, "places"), "places"),
    RecordColumn("places_below_mm", "REAL", lambda part, measured: thinnest_figure(part, "below_mm"), "places_below_mm"),
    RecordColumn("walls_mm", "REAL", lambda part, measured: thinnest_figure(part, "walls_mm"), "walls_mm"),
    RecordColumn("median_mm", "REAL", lambda part, measured: measured["thickness_mm"]["median"], "median_mm"),
    RecordColumn("error_bound_mm", "REAL", lambda part, measured: measured["thickness_mm"]["error_bound"], "error_bound_mm"),
    RecordColumn("topology", "TEXT", lambda part, measured: part.get("form", {}).get("topology")),
    _of_record("triangles", "triangles"),
    RecordColumn("warnings", None, lambda part, measured: joined(part["warnings"]), "warnings"),
    RecordColumn("notes", "TEXT", lambda part, measured: part.get("notes") or ""),
    RecordColumn("mesh", "TEXT", _mesh),
    _of_record("link"),
    RecordColumn("labels", "TEXT", _labels, "labels", lambda part, measured: labels_text(part.get("labels", ()))),
    RecordColumn("said", "TEXT", _said),
    RecordColumn("text", "TEXT", _text),
)


def row_class(name, fields) -> Any:
    """A named tuple class to derive from. Its fields come from a table, so its type is Any for type checkers."""
    return namedtuple(name, fields)


INDEXED = tuple(column for column in COLUMNS if column.type)
"""Columns of the search index."""

TITLED = tuple(column for column in COLUMNS if column.title)
"""Columns of the CSV table, in their order."""

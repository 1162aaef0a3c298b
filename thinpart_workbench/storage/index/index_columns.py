# SPDX-License-Identifier: LGPL-2.1-or-later
"""The values that the search index stores for a part, in the types of SQLite."""

import json
from typing import Callable

from ...core.descriptors.packed_distribution import packed_local, packed_middle, packed_slanted, packed_walls
from ...core.foreign_text import sql_text
from ...core.forms.recorded_form import packed_form
from ...core.record.face_limits import limited_part
from ...core.reuse.similarity import signature
from ..record_columns import INDEXED

LARGE_COLUMNS = ("wall_bins", "wall_area", "slanted_bins", "slanted_angles", "slanted_area", "middle_bins",
                 "middle_parallel", "middle_nonparallel", "local_bins", "local_area", "signature", "form", "outline",
                 "limited")
"""Blobs, and JSON of `limited_part`, stored in a table of their own: most queries do not need them."""


_CONVERTERS: dict[str, Callable] = {"TEXT": sql_text, "INTEGER": int, "REAL": float}


def small_values(part):
    """Values of `INDEXED` for a part record."""
    measured = part["descriptors"]
    return [_stored_value(column, column.value(part, measured)) for column in INDEXED]


def large_values(part):
    """Values of `LARGE_COLUMNS` for a part record."""
    measured = part["descriptors"]
    walls, slanted = packed_walls(measured["distribution"]), packed_slanted(measured["nonparallel"])
    return (*walls, *slanted, *packed_middle(measured.get("middle")), *packed_local(measured.get("local")),
            signature(part).tobytes(), *packed_form(part), _limited(part))


def _limited(part):
    limited = limited_part(part)
    return None if limited is None else json.dumps(limited)


def _stored_value(column, value):
    return column.absent if value is None else _CONVERTERS[column.type](value)

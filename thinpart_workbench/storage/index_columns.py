"""What the search index keeps of a part: one table, a column each."""

import json
from collections import namedtuple

from ..core.packed_distribution import packed_slanted, packed_walls
from ..core.similarity import signature

Column = namedtuple("Column", "name type value")
"""SQL name, SQL type, and a function from (part record, its descriptors) to the value."""

NO_WALL = 9e999
"""Where a part has no slanted walls, the nearest is infinitely far: SQLite's infinity."""

_TYPES = {"TEXT": str, "INTEGER": int, "REAL": (int, float)}
_LARGEST = 2 ** 63


def _least_slanted(part, measured):
    value = measured["min_nonparallel"]
    return NO_WALL if value is None else value


def _text(part, measured):
    """What words are looked for in, besides the path."""
    return "\n".join(str(part.get(key) or "") for key in ("name", "label", "notes", "link", "mesh")).casefold()


def _json_or_none(key):
    def value(part, measured):
        content = part.get(key)
        return None if content is None else json.dumps(content, ensure_ascii=False)

    return value


COLUMNS = (
    Column("name", "TEXT", lambda part, measured: part["name"]),
    Column("label", "TEXT", lambda part, measured: part["label"]),
    Column("instances", "INTEGER", lambda part, measured: part["instances"]),
    Column("category", "TEXT", lambda part, measured: part["category"]),
    Column("criteria", "TEXT", lambda part, measured: f",{','.join(map(str, part['criteria']))},"),
    Column("margin", "REAL", lambda part, measured: part["margin"]),
    Column("borderline", "INTEGER", lambda part, measured: int(part["borderline"])),
    Column("d1_mm", "REAL", lambda part, measured: measured["box_mm"][0]),
    Column("d2_mm", "REAL", lambda part, measured: measured["box_mm"][1]),
    Column("d3_mm", "REAL", lambda part, measured: measured["box_mm"][2]),
    Column("diagonal_mm", "REAL", lambda part, measured: measured["diagonal_mm"]),
    Column("volume_mm3", "REAL", lambda part, measured: measured["volume_mm3"]),
    Column("area_mm2", "REAL", lambda part, measured: measured["area_mm2"]),
    Column("volume_ratio", "REAL", lambda part, measured: measured["volume_ratio"]),
    Column("d1_d2", "REAL", lambda part, measured: measured["d1_d2"]),
    Column("d2_d3", "REAL", lambda part, measured: measured["d2_d3"]),
    Column("thinnest_mm", "REAL", lambda part, measured: measured["thickness_mm"]["min"]),
    Column("median_mm", "REAL", lambda part, measured: measured["thickness_mm"]["median"]),
    Column("min_nonparallel", "REAL", _least_slanted),
    Column("parallel", "REAL", lambda part, measured: measured["shares"]["parallel"]),
    Column("nonparallel", "REAL", lambda part, measured: measured["shares"]["nonparallel"]),
    Column("unmeasured", "REAL", lambda part, measured: measured["shares"]["unmeasured"]),
    Column("unmet", "REAL", lambda part, measured: measured["shares"]["unmet"]),
    Column("triangles", "INTEGER", lambda part, measured: part["triangles"]),
    Column("notes", "TEXT", lambda part, measured: part.get("notes") or ""),
    Column("mesh", "TEXT", _json_or_none("mesh")),
    Column("link", "TEXT", lambda part, measured: part.get("link")),
    Column("text", "TEXT", _text),
)
"""Columns named as quantities in `core.descriptors` are those quantities; a test holds it."""

LARGE_COLUMNS = ("wall_bins", "wall_area", "slanted_bins", "slanted_angles", "slanted_area", "signature")
"""Bytes, kept in a table of their own: most questions do not need them."""


def small_values(part):
    """Values of `COLUMNS` for a part record.

    Raises
    ------
    KeyError, TypeError, ValueError
        where the record is not what it should be.
    """
    measured = part["descriptors"]
    return [_checked(each, each.value(part, measured)) for each in COLUMNS]


def large_values(part):
    """Values of `LARGE_COLUMNS` for a part record; errors as of `small_values`, and struct.error."""
    measured = part["descriptors"]
    walls, slanted = packed_walls(measured["distribution"]), packed_slanted(measured["nonparallel"])
    return (*walls, *slanted, signature(part).tobytes())


def _checked(column, value):
    if value is None:
        return None
    if not isinstance(value, _TYPES[column.type]):
        raise TypeError(f"{column.name} is {type(value).__name__}")
    if column.type == "TEXT":
        return value if value.isascii() else value.encode("utf-8", "replace").decode()
    if isinstance(value, int) and abs(value) >= _LARGEST:
        raise ValueError(f"{column.name} is too large")
    return value

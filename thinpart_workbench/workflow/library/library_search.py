"""Search over several libraries in one common order."""

from typing import NamedTuple

from ...core.errors import ThinPartError
from ...storage.index.written_query import SORTABLE
from .find_parts import find_parts


class SortedParts(NamedTuple):
    """Sorted parts without duplicates, list of StoredPart; and their number before the limit is applied."""

    parts: list
    total: int


def search(indexes, query, sort="file", descending=False, limit=None):
    """Parts of some libraries that match a query.

    Parameters
    ----------
    indexes : list of LibraryIndex
        Refreshed.
    query : PartQuery
    sort : str
        One of `SORTABLE`; parts without a value come last.
    descending : bool
    limit : int, optional

    Returns
    -------
    SortedParts

    Raises
    ------
    ThinPartError
        kind ``usage`` if parts cannot be sorted by `sort`.
    """
    if sort not in SORTABLE:
        raise ThinPartError(f"Parts are not sorted by {sort!r}: there are {', '.join(SORTABLE)}.", "usage")
    found = [find_parts(index, query, _order(sort, descending)) for index in indexes]
    parts = _distinct(part for parts in found for part in parts)
    if len(found) > 1:
        parts = sorted(parts, key=lambda part: _sort_key(part, sort, descending), reverse=descending)
    return SortedParts(list(parts)[:limit], sum(map(len, found)))


def _order(sort, descending):
    direction = " DESC" if descending else ""
    if sort == "file":
        return f"files.path{direction}, parts.id"
    return f"{sort} IS NULL, {sort}{direction}, files.path, parts.id"


def _sort_key(part, sort, descending):
    """Sort key with the order of `_order`, for parts of several libraries; None comes last in both directions."""
    value = getattr(part, sort)
    return (value is None) != descending, value if value is not None else 0


def _distinct(parts):
    """Yield each part once, also if one library contains another."""
    seen = set()
    for part in parts:
        key = part.info_file, part.name, part.error_message
        if key not in seen:
            seen.add(key)
            yield part

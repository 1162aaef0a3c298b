# SPDX-License-Identifier: LGPL-2.1-or-later
"""Queries and orders as people write them."""

import re
from datetime import datetime, timedelta, timezone

from ...core.errors import ThinPartError
from ...core.judging.conditions import search_conditions
from .part_query import RANGED, PartQuery

SORTABLE = [*sorted(RANGED), "borderline", "category", "file", "label"]
"""Columns by which parts can be sorted."""

_AGE = re.compile(r"^(\d{1,6})\s*([hdwy])$")
_HOURS = {"h": 1, "d": 24, "w": 24 * 7, "y": 24 * 365}


def part_query(conditions=(), changed_since=None, ranges=(), **fields):
    """Create a query: PartQuery. Raises ThinPartError, kind ``usage``: one sentence that names what cannot be parsed.

    Parameters
    ----------
    conditions : str, or iterable of str or SearchCondition
        All must hold, as in ``D2/D3 > 6 and F[0;0.05] >= 0.5``.
    changed_since : str or datetime, optional
        See `moment`.
    ranges : dict of str to (float or None, float or None), optional
        Least and greatest value by column.
    fields
        The other fields of a `PartQuery`; lists are accepted for tuples.
    """
    parsed = []
    for condition in [conditions] if isinstance(conditions, str) else conditions:
        if not isinstance(condition, str):
            parsed.append(condition)
        elif condition.strip():
            parsed += search_conditions(condition)
    if isinstance(changed_since, str):
        changed_since = moment(changed_since)
    elif changed_since is not None:
        changed_since = changed_since.astimezone(timezone.utc)
    fields = {key: tuple(value) if isinstance(value, list) else value for key, value in fields.items()}
    ranges = tuple((column, least, most) for column, (least, most) in dict(ranges).items())
    return PartQuery(conditions=tuple(parsed), changed_since=changed_since, ranges=ranges, **fields)


def moment(text):
    """The time that a date or an age stands for: datetime, in UTC; raises ThinPartError of kind ``usage``.

    Parameters
    ----------
    text : str
        ``2026-03-31``, also with a time; or ``12h``, ``7d``, ``4w``, ``1y``.
    """
    age = _AGE.match(text.strip().lower())
    try:
        if age:
            return datetime.now(timezone.utc) - timedelta(hours=int(age[1]) * _HOURS[age[2]])
        return datetime.fromisoformat(text).astimezone(timezone.utc)
    except (ValueError, OverflowError):
        raise ThinPartError(
            f"'{text}' is no date such as 2026-03-31 and no age such as 12h, 7d, 4w or 1y.", "usage") from None

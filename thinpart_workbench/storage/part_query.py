"""Questions to a library: which parts, in which order."""

from dataclasses import dataclass, fields
from datetime import datetime
from typing import Optional

from ..core.descriptors import STATED_ANGLES, STATED_FLOOR
from .index_columns import COLUMNS

FAILED = "failed"
"""Stands among the categories for what could not be analysed."""

_COLUMNS = {each.name for each in COLUMNS}


@dataclass(frozen=True)
class PartQuery:
    """What parts must fulfil; everything that is set must hold.

    Attributes
    ----------
    categories, criteria : tuple of str
        One of them is enough; `FAILED` among the categories stands for failures.
    least_thickness, most_thickness : float or None, mm
        Of the thinnest wall.
    least_size, most_size : float or None, mm
        Of the longest side of the box.
    least_ratio, most_ratio : float or None
        Of V/VBB.
    conditions : tuple of SearchCondition
    words : str
        Each word must occur in the path, name, label, notes, mesh settings or link.
    has_notes : bool or None
        Whether something is kept with the part: notes, mesh settings or a link.
    borderline : bool or None
    failed : bool or None
        True for failures alone, False for parts alone, None for both.
    changed_since : datetime or None
        When the document was changed.
    """

    categories: tuple = ()
    criteria: tuple = ()
    least_thickness: Optional[float] = None
    most_thickness: Optional[float] = None
    least_size: Optional[float] = None
    most_size: Optional[float] = None
    least_ratio: Optional[float] = None
    most_ratio: Optional[float] = None
    conditions: tuple = ()
    words: str = ""
    has_notes: Optional[bool] = None
    borderline: Optional[bool] = None
    failed: Optional[bool] = False
    changed_since: Optional[datetime] = None

    def where(self):
        """The condition in SQL, and the values of its question marks.

        Returns
        -------
        sql : str
        values : list
        """
        terms = [term for each in fields(self) for term in _TERMS[each.name](getattr(self, each.name))]
        return " AND ".join(sql for sql, _ in terms) or "1", [value for _, own in terms for value in own]


def _at_least(column):
    return lambda value: [] if value is None else [(f"{column} >= ?", [value])]


def _at_most(column):
    return lambda value: [] if value is None else [(f"{column} <= ?", [value])]


def _is(true, false):
    def term(value):
        return [] if value is None else [(true if value else false, [])]

    return term


def _categories(names):
    if names:
        failed = " OR error_kind IS NOT NULL" if FAILED in names else ""
        yield f"(category IN ({', '.join('?' * len(names))}){failed})", list(names)


def _criteria(names):
    if names:
        each = "criteria LIKE '%,' || ? || ',%'"
        yield f"({' OR '.join([each] * len(names))})", list(map(str, names))


def _words(text):
    for word in text.casefold().split():
        yield "(instr(text, ?) OR instr(files.words, ?))", [word, word]


def _changed_since(moment):
    if moment is not None:
        yield "files.modified >= ?", [moment.isoformat()]


def _conditions(conditions):
    for each in conditions:
        expression, values = _expression(each.quantity)
        yield f"{expression} {each.comparison} ?", [*values, each.value]


def _expression(quantity):
    """A quantity in SQL."""
    if quantity.name in _COLUMNS and quantity.bounds in ((), STATED_ANGLES):
        return quantity.name, []
    large = "(SELECT {} FROM distributions WHERE distributions.id = parts.id)"
    if quantity.name == "F":
        return large.format("wall_share(wall_bins, wall_area, ?, ?)"), list(quantity.bounds)
    call = "least_slanted(slanted_bins, slanted_angles, slanted_area, ?, ?, ?)"
    return large.format(call), [STATED_FLOOR, *quantity.bounds]


_TERMS = {
    "categories": _categories,
    "criteria": _criteria,
    "least_thickness": _at_least("thinnest_mm"),
    "most_thickness": _at_most("thinnest_mm"),
    "least_size": _at_least("d1_mm"),
    "most_size": _at_most("d1_mm"),
    "least_ratio": _at_least("volume_ratio"),
    "most_ratio": _at_most("volume_ratio"),
    "conditions": _conditions,
    "words": _words,
    "has_notes": _is("(notes != '' OR mesh IS NOT NULL OR link IS NOT NULL)",
                     "(notes = '' AND mesh IS NULL AND link IS NULL)"),
    "borderline": _is("borderline = 1", "borderline = 0"),
    "failed": _is("error_kind IS NOT NULL", "error_kind IS NULL"),
    "changed_since": _changed_since,
}
"""Field of a query: the terms that its value gives, each with the values of its question marks."""

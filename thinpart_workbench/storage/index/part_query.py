# SPDX-License-Identifier: LGPL-2.1-or-later
"""Queries to a library: the conditions that parts must meet."""

from dataclasses import dataclass
from datetime import datetime
from typing import Optional

from ...core.descriptors.descriptor_table import STATED_ANGLES, STATED_FLOOR
from ...core.descriptors.quantity import LocalShare, MiddleShare
from ...core.errors import ThinPartError
from ...core.foreign_text import sql_like, sql_text
from ...core.message import message
from ..record_columns import INDEXED

FAILED = "failed"
"""The category that stands for documents and parts that could not be analysed."""

RANGED = tuple(column.name for column in INDEXED if column.type in ("REAL", "INTEGER") and column.name != "borderline")
"""Columns that a query may bound: every quantity that records have, and other numbers."""

FLAGS = {
    "borderline": "borderline",
    "has_notes": "(notes != '' OR mesh IS NOT NULL OR link IS NOT NULL)",
    "labelled": "(said != ',')",
    "disputed": "(said NOT IN (',', ',' || category || ','))",
}
"""In SQL, by field of a query: whether a part is near another category, has an annotation, whether people say what it is,
and whether somebody says otherwise than the verdict. Of a failure they are unknown."""

MOST_TERMS = 500
"""Conditions, words and names of a query together: SQLite refuses a deeper expression than 1000."""

_LISTS = ("categories", "criteria", "conditions", "passes", "fails", "said", "ranges")

_COLUMNS = {column.name for column in INDEXED}


@dataclass(frozen=True)
class PartQuery:
    """The conditions that parts must meet; all that are set must hold.

    Attributes
    ----------
    categories, criteria : tuple of str
        One match is enough; `FAILED` among the categories selects failures.
    ranges : tuple of (str, float or None, float or None)
        A column of `RANGED` with its least and its greatest value, each at most once.
    conditions : tuple of SearchCondition
    words : str
        Each word must occur in the path, name, label, notes, mesh settings or link.
    has_notes : bool or None
        Whether the part has an annotation: notes, mesh settings or a link.
    said : tuple of str
        Somebody says that the part has one of these categories.
    labelled : bool or None
        Whether anybody says what category the part has.
    disputed : bool or None
        Whether somebody says another category than the verdict.
    passes, fails : tuple of WallLimits
        Processes whose limits of the wall the part keeps, and does not keep.
    borderline : bool or None
    failed : bool or None
        True for failures only, False for parts only, None for both.
    changed_since : datetime or None
        The document was changed then or later.
    """

    categories: tuple = ()
    criteria: tuple = ()
    ranges: tuple = ()
    conditions: tuple = ()
    passes: tuple = ()
    fails: tuple = ()
    words: str = ""
    has_notes: Optional[bool] = None
    said: tuple = ()
    labelled: Optional[bool] = None
    disputed: Optional[bool] = None
    borderline: Optional[bool] = None
    failed: Optional[bool] = False
    changed_since: Optional[datetime] = None

    def terms(self):
        """The filters that are set, in SQL: all of them must hold.

        Returns a dict of str to (str, list): by column for ``ranges``, by field for the others: a term, and the values for
        its placeholders. Those that take long come last. Raises ThinPartError, kind ``usage`` for more than `MOST_TERMS`, or
        a column that has no range.
        """
        count = len(self.words.split()) + sum(len(getattr(self, name)) for name in _LISTS)
        if count > MOST_TERMS:
            raise ThinPartError(message("The search has {count} conditions, words and names, more than {most}: leave some "
                                        "out.", count=count, most=MOST_TERMS), "usage")
        found = {name: list(_TERMS[name](getattr(self, name))) for name in _TERMS}
        found = {**{column: list(_range(column, least, most)) for column, least, most in self.ranges}, **found}
        return {name: (f"({' AND '.join(sql for sql, _ in terms)})",
                       [sql_text(value) if isinstance(value, str) else value for _, values in terms for value in values])
                for name, terms in found.items() if terms}

    def where(self):
        """The condition in SQL, and the values for its placeholders: see `terms`.

        Returns `sql` (str) and `values` (list).
        """
        return joined_terms(self.terms().values())


def joined_terms(terms):
    """One condition of several, which all must hold: SQL, and the values for its placeholders."""
    terms = list(terms)
    return " AND ".join(sql for sql, _ in terms) or "1", [value for _, values in terms for value in values]


def _range(column, least, most):
    if column not in RANGED:
        raise ThinPartError(message("There is no quantity {quantity!r}: there are {known}.",
                                    quantity=column, known=", ".join(RANGED)), "usage")
    for comparison, bound in ((">=", least), ("<=", most)):
        if bound is not None:
            yield f"{column} {comparison} ?", [bound]


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
        condition = "criteria LIKE ? ESCAPE '!'"
        yield f"({' OR '.join([condition] * len(names))})", [f"%,{sql_like(str(name))},%" for name in names]


def _said(names):
    if names:
        yield f"({' OR '.join(['instr(said, ?)'] * len(names))})", [f",{name}," for name in names]


def _words(text):
    for word in text.casefold().split():
        yield "(instr(text, ?) OR instr(files.words, ?))", [word, word]


def _changed_since(moment):
    if moment is not None:
        yield "files.modified >= ?", [moment.isoformat()]


def _conditions(conditions):
    for condition in conditions:
        expression, values = _expression(condition.quantity)
        yield f"{expression} {condition.comparison} ?", [*values, condition.value]


def _walls_pass(passes):
    large = ("(SELECT walls_pass(thinnest_mm, error_bound_mm, volume_mm3, area_mm2, diagonal_mm, unmeasured, unmet, "
             "wall_bins, wall_area, slanted_bins, slanted_area, limited, t99, d2_mm, ?, ?) "
             "FROM distributions WHERE distributions.id = parts.id)")

    def terms(limits):
        for each in limits:
            yield f"{large} = {int(passes)}", [each.min_mm, each.max_mm]

    return terms


def _expression(quantity):
    """A quantity as an SQL expression, and the values for its placeholders."""
    if quantity.name in _COLUMNS and quantity.bounds in ((), STATED_ANGLES):
        return quantity.name, []
    large = "(SELECT {} FROM distributions WHERE distributions.id = parts.id)"
    if isinstance(quantity, LocalShare):
        return large.format("local_share(local_bins, local_area, ?, ?)"), list(quantity.bounds)
    if isinstance(quantity, MiddleShare):
        call = ("middle_share(wall_bins, wall_area, slanted_bins, slanted_angles, slanted_area, middle_bins, "
                "middle_parallel, middle_nonparallel, d2_mm / diagonal_mm, ?, ?, ?)")
        return large.format(call), [*quantity.bounds, quantity.slanted]
    if quantity.is_area_share:
        return large.format("wall_share(wall_bins, wall_area, ?, ?)"), list(quantity.bounds)
    call = "least_slanted(slanted_bins, slanted_angles, slanted_area, ?, ?, ?)"
    return large.format(call), [STATED_FLOOR, *quantity.bounds]


_TERMS = {
    "failed": _is("error_kind IS NOT NULL", "error_kind IS NULL"),
    "categories": _categories,
    "criteria": _criteria,
    **{name: _is(sql, f"NOT {sql}") for name, sql in FLAGS.items()},
    "said": _said,
    "changed_since": _changed_since,
    "words": _words,
    "conditions": _conditions,
    "passes": _walls_pass(True),
    "fails": _walls_pass(False),
}
"""By field of a query: a function from its value to SQL terms, each with the values for its placeholders."""

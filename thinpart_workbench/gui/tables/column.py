# SPDX-License-Identifier: LGPL-2.1-or-later
"""Columns of tables: what a cell shows, and how rows are sorted by it."""

from dataclasses import dataclass
from functools import lru_cache
from typing import Any, Callable, Optional

from ..application.numbers import number
from ..application.qt import QtCore, QtGui, colour, flags_as_int


@dataclass(frozen=True)
class Column:
    """A column.

    Attributes
    ----------
    key : str
        Its name, by which an index sorts its rows; its title in a file.
    title : str
        Its heading; braces stand for the symbol of the unit where `has_unit`.
    value : callable
        Maps a row to a text, a number, or None; lengths in mm.
    text : callable, optional
        Maps a row and a LengthUnit to the text of the cell; by default it is the value, a text.
    order : callable, optional
        Maps a row to what rows are sorted by, by default the value: texts regardless of case; None and empty texts come last
        in either order.
    is_number : bool
        Whether cells are right-aligned.
    has_unit : bool
    meaning : str
        Tool tip of the heading.
    tip : callable, optional
        Maps a row and a LengthUnit to the tool tip of the cell; by default, or where that is empty, it is that of the row.
    picture : callable, optional
        Maps a row to a QPixmap, or None.
    is_struck, is_checked, is_editable : callable, optional
        Map a row to whether the text is struck through; whether there is a check mark, None for no box; and whether the
        text may be edited.
    is_sortable : bool
    is_hidden : bool
        Whether it is shown only when the user chooses it.
    is_path : bool
        Whether long texts are elided in the middle, because both ends are the most informative.
    stretches : bool
        Whether the column takes the width that the others leave.
    most, least : int
        Greatest width that its texts give it, in characters; and the width to which it gives way to others, 0 where it does
        not.
    """

    key: str
    title: str
    value: Callable
    text: Optional[Callable] = None
    order: Optional[Callable] = None
    is_number: bool = False
    has_unit: bool = False
    meaning: str = ""
    tip: Optional[Callable] = None
    picture: Optional[Callable] = None
    is_struck: Optional[Callable] = None
    is_checked: Optional[Callable] = None
    is_editable: Optional[Callable] = None
    is_sortable: bool = True
    is_hidden: bool = False
    is_path: bool = False
    stretches: bool = False
    most: int = 18
    least: int = 0

    def heading(self, unit):
        """The title, with the symbol of a LengthUnit."""
        return self.title.format(unit.symbol) if self.has_unit else self.title

    def brief(self, unit):
        """The heading without the symbol of a unit that ends it."""
        title, comma, _ = self.title.partition(", {")
        return title if self.has_unit and comma else self.heading(unit)

    def shown(self, row, unit):
        """The text of a row's cell."""
        return self.text(row, unit) if self.text else self.value(row) or ""

    def sort_key(self, row):
        """What a row is sorted by; None comes last."""
        value = (self.order or self.value)(row)
        return value.casefold() or None if isinstance(value, str) else value

    @property
    def alignment(self):
        """int: Qt flags for heading and cells."""
        return _alignment(self.is_number)


@lru_cache
def _alignment(is_number):
    # Kept: looking a name up in Qt's namespace takes longer than all the rest that a cell needs.
    return flags_as_int((QtCore.Qt.AlignRight if is_number else QtCore.Qt.AlignLeft) | QtCore.Qt.AlignVCenter)


def figures(key, title, value, shown, **more: Any):
    """A column of numbers.

    Parameters
    ----------
    key, title, value
        As of `Column`.
    shown : callable
        Maps a value and a LengthUnit to a text: `length`, `area` or the like.
    more
        Further attributes.
    """
    return Column(key, title, value, lambda row, unit: shown(value(row), unit), is_number=True,
                  has_unit=shown in (length, area), **more)


def length(millimetres, unit):
    """Text of a length; a dash for None."""
    return unit.number(millimetres)


def area(square_millimetres, unit):
    """Text of an area; a dash for None."""
    return number(unit.value(square_millimetres, 2))


def count(value, unit):
    """Text of a whole number; empty for None."""
    return "" if value is None else str(value)


def square(rgb):
    """QPixmap of a small square; red, green and blue from 0 to 1."""
    pixmap = QtGui.QPixmap(12, 12)
    pixmap.fill(colour(rgb))
    return pixmap

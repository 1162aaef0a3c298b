# SPDX-License-Identifier: LGPL-2.1-or-later
"""Search conditions as users write them: ``D2/D3 > 6 and F[0;0.05] >= 0.5``."""

import math
import re
from dataclasses import dataclass

from ..descriptors.descriptor_table import quantity_named, quantity_symbols
from ..errors import ThinPartError
from ..message import message

COMPARISONS = (">=", "<=", ">", "<")

_AND = re.compile(r" and | ?[,&]+ ?", re.IGNORECASE)
_COMPARISON = re.compile("([<>]=?)")
"""Both for text with single spaces. Patterns that try every length of a run of spaces take the square of it."""


@dataclass(frozen=True)
class RecordedNumber:
    """A number of a record that no descriptor gives: the ``name`` of its column; it has no ``bounds``."""

    name: str
    bounds: tuple = ()


RECORDED = tuple(map(RecordedNumber, ("risk", "thinnest_mm", "walls_mm", "places")))
"""What conditions may name beside quantities: the risk of the automatic mesh, from 0 to 1; the thinnest wall, and the
thinnest that does not end in a sharp edge; how many places are as thin."""


@dataclass(frozen=True)
class SearchCondition:
    """A quantity or a `RecordedNumber`, one of `COMPARISONS`, and a value in its unit."""

    quantity: object
    comparison: str
    value: float


def search_conditions(text):
    """Parse conditions that must all hold: tuple of SearchCondition.

    Raises ThinPartError, kind ``usage``: one sentence that names the part that is not understood.

    Parameters
    ----------
    text : str
        One or several, joined by ``and``; quantities as in `descriptors.QUANTITIES`.
    """
    text = " ".join(text.split())
    return tuple(_condition(part, text) for part in _AND.split(text))


def _condition(part, text):
    pieces = [piece.strip() for piece in _COMPARISON.split(part, maxsplit=1)]
    if len(pieces) < 3 or not all(pieces):
        raise ThinPartError(
            message("The condition {condition!r} is not understood: write a quantity, one of {comparisons} and a "
                    "number, as in 'D2/D3 > 6'.", condition=text, comparisons=", ".join(COMPARISONS)), "usage",
        )
    name, comparison, number = pieces
    try:
        value = float(number)
    except ValueError:
        value = math.nan
    if not math.isfinite(value):
        raise ThinPartError(message("{number!r} in the condition {condition!r} is not a number.",
                                    number=number, condition=text), "usage")
    try:
        quantity = next((number for number in RECORDED if number.name == name), None) or quantity_named(name)
    except KeyError:
        raise ThinPartError(
            message("There is no quantity {quantity!r} in the condition {condition!r}: there are {known}.",
                    quantity=name, condition=text,
                    known=", ".join([quantity_symbols(), *(number.name for number in RECORDED)])), "usage",
        ) from None
    return SearchCondition(quantity, comparison, value)


"""Conditions that people write down to search by: ``D2/D3 > 6 and F[0;0.05] >= 0.5``."""

import math
import re
from dataclasses import dataclass

from .descriptors import QUANTITIES, quantity_named
from .errors import ThinPartError

COMPARISONS = (">=", "<=", ">", "<")

_AND = re.compile(r"\s+and\s+|\s*[,&]+\s*", re.IGNORECASE)
_CONDITION = re.compile(r"^\s*(.+?)\s*(>=|<=|>|<)\s*(\S+)\s*$")


@dataclass(frozen=True)
class SearchCondition:
    """A quantity, one of `COMPARISONS`, and a value in the quantity's unit."""

    quantity: object
    comparison: str
    value: float


def search_conditions(text):
    """Read conditions that must all hold.

    Parameters
    ----------
    text : str
        One or several, joined by ``and``; quantities as in `descriptors.QUANTITIES`.

    Returns
    -------
    tuple of SearchCondition

    Raises
    ------
    ThinPartError
        kind ``usage``: one sentence that names what is not understood.
    """
    return tuple(_condition(part, text) for part in _AND.split(text.strip()))


def _condition(part, text):
    found = _CONDITION.match(part)
    if found is None:
        raise ThinPartError(
            f"The condition {text!r} is not understood: write a quantity, one of "
            f"{', '.join(COMPARISONS)} and a number, as in 'D2/D3 > 6'.", "usage",
        )
    name, comparison, number = found.groups()
    try:
        value = float(number)
    except ValueError:
        value = math.nan
    if not math.isfinite(value):
        raise ThinPartError(f"{number!r} in the condition {text!r} is not a number.", "usage")
    try:
        quantity = quantity_named(name)
    except KeyError:
        raise ThinPartError(
            f"There is no quantity {name!r} in the condition {text!r}: there are {_names()}.", "usage",
        ) from None
    return SearchCondition(quantity, comparison, value)


def _names():
    return ", ".join(f"{each.symbol}[a;b]" if each.bounds else each.symbol for each in QUANTITIES)

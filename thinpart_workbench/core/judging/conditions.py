"""Search conditions as users write them: ``D2/D3 > 6 and F[0;0.05] >= 0.5``."""

import math
import re
from dataclasses import dataclass

from ..descriptors.descriptor_table import quantity_named, quantity_symbols
from ..errors import ThinPartError
from ..message import message

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
    """Parse conditions that must all hold.

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
        kind ``usage``: one sentence that names the part that is not understood.
    """
    return tuple(_condition(part, text) for part in _AND.split(text.strip()))


def _condition(part, text):
    found = _CONDITION.match(part)
    if found is None:
        raise ThinPartError(
            message("The condition {condition!r} is not understood: write a quantity, one of {comparisons} and a "
                    "number, as in 'D2/D3 > 6'.", condition=text, comparisons=", ".join(COMPARISONS)), "usage",
        )
    name, comparison, number = found.groups()
    try:
        value = float(number)
    except ValueError:
        value = math.nan
    if not math.isfinite(value):
        raise ThinPartError(message("{number!r} in the condition {condition!r} is not a number.",
                                    number=number, condition=text), "usage")
    try:
        quantity = quantity_named(name)
    except KeyError:
        raise ThinPartError(
            message("There is no quantity {quantity!r} in the condition {condition!r}: there are {known}.",
                    quantity=name, condition=text, known=quantity_symbols()), "usage",
        ) from None
    return SearchCondition(quantity, comparison, value)


"""The unit in which people read and write lengths. Inside the program, everything is in millimetres."""

import re
from dataclasses import dataclass

from .number_text import bound_text, number, with_decimal_mark

_LENGTH_IN_TEXT = re.compile(r"(?<![\w.])(\d+(?:\.\d+)?(?:e[+-]?\d+)?)[ \u00a0]mm\b")


@dataclass(frozen=True)
class LengthUnit:
    """A unit of length.

    Attributes
    ----------
    symbol : str
        The same in every language.
    millimetres : float
        Length of one unit in mm.
    decimals : int
        Number of decimals in input fields for lengths: the last decimal is at most a few micrometres.
    decimal_mark : str
        That of the reader's language.
    """

    symbol: str
    millimetres: float
    decimals: int
    decimal_mark: str = "."

    def value(self, millimetres, power=1):
        """A length in this unit, for the powers 2 and 3 an area and a volume: float, None for None."""
        return None if millimetres is None else millimetres / self.millimetres ** power

    def number(self, millimetres):
        """A length in this unit without its symbol, with three significant digits; a dash for None."""
        return with_decimal_mark(number(self.value(millimetres)), self.decimal_mark)

    def text(self, millimetres):
        """A length in this unit with its symbol."""
        return self.with_symbol(self.number(millimetres))

    def bound_number(self, millimetres):
        """An error bound without its symbol; see `number_text.bound_text`."""
        return with_decimal_mark(bound_text(self.value(millimetres)), self.decimal_mark)

    def bound_text(self, millimetres):
        """An error bound with its symbol."""
        return self.with_symbol(self.bound_number(millimetres))

    def with_symbol(self, text):
        """One or several numbers, followed by the symbol."""
        return f"{text}\u00a0{self.symbol}"

    def convert_sentence(self, sentence):
        """A sentence with its lengths converted from millimetres to this unit, and all its numbers with the decimal mark."""
        if self.millimetres != 1.0:
            sentence = _LENGTH_IN_TEXT.sub(
                lambda match: self.with_symbol(number(self.value(float(match.group(1))))), sentence)
        return with_decimal_mark(sentence, self.decimal_mark)


MILLIMETRE = LengthUnit("mm", 1.0, 3)
INCH = LengthUnit("in", 25.4, 4)

UNITS = {unit.symbol: unit for unit in (MILLIMETRE, INCH)}
"""By their symbols, with a decimal point."""

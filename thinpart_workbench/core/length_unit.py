# SPDX-License-Identifier: LGPL-2.1-or-later
"""The unit in which people read and write lengths. Inside the program, everything is in millimetres."""

from dataclasses import dataclass

from .number_text import bound_text, number, with_decimal_mark


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

    def number(self, millimetres, digits=3):
        """A length in this unit without its symbol, with some significant digits; a dash for None."""
        return with_decimal_mark(number(self.value(millimetres), digits), self.decimal_mark)

    def text(self, millimetres, digits=3):
        """A length in this unit with its symbol."""
        return self.with_symbol(self.number(millimetres, digits))

    def bound_number(self, millimetres):
        """An error bound without its symbol; see `number_text.bound_text`."""
        return with_decimal_mark(bound_text(self.value(millimetres)), self.decimal_mark)

    def bound_text(self, millimetres):
        """An error bound with its symbol."""
        return self.with_symbol(self.bound_number(millimetres))

    def with_symbol(self, text):
        """One or several numbers, followed by the symbol."""
        return f"{text}\u00a0{self.symbol}"


MILLIMETRE = LengthUnit("mm", 1.0, 3)
INCH = LengthUnit("in", 25.4, 4)

UNITS = {unit.symbol: unit for unit in (MILLIMETRE, INCH)}
"""By their symbols, with a decimal point."""

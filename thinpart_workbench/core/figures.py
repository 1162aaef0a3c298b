# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures in sentences, which are written in the unit and with the decimal mark of whoever reads them."""

import re
from abc import ABC, abstractmethod
from dataclasses import dataclass
from typing import ClassVar, Optional, Union

from .length_unit import MILLIMETRE, LengthUnit
from .number_text import percent, with_decimal_mark

_DIGITS = re.compile(r"\.(\d)g?")


@dataclass(frozen=True)
class Figure(ABC):
    """Something that is measured; base class of its kinds.

    Formatted, as in a template, it is in English and in millimetres. The format says the significant digits of a length:
    ``{error:.2g}``.

    Attributes
    ----------
    value : float or None
    """

    value: Optional[float]

    key: ClassVar[str] = ""
    """In JSON, a figure is an object with its value under this key."""

    def __post_init__(self):
        if self.value is not None:
            object.__setattr__(self, "value", float(self.value))  # numpy types, which JSON cannot write

    @abstractmethod
    def text(self, unit, spec=""):
        """How it is written in a unit of lengths, with its decimal mark: str."""

    def __format__(self, spec):
        return self.text(MILLIMETRE, spec).replace("\u00a0mm", " mm")  # as info files and tables have it

    def data(self):
        """dict for JSON; see `figure_from`."""
        return {self.key: self.value}


class Length(Figure):
    """A length, mm."""

    key = "mm"

    def text(self, unit, spec=""):
        digits = _DIGITS.fullmatch(spec)
        return unit.text(self.value, int(digits[1]) if digits else 3)


class Share(Figure):
    """A share of something, from 0 to 1, written as percent."""

    key = "share"

    def text(self, unit, spec=""):
        return with_decimal_mark(percent(self.value), unit.decimal_mark)


@dataclass(frozen=True)
class Plain:
    """A number without a unit, for a template."""

    value: Union[int, float]
    unit: LengthUnit

    def __format__(self, spec):
        text = format(self.value, spec)
        if self.unit.decimal_mark == ".":
            return text
        return with_decimal_mark(text.replace(",", "\u202f"), self.unit.decimal_mark)  # thousands


@dataclass(frozen=True)
class Written:
    """A figure in a unit of lengths, for a template."""

    figure: Figure
    unit: LengthUnit

    def __format__(self, spec):
        return self.figure.text(self.unit, spec)


def figure_from(data):
    """The figure whose `Figure.data` this is, any JSON value; None for anything else."""
    if isinstance(data, dict) and len(data) == 1:
        (key, value), = data.items()
        kind = next((kind for kind in (Length, Share) if kind.key == key), None)
        if kind is not None and (value is None or isinstance(value, (int, float)) and not isinstance(value, bool)):
            return kind(value)
    return None


def in_unit(value, unit):
    """What stands for a field in a template, so that it is written in a unit; a text stands for itself."""
    if isinstance(value, Figure):
        return Written(value, unit)
    return Plain(value, unit) if isinstance(value, (int, float)) and not isinstance(value, bool) else value

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Kinds of simple values in a JSON document: numbers, texts and so on.

Each kind states its rule once, as Python code: a fast check is compiled from it (`value_checker`), and the first invalid
value is found with it. The JSON schema has the same limits. Tests verify that the three agree.
"""

import math
import re
import sys
from abc import ABC, abstractmethod
from dataclasses import dataclass, field
from functools import cached_property

from .value_checker import Source, compiled

LARGEST = 1e36
"""Largest number that may also be stored as float32, whose range ends at about a hundred times that."""

LARGEST_WHOLE = 2 ** 53
"""Largest whole number: beyond it, programs that read numbers as floating point lose digits."""

LONGEST = 1_000_000
"""Greatest number of characters of a text."""

_SHOWN = 40
"""Number of characters of an invalid value that are shown."""

_LARGEST_FLOAT = sys.float_info.max


def is_plain(data):
    """Whether JSON data is at most `LONGEST` bytes of ASCII without escapes. Then every text in it can be written and is
    no longer than `LONGEST`, so that the texts need no check one by one.
    """
    return len(data) <= LONGEST and data.isascii() and b"\\" not in data


class Kind(ABC):
    """A definition of valid values.

    Attributes
    ----------
    about : str
        Description in the schema.
    meaning : str
        A few words that describe the kind.
    """

    about: str = ""

    @property
    @abstractmethod
    def meaning(self) -> str:
        """A few words that describe the kind."""

    @abstractmethod
    def condition(self, value, source):
        """Python expression for whether a variable is of this kind, whatever its entries are; an exception means that it is
        not.

        Parameters
        ----------
        value : str
            Name of the variable.
        source : value_checker.Source
        """

    def check_entries(self, value, source, depth):
        """Write the lines that return False if an entry of a variable is not as it should be.

        Parameters
        ----------
        value : str
            Name of the variable.
        source : value_checker.Source
        depth : int
            Indentation depth of the lines.
        """
        return None

    def entry_faults(self, value, path):
        """Explain what is wrong with the entries of a value: iterable of str or None; see `first_fault`."""
        return ()

    @abstractmethod
    def schema(self):
        """dict: JSON schema of the kind."""

    def check(self, value, source, depth):
        """Write the lines that return False if a variable is not of this kind; see `check_entries`."""
        source.require(depth, self.condition(value, source))
        self.check_entries(value, source, depth)

    @cached_property
    def holds(self):
        """callable: whether a value is of this kind. Compiled when it is first asked for."""
        return compiled(self.check, Source())

    @cached_property
    def holds_plain(self):
        """callable: as `holds`, for values from JSON data for which `is_plain` is true."""
        return compiled(self.check, Source(is_plain=True))

    @cached_property
    def _holds_without_entries(self):
        return compiled(lambda value, source, depth: source.require(depth, self.condition(value, source)), Source())

    def fault(self, value, path):
        """Explain what is wrong with a value: str or None.

        What is at the path and what should be; None if the value is of this kind.

        Parameters
        ----------
        value
        path : str
            Path of the value, such as ``parts[0].descriptors.box_mm``.
        """
        return None if self.holds(value) else self.first_fault(value, path)

    def first_fault(self, value, path):
        """As `fault`, without the fast check."""
        if not self._holds_without_entries(value):
            return f"{path} is {shown(value)}, not {self.meaning}"
        return next(filter(None, self.entry_faults(value, path)), None)

    def _described(self, schema):
        return {**schema, "description": self.about} if self.about else schema


@dataclass(frozen=True)
class Number(Kind):
    """A finite number, between optional bounds, both inclusive."""

    least: float = -math.inf
    most: float = math.inf
    about: str = field(default="", compare=False)

    _types = frozenset((int, float))

    @property
    def _bounds(self):
        return max(float(self.least), -_LARGEST_FLOAT), min(float(self.most), _LARGEST_FLOAT)

    def condition(self, value, source):
        least, most = self._bounds
        # In Python a bool is an int.
        return f"{least!r} <= {value} <= {most!r} and {value} is not True and {value} is not False"

    def condition_of_all(self, values, source):
        """As `condition`, for all entries of a list."""
        least, most = self._bounds
        typed = f"set(map(type, {values})) <= {source.name(self._types)}"
        ordered = f"{least!r} <= min({values}) and max({values}) <= {most!r}"
        # Neither least nor greatest need be NaN where another is, but the sum is.
        number = "" if self._types == {int} else f" and not {source.name(math.isnan)}(sum({values}))"
        return f"not {values} or {typed} and {ordered}{number}"

    @property
    def meaning(self):
        """str"""
        if (self.least, self.most) == (-math.inf, math.inf):
            return "a finite number"
        return f"a number from {self.least:g} to {self.most:g}"

    def schema(self):
        bounds = {"minimum": self.least, "maximum": self.most}
        return self._described({"type": "number", **{
            key: value for key, value in bounds.items() if math.isfinite(value)}})


@dataclass(frozen=True)
class Whole(Number):
    """A whole number between two bounds, both inclusive."""

    least: int = 0
    most: int = LARGEST_WHOLE
    about: str = field(default="", compare=False)

    _types = frozenset((int,))

    @property
    def _bounds(self):
        return self.least, self.most

    def condition(self, value, source):
        return f"{value}.__class__ is int and {self.least} <= {value} <= {self.most}"

    @property
    def meaning(self):
        """str"""
        return f"a whole number from {self.least} to {self.most}"

    def schema(self):
        return self._described({"type": "integer", "minimum": self.least, "maximum": self.most})


@dataclass(frozen=True)
class Text(Kind):
    """A text that can be written. It may hold undecodable bytes of file names, as surrogate escapes.

    Attributes
    ----------
    longest : int
        Greatest number of characters.
    pattern : str
        Regular expression for the full text; empty for any text.
    meaning : str
    """

    longest: int = LONGEST
    pattern: str = ""
    meaning: str = "a text that can be written"
    about: str = field(default="", compare=False)

    def condition(self, value, source):
        # A Message is a str as well. Most texts are none, and comparing the class is faster than isinstance.
        conditions = [f"({value}.__class__ is str or isinstance({value}, str))"]
        if not source.is_plain:
            conditions.append(f"({value}.isascii() or {source.name(_can_be_written)}({value}))")
        if not source.is_plain or self.longest < LONGEST:
            conditions.append(f"len({value}) <= {self.longest}")
        if self.pattern:
            conditions.append(f"{source.name(re.compile(self.pattern).fullmatch)}({value})")
        return " and ".join(conditions)

    def schema(self):
        pattern = {"pattern": f"^{self.pattern}$"} if self.pattern else {}
        return self._described({"type": "string", "maxLength": self.longest, **pattern})


@dataclass(frozen=True)
class Flag(Kind):
    """True or false."""

    meaning: str = "true or false"
    about: str = field(default="", compare=False)

    def condition(self, value, source):
        return f"{value} is True or {value} is False"

    def schema(self):
        return self._described({"type": "boolean"})


@dataclass(frozen=True)
class OneOf(Kind):
    """One of a few texts, or of a few whole numbers."""

    values: tuple
    about: str = field(default="", compare=False)

    def condition(self, value, source):
        return f"{value}.__class__ is {type(self.values[0]).__name__} and {value} in {self.values!r}"

    @property
    def meaning(self):
        """str"""
        return " or ".join(map(shown, self.values))

    def schema(self):
        values = {"enum": list(self.values)} if len(self.values) > 1 else {"const": self.values[0]}
        return self._described(values)


@dataclass(frozen=True)
class Either(Kind):
    """One of two kinds that have no entries."""

    first: Kind
    second: Kind
    about: str = field(default="", compare=False)

    def condition(self, value, source):
        return f"{self.first.condition(value, source)} or {self.second.condition(value, source)}"

    @property
    def meaning(self):
        """str"""
        return f"{self.first.meaning} or {self.second.meaning}"

    def schema(self):
        return self._described({"oneOf": [self.first.schema(), self.second.schema()]})


@dataclass(frozen=True)
class OrNull(Kind):
    """A kind, or null where the value is not known."""

    kind: Kind
    about: str = field(default="", compare=False)

    def condition(self, value, source):
        return f"{value} is None or {self.kind.condition(value, source)}"

    def check(self, value, source, depth):
        source.line(depth, f"if {value} is not None:")
        self.kind.check(value, source, depth + 1)

    @property
    def meaning(self):
        """str"""
        return self.kind.meaning

    def first_fault(self, value, path):
        return None if value is None else self.kind.first_fault(value, path)

    def schema(self):
        return self._described({"oneOf": [{"type": "null"}, self.kind.schema()]})


def _can_be_written(text):
    """Whether a text can be encoded, with undecodable bytes of file names as surrogate escapes (PEP 383)."""
    try:
        text.encode("utf-8", "surrogateescape")
    except UnicodeEncodeError:
        return False
    return True


def shown(value):
    """Describe a value for people: shortened if it is long, and for an object or list only its type."""
    if isinstance(value, dict):
        return "an object"
    if isinstance(value, list):
        return f"a list of {len(value)}"
    if value is None or isinstance(value, bool):
        return {None: "null", True: "true", False: "false"}[value]
    if isinstance(value, int) and abs(value) > LARGEST_WHOLE:
        return "a number of too many digits"
    text = ascii(value)
    return text if len(text) <= _SHOWN else text[:_SHOWN] + "..."

"""Kinds of simple values in a JSON document: numbers, texts and so on.

Each kind defines its values in three ways: as Python code for a fast check (`value_checker`), as a sentence about the
first invalid value, and as JSON schema. Tests verify that the three agree.
"""

import math
import re
import sys
from abc import ABC, abstractmethod
from dataclasses import dataclass, field

LARGEST = 1e36
"""Largest number that may also be stored as float32, whose range ends at about a hundred times that."""

LARGEST_WHOLE = 2 ** 53
"""Largest whole number: beyond it, programs that read numbers as floating point lose digits."""

LONGEST = 1_000_000
"""Greatest number of characters of a text."""

_SHOWN = 40
"""Number of characters of an invalid value that are shown."""

_LARGEST_FLOAT = sys.float_info.max
_NUMBERS, _WHOLE = frozenset((int, float)), frozenset((int,))


class Kind(ABC):
    """A definition of valid values.

    Attributes
    ----------
    about : str
        Description in the schema.
    """

    about: str

    @abstractmethod
    def check(self, value, source, depth):
        """Write the lines that return False if a variable is not of this kind.

        Parameters
        ----------
        value : str
            Name of the variable.
        source : value_checker.Source
        depth : int
            Indentation depth of the lines.
        """

    @abstractmethod
    def fault(self, value, path):
        """Explain what is wrong with a value.

        Parameters
        ----------
        value
        path : str
            Path of the value, such as ``parts[0].descriptors.box_mm``.

        Returns
        -------
        str or None
            What is at the path and what should be; None if the value is of this kind.
        """

    @abstractmethod
    def schema(self):
        """dict: JSON schema of the kind."""

    def _described(self, schema):
        return {**schema, "description": self.about} if self.about else schema


class SimpleKind(Kind):
    """A kind that one Python expression can check."""

    @property
    @abstractmethod
    def meaning(self) -> str:
        """A few words that describe the kind."""

    @abstractmethod
    def condition(self, value, source):
        """Python expression for whether a variable is of this kind; an exception means that it is not.

        Parameters
        ----------
        value : str
            Name of the variable.
        source : value_checker.Source
        """

    @abstractmethod
    def holds(self, value):
        """Whether a value is of this kind."""

    def check(self, value, source, depth):
        source.line(depth, f"if not ({self.condition(value, source)}): return False")

    def fault(self, value, path):
        return None if self.holds(value) else f"{path} is {shown(value)}, not {self.meaning}"


@dataclass(frozen=True)
class Number(SimpleKind):
    """A finite number, between optional bounds, both inclusive."""

    least: float = -math.inf
    most: float = math.inf
    about: str = field(default="", compare=False)

    def condition(self, value, source):
        least, most = self._bounds()
        # In Python a bool is an int.
        return f"{least!r} <= {value} <= {most!r} and {value} is not True and {value} is not False"

    def all_hold(self, values):
        """Whether all values of a non-empty list are of this kind."""
        least, most = self._bounds()
        return set(map(type, values)) <= _NUMBERS and least <= min(values) and max(values) <= most

    def holds(self, value):
        least, most = self._bounds()
        return type(value) in _NUMBERS and least <= value <= most

    def _bounds(self):
        return max(self.least, -_LARGEST_FLOAT), min(self.most, _LARGEST_FLOAT)

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
class Whole(SimpleKind):
    """A whole number between two bounds, both inclusive."""

    least: int = 0
    most: int = LARGEST_WHOLE
    about: str = field(default="", compare=False)

    def condition(self, value, source):
        return f"{value}.__class__ is int and {self.least} <= {value} <= {self.most}"

    def all_hold(self, values):
        """Whether all values of a non-empty list are of this kind."""
        if 1 < self.least and self.most < 256:
            # Seven times as fast. Excludes bools, too: they would become 0 or 1.
            return not bytes(values).translate(None, bytes(range(self.least, self.most + 1)))
        return set(map(type, values)) == _WHOLE and self.least <= min(values) and max(values) <= self.most

    def holds(self, value):
        return type(value) is int and self.least <= value <= self.most

    @property
    def meaning(self):
        """str"""
        return f"a whole number from {self.least} to {self.most}"

    def schema(self):
        return self._described({"type": "integer", "minimum": self.least, "maximum": self.most})


@dataclass(frozen=True)
class Text(SimpleKind):
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

    def holds(self, value):
        return (isinstance(value, str) and _can_be_written(value) and len(value) <= self.longest
                and (not self.pattern or re.fullmatch(self.pattern, value) is not None))

    def schema(self):
        pattern = {"pattern": f"^{self.pattern}$"} if self.pattern else {}
        return self._described({"type": "string", "maxLength": self.longest, **pattern})


@dataclass(frozen=True)
class Flag(SimpleKind):
    """True or false."""

    meaning: str = "true or false"
    about: str = field(default="", compare=False)

    def condition(self, value, source):
        return f"{value} is True or {value} is False"

    def holds(self, value):
        return value is True or value is False

    def schema(self):
        return self._described({"type": "boolean"})


@dataclass(frozen=True)
class OneOf(SimpleKind):
    """One of a few texts, or of a few whole numbers."""

    values: tuple
    about: str = field(default="", compare=False)

    def condition(self, value, source):
        return f"{value}.__class__ is {type(self.values[0]).__name__} and {value} in {self.values!r}"

    def holds(self, value):
        return type(value) is type(self.values[0]) and value in self.values

    @property
    def meaning(self):
        """str"""
        return " or ".join(map(shown, self.values))

    def schema(self):
        values = {"enum": list(self.values)} if len(self.values) > 1 else {"const": self.values[0]}
        return self._described(values)


@dataclass(frozen=True)
class Either(SimpleKind):
    """One of two kinds that have simple values."""

    first: SimpleKind
    second: SimpleKind
    about: str = field(default="", compare=False)

    def condition(self, value, source):
        return f"{self.first.condition(value, source)} or {self.second.condition(value, source)}"

    def holds(self, value):
        return self.first.holds(value) or self.second.holds(value)

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

    def check(self, value, source, depth):
        source.line(depth, f"if {value} is not None:")
        self.kind.check(value, source, depth + 1)

    def fault(self, value, path):
        return None if value is None else self.kind.fault(value, path)

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

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Kinds of lists and objects, composed of other kinds up to the definition of a document."""

import marshal
from dataclasses import dataclass, field
from functools import cached_property

from .value_kinds import LONGEST, Kind, Number, Text, shown

DEEPEST = 32
"""Greatest depth of values that are not defined in detail, such as mesh settings."""

_WITHOUT_REFERENCES = 2
"""Version of marshal's format in which equal values have equal bytes."""


@dataclass(frozen=True)
class ListOf(Kind):
    """A list of one kind.

    Attributes
    ----------
    kind : Kind
    least, most : int
        Least and greatest number of entries.
    distinct : str
        Key whose value must differ between entries that are objects; empty if none must.
    """

    kind: Kind
    least: int = 0
    most: int = 10_000_000
    distinct: str = ""
    about: str = field(default="", compare=False)

    def condition(self, value, source):
        return f"{value}.__class__ is list and {self.least} <= len({value}) <= {self.most}"

    def check_entries(self, value, source, depth):
        if self.least == self.most <= 3:
            entries = [source.variable() for _ in range(self.most)]
            source.line(depth, f"{', '.join(entries)}, = {value}")
            for entry in entries:
                self.kind.check(entry, source, depth)
        elif isinstance(self.kind, Number):
            source.require(depth, self.kind.condition_of_all(value, source))
        else:
            entry = source.variable()
            source.line(depth, f"for {entry} in {value}:")
            self.kind.check(entry, source, depth + 1)
        if self.distinct:
            source.require(depth, f"{source.name(self._twice)}({value}) is None")

    def _twice(self, entries):
        """The name that two entries have in common, or None."""
        seen = set()
        for entry in entries:
            name = entry[self.distinct]
            if name in seen:
                return name
            seen.add(name)
        return None

    @property
    def meaning(self):
        """str"""
        if self.least == self.most:
            return f"a list of {self.most}"
        return f"a list of {self.least} to {self.most}"

    def entry_faults(self, value, path):
        for number, entry in enumerate(value):
            yield self.kind.first_fault(entry, f"{path}[{number}]")
        twice = self._twice(value) if self.distinct else None
        yield None if twice is None else f"{path} has {shown(twice)} twice"

    def schema(self):
        return self._described({"type": "array", "items": self.kind.schema(),
                                "minItems": self.least, "maxItems": self.most})


@dataclass(frozen=True)
class Row(Kind):
    """A list of fixed length with a kind for each entry."""

    kinds: tuple
    about: str = field(default="", compare=False)

    def condition(self, value, source):
        return f"{value}.__class__ is list and len({value}) == {len(self.kinds)}"

    def check_entries(self, value, source, depth):
        entries = [source.variable() for _ in self.kinds]
        source.line(depth, f"{', '.join(entries)}, = {value}")
        for kind, entry in zip(self.kinds, entries):
            kind.check(entry, source, depth)

    @property
    def meaning(self):
        """str"""
        return f"a list of {len(self.kinds)}"

    def entry_faults(self, value, path):
        return (kind.first_fault(entry, f"{path}[{number}]") for number, (kind, entry) in enumerate(zip(self.kinds, value)))

    def schema(self):
        # Versions of JSON schema differ in how they give each entry its own kind.
        kinds = [kind.schema() for kind in dict.fromkeys(self.kinds)]
        return self._described({"type": "array", "items": {"anyOf": kinds},
                                "minItems": len(self.kinds), "maxItems": len(self.kinds)})


@dataclass(frozen=True)
class Anything(Kind):
    """Any JSON value, no deeper than `DEEPEST`, without numbers and texts that cannot be written.

    Attributes
    ----------
    longest : int
        Greatest number of characters of a text in it.
    """

    longest: int = LONGEST
    meaning: str = "what can be written"

    def condition(self, value, source):
        return f"{source.name(self._can_be_written)}({value}, {source.name(Text(self.longest).holds)})"

    def _can_be_written(self, value, is_text, levels=DEEPEST):
        if isinstance(value, dict):
            return levels > 0 and all(map(is_text, value)) and all(
                self._can_be_written(item, is_text, levels - 1) for item in value.values())
        if isinstance(value, list):
            return levels > 0 and all(self._can_be_written(item, is_text, levels - 1) for item in value)
        return value is None or isinstance(value, bool) or is_text(value) or _NUMBER.holds(value)

    def schema(self):
        return {}


_TEXT, _NUMBER, ANYTHING = Text(), Number(), Anything()


@dataclass(frozen=True, eq=False)
class Record(Kind):
    """An object with a kind for each key.

    Other keys are allowed and preserved, since a later version may have written them.

    Attributes
    ----------
    required : dict of str to Kind
    optional : dict of str to Kind
        Keys that may be missing.
    later : dict of str to Kind
        Optional keys that are always written; earlier versions did not have them.
    alike : tuple of str
        Keys of lists that must have the same length.
    choice : tuple of str
        Optional keys of which exactly one must be there.
    is_open : bool
        Whether other keys than these may be written.
    """

    required: dict
    optional: dict = field(default_factory=dict)
    later: dict = field(default_factory=dict)
    alike: tuple = ()
    choice: tuple = ()
    is_open: bool = False
    about: str = ""
    meaning: str = "an object"

    @cached_property
    def kinds(self):
        """dict of str to Kind: of all keys."""
        return {**self.required, **self.optional, **self.later}

    def condition(self, value, source):
        return f"{value}.__class__ is dict"

    def check_entries(self, value, source, depth):
        count = str(len(self.required))
        for key, kind in self.kinds.items():
            entry, inner = source.variable(), depth
            if key not in self.required:
                count += f" + ({key!r} in {value})"
                source.line(depth, f"if {key!r} in {value}:")
                inner += 1
            source.line(inner, f"{entry} = {value}[{key!r}]")
            kind.check(entry, source, inner)
        source.require(depth, f"len({value}) == {count} or {source.name(self._others_hold)}({value})")
        for holds, _ in self._rules():
            source.require(depth, f"{source.name(holds)}({value})")

    def _others_hold(self, value):
        return ANYTHING.holds(self._others(value))

    def _others(self, value):
        return {key: value[key] for key in value if key not in self.kinds}

    def _rules(self):
        """Functions that an object with valid entries must satisfy, and what is wrong where it does not."""
        if self.alike:
            yield (lambda value: len({len(value[key]) for key in self.alike}) == 1), "lists of different lengths"
        if self.choice:
            named = " and ".join(self.choice)
            yield (lambda value: sum(key in value for key in self.choice) == 1), f"not just one of {named}"

    def entry_faults(self, value, path):
        prefix = path and f"{path}."
        for key, kind in self.kinds.items():
            if key in value:
                yield kind.first_fault(value[key], prefix + key)
            elif key in self.required:
                yield f"{prefix}{key} is missing"
        for key, other in self._others(value).items():
            # Together with its key, which adds the level of depth that the object has.
            if not ANYTHING.holds({key: other}):
                yield f"{prefix}{ascii(key)[1:-1]} is {shown(other)}, not {ANYTHING.meaning}"
        for holds, fault in self._rules():
            yield None if holds(value) else f"{path} has {fault}"

    def schema(self):
        """JSON schema of what is written. Files that are read may have more keys and lack later ones."""
        choice = {"oneOf": [{"required": [key]} for key in self.choice]} if self.choice else {}
        return self._described({
            "type": "object", **choice,
            "properties": {key: kind.schema() for key, kind in self.kinds.items()},
            "required": [*self.required, *self.later],
            "additionalProperties": self.is_open,
        })


@dataclass(frozen=True)
class MapOf(Kind):
    """An object with any keys, whose values are all of one kind."""

    kind: Kind
    about: str = ""
    meaning: str = "an object"

    def condition(self, value, source):
        return f"{value}.__class__ is dict"

    def check_entries(self, value, source, depth):
        key, entry = source.variable(), source.variable()
        source.line(depth, f"for {key}, {entry} in {value}.items():")
        _TEXT.check(key, source, depth + 1)
        self.kind.check(entry, source, depth + 1)

    def entry_faults(self, value, path):
        for key, entry in value.items():
            yield self.kind.first_fault(entry, f"{path}.{ascii(key)[1:-1]}") if _TEXT.holds(key) else (
                f"{path} has the key {shown(key)}, not {_TEXT.meaning}")

    def schema(self):
        return self._described({"type": "object", "additionalProperties": self.kind.schema()})


class Known(Kind):
    """A kind that remembers the last valid value, for values that repeat, such as the profile in a library's files."""

    def __init__(self, kind):
        self._kind, self._last, self._last_data = kind, None, None

    @property
    def meaning(self):
        return self._kind.meaning

    def condition(self, value, source):
        return f"{source.name(self._is_valid)}({value})"

    def _is_valid(self, value):
        # Equal is not enough: false equals 0.
        if type(value) is dict and value == self._last and marshal.dumps(value, _WITHOUT_REFERENCES) == self._last_data:
            return True
        if not self._kind.holds(value):
            return False
        self._last = self._last_data = None
        if type(value) is dict:
            self._last, self._last_data = value, marshal.dumps(value, _WITHOUT_REFERENCES)
        return True

    def first_fault(self, value, path):
        return self._kind.first_fault(value, path)

    def schema(self):
        return self._kind.schema()

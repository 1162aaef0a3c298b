"""Kinds of lists and objects, composed of other kinds up to the definition of a document."""

import marshal
from dataclasses import dataclass, field

from .value_checker import checker
from .value_kinds import LONGEST, Kind, Number, SimpleKind, Text, shown

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

    def check(self, value, source, depth):
        source.line(depth, f"if not ({value}.__class__ is list and {self.least} <= len({value}) <= {self.most}): "
                    "return False")
        if self.least == self.most <= 3:
            entries = [source.variable() for _ in range(self.most)]
            source.line(depth, f"{', '.join(entries)}, = {value}")
            for entry in entries:
                self.kind.check(entry, source, depth)
        elif hasattr(self.kind, "all_hold"):
            source.line(depth, f"if {value} and not {source.name(self.kind.all_hold)}({value}): return False")
        else:
            entry = source.variable()
            source.line(depth, f"for {entry} in {value}:")
            self.kind.check(entry, source, depth + 1)
        if self.distinct:
            source.line(depth, f"if {source.name(self._twice)}({value}) is not None: return False")

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

    def fault(self, value, path):
        if type(value) is not list or not self.least <= len(value) <= self.most:
            return f"{path} is {shown(value)}, not {self.meaning}"
        faults = (self.kind.fault(entry, f"{path}[{number}]") for number, entry in enumerate(value))
        found = next(filter(None, faults), None)
        twice = self._twice(value) if self.distinct and not found else None
        return found if twice is None else f"{path} has {shown(twice)} twice"

    def schema(self):
        return self._described({"type": "array", "items": self.kind.schema(),
                                "minItems": self.least, "maxItems": self.most})


@dataclass(frozen=True)
class Row(Kind):
    """A list of fixed length with a kind for each entry."""

    kinds: tuple
    about: str = field(default="", compare=False)

    def check(self, value, source, depth):
        entries = [source.variable() for _ in self.kinds]
        source.line(depth, f"if {value}.__class__ is not list: return False")
        source.line(depth, f"{', '.join(entries)}, = {value}")
        for kind, entry in zip(self.kinds, entries):
            kind.check(entry, source, depth)

    @property
    def meaning(self):
        """str"""
        return f"a list of {len(self.kinds)}"

    def fault(self, value, path):
        if type(value) is not list or len(value) != len(self.kinds):
            return f"{path} is {shown(value)}, not {self.meaning}"
        faults = (kind.fault(entry, f"{path}[{number}]")
                  for number, (kind, entry) in enumerate(zip(self.kinds, value)))
        return next(filter(None, faults), None)

    def schema(self):
        # Versions of JSON schema differ in how they give each entry its own kind.
        kinds = [kind.schema() for kind in dict.fromkeys(self.kinds)]
        return self._described({"type": "array", "items": {"anyOf": kinds},
                                "minItems": len(self.kinds), "maxItems": len(self.kinds)})


class Anything(SimpleKind):
    """Any JSON value, no deeper than `DEEPEST`, without numbers and texts that cannot be written.

    Parameters
    ----------
    longest : int, optional
        Greatest number of characters of a text in it.
    """

    meaning = "what can be written"
    about = ""

    def __init__(self, longest=LONGEST):
        self._text = Text(longest=longest)

    def condition(self, value, source):
        return f"{source.name(self.holds)}({value})"

    def holds(self, value, levels=DEEPEST):
        if isinstance(value, dict):
            return levels > 0 and all(map(self._text.holds, value)) and all(
                self.holds(item, levels - 1) for item in value.values())
        if isinstance(value, list):
            return levels > 0 and all(self.holds(item, levels - 1) for item in value)
        return value is None or isinstance(value, bool) or self._text.holds(value) or _NUMBER.holds(value)

    def schema(self):
        return {}


_TEXT, _NUMBER, ANYTHING = Text(), Number(), Anything()


class Record(Kind):
    """An object with a kind for each key.

    Other keys are allowed and preserved, since a later version may have written them.

    Parameters
    ----------
    required : dict of str to Kind
    optional : dict of str to Kind, optional
        Keys that may be missing.
    later : dict of str to Kind, optional
        Optional keys that are always written; earlier versions did not have them.
    alike : tuple of str, optional
        Keys of lists that must have the same length.
    choice : tuple of str, optional
        Optional keys of which exactly one must be there.
    is_open : bool, optional
        Whether other keys than these may be written.
    about : str, optional
    """

    meaning = "an object"

    def __init__(self, required, optional=None, later=None, alike=(), choice=(), is_open=False, about=""):
        self._required, self._later = dict(required), dict(later or {})
        self._optional = {**(optional or {}), **self._later}
        self._kinds = {**self._required, **self._optional}
        self._alike, self._choice, self._is_open, self.about = alike, choice, is_open, about

    @property
    def required(self):
        """dict of str to Kind: keys that are always there."""
        return dict(self._required)

    @property
    def optional(self):
        """dict of str to Kind: keys that may be missing, including those that earlier versions did not write."""
        return dict(self._optional)

    def check(self, value, source, depth):
        source.line(depth, f"if {value}.__class__ is not dict: return False")
        variables = {key: source.variable() for key in self._kinds}
        for key, kind in self._required.items():
            source.line(depth, f"{variables[key]} = {value}[{key!r}]")
            kind.check(variables[key], source, depth)
        count = str(len(self._required))
        for key, kind in self._optional.items():
            source.line(depth, f"if {key!r} in {value}:")
            source.line(depth + 1, f"{variables[key]} = {value}[{key!r}]")
            kind.check(variables[key], source, depth + 1)
            count += f" + ({key!r} in {value})"
        source.line(depth, f"if len({value}) != {count} and not {source.name(self._others_hold)}({value}): "
                    "return False")
        if self._alike:
            lengths = " == ".join(f"len({variables[key]})" for key in self._alike)
            source.line(depth, f"if not ({lengths}): return False")
        if self._choice:
            source.line(depth, f"if not {source.name(self._has_one)}({value}): return False")

    def _others_hold(self, value):
        return ANYTHING.holds(self._others(value))

    def _others(self, value):
        return {key: value[key] for key in value if key not in self._kinds}

    def _has_one(self, value):
        return sum(key in value for key in self._choice) == 1

    def fault(self, value, path):
        if type(value) is not dict:
            return f"{path} is {shown(value)}, not {self.meaning}"
        found = next(filter(None, self._faults(value, path and f"{path}.")), None)
        if found:
            return found
        if self._alike and len({len(value[key]) for key in self._alike}) > 1:
            return f"{path} has lists of different lengths"
        if self._choice and not self._has_one(value):
            return f"{path} has not just one of {' and '.join(self._choice)}"
        return None

    def _faults(self, value, prefix):
        for key, kind in self._kinds.items():
            if key in value:
                yield kind.fault(value[key], prefix + key)
            elif key in self._required:
                yield f"{prefix}{key} is missing"
        for key, other in self._others(value).items():
            # Together with its key, which adds the level of depth that the object has.
            if not ANYTHING.holds({key: other}):
                yield f"{prefix}{ascii(key)[1:-1]} is {shown(other)}, not {ANYTHING.meaning}"

    def schema(self):
        """JSON schema of what is written. Files that are read may have more keys and lack later ones."""
        choice = {"oneOf": [{"required": [key]} for key in self._choice]} if self._choice else {}
        return self._described({
            "type": "object", **choice,
            "properties": {key: kind.schema() for key, kind in self._kinds.items()},
            "required": [key for key in self._kinds if key in self._required or key in self._later],
            "additionalProperties": self._is_open,
        })


class MapOf(SimpleKind):
    """An object with any keys, whose values are all of one kind."""

    meaning = "an object"

    def __init__(self, kind, about=""):
        self._kind, self._check, self.about = kind, checker(kind), about

    def condition(self, value, source):
        return f"{source.name(self.holds)}({value})"

    def holds(self, value):
        return type(value) is dict and all(map(_TEXT.holds, value)) and all(map(self._check, value.values()))

    def fault(self, value, path):
        if type(value) is not dict:
            return f"{path} is {shown(value)}, not {self.meaning}"
        for key, entry in value.items():
            if not _TEXT.holds(key):
                return f"{path} has the key {shown(key)}, not {_TEXT.meaning}"
            fault = self._kind.fault(entry, f"{path}.{ascii(key)[1:-1]}")
            if fault:
                return fault
        return None

    def schema(self):
        return self._described({"type": "object", "additionalProperties": self._kind.schema()})


class Known(SimpleKind):
    """A kind that remembers the last valid value, for values that repeat, such as the profile in a library's files."""

    def __init__(self, kind):
        self._kind, self._check, self._last, self._last_data = kind, None, None, None
        self.about = ""

    @property
    def meaning(self):
        return self._kind.meaning

    def condition(self, value, source):
        return f"{source.name(self.holds)}({value})"

    def holds(self, value):
        # Equal is not enough: false equals 0.
        if type(value) is dict and value == self._last and marshal.dumps(value, _WITHOUT_REFERENCES) == self._last_data:
            return True
        if self._check is None:
            self._check = checker(self._kind)
        if not self._check(value):
            return False
        self._last = self._last_data = None
        if type(value) is dict:
            self._last, self._last_data = value, marshal.dumps(value, _WITHOUT_REFERENCES)
        return True

    def fault(self, value, path):
        return self._kind.fault(value, path)

    def schema(self):
        return self._kind.schema()

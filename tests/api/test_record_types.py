"""The types of records say just what the definition of info files says."""

from typing import Any, Optional, Union, get_type_hints

import pytest

from thinpart_workbench.core.kinds.compound_kinds import ListOf, Record, Row
from thinpart_workbench.core.kinds.value_kinds import Either, Flag, Number, OneOf, OrNull, Text, Whole
from thinpart_workbench.core.record import record_types
from thinpart_workbench.core.record.part_definition import FAILURE, PART
from thinpart_workbench.core.record.record_types import FailureRecord, PartRecord

SIMPLE = {Number: float, Whole: int, Text: str, Flag: bool}


def differences(kind, given, place):
    """What is otherwise in a type than in a kind: sentences."""
    if isinstance(kind, Record) and kind.required | kind.optional:
        if not hasattr(given, "__required_keys__"):
            return [f"{place} is {given}, no TypedDict"]
        found = []
        for word, keys, own in (("required", kind.required, given.__required_keys__),
                                ("optional", kind.optional, given.__optional_keys__)):
            found += [f"{place}: {key} is not alike {word}" for key in sorted(set(keys) ^ set(own))]
        hints = get_type_hints(given)
        for key, each in {**kind.required, **kind.optional}.items():
            if key in hints:
                found += differences(each, hints[key], f"{place}.{key}")
        return found
    if isinstance(kind, OrNull):
        inner = [each for each in getattr(given, "__args__", ()) if each is not type(None)]
        if len(inner) == 0 or given != Optional[Union[tuple(inner)]]:
            return [f"{place} is {given}, which is never None"]
        return differences(kind.kind, Union[tuple(inner)], place)
    if isinstance(kind, (ListOf, Row)):
        if getattr(given, "__origin__", None) is not list:
            return [f"{place} is {given}, no list"]
        kinds = [kind.kind] if isinstance(kind, ListOf) else kind.kinds
        return [each for inner in kinds for each in differences(inner, given.__args__[0], f"{place}[]")]
    expected = expected_type(kind)
    return [] if given == expected else [f"{place} is {given}, not {expected}"]


def expected_type(kind):
    if isinstance(kind, Record):
        return dict[str, Any]
    if isinstance(kind, Either):
        return Union[expected_type(kind.first), expected_type(kind.second)]
    if isinstance(kind, OneOf):
        return type(kind.values[0])
    return SIMPLE[type(kind)]


@pytest.mark.parametrize("kind, given", [(PART, PartRecord), (FAILURE, FailureRecord)])
def test_types_are_as_the_definition(kind, given):
    assert differences(kind, given, given.__name__) == []


def test_differences_are_found():
    one = Record({"a": Number(), "b": ListOf(OrNull(Whole())), "c": Record({"d": Text()})}, {"e": Flag()})

    text = record_types.TypedDict("text", {"d": str})
    maybe_text = record_types.TypedDict("maybe_text", {"d": Optional[str]})

    class _Right(record_types.TypedDict):
        a: float
        b: list[Optional[int]]
        c: text

    class Right(_Right, total=False):
        e: bool

    class Wrong(record_types.TypedDict):
        a: int
        b: list[int]
        c: maybe_text
        e: bool

    assert differences(one, Right, "part") == []
    assert differences(one, Wrong, "part") == [
        "part: e is not alike required", "part: e is not alike optional", "part.a is <class 'int'>, not <class 'float'>",
        "part.b[] is <class 'int'>, which is never None", f"part.c.d is {Optional[str]}, not <class 'str'>"]

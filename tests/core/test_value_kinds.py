# SPDX-License-Identifier: LGPL-2.1-or-later
"""The quick check, the sentence about a fault and the JSON schema of a definition say the same."""

import json
import math

import jsonschema
import made_library
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from thinpart_workbench.core.kinds.compound_kinds import ANYTHING, DEEPEST, Anything, Known, ListOf, MapOf, Record, Row
from thinpart_workbench.core.kinds.value_kinds import Either, Flag, Number, OneOf, OrNull, Text, Whole, is_plain
from thinpart_workbench.core.record.record_types import PART

KINDS = {
    "number": Number(), "share": Number(0, 1), "whole": Whole(), "text": Text(), "short": Text(3),
    "pattern": Text(pattern="[ab]*"), "flag": Flag(), "word": OneOf(("a", "b")), "bit": OneOf((0, 1)),
    "id": Either(Whole(-5, 5), Text()), "maybe": OrNull(Number(-1, 1)), "anything": ANYTHING,
    "map": MapOf(Number(-1, 1)), "longer": MapOf(Anything(longest=2_000_000)),
    "numbers": ListOf(Number(-2, 2)), "bins": ListOf(Whole(0, 9)), "angles": ListOf(Whole(10, 55)),
    "texts": ListOf(Text(), 1, 2), "point": ListOf(Number(), 3, 3), "row": Row((Number(1, 2), Flag())),
    "points": ListOf(ListOf(Number(), 3, 3), 2, 2), "known": Known(Record({"a": Number()})),
    "record": Record({"a": Number(), "b": Text()}, {"c": Flag()}, {"d": OrNull(Text())}),
    "alike": Record({"a": ListOf(Number()), "b": ListOf(Whole())}, alike=("a", "b")),
    "choice": Record({}, {"a": Text(), "b": Number()}, choice=("a", "b")),
    "distinct": ListOf(Record({"a": Text()}), distinct="a"),
}

simple = st.one_of(
    st.none(), st.booleans(), st.integers(-20, 60), st.sampled_from([10 ** 40, 10 ** 400, 2 ** 53, 2 ** 53 + 1]),
    st.floats(), st.sampled_from(["", "a", "b", "abc", "abcd", "\ud800", "\udcff", "\0", "ü"]))
values = st.recursive(simple, lambda inner: st.one_of(
    st.lists(inner, max_size=4), st.dictionaries(st.sampled_from(["a", "b", "c", "d", "e", "\ud800"]), inner,
                                                 max_size=4)), max_leaves=8)


def test_what_repeats_is_the_same_and_not_only_equal():
    check = Known(Record({"a": Number(), "b": Flag()})).holds
    assert check({"a": 0, "b": False}) and check({"a": 0, "b": False})
    assert not check({"a": False, "b": False}) and not check({"a": 0, "b": 0})


@pytest.mark.parametrize("name", KINDS)
@settings(max_examples=100, deadline=None)
@given(value=values)
def test_the_quick_check_holds_where_there_is_no_fault(name, value):
    kind = KINDS[name]
    fault = kind.first_fault(value, "here")
    assert kind.holds(value) == (fault is None) == (kind.fault(value, "here") is None), fault
    assert fault is None or fault.startswith("here") and len(fault) < 200
    try:
        text = json.dumps(value, ensure_ascii=False, allow_nan=False).encode()
    except ValueError:
        return
    if is_plain(text):
        assert kind.holds_plain(value) == (fault is None)
    if fault is None and name not in ("alike", "distinct", "known"):
        # What is read may have more keys than what is written.
        if not isinstance(value, dict) or set(value) >= {"a", "b", "d"} and set(value) <= set("abcd"):
            jsonschema.validate(value, kind.schema())


places = st.lists(st.integers(0, 10 ** 6), max_size=6)


@settings(max_examples=300, deadline=None)
@given(places, values)
def test_a_part_record_with_anything_anywhere(steps, value):
    record = made_library.record_of("plate")
    target, key = record, "name"
    for step in steps:
        keys = list(target) if isinstance(target, dict) else range(len(target))
        key = keys[step % len(keys)]
        if not isinstance(target[key], (dict, list)) or not target[key]:
            break
        target, key = target[key], 0 if isinstance(target[key], list) else next(iter(target[key]))
    target[key] = value
    assert PART.holds(record) == (PART.first_fault(record, "here") is None)


def test_what_is_wrong_is_said_with_its_place():
    record = made_library.record_of("plate")
    assert PART.fault(record, "parts[0]") is None
    record["descriptors"]["box_mm"][1] = -math.inf
    assert PART.fault(record, "parts[0]") == (
        "parts[0].descriptors.box_mm[1] is -inf, not a number from 0 to 1e+36")
    del record["descriptors"]["box_mm"]
    assert PART.fault(record, "parts[0]") == "parts[0].descriptors.box_mm is missing"


def test_levels_of_what_is_not_defined():
    deep = 1
    for _ in range(DEEPEST):
        deep = [deep]
    assert ANYTHING.holds(deep) and not ANYTHING.holds([deep])
    assert Record({}).holds({"x": deep[0]}) and not Record({}).holds({"x": deep})

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sentences that keep what they are made of: as text, as data, and as what another process says they are."""

import copy
import json
import pickle
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from thinpart_workbench.core.errors import ThinPartError
from thinpart_workbench.core.figures import Length, Share
from thinpart_workbench.core.length_unit import INCH, MILLIMETRE
from thinpart_workbench.core.message import (
    Message,
    from_data,
    in_other_words,
    joined,
    message,
    restored,
    to_data,
    with_messages,
)

EMPTY = message("{file} is empty (0 bytes).", file="a.step")
THIN = message("The wall is {wall} in {faces:,} faces.", wall=Length(1.23456), faces=12345)
ABOUT = message("{about}: {sentence}", about="Block", sentence=THIN)


def test_a_message_is_the_sentence():
    assert EMPTY == "a.step is empty (0 bytes)." and {EMPTY: 1}["a.step is empty (0 bytes)."] == 1
    assert THIN == "The wall is 1.23 mm in 12,345 faces."
    assert ABOUT == "Block: The wall is 1.23 mm in 12,345 faces."
    assert json.loads(json.dumps([EMPTY])) == ["a.step is empty (0 bytes)."]


def test_an_error_says_its_message():
    told = str(ThinPartError(EMPTY, "empty"))
    assert (told.template, told.fields) == ("{file} is empty (0 bytes).", {"file": "a.step"})


def test_what_an_exception_says_is_a_field():
    inner = ThinPartError(EMPTY, "empty")
    assert message("({problem})", problem=inner).fields["problem"].fields == {"file": "a.step"}
    assert message("({problem})", problem=ValueError("no number")).fields == {"problem": "no number"}


def test_fields_are_what_json_can_say(tmp_path):
    said = message("{a} {b} {c} {d} {e}", a=np.int64(3), b=np.float32(0.5), c=tmp_path, d=None, e=True)
    assert said == f"3 0.5 {tmp_path} None True"
    assert [type(each) for each in said.fields.values()] == [int, float, str, type(None), bool]


def test_a_field_is_missing():
    with pytest.raises(KeyError):
        message("{file} is empty.")


@pytest.mark.parametrize("change", [copy.deepcopy, lambda said: pickle.loads(pickle.dumps(said)),
                                    lambda said: from_data(json.loads(json.dumps(to_data(said))))])
@pytest.mark.parametrize("said", [EMPTY, THIN, ABOUT, joined([EMPTY, THIN, ABOUT])])
def test_a_copy_is_the_same(change, said):
    told = change(said)
    assert told == said and to_data(told) == to_data(said)


def test_several_in_one_text():
    assert joined([]) == "" and joined(["a.", "b."]) == "a. b." and joined([EMPTY]) is EMPTY
    assert joined([EMPTY, THIN]) == f"{EMPTY} {THIN}" and joined([EMPTY, THIN]).fields["next"] is THIN


def test_lines_have_messages_beside_their_sentences():
    content = {"parts": [{"warnings": [EMPTY, "plain"], "reason": ABOUT}], "failures": ({"message": EMPTY},)}
    line = json.loads(json.dumps(with_messages(content)))
    assert line.pop("messages") == [to_data(EMPTY), to_data(ABOUT)]
    assert line == json.loads(json.dumps(content))
    told = restored(json.loads(json.dumps(with_messages(content))))
    assert "messages" not in told and told == line
    assert told["parts"][0]["reason"].fields["sentence"].fields == {"wall": Length(1.23456), "faces": 12345}
    assert isinstance(told["failures"][0]["message"], Message)
    assert not isinstance(told["parts"][0]["warnings"][1], Message)


def test_a_line_without_messages_is_as_it_was():
    content = {"done": True, "record": {"warnings": ["plain"]}}
    assert with_messages(content) is content and restored(content) is content


@pytest.mark.parametrize("line", [None, 3, [], "x", {"messages": 7, "a": "x"}, {"messages": [None, {}], "a": "x"}])
def test_lines_of_any_kind_are_taken(line):
    assert restored(line) == ({"a": "x"} if isinstance(line, dict) else line)


@pytest.mark.parametrize("data", [
    None, 3, "x", [], {}, {"template": "x"}, {"template": 3, "fields": {}}, {"template": "x", "fields": []},
    {"template": "{a", "fields": {"a": 1}}, {"template": "{}", "fields": {}}, {"template": "{0}", "fields": {"0": 1}},
    {"template": "{a}", "fields": {}}, {"template": "{a}", "fields": {"a": [1]}},
    {"template": "{a}", "fields": {"a": {}}},
    {"template": "{a.__class__}", "fields": {"a": 1}}, {"template": "{a[0]}", "fields": {"a": "x"}},
    {"template": "{a:999999999}", "fields": {"a": 1}}, {"template": "{a:.999999999f}", "fields": {"a": 1.0}},
    {"template": "{a:{b}}", "fields": {"a": 1, "b": 9}}, {"template": "{a:.3g}", "fields": {"a": "x"}},
    {"template": "{a:.3g}", "fields": {"a": 10**400}}, {"template": "{a}", "fields": {"a": {"mm": 10**400}}},
    {"template": "{a}", "fields": {"a": {"mm": "3"}}}, {"template": "{a}", "fields": {"a": {"mm": 3, "share": 1}}},
    {"template": "{a}" * 21, "fields": {"a": "x"}}, {"template": "{a}{a}", "fields": {"a": "x" * 150_000}}])
def test_what_is_no_message_is_none(data):
    assert from_data(data) is None


def test_messages_within_messages_have_an_end():
    data = {"template": "x", "fields": {}}
    for _ in range(10_000):
        data = {"template": "{a}", "fields": {"a": data}}
    assert from_data(data) is None


# -- figures

GERMAN_INCH = replace(INCH, decimal_mark=",")
NAMED = message("{part}, {wall} thick, give or take {error:.2g}, on {share} of {faces:,} faces, {angle:g} degrees: {about}",
                part="lid 3 mm.step", wall=Length(3.0), error=Length(0.12345), share=Share(0.0125), faces=12345, angle=2.5,
                about=message("{wall} in lid 3.5 mm of v1.2", wall=Length(1234.5)))


def _as_it_is(text):
    return text


def _shown(unit, look_up=_as_it_is):
    """What a reader sees after the message went to another process."""
    line = json.loads(json.dumps(with_messages({"warnings": [NAMED]})))
    told, = restored(line)["warnings"]
    assert isinstance(told, Message) and to_data(told) == to_data(NAMED)
    return in_other_words(told, look_up, unit).replace("\u00a0", " ")


def test_figures_are_in_millimetres_in_english():
    assert NAMED.replace("\u00a0", " ") == ("lid 3 mm.step, 3 mm thick, give or take 0.12 mm, on 1.2 % of 12,345 faces, "
                                            "2.5 degrees: 1234 mm in lid 3.5 mm of v1.2")
    assert "3 mm thick" in NAMED, "as before: with a plain space"


@pytest.mark.parametrize("unit, seen", [
    (MILLIMETRE, "lid 3 mm.step, 3 mm thick, give or take 0.12 mm, on 1.2 % of 12,345 faces, 2.5 degrees: 1234 mm in "
                 "lid 3.5 mm of v1.2"),
    (INCH, "lid 3 mm.step, 0.118 in thick, give or take 0.0049 in, on 1.2 % of 12,345 faces, 2.5 degrees: 48.6 in in "
           "lid 3.5 mm of v1.2"),
    (GERMAN_INCH, "lid 3 mm.step, 0,118 in thick, give or take 0,0049 in, on 1,2 % of 12\u202f345 faces, 2,5 degrees: "
                  "48,6 in in lid 3.5 mm of v1.2")])
def test_figures_are_in_the_unit_of_the_reader_and_names_stay_as_they_are(unit, seen):
    assert _shown(unit) == seen


def test_a_translation_has_the_same_figures():
    german = {NAMED.template: "{wall} ({error:.2g}, {share}) bei {part}: {about}", "{wall} in lid 3.5 mm of v1.2": "{wall}!"}
    assert _shown(GERMAN_INCH, lambda text: german.get(text, text)) == (
        "0,118 in (0,0049 in, 1,2 %) bei lid 3 mm.step: 48,6 in!")


def test_what_an_earlier_version_stored_has_its_lengths_and_its_names():
    stored = {
        "warnings": ["The lid 3 mm is 1.5e+05 mm across, give or take 0.12 mm.", "lid 3 mm.step has 2.5 mm."],
        "messages": [{"template": "The {part} is {mm:.3g} mm across, give or take {error:.2g} mm.",
                      "fields": {"part": "lid 3 mm", "mm": 150000.0, "error": 0.1234}}]}
    across, plain = restored(json.loads(json.dumps(stored)))["warnings"]
    assert across.template == "The {part} is {mm} across, give or take {error:.2g}."
    assert across.fields == {"part": "lid 3 mm", "mm": Length(150000.0), "error": Length(0.1234)}
    assert in_other_words(across, _as_it_is, INCH).replace("\u00a0", " ") == (
        "The lid 3 mm is 5906 in across, give or take 0.0049 in.")
    assert in_other_words(plain, _as_it_is, GERMAN_INCH) == plain, "nobody knows which of it is a name"


@given(st.text(max_size=40), st.sampled_from([MILLIMETRE, INCH, GERMAN_INCH]))
def test_no_text_is_rewritten(name, unit):
    for text in (name, f"{name} 3 mm", f"3.5 mm {name}.step", f"0.5 % {name} 1.25"):
        assert in_other_words(text, _as_it_is, unit) == text
        assert in_other_words(message("{name}", name=text), _as_it_is, unit) == text

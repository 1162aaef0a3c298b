# SPDX-License-Identifier: LGPL-2.1-or-later
"""The kinds that types of records stand for."""

import json
import subprocess
import sys
from pathlib import Path
from typing import Annotated, Any, NotRequired, Optional, TypedDict, Union

import pytest

from thinpart_workbench.core.kinds.compound_kinds import ListOf, Record
from thinpart_workbench.core.kinds.typed_kinds import LATER, Restricted, kind_of
from thinpart_workbench.core.kinds.value_kinds import Either, Flag, Number, OneOf, OrNull, Text, Whole

ROOT = Path(__file__).resolve().parents[2]

Share = Annotated[float, Number(0, 1)]


class Wall(TypedDict):
    name: str
    share: Optional[Annotated[Share, Restricted(about="of the surface")]]


class Base(TypedDict, total=False):
    note: str


class Part(Base):
    walls: Annotated[list[Wall], Restricted(most=3, distinct="name")]
    id: Union[Annotated[int, Whole(-5, 5)], str]
    kind: Annotated[str, OneOf(("a", "b"))]
    lists: Annotated[dict[str, list], Record({"x": ListOf(Number()), "y": ListOf(Flag())}), Restricted(alike=("x", "y"))]
    old: NotRequired[bool]
    new: NotRequired[Annotated[Optional[float], LATER]]


@pytest.mark.parametrize("given, kind", [
    (float, Number()), (int, Whole()), (str, Text()), (bool, Flag()), (Share, Number(0, 1)),
    (Optional[Share], OrNull(Number(0, 1))), (list[Optional[int]], ListOf(OrNull(Whole()))),
    (Union[int, str], Either(Whole(), Text())), (Annotated[Share, Restricted(most=2)], Number(0, 2)),
    (Optional[Union[int, str]], OrNull(Either(Whole(), Text()))),
])
def test_simple_types(given, kind):
    assert kind_of(given) == kind and kind_of(given).schema() == kind.schema()


def test_objects():
    kind = kind_of(Part)
    assert list(kind.required) == ["walls", "id", "kind", "lists"]
    assert list(kind.optional) == ["note", "old"] and list(kind.later) == ["new"]
    assert kind.schema()["required"] == ["walls", "id", "kind", "lists", "new"]
    assert kind.kinds["walls"].kind.kinds["share"].kind.about == "of the surface"
    assert kind_of(dict[str, Any]).holds({"x": [1, None]}) and kind_of(dict[str, Any]).schema()["additionalProperties"]


def test_limits_are_checked():
    kind = kind_of(Part)
    good = {"walls": [{"name": "x", "share": None}], "id": "p", "kind": "a", "lists": {"x": [1], "y": [True]}}
    assert kind.fault(good, "part") is None and kind.fault({**good, "note": "", "old": True, "new": None}, "part") is None
    for bad, fault in [
        ({"walls": [{"name": "x", "share": 2}]}, "part.walls[0].share is 2, not a number from 0 to 1"),
        ({"walls": [{"name": "x", "share": 0}] * 2}, "part.walls has 'x' twice"),
        ({"walls": [1] * 4}, "part.walls is a list of 4, not a list of 0 to 3"),
        ({"id": 6}, "part.id is 6, not a whole number from -5 to 5 or a text that can be written"),
        ({"lists": {"x": [1], "y": []}}, "part.lists has lists of different lengths"),
        ({"note": 1}, "part.note is 1, not a text that can be written"), ({"kind": "c"}, "part.kind is 'c', not 'a' or 'b'"),
        ({"new": ""}, "part.new is '', not a finite number"),
    ]:
        assert kind.fault({**good, **bad}, "part") == fault
    del good["id"]
    assert kind.fault(good, "part") == "part.id is missing"


@pytest.mark.parametrize("given", [bytes, tuple[int], set, Optional[bytes]])
def test_types_without_a_kind_are_refused(given):
    with pytest.raises(TypeError, match="has no kind"):
        kind_of(given)


OLDER_PYTHON = """
import json, sys, typing
import numpy, jsonschema  # whatever looks at the version has done so
from thinpart_workbench.core.kinds import value_kinds
sys.version_info = (3, 10)
from thinpart_workbench.storage.info.info_definition import json_schema
print(json.dumps(json_schema()))
"""


def test_pythons_that_lack_some_names_of_types_have_the_same_definition():
    run = subprocess.run([sys.executable, "-c", OLDER_PYTHON], cwd=ROOT, capture_output=True, encoding="utf-8",
                         stdin=subprocess.DEVNULL)
    assert run.returncode == 0, run.stderr
    assert json.loads(run.stdout) == json.loads((ROOT / "resources" / "info-file.schema.json").read_text(encoding="utf-8"))

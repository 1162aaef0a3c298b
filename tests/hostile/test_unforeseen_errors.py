# SPDX-License-Identifier: LGPL-2.1-or-later
"""What people read where a reader or the mesher raises an exception that nobody foresaw: never its own words."""

import json
import zipfile
import zlib

import pytest

from thinpart_workbench.core.errors import ThinPartError
from thinpart_workbench.core.judging.criteria import load_profile
from thinpart_workbench.core.message import Message, message
from thinpart_workbench.core.problem import UNEXPECTED, problem_of
from thinpart_workbench.workflow.analysis import analyse_part
from thinpart_workbench.workflow.analysis.analyse_file import FileTask
from thinpart_workbench.workflow.workers.reading import analysed, answer

SECRET = "x must consist of vectors of length 3 but has shape (0,) at 0x7f00"


class OCCError(Exception):
    """As FreeCAD raises it."""


ERRORS = [
    ValueError(SECRET), IndexError(SECRET), RuntimeError(SECRET), KeyError(SECRET), OSError(SECRET), TypeError(SECRET),
    AssertionError(SECRET), OCCError(f"BRep_API: command not done {SECRET}"), EOFError(SECRET),
    UnicodeDecodeError("utf-8", b"\xff", 0, 1, SECRET), json.JSONDecodeError(SECRET, "{", 0), zipfile.BadZipFile(SECRET),
    zlib.error(SECRET)]

PLACES = ["Part.read", "MeshPart.meshFromShape", "thinpart_workbench.freecad_adapter.reading.part_files.read_parts",
          "thinpart_workbench.workflow.analysis.analyse_part.measure"]
"""Of FreeCAD and of ThinPart, in the order in which a file passes them."""


def has_inside(sentence):
    """Whether a sentence tells what is inside the program."""
    return any(word in sentence for word in (SECRET, "Error", "BadZipFile", "Traceback", "0x7f", "shape (0,)", "None"))


@pytest.mark.parametrize("error", ERRORS, ids=lambda error: type(error).__name__)
def test_an_exception_is_described_in_words_for_people(error):
    said = problem_of(error)
    assert isinstance(said, Message) and not has_inside(said)


def test_words_of_our_own_and_of_the_system_are_told():
    assert problem_of(ThinPartError("plate.step is empty.")) == "plate.step is empty."
    assert problem_of(ValueError(message("it is nested too deeply"))) == "it is nested too deeply"
    assert problem_of(OSError(28, "No space left on device", "/tmp/x")) == "No space left on device"
    assert problem_of(KeyError("x")) == UNEXPECTED


@pytest.fixture(scope="module")
def two_boxes(tmp_path_factory):
    """A STEP file of two different parts."""
    import FreeCAD
    import Part

    file = tmp_path_factory.mktemp("boxes") / "two_boxes.step"
    Part.Compound([Part.makeBox(30, 20, 10), Part.makeBox(9, 8, 7, FreeCAD.Vector(50, 0, 0))]).exportStep(str(file))
    return file


def raises(error):
    def call(*arguments, **named):
        raise error

    return call


@pytest.mark.parametrize("error", [*ERRORS, MemoryError(SECRET), RuntimeError(f"std::bad_alloc {SECRET}")],
                         ids=lambda error: type(error).__name__)
@pytest.mark.parametrize("place", PLACES)
def test_a_file_that_fails_has_a_sentence_for_people(monkeypatch, tmp_path, two_boxes, place, error):
    info_file = tmp_path / "two_boxes.step.thinpart.json"
    monkeypatch.setattr(place, raises(error))
    outcome = answer(analysed, FileTask(str(two_boxes), str(info_file)))
    told = [outcome["error"]] if "error" in outcome else outcome["failures"]
    assert told and all("two_boxes" in each["message"] and not has_inside(each["message"]) for each in told)
    assert not has_inside(json.dumps(told))
    if info_file.exists():
        assert not has_inside(info_file.read_text())
    if isinstance(error, MemoryError) or "bad_alloc" in str(error):
        assert [each["kind"] for each in told] == ["memory"]


def test_a_part_that_fails_does_not_lose_the_verdicts_of_the_others(monkeypatch, two_boxes, capfd):
    whole = analyse_part.measure

    def fails_at_the_small_one(mesh, *arguments, **named):
        if mesh.extent < 20.0:
            raise IndexError(SECRET)
        return whole(mesh, *arguments, **named)

    monkeypatch.setattr(analyse_part, "measure", fails_at_the_small_one)
    outcome = answer(analysed, FileTask(str(two_boxes)))
    assert [part["category"] for part in outcome["parts"]] == ["normal"]
    assert [(each["label"], each["kind"]) for each in outcome["failures"]] == [("two_boxes (2)", "failed")]
    assert SECRET in capfd.readouterr().err  # for whoever looks for the cause


@pytest.mark.parametrize("content", [b"{", b"\xff\xfe", b"[" * 100_000])
def test_a_profile_that_cannot_be_read_is_described_in_words_for_people(tmp_path, content):
    profile = tmp_path / "own.json"
    profile.write_bytes(content)
    with pytest.raises(ThinPartError) as raised:
        load_profile(profile)
    assert "own.json" in str(raised.value) and "codec" not in str(raised.value) and "char" not in str(raised.value)

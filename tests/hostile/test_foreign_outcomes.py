# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a worker that has gone wrong says came of its file: never a traceback, and never more than a row."""

import copy
import json

import pytest
from forged_workers import ForgedWorkers
from made_library import record_of
from program import SAMPLES

from thinpart_workbench.core.analysis_limits import Limits
from thinpart_workbench.workflow.analysis.analyse_file import FileTask, analyse_file
from thinpart_workbench.workflow.analysis.analysis_outcome import checked_outcome
from thinpart_workbench.workflow.analysis.result_files import write_results
from thinpart_workbench.workflow.workers import task_run
from thinpart_workbench.workflow.workers.worker_pool import analyse_files


@pytest.fixture(scope="module")
def honest():
    """An outcome as it comes from a worker."""
    return json.loads(json.dumps(analyse_file(FileTask(str(SAMPLES / "plate.step"), thumbnails=True, force=True))))


def _without(key):
    return lambda outcome: outcome.pop(key)


def _with(value, *keys):
    def change(outcome):
        for key in keys[:-1]:
            outcome = outcome[key]
        outcome[keys[-1]] = value

    return change


@pytest.fixture
def answered(monkeypatch):
    """What becomes of a file whose worker answers with something."""
    def answered(answer):
        monkeypatch.setattr(task_run, "ProcessPool", ForgedWorkers.that_answer(answer))
        outcome, = analyse_files([FileTask("a.step")], Limits())
        return outcome

    return answered


BAD = [_without("parts"), _without("failures"), _without("seconds"), _with("x", "parts"), _with([1], "parts"),
       _with(None, "unwritten", "source"), _with("../../etc", "unwritten", "source", "sha256"), _with([], "unwritten"),
       _with({"kind": "unknown", "message": "x"}, "error"), _with("x", "error"), _with(-1, "seconds"),
       _with("x", "parts", 0, "descriptors", "box_mm"), _with([{"part": 1}], "failures")]


@pytest.mark.parametrize("change", BAD)
def test_what_is_no_outcome_is_a_failure_of_the_file(honest, answered, change):
    outcome = copy.deepcopy(honest)
    change(outcome)
    checked = answered(outcome)
    assert checked["file"] == "a.step" and checked["error"]["kind"] == "failed"
    assert checked["error"]["message"].startswith("a.step failed: its result cannot be stored (")


@pytest.mark.parametrize("outcome", [None, 1, "x", [], [[]], {}, {"error": None}, {"parts": {}}])
def test_what_is_anything_at_all_is_a_failure_too(answered, outcome):
    assert answered(outcome)["error"]["kind"] == "failed"


def test_an_honest_outcome_is_taken_for_the_file_that_was_asked_for(honest, tmp_path, monkeypatch):
    monkeypatch.setenv("THINPART_CACHE", str(tmp_path / "cache"))
    task = FileTask(str(SAMPLES / "plate.step"), str(tmp_path / "plate.step.thinpart.json"), thumbnails=True)
    written = write_results(task, checked_outcome(task, {**honest, "file": "/etc/passwd"}))
    assert written["file"] == task.file and written["failures"] == [] and "unwritten" not in written
    assert (tmp_path / "plate.step.thinpart.json").exists() and len(list((tmp_path / "cache").rglob("*.png"))) == 1


@pytest.mark.parametrize("drawn", [{}, None, {"Solid1": None}, {"Solid1": {"thumbnail": "x"}}, {"Solid1": {"thumbnail": 7}},
                                   {"Solid1": {"thumbnail": "QUJD"}}, {"Solid1": []}])
def test_a_picture_that_is_none_is_left_out(honest, tmp_path, monkeypatch, drawn):
    monkeypatch.setenv("THINPART_CACHE", str(tmp_path / "cache"))
    outcome = copy.deepcopy(honest)
    outcome["unwritten"]["drawn"] = drawn
    task = FileTask(str(SAMPLES / "plate.step"), str(tmp_path / "plate.step.thinpart.json"))
    if drawn is None:
        with pytest.raises(ValueError, match="drawn"):
            checked_outcome(task, outcome)
    else:
        written = write_results(task, checked_outcome(task, outcome))
        assert written["failures"] == [] and (tmp_path / "plate.step.thinpart.json").exists()
    assert not list((tmp_path / "cache").rglob("*.png"))


def test_the_record_of_a_made_part_is_an_outcome_too():
    outcome = {"file": "x", "parts": [record_of("wedge")], "failures": [], "reused": True, "seconds": 0.1}
    assert checked_outcome(FileTask("a.step"), json.loads(json.dumps(outcome)))["parts"]

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tasks of workers: an answer is a result only if it is checked, results are kept, and whoever asked may stop."""

from dataclasses import dataclass

import pytest
from forged_workers import ForgedWorkers

from thinpart_workbench.core.analysis_limits import Limits
from thinpart_workbench.core.errors import Cancelled, ThinPartError
from thinpart_workbench.core.run_control import RunControl
from thinpart_workbench.workflow.workers import task_run
from thinpart_workbench.workflow.workers.result_cache import ResultCache
from thinpart_workbench.workflow.workers.task_run import run_tasks

FAILURE = {"kind": "empty", "message": "It is empty."}


@dataclass(frozen=True)
class Task:
    file: str = "/share/a.step"


def work(task):
    """Nothing: no worker starts here."""


def doubled(task, answer):
    if not isinstance(answer, int):
        raise ValueError("it is no number")
    if answer < 0:
        raise ThinPartError("It has changed.", "unreadable")
    return 2 * answer


@pytest.fixture
def done(monkeypatch):
    """What becomes of a task to which workers give an answer."""
    def done(answer, check=doubled, **how):
        monkeypatch.setattr(task_run, "ProcessPool", ForgedWorkers.that_answer(answer))
        found, = run_tasks([Task()], work, check, Limits(), **how)
        return found

    return done


@pytest.fixture
def cache(tmp_path, monkeypatch):
    monkeypatch.setenv("THINPART_CACHE", str(tmp_path))

    def cache(**how):
        return ResultCache("kept", lambda task: task.file, 1000, **how)

    return cache


def test_a_result_is_what_the_check_makes_of_the_answer(done):
    assert (done(3).result, done(3).failure) == (6, None)


@pytest.mark.parametrize("answer, kind, words", [
    ("x", "failed", "a.step failed: its result cannot be used (it is no number)."), (-1, "unreadable", "It has changed."),
    ({"file": "/etc/passwd", "error": FAILURE, "parts": 7}, "empty", "It is empty."),
    ({"file": "/etc/passwd", "error": {**FAILURE, "kind": "odd"}}, "failed", "it is no number")])
def test_what_is_no_result_is_a_failure_of_the_file(done, answer, kind, words):
    found = done(answer)
    assert found.result is None and {*found.failure} == {"file", "error"} and found.failure["file"] == Task.file
    assert found.failure["error"]["kind"] == kind and words in found.failure["error"]["message"]


def test_a_result_is_kept_and_checked_again(done, cache):
    def same(task, answer):
        return answer

    assert done(3, same, cache=cache()).result == 3
    assert done(4, same, cache=cache()).result == 3
    assert done(4, doubled, cache=cache(renew=True)).result == 8
    assert done(-1, doubled, cache=cache()).result == 16  # of the kept 8

    def changed(task, answer):
        if answer != 5:
            raise ThinPartError("It has changed.", "unreadable")
        return answer

    assert done(5, changed, cache=cache()).result == 5


@pytest.mark.parametrize("answer", ["x", -1, 7])
def test_failures_and_what_does_not_last_are_not_kept(done, cache, answer):
    done(answer, cache=cache(lasts=lambda result: False))
    assert cache().result(Task()) is None


@pytest.mark.parametrize("content", [b"{", b"NaN", b"[" * 500, b"7" * 2000])
def test_what_cannot_be_read_is_done_again(done, cache, tmp_path, content):
    done(3, cache=cache())
    kept, = (tmp_path / "kept").iterdir()
    kept.write_bytes(content)
    assert done(4, cache=cache()).result == 8


def test_what_is_no_longer_wanted_is_not_begun(done):
    control = RunControl()
    control.stop()
    with pytest.raises(Cancelled):
        done(3, control=control)
    assert control.is_ending

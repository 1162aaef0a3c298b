# SPDX-License-Identifier: LGPL-2.1-or-later
"""Processes beside the window: what they write, how they end, and what they are ended for."""

import json
import os

import exit_cases
import pytest
import window_actions as window

from thinpart_workbench.gui.processes import child_process
from thinpart_workbench.gui.processes.child_process import ChildProcess
from thinpart_workbench.gui.processes.conversation import Conversation
from thinpart_workbench.system.exit_cause import ExitCause

SCRIPT = """
import json, os, sys, time
what = sys.argv[1] if len(sys.argv) > 1 else "memory"
if what == "lines":
    for number in range(int(sys.argv[2])):
        print(json.dumps({"number": number}), flush=number % 100 == 0)
        print("error", number, file=sys.stderr)
    print("the rest", end="")
elif what == "much":
    sys.stderr.write("x" * 300000 + "the last words")
elif what == "echo":
    print(os.getcwd(), flush=True)
    for line in sys.stdin:
        print(line.strip()[::-1], flush=True)
    open(sys.argv[2], "w").close()
elif what == "memory":
    from tests.exit_cases import end_as
    end_as("C++'s memory")
elif what == "deaf":
    print("here", flush=True)
    time.sleep(600)
"""


@pytest.fixture
def script(tmp_path, monkeypatch):
    """Module in another process: SCRIPT."""
    (tmp_path / "spoken_script.py").write_text(SCRIPT)
    environment = child_process.python_environment
    monkeypatch.setattr(child_process, "python_environment", lambda: {
        **environment(), "PYTHONPATH": environment()["PYTHONPATH"] + os.pathsep + str(tmp_path)})
    return "spoken_script"


@pytest.fixture
def spoken(script):
    """Starts the script, with what it says: ChildProcess and its lists of lines, errors and ends."""
    made = []

    def start(*arguments, patience=0.0, **options):
        process = ChildProcess(patience=patience)
        process.lines, process.errors, process.ends, process.lefts = [], [], [], []
        process.line.connect(process.lines.append)
        process.error_line.connect(process.errors.append)
        process.ended.connect(process.ends.append)
        process.released.connect(lambda: process.lefts.append(process.is_running))
        process.start(script, [str(each) for each in arguments], **options)
        made.append(process)
        return process

    yield start
    for each in made:
        each.end_now()


def is_there(number):
    return os.path.exists(f"/proc/{number}/exe")


@pytest.mark.parametrize("name", exit_cases.CASES)
def test_a_process_that_ends_in_every_way(name):
    process, ends = ChildProcess(), []
    process.ended.connect(ends.append)
    process.start("tests.exit_cases", [name])
    window.wait_until(lambda: ends)
    assert ends[0].cause() is exit_cases.CASES[name][1], (ends[0].code, ends[0].text)
    assert not process.is_running and process.process_id is None


def test_all_that_it_writes_is_told_before_its_end(spoken):
    process = spoken("lines", 20000)
    counts = []
    process.ended.connect(lambda _: counts.append((len(process.lines), len(process.errors))))
    window.wait_until(lambda: process.ends)
    assert counts == [(20001, 20000)] and process.lines[-1] == b"the rest" and process.errors[-1] == b"error 19999"
    assert [json.loads(each)["number"] for each in process.lines[:-1]] == list(range(20000))
    assert process.lefts == [False]


def test_of_its_errors_the_last_are_kept(spoken):
    process = spoken("much")
    window.wait_until(lambda: process.ends)
    last = process.ends[0].error_output
    assert len(last) == child_process.LAST_WORDS and last.endswith(b"xthe last words")


def test_it_is_spoken_to_and_ends_with_its_input(spoken, tmp_path):
    process = spoken("echo", tmp_path / "done", folder=str(tmp_path))
    process.write(b"abc\n")
    window.wait_until(lambda: process.lines == [str(tmp_path).encode(), b"cba"])
    process.close_input()
    window.wait_until(lambda: process.ends)
    assert process.ends[0].cause() is ExitCause.WELL and (tmp_path / "done").exists()


def test_one_that_is_ended_tells_nothing_more_and_is_gone(spoken):
    process = spoken("deaf")
    window.wait_until(lambda: process.lines)
    number = process.process_id
    process.end_now()
    assert not is_there(number) and process.lefts == [False]
    window.settle(100)
    assert process.ends == [] and process.lines == [b"here"]


def test_one_with_patience_is_waited_for(spoken, tmp_path):
    process = spoken("echo", tmp_path / "done")
    window.wait_until(lambda: process.lines)
    process.end_now(patience=30.0)
    assert (tmp_path / "done").exists()


def test_one_that_is_left_to_itself_finishes_and_can_be_started_anew(spoken, tmp_path):
    process = spoken("echo", tmp_path / "done", patience=30.0)
    window.wait_until(lambda: process.lines)
    number = process.process_id
    process.detach()
    assert not process.is_running and process.lefts == [False]
    process.start("spoken_script", ["deaf"])
    window.wait_until(lambda: process.lines[-1] == b"here" and not is_there(number))
    assert (tmp_path / "done").exists() and process.process_id != number and process.ends == []


def test_one_with_nothing_left_to_do_is_killed_without_waiting(spoken):
    process = spoken("deaf")
    window.wait_until(lambda: process.lines)
    number = process.process_id
    process.detach(kill=True)
    window.wait_until(lambda: not is_there(number))
    assert process.ends == [] and process.lefts == [False]


def test_one_that_does_not_end_in_time_is_killed_and_tells_it(spoken):
    process = spoken("deaf")
    window.wait_until(lambda: process.lines)
    process.kill_after(0.1)
    window.wait_until(lambda: process.ends)
    assert process.ends[0].cause() is ExitCause.KILLED


def test_one_that_cannot_start_tells_it(monkeypatch, tmp_path):
    monkeypatch.setattr(child_process, "python_program", lambda: str(tmp_path / "no_python"))
    process, told = ChildProcess(), []
    process.released.connect(lambda: told.append("left"))
    process.failed_to_start.connect(lambda: told.append("failed"))
    process.ended.connect(told.append)
    process.start("spoken_script")
    window.wait_until(lambda: "failed" in told)
    assert told == ["left", "failed"] and not process.is_running


def test_whoever_is_told_of_a_line_may_end_it(spoken):
    process = spoken("lines", 1000)
    process.line.connect(lambda _: process.end_now())
    window.wait_until(lambda: not process.is_running)
    window.settle(100)
    assert len(process.lines) == 1 and process.ends == []


# ---- what the workers tell of their own failures ----


def conversation(module, **job):
    """Sentence with which a worker ends that was given a job, and what it told."""
    process, told, over = Conversation(module), [], []
    process.received.connect(told.append)
    process.finished.connect(over.append)
    assert process.ensure_started() == ""
    process.send(**job)
    window.wait_until(lambda: over)
    return over[0], told, process.failure


@pytest.mark.parametrize("module, job", [
    ("request_worker", {"nothing": "foreseen"}),
    ("judging_worker", {"nothing": "foreseen"}),
    ("library_worker", {"ask": "nothing"}),
])
def test_what_no_worker_has_foreseen_is_told_as_data(module, job):
    sentence, told, failure = conversation(module, **job)
    assert told == [] and failure["kind"] == "failed"
    assert sentence == failure["message"] and sentence.startswith("The worker process failed (")


@pytest.mark.complains("Fatal Python error", "Extension modules", "bad_alloc", "<no Python frame>", "File ")
def test_a_conversation_that_runs_out_of_memory_says_so(script, monkeypatch):
    process, over = Conversation("none"), []
    monkeypatch.setattr(process, "_module", script)
    process.finished.connect(over.append)
    process.ensure_started()
    window.wait_until(lambda: over)
    assert over == ["There is not enough memory for this."]

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Worker processes: what waits has no time limit, what dies is replaced, nobody outlives the parent."""

import ctypes
import os
import signal
import subprocess
import sys
import tempfile
import time
from collections import deque
from pathlib import Path

import pytest
import time_limit
from worker_outcomes import results

from thinpart_workbench.core.errors import ThinPartError
from thinpart_workbench.core.run_control import RunControl
from thinpart_workbench.workflow.analysis.analyse_file import FileTask
from thinpart_workbench.workflow.workers.process_pool import ProcessPool

ROOT = Path(__file__).resolve().parents[2]


def do(task):
    what, argument = task.file.split()[:2]
    if what == "sleep":
        time.sleep(float(argument))
    elif what == "die":
        os._exit(int(argument))
    elif what == "raise":
        raise {"key": KeyError, "odd": Odd}[argument]("a", "b")
    elif what.startswith("print"):
        os.write(1, argument.encode() + b"\n")
        if what.endswith("die"):
            os._exit(1)
    elif what == "number":
        time.sleep(0.5)
        return tempfile.gettempdir()  # of the worker, whichever process reads the file
    elif what == "infinite":
        return float("inf")
    elif what == "leave":
        Path(tempfile.gettempdir(), "left").write_text("a document that was unpacked")
        return os.path.join(tempfile.gettempdir(), "left")
    elif what == "return":
        return "x" * int(argument)
    elif what == "hold-lock":
        # Foreign code that keeps Python's lock, as a reader of CAD files does.
        Path(tempfile.gettempdir(), "busy").write_text(str(os.getpid()))
        ctypes.PyDLL(None).sleep(600)
    return task.file


class Odd(Exception):
    """Cannot be made from its arguments, as some that libraries raise."""

    def __init__(self, one, two):
        super().__init__(one)


def start_well():
    """A worker that starts."""


def start_badly():
    raise RuntimeError("cannot start")


@pytest.fixture(params=[False, True], ids=["free", "confined"])
def started(tmp_path, request):
    made = []

    def start(count, seconds, start=start_well, arguments=()):
        made.append(ProcessPool(count, seconds, str(tmp_path), do, start, arguments, confine=request.param))
        return made[-1]

    yield start
    for each in made:
        each.stop()


def worker_processes():
    """Numbers of the worker processes of this one."""
    found = []
    for process in Path("/proc").glob("[0-9]*"):
        try:
            parent = int((process / "stat").read_text().rpartition(")")[2].split()[1])
            command = (process / "cmdline").read_bytes()
        except OSError:
            continue  # it has ended meanwhile
        if parent == os.getpid() and b"pool_worker" in command:
            found.append(int(process.name))
    return found


def test_a_task_that_waits_does_not_run_into_the_time_limit(started):
    tasks = [f"sleep 0.6 {number}" for number in range(5)]
    assert results(started(1, 1.5), tasks) == [(task, task) for task in tasks]


def test_a_task_that_takes_too_long_is_ended_and_the_rest_goes_on(started):
    ended = dict(results(started(1, 1.0), ["sleep 60", "sleep 0 a", "sleep 0 b"]))
    assert ended == {"sleep 60": "TimeoutError", "sleep 0 a": "sleep 0 a", "sleep 0 b": "sleep 0 b"}


def test_workers_end_although_their_pipe_is_full(started):
    workers = started(1, 60.0)
    for number in range(4):
        workers.submit(FileTask(f"sleep 60 {number}", profile={"large": "x" * 10 ** 6}))
    time.sleep(1)
    workers.stop()
    assert worker_processes() == []


def test_only_a_few_tasks_are_handed_over_at_once(started):
    workers = started(2, 60.0)
    for number in range(100):
        if not workers.has_room:
            break
        workers.submit(FileTask(f"sleep 0 {number}"))
    assert number == 8


def test_tasks_that_kill_their_worker_are_named_and_the_rest_goes_on(started):
    tasks = ["sleep 0 a", *(f"die 7 {number}" for number in range(4)), "sleep 0 b"]
    ended = dict(results(started(2, 60.0), tasks))
    assert ended == {task: "WorkerDied" if "die" in task else task for task in tasks}


def test_workers_that_cannot_start_end_the_run_with_a_sentence(started):
    with pytest.raises(ThinPartError) as caught:
        results(started(2, 60.0, start_badly), ["sleep 0"])
    assert caught.value.kind == "crash" and "as soon as they start" in str(caught.value)


def test_workers_that_are_killed_while_they_wait_are_replaced(started):
    workers = started(2, 60.0)
    tasks = [f"sleep 0 {number}" for number in range(6)]
    for _ in range(7):  # more often than workers may fail to start
        assert sorted(results(workers, tasks)) == [(task, task) for task in tasks]
        for number in worker_processes():
            os.kill(number, signal.SIGKILL)
            assert ended(number)


def test_what_is_held_is_begun_afterwards(started):
    workers = started(1, 60.0)
    workers.set_paused(True)
    workers.submit(FileTask("sleep 0"))
    for _ in range(10):
        assert workers.next_finished() is None
    workers.set_paused(False)
    assert results(workers, ["sleep 0 b"]) == [("sleep 0", "sleep 0"), ("sleep 0 b", "sleep 0 b")]


def test_workers_are_stopped_while_they_are_held(started):
    workers = started(2, 60.0)
    results(workers, ["sleep 0", "sleep 0 b"])
    workers.set_paused(True)
    workers.submit(FileTask("sleep 60"))
    workers.stop()
    assert worker_processes() == []


def test_what_a_task_raises_and_returns_comes_back_whatever_it_prints(started):
    tasks = ["raise key", "print 0", "return 3000000", "sleep 0"]
    ended = dict(results(started(1, 60.0), tasks))
    assert ended.pop("raise key") == "KeyError: ('a', 'b')" and len(ended.pop("return 3000000")) == 3000000
    assert ended == {task: task for task in ("print 0", "sleep 0")}


def test_what_no_json_can_say_is_told_as_a_failure(started):
    workers = started(1, 60.0)
    (_, odd), (_, infinite), (_, well) = results(workers, ["raise odd", "infinite 0", "sleep 0"])
    assert odd == "Odd: a" and infinite.startswith("ValueError: Out of range float") and well == "sleep 0"


def test_what_a_worker_printed_before_it_died_is_known_and_nothing_of_the_task_before(started):
    workers = started(1, 60.0)
    assert results(workers, ["print earlier"]) == [("print earlier", "print earlier")]
    workers.submit(FileTask("print-and-die last words"))
    while (one := workers.next_finished()) is None:
        pass
    assert one[0].exception().end.error_output == b"last\n"


def test_a_worker_leaves_nothing_behind(started, tmp_path):
    workers = started(1, 60.0)
    left = results(workers, ["leave 0", "die 1", "leave 1"])
    workers.stop()
    assert [Path(result).parent.parent == tmp_path for task, result in left if "leave" in task] == [True, True]
    assert left[1] == ("die 1", "WorkerDied") and not any(tmp_path.iterdir())


def test_two_workers_work_at_the_same_time(started):
    numbers = results(started(2, 60.0), [f"number {number}" for number in range(6)])
    assert len({number for _, number in numbers}) == 2


def test_nothing_is_left_open_when_workers_are_stopped(started):
    before = None
    for _ in range(3):
        workers = started(2, 60.0)
        results(workers, ["sleep 0", "die 1", "sleep 0 b"])
        workers.stop()
        assert worker_processes() == []
        now = len(os.listdir("/proc/self/fd"))
        assert before in (None, now)
        before = now


PARENT = """
import os, sys
sys.path[:0] = [{root!r}, {tests!r}, {here!r}]
from test_workers import ProcessPool, FileTask, do, start_well
if __name__ == "__main__":
    workers = ProcessPool(1, 600.0, {folder!r}, do, start_well, confine={confined})
    if {again}:
        workers.submit(FileTask("die 1"))
        while workers.next_finished() is None: pass
    workers.submit(FileTask("hold-lock 0"))
    while True: workers.next_finished()
"""


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="the service is Linux's")
@pytest.mark.parametrize("confined", [False, True])
@pytest.mark.parametrize("again", [False, True])
def test_a_worker_that_is_busy_in_foreign_code_ends_with_its_parent(tmp_path, again, confined):
    script = tmp_path / "parent.py"
    script.write_text(PARENT.format(root=str(ROOT), tests=str(ROOT / "tests"), here=str(Path(__file__).parent),
                                    folder=str(tmp_path), again=again, confined=confined))
    parent = subprocess.Popen([sys.executable, str(script)], start_new_session=True)
    def said():
        return [each.read_text() for each in tmp_path.glob("worker-*/busy") if each.read_text()]

    time_limit.wait_until(said, "the number of the busy worker")
    number = int(said()[0])
    try:
        os.kill(number, 0)
        os.kill(parent.pid, signal.SIGKILL)
        parent.wait()
        assert ended(number)
    finally:
        if not ended(number):
            os.kill(number, signal.SIGKILL)


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="the service is Linux's")
def test_a_worker_whose_parent_ended_before_it_asked_ends_too():
    program = ("from thinpart_workbench.system.parent_death import end_with_parent\n"
               f"end_with_parent({os.getpid()})\nprint('goes on')\nend_with_parent(1)\nprint('too far')\n")
    run = subprocess.run([sys.executable, "-c", program], cwd=ROOT, capture_output=True, encoding="utf-8")
    assert run.stdout in ("goes on\n", "") and run.returncode == 1


def ended(number):
    """Whether a process is over, or about to be taken off by whoever inherited it."""
    for _ in range(100):
        try:
            state = Path(f"/proc/{number}/stat").read_text().rpartition(")")[2].split()[0]
        except OSError:
            return True
        if state == "Z":
            return True
        time.sleep(0.05)
    return False


def test_other_work_is_done_while_workers_are_busy_and_not_again(started):
    workers = started(1, 60.0)
    done = []
    tasks = deque([FileTask("sleep 0.6"), FileTask("sleep 0.6")])
    finished = list(workers.run(tasks, RunControl(), meanwhile=(done.append(number) for number in range(3))))
    assert len(finished) == 2 and done == [0, 1, 2]

"""Worker processes: what waits has no time limit, what dies is replaced, nobody outlives the parent."""

import ctypes
import multiprocessing
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

import time_limit
from thinpart_workbench.core.errors import ThinPartError
from thinpart_workbench.workflow.analyse_file import FileTask
from thinpart_workbench.workflow.parent_death import end_with_parent  # noqa: F401 - programs import it from here
from thinpart_workbench.workflow.workers import Workers

ROOT = Path(__file__).resolve().parents[2]


def do(task, log, hold):
    if os.path.exists(hold):
        return None
    Path(log).touch()
    what, argument = task.file.split()[:2]
    if what == "sleep":
        time.sleep(float(argument))
    elif what == "die":
        os._exit(int(argument))
    elif what == "hold-lock":
        # Foreign code that keeps Python's lock, as a reader of CAD files does.
        Path(argument).write_text(str(os.getpid()))
        ctypes.PyDLL(None).sleep(600)
    return task.file


def start_well():
    """A worker that starts."""


def start_badly():
    raise RuntimeError("cannot start")


@pytest.fixture
def started(tmp_path):
    made = []

    def start(count, seconds, start=start_well, arguments=()):
        made.append(Workers(count, seconds, str(tmp_path), do, start, arguments))
        return made[-1]

    yield start
    for each in made:
        each.stop()


def results(workers, tasks):
    """(task, result or name of the exception) in the order in which they end."""
    waiting, ended = [FileTask(task) for task in tasks], []
    while waiting or workers.busy:
        while waiting and workers.has_room:
            workers.begin(waiting.pop(0))
        one = workers.next_ended()
        if one is None:
            waiting[:0] = workers.lost_tasks()
            continue
        future, task, _ = one
        error = future.exception()
        ended.append((task.file, future.result() if error is None else type(error).__name__))
    return ended


def test_a_task_that_waits_does_not_run_into_the_time_limit(started):
    tasks = [f"sleep 0.6 {number}" for number in range(5)]
    assert results(started(1, 1.5), tasks) == [(task, task) for task in tasks]


def test_a_task_that_takes_too_long_is_ended_and_the_rest_goes_on(started):
    ended = dict(results(started(1, 1.0), ["sleep 60", "sleep 0 a", "sleep 0 b"]))
    assert ended == {"sleep 60": "TimeoutError", "sleep 0 a": "sleep 0 a", "sleep 0 b": "sleep 0 b"}


def test_workers_end_although_their_pipe_is_full(started):
    workers = started(1, 60.0)
    for number in range(4):
        workers.begin(FileTask(f"sleep 60 {number}", profile={"large": "x" * 10 ** 6}))
    time.sleep(1)
    workers.stop()
    assert not multiprocessing.active_children()


def test_only_a_few_tasks_are_handed_over_at_once(started):
    workers = started(2, 60.0)
    for number in range(100):
        if not workers.has_room:
            break
        workers.begin(FileTask(f"sleep 0 {number}"))
    assert number == 8


def test_tasks_that_kill_their_worker_are_named_and_the_rest_goes_on(started):
    tasks = ["sleep 0 a", *(f"die 7 {number}" for number in range(4)), "sleep 0 b"]
    ended = dict(results(started(2, 60.0), tasks))
    assert ended == {task: "ProcessExpired" if "die" in task else task for task in tasks}


def test_workers_that_cannot_start_end_the_run_with_a_sentence(started):
    with pytest.raises(ThinPartError) as caught:
        results(started(2, 60.0, start_badly), ["sleep 0"])
    assert caught.value.kind == "crash" and "as soon as they start" in str(caught.value)


def test_workers_that_are_killed_while_they_wait_are_replaced(started):
    workers = started(2, 60.0)
    tasks = [f"sleep 0 {number}" for number in range(6)]
    for _ in range(7):  # more often than workers may fail to start
        assert sorted(results(workers, tasks)) == [(task, task) for task in tasks]
        for worker in multiprocessing.active_children():
            worker.kill()
            worker.join()


def test_what_is_held_comes_back_untouched(started):
    workers = started(1, 60.0)
    workers.hold(True)
    workers.begin(FileTask("die 1"))
    while (one := workers.next_ended()) is None:
        assert not workers.lost_tasks()
    assert one[0].result() is None and not workers.busy
    workers.hold(False)
    assert results(workers, ["sleep 0"]) == [("sleep 0", "sleep 0")]


PARENT = """
import os, sys
sys.path[:0] = [{root!r}, {tests!r}, {here!r}]
from test_workers import Workers, FileTask, do, end_with_parent
if __name__ == "__main__":
    workers = Workers(1, 600.0, {folder!r}, do, end_with_parent, (os.getpid(),))
    if {again}:  # the next worker is started by a thread of the pool
        workers.begin(FileTask("die 1"))
        while workers.next_ended() is None: pass
    workers.begin(FileTask("hold-lock {folder}/busy"))
    while True: workers.next_ended()
"""


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="the service is Linux's")
@pytest.mark.parametrize("again", [False, True])
def test_a_worker_that_is_busy_in_foreign_code_ends_with_its_parent(tmp_path, again):
    script = tmp_path / "parent.py"
    script.write_text(PARENT.format(root=str(ROOT), tests=str(ROOT / "tests"), here=str(Path(__file__).parent),
                                    folder=str(tmp_path), again=again))
    parent = subprocess.Popen([sys.executable, str(script)], start_new_session=True)
    busy = tmp_path / "busy"
    time_limit.wait_until(lambda: busy.exists() and busy.read_text(), "the number of the busy worker")
    number = int(busy.read_text())
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
    program = ("from thinpart_workbench.workflow.parent_death import end_with_parent\n"
               f"end_with_parent({os.getpid()})\nprint('goes on')\nend_with_parent(1)\nprint('too far')\n")
    run = subprocess.run([sys.executable, "-c", program], cwd=ROOT, capture_output=True, text=True)
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

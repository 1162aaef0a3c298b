# SPDX-License-Identifier: LGPL-2.1-or-later
"""A test that hangs fails after its time, with what it waited for, and those after it are done."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

HERE = Path(__file__).resolve().parent

HANGING = '''
import subprocess, sys, time
import pytest
import time_limit

def test_waits_for_a_program():
    subprocess.run([sys.executable, "-c", "import time; time.sleep(60)", "a program that hangs"])

def test_keeps_the_exception_to_itself():
    try:
        time.sleep(60)
    except time_limit.TooLong:
        pass

def test_polls():
    time_limit.wait_until(lambda: False, "the impossible")

def test_polls_for_a_moment():
    time_limit.wait_until(lambda: False, lambda: "Godot", 0.1)

@pytest.fixture
def slow_end():
    yield
    time.sleep(60)

def test_is_not_taken_down(slow_end):
    assert False, "before that"

@pytest.mark.timeout(30)  # this one may
def test_has_more_time():
    time.sleep(1)
'''

LOCKED = '''
import ctypes, signal

def test_holds_the_lock_of_python():
    signal.pthread_sigmask(signal.SIG_BLOCK, [signal.SIGALRM])  # or it would end the sleep
    ctypes.PyDLL(None).sleep(60)

def test_after_it():
    pass
'''


@pytest.fixture
def run(tmp_path):
    """Runs a file of tests with this suite's settings, but half a second of time, and returns what came out."""
    (tmp_path / "pytest.ini").write_text("[pytest]\naddopts = -ra --strict-markers\ntimeout = 0.5\n")
    (tmp_path / "conftest.py").write_text(
        "import time_limit\ntime_limit.TEARDOWN_SECONDS = time_limit.GRACE_SECONDS = 0.5\n" +
        (HERE / "conftest.py").read_text())

    def run(content):
        (tmp_path / "test_it.py").write_text(content)
        return subprocess.run(
            [sys.executable, "-m", "pytest", "-p", "no:cacheprovider", "-q"], cwd=tmp_path, capture_output=True,
            env=dict(os.environ, PYTHONPATH=str(HERE), COLUMNS="200"), text=True, timeout=50)

    return run


def test_each_is_told_with_what_it_waited_for(run):
    ended = run(HANGING)
    said = ended.stdout
    assert ended.returncode == 1 and "5 failed, 1 passed, 1 error" in said, said
    assert "test_it.py::test_waits_for_a_program has not ended after 0.5 s." in said
    assert "import time; time.sleep(60) a program that hangs" in said
    assert "test_it.py::test_keeps_the_exception_to_itself has not ended after 0.5 s." in said
    assert "test_it.py::test_polls has not ended after 0.5 s." in said and "It waits for the impossible\n" in said
    assert "AssertionError: waited 0.1 s for Godot" in said
    assert "test_it.py::test_is_not_taken_down (what comes after it) has not ended after 0.5 s." in said


def test_what_python_cannot_end_ends_the_run_with_its_stack(run):
    ended = run(LOCKED)
    assert ended.returncode == 1 and "passed" not in ended.stdout
    assert "in test_holds_the_lock_of_python" in ended.stderr

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Why a process has ended: real ones, and codes that this system does not have."""

import subprocess
import sys
from pathlib import Path

import exit_cases
import pytest

from thinpart_workbench.system import exit_cause
from thinpart_workbench.system.exit_cause import KILLED_END, ExitCause, ProcessEnd

ROOT = Path(__file__).resolve().parents[1]


@pytest.mark.parametrize("name", exit_cases.CASES)
def test_a_process_that_ends_in_every_way(name):
    run = subprocess.run([sys.executable, "-m", "tests.exit_cases", name], cwd=ROOT, capture_output=True)
    end = ProcessEnd(run.returncode, run.stderr)
    assert end.cause() is exit_cases.CASES[name][1], (run.returncode, end.text)


def test_what_ends_before_it_is_done_has_not_ended_well():
    assert ProcessEnd(0, b"").cause() is ExitCause.WELL
    assert ProcessEnd(0, b"").cause(is_done=False) is ExitCause.FAILED
    assert ProcessEnd(0, b"std::bad_alloc").cause(is_done=False) is ExitCause.OUT_OF_MEMORY


def test_the_status_of_a_program_that_ran_it_in_its_place():
    # bubblewrap and shells: 128, and the signal of what they ran.
    assert [ProcessEnd(128 + number).cause() for number in (9, 11, 15)] == [
        ExitCause.KILLED, ExitCause.CRASHED, ExitCause.KILLED]
    assert ProcessEnd(128).cause() is ProcessEnd(255).cause() is ExitCause.FAILED


def test_windows(monkeypatch):
    monkeypatch.setattr(exit_cause.sys, "platform", "win32")
    assert ProcessEnd(0xC0000005).cause() is ExitCause.CRASHED  # as subprocess has an access violation
    assert ProcessEnd(0xC0000005 - (1 << 32)).cause() is ExitCause.CRASHED  # as Qt has it
    assert ProcessEnd(0xF291).cause() is ExitCause.KILLED
    assert ProcessEnd(139).cause() is ExitCause.FAILED and ProcessEnd(0).cause() is ExitCause.WELL


def test_one_that_somebody_else_has_ended():
    assert KILLED_END.cause() is ExitCause.KILLED

# SPDX-License-Identifier: LGPL-2.1-or-later
"""`thinpart test` runs the tests without window in several processes, each with a session of its own."""

import argparse
import os
import subprocess
import sys

import pytest
from program import environment

from thinpart_workbench.cli.commands import test as command

FILES = ["tests/test_requirements.py", "tests/core/test_progress.py"]


def asked(*arguments):
    """What the command makes of a command line."""
    parser = argparse.ArgumentParser()
    command.add_arguments(parser)
    options, options.rest = parser.parse_known_args(arguments)
    return command.spread(options)


def test_all_tests_have_all_cores_and_chosen_ones_a_process_unless_it_is_said(monkeypatch):
    monkeypatch.setattr(os, "cpu_count", lambda: 6)
    assert asked("--no-gui") == ["-n", "6", "--dist", "loadfile"]
    assert asked("tests/core", "-k", "plate") == asked("--processes", "1") == []
    assert asked("--processes", "3", "tests/core") == ["-n", "3", "--dist", "loadfile"]
    monkeypatch.setattr(os, "cpu_count", lambda: 1)
    assert asked("--no-gui") == []


def test_without_xdist_there_is_one_process(monkeypatch):
    monkeypatch.setattr(command.importlib.util, "find_spec", lambda name: None)
    assert asked("--processes", "3") == []


@pytest.mark.parametrize("processes", [1, 2])
def test_the_processes_run_all_that_was_asked_for(processes):
    run = subprocess.run(
        [sys.executable, "-m", "thinpart_workbench", "test", "--processes", str(processes), "--verbose", *FILES],
        env=environment(COLUMNS="200"), capture_output=True, encoding="utf-8", stdin=subprocess.DEVNULL)
    assert run.returncode == 0, run.stdout
    done = [line for line in run.stdout.splitlines() if "PASSED" in line]
    assert all(any(file in line for line in done) for file in FILES)
    assert {number for number in range(3) if any(f"[gw{number}]" in line for line in done)} == (
        {0, 1} if processes == 2 else set())

# SPDX-License-Identifier: LGPL-2.1-or-later
"""``thinpart test --again``: a few tests that fail have a second try, which is said; more than a few have none."""

import subprocess
import sys

import pytest

from thinpart_workbench.cli.commands.test import MOST_AGAIN

ONCE = """
from pathlib import Path

def test_first_time():
    seen = Path(__file__).with_name("seen")
    was_there = seen.exists()
    seen.touch()
    assert was_there

def test_that_passes():
    pass
"""
ALWAYS = "def test_always():\n    assert 0\n"
MANY = "".join(f"def test_{number}():\n    assert 0\n" for number in range(MOST_AGAIN + 1))


@pytest.mark.parametrize("text, options, status, runs", [
    (ONCE, ["--again"], 0, 2), (ONCE, [], 1, 1), (ALWAYS, ["--again"], 1, 2), (MANY, ["--again"], 1, 1)],
    ids=["once", "not asked for", "always", "many"])
def test_what_fails_is_run_once_more(tmp_path, text, options, status, runs):
    file = tmp_path / "test_given.py"
    file.write_text(text)
    done = subprocess.run([sys.executable, "-m", "thinpart_workbench", "test", *options, str(file)],
                          stdin=subprocess.DEVNULL, capture_output=True, text=True)
    assert done.returncode == status, done.stdout + done.stderr
    assert done.stdout.count("test session starts") == runs
    assert ("run once more" in done.stdout) == (runs == 2)

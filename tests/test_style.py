# SPDX-License-Identifier: LGPL-2.1-or-later
"""The code is as ruff.toml and mypy.ini ask, where the two programs are: Debian testing has both, so CI runs them there."""

import os
import shutil
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[1]

SECONDS = 300
"""Both read all files anew, mypy those of Python's types too, and other tests have the processors meanwhile."""


def complaints(program, *arguments):
    """What a program says of the checkout; nothing where it has no complaint."""
    if shutil.which(program) is None:
        pytest.skip(f"{program} is not installed; `tests/on_debian forky tests/test_style.py` brings it")
    run = subprocess.run([program, *arguments], cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                         stdin=subprocess.DEVNULL, encoding="utf-8")
    return run.stdout if run.returncode else ""


@pytest.mark.timeout(SECONDS)  # reads all files
def test_ruff_finds_nothing():
    assert complaints("ruff", "check", "--no-cache") == ""


@pytest.mark.timeout(SECONDS)  # reads three layers, and the types of what they import
def test_mypy_finds_nothing():
    assert complaints("mypy", f"--cache-dir={os.devnull}") == ""

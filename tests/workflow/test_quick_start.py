# SPDX-License-Identifier: LGPL-2.1-or-later
"""What makes the command line start quickly: compiled modules for workers, and no numpy before they start."""

import os
import subprocess
import sys
import time
from importlib.util import cache_from_source
from pathlib import Path

import pytest

from thinpart_workbench.workflow.workers.compiled_modules import compiled_modules

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture
def package(tmp_path, monkeypatch):
    """A package with a module, one in a folder below, one with an error and one of the window."""
    monkeypatch.setattr(sys, "dont_write_bytecode", False)
    for name, content in (("one.py", "ONE = 1\n"), ("below/two.py", "TWO = 2\n"), ("gui/window.py", "WINDOW = 3\n")):
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text(content)
    return tmp_path


def test_modules_are_compiled_once_and_again_after_a_change(package):
    one, two = os.fspath(package / "one.py"), os.fspath(package / "below" / "two.py")
    assert list(compiled_modules(package)) == [one, two]
    assert os.path.getsize(cache_from_source(one)) and os.path.getsize(cache_from_source(two))
    assert not os.path.exists(cache_from_source(package / "gui" / "window.py"))
    assert not list(compiled_modules(package))
    Path(one).write_text("ONE = 11\n")
    os.utime(one, (time.time() + 10, time.time() + 10))
    os.utime(cache_from_source(two))
    before = Path(cache_from_source(one)).read_bytes()
    list(compiled_modules(package))
    assert Path(cache_from_source(one)).read_bytes() != before


def test_who_wants_no_bytecode_gets_none(package, monkeypatch):
    monkeypatch.setattr(sys, "dont_write_bytecode", True)
    assert not list(compiled_modules(package)) and not list(package.rglob("*.pyc"))


def test_a_folder_that_cannot_be_written_is_left_alone(package):
    (package / "__pycache__").write_text("a file where the folder would be")
    assert not list(compiled_modules(package)) and not list(package.rglob("*.pyc"))


def test_a_module_that_does_not_compile_is_no_error(package):
    (package / "one.py").write_text("ONE = (\n")
    assert not list(compiled_modules(package))


def test_the_command_line_starts_workers_before_it_imports_numpy():
    code = ("import sys; import thinpart_workbench.cli.commands.classify;"
            "print([name for name in ('numpy', 'scipy') if name in sys.modules])")
    run = subprocess.run([sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True, check=True)
    assert run.stdout.strip() == "[]"

# SPDX-License-Identifier: LGPL-2.1-or-later
"""What docs/python.md shows runs, and prints what it says."""

import re
import shutil
import subprocess
import sys

import pytest
from program import ROOT, SAMPLES, environment

FREECADCMD = shutil.which("freecadcmd") or shutil.which("FreeCADCmd")
TEXT = (ROOT / "docs" / "python.md").read_text(encoding="utf-8")
BLOCKS = re.findall(r"^```(python[^\n]*)\n(.*?)^```$", TEXT, re.MULTILINE | re.DOTALL)
SCRIPTS = [block for kind, block in BLOCKS if kind == "python"]
CONSOLE = [block for kind, block in BLOCKS if kind == "python freecad"]

_TYPED = """
import sys, traceback
sys.path.append({checkout!r})  # as FreeCAD does with the folder of an add-on; PYTHONPATH is not read by all versions
try:
    exec(compile(open({path!r}).read(), "console", "exec"), {{"__name__": "__main__"}})
except BaseException:
    traceback.print_exc()
print("typed to its end")
"""


def title(block):
    before = TEXT[:TEXT.index(block)]
    return re.findall(r"^## (.*)$", before, re.MULTILINE)[-1] + f" {before.count(chr(10))}"


def expected(block):
    return re.findall(r"print\(.*\)  # (.*)$", block, re.MULTILINE)


@pytest.fixture
def place(tmp_path):
    """A folder with the files that the examples name."""
    shutil.copy(SAMPLES / "bent_sheet_bracket.step", tmp_path / "bracket.step")
    (tmp_path / "parts").mkdir()
    for name in ("block.step", "tube.step"):
        shutil.copy(SAMPLES / name, tmp_path / "parts")
    (tmp_path / "parts" / "damaged.step").write_text("ISO-10303-21;\n")
    return tmp_path


def test_there_are_examples_and_each_says_what_it_prints():
    assert len(SCRIPTS) >= 7 and len(CONSOLE) == 1 and len(SCRIPTS) + len(CONSOLE) == len(BLOCKS)
    for block in SCRIPTS + CONSOLE:
        assert block.count("print(") == len(expected(block)) > 0


@pytest.mark.parametrize("block", SCRIPTS, ids=title)
def test_a_script_prints_what_it_says(block, place):
    ran = subprocess.run([sys.executable, "-c", block], cwd=place, capture_output=True, encoding="utf-8",
                         env=environment(THINPART_CACHE=str(place / "cache")))
    assert ran.stdout.splitlines() == expected(block), ran.stderr
    assert ran.returncode == 0


@pytest.mark.parametrize("block", CONSOLE, ids=title)
def test_what_is_typed_into_freecad_prints_what_it_says(block, place):
    (place / "typed.txt").write_text(block)
    (place / "console.py").write_text(_TYPED.format(path=str(place / "typed.txt"), checkout=str(ROOT)))
    ran = subprocess.run([FREECADCMD, "console.py"], cwd=place, capture_output=True, encoding="utf-8",
                         stdin=subprocess.DEVNULL, env=environment(
                             THINPART_CACHE=str(place / "cache"), HOME=str(place), FREECAD_USER_HOME=str(place)))
    lines = [line for line in ran.stdout.splitlines() if line.strip()]
    assert "typed to its end" in lines, ran.stdout + ran.stderr
    wanted, end = expected(block), lines.index("typed to its end")  # what FreeCAD itself says may come before or after
    assert lines[end - len(wanted):end] == wanted, ran.stdout + ran.stderr

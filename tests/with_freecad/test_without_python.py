# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCADCmd where there is no Python, and a Python that has numpy and scipy alone."""

import json
import os
import re
import shutil
import subprocess
from pathlib import Path

import pytest
from program import BARE_PYTHON, SAMPLES, environment, thinpart

from thinpart_workbench import PACKAGES_VARIABLE
from thinpart_workbench.system.landlock import landlock_version
from thinpart_workbench.system.python_process import module_command

FREECADCMD = shutil.which("freecadcmd")
SCRIPT = """
import atexit, sys
print("ran with", *sys.argv[1:], flush=True)
end = sys.argv[1]
if end == "raise": raise ValueError("what it says")
if end == "text": sys.exit("a sentence")
if end != "0": sys.exit(int(end))
"""


def run_by_freecadcmd(module, *arguments, **more):
    command, variables = module_command(module, arguments, FREECADCMD)
    variables.update(more, PYTHONPATH=os.pathsep.join(filter(None, (more.get("PYTHONPATH"), environment()["PYTHONPATH"]))))
    return subprocess.run(command, env={**os.environ, **variables}, capture_output=True, encoding="utf-8", timeout=120,
                          stdin=subprocess.DEVNULL)


@pytest.mark.parametrize("end, status", [("0", 0), ("7", 7), ("text", 1), ("raise", 1)])
def test_a_module_runs_once_and_its_status_is_that_of_freecadcmd(tmp_path, end, status):
    folder = tmp_path / "a folder \u00fc"
    folder.mkdir()
    (folder / "made_module.py").write_text(SCRIPT)
    run = run_by_freecadcmd("made_module", end, "--like-an-option", "/no/file.step", PYTHONPATH=str(folder))
    assert run.returncode == status, run.stderr
    assert run.stdout.count(f"ran with {end} --like-an-option /no/file.step") == 1
    assert ("a sentence" in run.stderr) == (end == "text") and ("what it says" in run.stderr) == (end == "raise")


def test_a_folder_is_classified_by_freecadcmd_and_its_workers(tmp_path):
    folder = tmp_path / "parts \u00fc"
    folder.mkdir()
    for name in ("wedge.step", "tube.step"):
        shutil.copy(SAMPLES / name, folder)
    (folder / "bad.step").write_bytes(b"ISO-10303-21;" + b"\0" * 1000)
    run = run_by_freecadcmd("thinpart_workbench", "classify", str(folder), "--json", "--jobs", "2")
    records = [json.loads(line) for line in run.stdout.splitlines() if line.startswith('{"file"')]
    assert run.returncode == 1, run.stderr
    assert sorted(each.get("category", "failed") for each in records) == ["failed", "normal", "thin"]
    assert len(list(folder.glob("*.thinpart.json"))) == 2
    if landlock_version():
        assert {json.dumps(each["confinement"]) for each in records} == {'{"files": "landlock", "network": "seccomp"}'}


def test_installed_packages_are_found_after_those_of_freecads_python(tmp_path, monkeypatch):
    for name in ("numpy", "made_package"):
        (tmp_path / name).mkdir()
        (tmp_path / name / "__init__.py").write_text("here = True\n")
    monkeypatch.setenv(PACKAGES_VARIABLE, os.pathsep.join([str(tmp_path / "gone"), str(tmp_path)]))
    program = ("import thinpart_workbench, numpy, made_package\n"
               "print(made_package.here, hasattr(numpy, 'here'))")
    run = subprocess.run(["/usr/bin/python3", "-c", program], env=environment(), capture_output=True, encoding="utf-8")
    assert run.stdout.split() == ["True", "False"], run.stderr


def test_learning_without_scikit_learn_is_refused_in_one_sentence(tmp_path, monkeypatch):
    monkeypatch.setenv("THINPART_TEST_PATH", str(BARE_PYTHON))
    run = thinpart("learn", tmp_path, "-o", tmp_path / "house.json")
    assert run.returncode == 1 and run.stdout == "" and not (tmp_path / "house.json").exists()
    assert run.stderr.count("\n") == 1 and "scikit-learn" in run.stderr


@pytest.mark.parametrize("said", [{"FORCE_COLOR": "1"}, {"FORCE_COLOR": "1", "NO_COLOR": "1"}, {"NO_COLOR": "1"}, {}])
def test_a_table_in_colours_has_the_cells_of_one_without(tmp_path, monkeypatch, said):
    shutil.copy(SAMPLES / "wedge.step", tmp_path / "\u5bec.step")
    shutil.copy(SAMPLES / "assembly_of_three.FCStd", tmp_path)
    plain = thinpart("classify", tmp_path, "--no-info").stdout
    for name, value in said.items():
        monkeypatch.setenv(name, value)
    shown = thinpart("classify", tmp_path, "--no-info").stdout
    assert re.sub(r"\x1b\[[\d;]*m", "", shown) == plain and Path(tmp_path, "\u5bec.step").name in plain
    assert ("\x1b[32mnormal\x1b[0m" in shown) == ("\x1b[1mFile\x1b[0m" in shown) == ("FORCE_COLOR" in said)

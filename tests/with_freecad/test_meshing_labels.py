# SPDX-License-Identifier: LGPL-2.1-or-later
"""Labels without a person: parts that the real Gmsh meshes, and what keeps it from doing so."""

import csv
import json
import os
import shutil
import signal
import stat
import subprocess
import sys

import pytest
import time_limit
from program import SAMPLES, environment, thinpart

from thinpart_workbench.api.learning import label_by_meshing
from thinpart_workbench.core.analysis_limits import Limits
from thinpart_workbench.core.errors import ThinPartError
from thinpart_workbench.core.judging.criteria import load_profile

needs_gmsh = pytest.mark.skipif(shutil.which("gmsh") is None, reason="gmsh is not installed")
LIMITS = Limits(60.0, 4096, 2)


@pytest.fixture(scope="module")
def classified(tmp_path_factory):
    """Samples and made parts: a block, a thin sheet, a block with a thin fin, an assembly, and a mesh."""
    import Part

    folder = tmp_path_factory.mktemp("classified")
    for name in ("block.FCStd", "assembly_of_three.step"):
        shutil.copy(SAMPLES / name, folder)
    block = Part.makeBox(100, 60, 40)
    block.exportStep(str(folder / "solid.step"))
    Part.makeBox(100, 80, 0.3).exportStep(str(folder / "sheet.step"))
    fin = Part.makeBox(0.3, 60, 25)
    fin.translate((50, 0, 40))
    block.fuse(fin).removeSplitter().exportBrep(str(folder / "fin.brep"))
    (folder / "triangles.stl").write_bytes(b"")
    import MeshPart

    MeshPart.meshFromShape(block, LinearDeflection=1.0).write(str(folder / "triangles.stl"))
    assert thinpart("classify", folder, "--jobs", 2).returncode == 0
    return folder


@pytest.fixture
def library(classified, tmp_path, monkeypatch):
    monkeypatch.setenv("THINPART_CACHE", str(tmp_path / "cache"))
    return shutil.copytree(classified, tmp_path / "library", copy_function=shutil.copy2)


@pytest.fixture
def other_gmsh(tmp_path, monkeypatch):
    """Puts a program in the place of Gmsh, for faults that the real one cannot be made to have."""
    def put(text):
        (tmp_path / "bin").mkdir(exist_ok=True)
        program = tmp_path / "bin" / "gmsh"
        program.write_text(f'#!/bin/sh\n[ "$1" = --version ] && echo 9.9.9 && exit\n{text}\n')
        program.chmod(program.stat().st_mode | stat.S_IXUSR)
        monkeypatch.setenv("PATH", f"{tmp_path / 'bin'}{os.pathsep}{os.environ['PATH']}")

    return put


@needs_gmsh
def test_blocks_are_normal_sheets_thin_and_fins_thin_features(library):
    meshing = label_by_meshing(library, limits=LIMITS)
    found = {result.file: result for result in meshing.results if result.file != "assembly_of_three.step"}
    assert {file: result.category for file, result in found.items()} == {
        "block.FCStd": "normal", "solid.step": "normal", "sheet.step": "thin", "fin.brep": "thin_features"}
    assert found["sheet.step"].figures["trouble_share"] > 0.9 and found["solid.step"].figures["trouble_share"] == 0.0
    assert 0.05 < found["fin.brep"].figures["trouble_share"] < 0.5 and found["fin.brep"].figures["least_ratio"] < 0.3
    assert len([result for result in meshing.results if result.file == "assembly_of_three.step"]) == 3
    failure, = meshing.failures
    assert failure["file"] == "triangles.stl" and "triangles" in failure["message"]
    person, = {label.person for label in meshing.labels}
    assert person == meshing.labelling.person and person.startswith("gmsh ")
    judged = {condition.quantity.symbol for criterion in load_profile().criteria for condition in criterion.conditions}
    assert {each.symbol for each in meshing.quantities} >= {"V/VBB", "F[0;0.05]", *judged}


@needs_gmsh
def test_the_command_writes_labels_that_learn_reads_and_goes_on_where_it_was(library, tmp_path):
    table = tmp_path / "gmsh.csv"
    run = thinpart("learn", "--from-meshing", library, "--export-labels", table, "--jobs", 2)
    assert run.returncode == 1 and "7 parts labelled by gmsh" in run.stdout and "Area under ROC" in run.stdout
    assert "triangles.stl" in run.stderr and run.stderr.count("\n") == 1
    with table.open(newline="") as file:
        rows = {row["file"]: row for row in csv.DictReader(file)}
    assert rows["sheet.step"]["category"] == "thin" and float(rows["sheet.step"]["trouble_share"]) > 0.9
    again = thinpart("learn", library, "--labels", table)
    assert "No part is" in again.stderr or "too few labels" in again.stderr
    kept = list((tmp_path / "cache" / "meshing").iterdir())
    assert len(kept) == 6
    kept[0].write_text("{")  # a damaged one is made anew
    content = json.loads(thinpart("learn", "--from-meshing", library, "--json").stdout)
    assert len(content["parts"]) == 7
    measured = [each["measured"] for part in kept for each in json.loads(part.read_text())]
    assert sorted(each["elements"] for each in measured if each) == sorted(each["elements"] for each in content["parts"])
    assert content["quantities"][0]["area"] >= content["quantities"][-1]["area"]


def test_a_crash_is_one_row_of_trouble_and_no_mesh_at_all(library, other_gmsh):
    other_gmsh("kill -SEGV $$")
    meshing = label_by_meshing(library, limits=LIMITS)
    assert {result.figures["reason"] for result in meshing.results} == {"Gmsh crashed"} and len(meshing.results) == 7
    assert all(result.has_trouble and result.category == "thin" for result in meshing.results)
    assert {(label.is_sure, label.second) for label in meshing.labels} == {(False, "thin_features")}
    assert meshing.quantities == (), "nothing tells trouble from trouble"


def test_what_takes_too_long_is_ended(library, other_gmsh):
    other_gmsh("while :; do :; done")
    for name in ("assembly_of_three.step", "block.FCStd", "fin.brep", "triangles.stl"):
        (library / f"{name}.thinpart.json").unlink()
    meshing = label_by_meshing(library, limits=Limits(1.0, 4096, 2))
    assert [result.figures["reason"] for result in meshing.results] == ["Gmsh took too long"] * 2


def test_what_gmsh_states_is_the_reason(library, other_gmsh):
    other_gmsh('echo "Info    : well"; echo "Error   : Invalid boundary mesh on surface 7"; exit 1')
    meshing = label_by_meshing(library, limits=LIMITS)
    assert {result.figures["reason"] for result in meshing.results} == {"Invalid boundary mesh on surface 7"}


def test_a_changed_document_is_not_meshed(library):
    if shutil.which("gmsh") is None:
        pytest.skip("gmsh is not installed")
    (library / "solid.step").write_text((library / "sheet.step").read_text() + "\n")
    meshing = label_by_meshing(library, limits=LIMITS)
    sentence, = [each["message"] for each in meshing.failures if each["file"] == "solid.step"]
    assert "has changed since it was classified" in sentence


def test_without_gmsh_it_is_one_sentence(library, monkeypatch, tmp_path):
    monkeypatch.setenv("PATH", str(tmp_path))
    monkeypatch.setattr("sys.executable", str(tmp_path / "python3"))
    with pytest.raises(ThinPartError, match="Meshing needs Gmsh: install it"):
        label_by_meshing(library)


def test_only_what_fits_together_is_accepted(library, tmp_path):
    run = thinpart("learn", "--from-meshing", library, "--labels", "x.csv")
    assert run.returncode == 2 and "stands instead of --labels" in run.stderr
    (tmp_path / "two.json").write_text(json.dumps({
        "format": "thinpart-profile", "version": 1, "name": "two", "categories": [{"name": "flat", "criteria": [
            {"id": 1, "conditions": [{"quantity": "D2/D3", "comparison": ">", "value": 6}]}]}]}))
    run = thinpart("learn", "--from-meshing", library, "--profile", tmp_path / "two.json")
    assert run.returncode == 2 and "has no category thin, thin_features" in run.stderr


@needs_gmsh
def test_ctrl_c_keeps_what_was_meshed(library, tmp_path):
    for number in range(30):
        shutil.copy2(library / "fin.brep", library / f"fin{number}.brep")
    assert thinpart("classify", library, "--jobs", 2).returncode == 0
    cache = tmp_path / "cache" / "meshing"
    run = subprocess.Popen([sys.executable, "-m", "thinpart_workbench", "learn", "--from-meshing", library, "--jobs", "1"],
                           env=environment(), stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    time_limit.wait_until(lambda: cache.is_dir() and any(cache.iterdir()), "a part that is meshed")
    run.send_signal(signal.SIGINT)
    _, errors = run.communicate()
    assert run.returncode == 130 and b"interrupted" in errors
    kept = len(list(cache.iterdir()))
    assert 0 < kept < 36
    assert len(json.loads(thinpart("learn", "--from-meshing", library, "--json").stdout)["parts"]) == 37

# SPDX-License-Identifier: LGPL-2.1-or-later
"""``learn --from-solver``: parts that the real Gmsh meshes and the real CalculiX solves, and what keeps them from it."""

import csv
import json
import os
import shutil

import pytest
from program import SAMPLES, thinpart

from thinpart_workbench.api.learning import label_by_solver
from thinpart_workbench.core.analysis_limits import Limits
from thinpart_workbench.core.errors import ThinPartError

needs_programs = pytest.mark.skipif(shutil.which("gmsh") is None or shutil.which("ccx") is None,
                                    reason="gmsh or calculix-ccx is not installed")
LIMITS = Limits(30.0, 6144, 2)


@pytest.fixture(scope="module")
def library(tmp_path_factory):
    """A bar, a sheet, a bar with a thin fin, a sample, and triangles; with a cache that all tests share."""
    import MeshPart
    import Part

    folder = tmp_path_factory.mktemp("library")
    bar = Part.makeBox(100, 12, 10)
    bar.exportStep(str(folder / "bar.step"))
    Part.makeBox(100, 100, 1).exportStep(str(folder / "sheet.step"))
    fin = Part.makeBox(0.5, 12, 12)
    fin.translate((50, 0, 10))
    bar.fuse(fin).removeSplitter().exportBrep(str(folder / "fin.brep"))
    shutil.copy(SAMPLES / "tube.step", folder)
    MeshPart.meshFromShape(bar, LinearDeflection=1.0).write(str(folder / "triangles.stl"))
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("THINPART_CACHE", str(tmp_path_factory.mktemp("cache")))
        assert thinpart("classify", folder, "--jobs", 2).returncode == 0
        yield folder


@needs_programs
@pytest.mark.timeout(400)  # some thirty meshes are solved, all in all a minute of a processor
def test_the_command_writes_labels_for_what_the_automatic_mesh_gets_wrong(library, tmp_path):
    table = tmp_path / "solver.csv"
    run = thinpart("learn", "--from-solver", library, "--export-labels", table, "--jobs", 2)
    assert run.returncode == 1 and "4 parts labelled by calculix 2." in run.stdout, run.stdout + run.stderr
    assert "triangles.stl" in run.stderr and run.stderr.count("\n") == 1
    with table.open(newline="") as file:
        rows = {row["file"]: row for row in csv.DictReader(file)}
    assert {file: (row["category"], row["sure"]) for file, row in rows.items()} == {
        "bar.step": ("normal", "yes"), "sheet.step": ("thin", "yes"), "tube.step": ("thin", "yes"),
        "fin.brep": ("thin_features", "yes")}
    assert float(rows["bar.step"]["error"]) < 0.04 < float(rows["sheet.step"]["error"])
    assert 0.05 < float(rows["fin.brep"]["coarse_share"]) < 0.5 < float(rows["tube.step"]["coarse_share"])
    again = thinpart("learn", library, "--labels", table)
    assert "No part is" in again.stderr or "too few labels" in again.stderr


@needs_programs
@pytest.mark.timeout(400)  # alone, it solves all of them first
def test_what_was_solved_is_kept_and_the_error_may_be_another(library):
    content = json.loads(thinpart("learn", "--from-solver", library, "--json", "--error", 0.02).stdout)
    parts = {part["file"]: part for part in content["parts"]}
    assert content["error"] == 0.02 and content["mesh_size"] == 0.1 and len(parts) == 4
    assert all(part["trouble"] for part in parts.values())
    # No wall of the bar is thin against an element, so that something else is to blame.
    assert (parts["bar.step"]["category"], parts["bar.step"]["sure"]) == ("thin_features", False)
    assert parts["sheet.step"]["category"] == "thin" and parts["sheet.step"]["sure"]


@needs_programs
def test_the_mesh_size_of_a_company_in_mm(library, tmp_path):
    for name in ("bar.step", "bar.step.thinpart.json"):
        shutil.copy2(library / name, tmp_path)
    labels = label_by_solver(tmp_path, limits=LIMITS, size_mm=7.0)
    result, = labels.results
    assert (result.category, result.has_trouble, labels.failures) == ("normal", False, ())
    assert result.figures["error"] < 0.02 and result.figures["nodes"] > 600
    assert labels.as_dict()["mesh_size_mm"] == 7.0 and labels.as_dict()["mesh_size"] is None
    assert {label.person for label in labels.labels} == {labels.labelling.person}


def test_without_a_solver_it_is_one_sentence(library, monkeypatch, tmp_path):
    if shutil.which("gmsh") is None:
        pytest.skip("gmsh is not installed")
    (tmp_path / "gmsh").symlink_to(shutil.which("gmsh"))
    monkeypatch.setenv("PATH", str(tmp_path))
    monkeypatch.setattr("sys.executable", str(tmp_path / "python3"))
    with pytest.raises(ThinPartError, match="This needs CalculiX: install it"):
        label_by_solver(library)


@needs_programs
@pytest.mark.timeout(150)  # three solutions that never end have 4 s of a processor each
def test_what_is_not_known_gets_no_label(library, tmp_path, monkeypatch):
    for name in ("sheet.step", "sheet.step.thinpart.json"):
        shutil.copy2(library / name, tmp_path)
    (tmp_path / "bin").mkdir()
    endless = tmp_path / "bin" / "ccx"
    endless.write_text('#!/bin/sh\n[ "$1" = -v ] && echo "This is Version 9.9" && exit\nwhile :; do :; done\n')
    endless.chmod(0o755)
    monkeypatch.setenv("PATH", f"{tmp_path / 'bin'}{os.pathsep}{os.environ['PATH']}")
    labels = label_by_solver(tmp_path, limits=Limits(1.0, 6144, 1))
    failure, = labels.failures
    assert labels.results == () and failure["part"] == "Solid1"
    assert failure["message"] == "The error of its mesh is not known (the solver took too long)."


@pytest.mark.parametrize("arguments, reason", [
    (("--from-solver", "--labels", "x.csv"), "--from-solver stands instead of --labels"),
    (("--from-solver", "--from-meshing"), "not allowed with argument"),
    (("--from-solver", "--mesh-size", 0.1, "--mesh-size-mm", 3), "not allowed with argument"),
    (("--from-solver", "--mesh-size", 0), "have to be more than 0"),
    (("--from-solver", "--error", "nan"), "have to be more than 0"),
    (("--from-meshing", "--mesh-size", 0.1), "belong to --from-solver"),
    (("--error", 0.1), "belong to --from-solver")])
def test_only_what_fits_together_is_accepted(library, arguments, reason):
    run = thinpart("learn", library, *arguments)
    assert run.returncode == 2 and reason in run.stderr

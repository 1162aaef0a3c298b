# SPDX-License-Identifier: LGPL-2.1-or-later
"""``thinpart size --shell FILE.inp`` of walls on thick bodies, with the real Gmsh and CalculiX: shell and solid, tied."""

import json
import re
import shutil
import subprocess

import numpy as np
import pytest
from program import thinpart

pytestmark = pytest.mark.skipif(shutil.which("gmsh") is None, reason="gmsh is not installed")


@pytest.fixture(autouse=True)
def own_cache(tmp_path, monkeypatch):
    monkeypatch.setenv("THINPART_CACHE", str(tmp_path / "cache"))


def plate_with_boss():
    import FreeCAD
    import Part

    return Part.makeBox(160, 100, 4).fuse(Part.makeCylinder(15, 30, FreeCAD.Vector(80, 50, 0)))


def ribbed_block():
    import FreeCAD
    import Part

    return Part.makeBox(100, 60, 20).fuse([Part.makeBox(100, 4, 50, FreeCAD.Vector(0, y, 20)) for y in (6, 28, 50)])


def plate_with_a_filleted_boss():
    shape = plate_with_boss().removeSplitter()
    return shape.makeFillet(3.0, [edge for edge in shape.Edges if edge.BoundBox.ZMin > 3.9 and edge.BoundBox.ZMax < 4.1
                                  and edge.Curve.TypeId == "Part::GeomCircle"])


def written(shape, folder, name="part.inp"):
    """The record of the shell of a part, what was said, and the file."""
    shape.removeSplitter().Solids[0].exportBrep(str(folder / "part.brep"))
    run = thinpart("size", folder / "part.brep", "--shell", folder / name, "--json")
    assert run.returncode == 0, run.stderr
    line = next(json.loads(line) for line in run.stdout.splitlines() if line.startswith('{"file"'))
    return line["shell"], folder / name


def frequencies(folder, name, text):
    """Elastic frequencies of a free body, and what CalculiX said."""
    (folder / f"{name}.inp").write_text(text + "*STEP\n*FREQUENCY\n12\n*END STEP\n")
    end = subprocess.run(["ccx", name], cwd=folder, capture_output=True, text=True, timeout=50)
    assert "Job finished" in end.stdout, end.stdout[-1000:]
    lines = (folder / f"{name}.dat").read_text().split("P A R T I C I P A T I O N")[0].splitlines()
    return np.array([float(line.split()[3]) for line in lines if re.match(r"\s+\d+(\s+\S+){4}$", line)])[6:], end.stdout


PLATE = (854.1, 939.7, 1742.9, 2042.4, 2231.4, 2633.8)
BLOCK = (1321.4, 1330.9, 2024.9, 2034.5, 2040.5, 2170.4)
"""Of the solids, Hz: tetrahedra of second order of 5.2 mm, 11,149 and 18,181 nodes."""


@pytest.mark.skipif(shutil.which("ccx") is None, reason="calculix-ccx is not installed")
@pytest.mark.parametrize("shape, solid", [(plate_with_boss, PLATE), (ribbed_block, BLOCK)])
def test_shell_and_solid_swing_as_the_solid_does(shape, solid, tmp_path):
    record, path = written(shape(), tmp_path)
    assert record["solid"]["elements"] > 100 and record["left_solid"] == [] and record["warnings"] == []
    assert record["volume_share"] + record["solid"]["volume_share"] == pytest.approx(1.0, abs=0.01)
    found, said = frequencies(tmp_path, "mixed", path.read_text())
    assert "no tied MPC" not in said
    assert found == pytest.approx(solid, rel=0.03)


def test_the_cut_runs_below_the_boss_and_before_its_fillet(tmp_path):
    record, path = written(plate_with_a_filleted_boss(), tmp_path)
    # A cylinder of the plate below boss and fillet is solid with them.
    assert record["walls"][0]["area"] == pytest.approx(160 * 100 - np.pi * 18 ** 2, rel=0.01)
    text = path.read_text()
    ends = re.search(r"NAME=SHELLEND\n((?:\d+,S[345]\n)+)\*TIE", text)
    assert ends is not None and len(ends[1].splitlines()) >= 10
    # All numbers are distinct.
    nodes = re.findall(r"^(\d+),\S+,\S+,\S+$", "".join(re.findall(r"\*NODE[^\n]*\n([^*]*)", text)), re.MULTILINE)
    assert len(nodes) == len(set(nodes)) == record["nodes"] + record["solid"]["nodes"]


def test_other_formats_have_the_shell_alone(tmp_path):
    record, path = written(plate_with_boss(), tmp_path, "part.msh")
    assert record["solid"] is None and path.exists()


def test_a_part_that_is_all_shell_has_no_solid(tmp_path):
    import Part

    record, path = written(Part.makeBox(100, 50, 2).fuse(Part.makeBox(2, 50, 40)), tmp_path)
    assert record["solid"] is None and record["warnings"] == [] and "*TIE" not in path.read_text()


def test_what_is_said_has_both(tmp_path):
    ribbed_block().removeSplitter().Solids[0].exportBrep(str(tmp_path / "part.brep"))
    run = thinpart("size", tmp_path / "part.brep", "--shell", tmp_path / "part.inp")
    assert "The rest, 66.7 % of the volume, is solid: " in run.stdout
    assert "The shell and what is solid, tied to it, were written to part.inp" in run.stdout

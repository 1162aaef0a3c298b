# SPDX-License-Identifier: LGPL-2.1-or-later
"""``thinpart size --shell`` with the real Gmsh and CalculiX: mid-surfaces, their files, and how they bend."""

import csv
import json
import os
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


@pytest.fixture(scope="module")
def parts(tmp_path_factory):
    """Sheet, profiles, a block, a mesh."""
    import FreeCAD
    import MeshPart
    import Part

    folder = tmp_path_factory.mktemp("parts")
    plate = Part.makeBox(100, 30, 2)
    plate.exportBrep(str(folder / "plate.brep"))
    beam = Part.makeBox(200, 60, 6).fuse([
        Part.makeBox(200, 4, 80, FreeCAD.Vector(0, 28, 0)), Part.makeBox(200, 60, 6, FreeCAD.Vector(0, 0, 74))])
    beam.removeSplitter().exportStep(str(folder / "beam.step"))
    angle = Part.makeBox(60, 40, 2).fuse(Part.makeBox(2, 40, 30)).removeSplitter()
    angle.cut(Part.makeCylinder(8, 9, FreeCAD.Vector(35, 20, -2))).exportStep(str(folder / "angle.step"))
    tube = Part.makeCylinder(20, 90).cut(Part.makeCylinder(18, 90))
    tube.exportStep(str(folder / "tube.step"))
    block = Part.makeBox(50, 40, 30)
    block.exportBrep(str(folder / "block.brep"))
    MeshPart.meshFromShape(plate, LinearDeflection=1.0).write(str(folder / "triangles.stl"))
    return folder


def record(*arguments):
    run = thinpart("size", *arguments, "--json")
    return next(json.loads(line) for line in run.stdout.splitlines() if line.startswith('{"file"')), run


def read_inp(path):
    """Nodes and elements of a file for CalculiX: two dicts by number."""
    nodes, elements, section = {}, {}, ""
    for line in path.read_text().splitlines():
        if line.startswith("*"):
            section = line
        elif section.startswith("*NODE"):
            number, *point = line.split(",")
            nodes[int(number)] = [float(value) for value in point]
        elif section.startswith("*ELEMENT"):
            number, *corners = map(int, line.split(","))
            elements[number] = corners
    return nodes, elements


def test_an_i_beam_keeps_its_web_and_both_flanges(parts, tmp_path):
    line, run = record(parts / "beam.step", "--shell", tmp_path / "beam.inp")
    shell = line["shell"]
    assert run.returncode == 0 and line["idealisation"]["advice"] == "shell"
    # Half-way through the walls: flanges 60 wide, a web between their middles.
    areas = sorted((round(wall["thickness"], 3), round(wall["area"], 1)) for wall in shell["walls"])
    assert areas == [(4.0, 200.0 * 74.0), (6.0, 12000.0), (6.0, 12000.0)]
    assert shell["left_solid"] == [] and shell["warnings"] == []
    nodes, elements = read_inp(tmp_path / "beam.inp")
    assert (len(nodes), len(elements)) == (shell["nodes"], shell["elements"])
    # Where the web meets a flange, three triangles share an edge: they are welded.
    sides = [tuple(sorted(pair)) for corners in elements.values() for pair in zip(corners[:3], corners[1:3] + corners[:1])]
    _, shared = np.unique(sides, axis=0, return_counts=True)
    assert shared.max() == 3
    heights = {round(point[2], 6) for point in nodes.values()}
    assert min(heights) == 3.0 and max(heights) == 77.0


def test_an_l_profile_is_welded_and_keeps_its_hole(parts, tmp_path):
    line, _ = record(parts / "angle.step", "--shell", tmp_path / "angle.inp")
    nodes, elements = read_inp(tmp_path / "angle.inp")
    sides = [tuple(sorted(pair)) for corners in elements.values() for pair in zip(corners[:3], corners[1:3] + corners[:1])]
    edges, count = np.unique(sides, axis=0, return_counts=True)
    ends = edges[count == 1]
    points = np.array([[nodes[node] for node in edge] for edge in ends])
    length = np.linalg.norm(points[:, 1] - points[:, 0], axis=1).sum()
    # Two legs from the corner of the middles, and the hole's outline as chords.
    assert length == pytest.approx(2 * (59 + 29 + 40) + 2 * np.pi * 8, rel=0.02)
    volume = sum(wall["thickness"] * wall["area"] for wall in line["shell"]["walls"])
    assert volume == pytest.approx((59 * 40 - np.pi * 64 + 29 * 40) * 2.0, rel=0.01)


def test_the_height_of_a_strip_on_edge_is_no_wall(tmp_path):
    """A frame of strips of 3.5 by 14 mm, whose top and bottom have material between them everywhere too."""
    import FreeCAD
    import Part

    frame = Part.makeBox(90, 215, 14).cut(Part.makeBox(83, 212, 14, FreeCAD.Vector(3.5, 3.5, 0)))
    frame.exportBrep(str(tmp_path / "frame.brep"))
    line, run = record(tmp_path / "frame.brep", "--shell", tmp_path / "frame.inp")
    assert run.returncode == 0, run.stderr
    shell = line["shell"]
    assert [wall["thickness"] for wall in shell["walls"]] == [pytest.approx(3.5)] * 3
    assert shell["volume_share"] == pytest.approx(1.0, abs=0.01) and shell["left_solid"] == []


def test_a_small_piece_that_does_not_meet_the_rest_is_left_solid(tmp_path):
    """A lug on a boss on a plate: between its mid-surface and that of the plate is solid material."""
    import FreeCAD
    import Part

    boss, lug = Part.makeBox(12, 12, 10, FreeCAD.Vector(50, 30, 2)), Part.makeBox(1.5, 12, 12, FreeCAD.Vector(55, 30, 12))
    part = Part.makeBox(120, 80, 2).fuse([boss, lug]).removeSplitter()
    part.exportBrep(str(tmp_path / "lug.brep"))
    line, run = record(tmp_path / "lug.brep", "--shell", tmp_path / "lug.msh")
    assert run.returncode == 0, run.stderr
    shell = line["shell"]
    assert [wall["thickness"] for wall in shell["walls"]] == [pytest.approx(2.0)]
    assert any("Pieces that do not meet the rest were left out" in warning for warning in shell["warnings"])
    assert pytest.approx(1.5) in [each["thickness"] for each in shell["left_solid"]]
    nodes = (tmp_path / "lug.msh").read_text().split("$Nodes\n")[1].split("$EndNodes")[0].splitlines()[1:]
    assert {float(node.split()[3]) for node in nodes} == {1.0}
    # For CalculiX, both are solid, and tied to the plate.
    line, _ = record(tmp_path / "lug.brep", "--shell", tmp_path / "lug.inp")
    assert line["shell"]["solid"]["elements"] > 20 and line["shell"]["warnings"] == []


@pytest.mark.parametrize("ending", ["msh", "unv"])
def test_gmsh_reads_the_file(parts, tmp_path, ending):
    path = tmp_path / f"tube.{ending}"
    line, _ = record(parts / "tube.step", "--shell", path)
    end = subprocess.run(["gmsh", path, "-0", "-v", "4", "-o", tmp_path / "again.msh", "-format", "msh2", "-save_all"],
                         capture_output=True, text=True, timeout=50)
    counts = [int(value) for value in re.findall(r"(\d+) (?:nodes|elements)", end.stdout + end.stderr)]
    saved = (tmp_path / "again.msh").read_text()
    assert int(saved.split("$Nodes\n")[1].split()[0]) == line["shell"]["nodes"], counts
    assert int(saved.split("$Elements\n")[1].split()[0]) == line["shell"]["elements"]


@pytest.mark.skipif(shutil.which("ccx") is None, reason="calculix-ccx is not installed")
def test_calculix_bends_the_shell_of_a_plate_as_a_beam_does(parts, tmp_path):
    record(parts / "plate.brep", "--shell", tmp_path / "plate.inp")
    nodes, _ = read_inp(tmp_path / "plate.inp")
    held = [number for number, point in nodes.items() if abs(point[0]) < 1e-6]
    tip = [number for number, point in nodes.items() if abs(point[0] - 100.0) < 1e-6]
    lines = ["*NSET, NSET=HELD", *(f"{node}," for node in held), "*NSET, NSET=TIP", *(f"{node}," for node in tip),
             "*BOUNDARY", "HELD,1,6", "*STEP", "*STATIC", "*CLOAD", *(f"{node},3,{10.0 / len(tip)}" for node in tip),
             "*NODE FILE, OUTPUT=2D", "U", "*END STEP", ""]
    (tmp_path / "bent.inp").write_text((tmp_path / "plate.inp").read_text() + "\n".join(lines))
    end = subprocess.run(["ccx", "bent"], cwd=tmp_path, capture_output=True, text=True, timeout=50)
    assert "Job finished" in end.stdout, end.stdout[-1000:]
    moved = {int(line[3:13]): float(line[37:49]) for line in (tmp_path / "bent.frd").read_text().split("DISP")[1].split(
        " -3")[0].splitlines() if line.startswith(" -1")}
    # F L^3 / 3 E I, with E between that of a narrow beam and that of a wide plate, 1 / (1 - 0.3^2) of it.
    beam = 10.0 * 100.0 ** 3 / (3 * 210000.0 * 30.0 * 2.0 ** 3 / 12)
    assert 0.91 * beam < np.mean([moved[node] for node in tip]) < 1.01 * beam


def test_what_has_no_shell_says_so_and_leaves_no_file(parts, tmp_path):
    for name, why in (
            ("block.brep", "No wall of block is wide and thin enough for a shell: mesh it as a solid"),
            ("triangles.stl", "made of triangles, which have no mid-surface: use its STEP file")):
        path = tmp_path / "none.inp"
        run = thinpart("size", parts / name, "--shell", path)
        assert run.returncode != 0 and why in run.stderr and "was not written" in run.stderr
        assert not path.exists()


def test_a_mesh_cut_short_is_said_and_leaves_no_file_and_is_not_kept(parts, tmp_path, monkeypatch):
    """As on a full disk: a program in the place of Gmsh writes the beginning of a mesh."""
    program, path = tmp_path / "bin" / "gmsh", os.environ["PATH"]
    program.parent.mkdir()
    start = "$MeshFormat\\n2.2 1 8\\n\\1\\0\\0\\0\\n$EndMeshFormat\\n$Nodes\\n9\\n"
    version = subprocess.run(["gmsh", "--version"], capture_output=True, text=True)
    known = (version.stdout + version.stderr).split()[-1]
    program.write_text(f'#!/bin/sh\n[ "$1" = --version ] && echo {known} && exit\nfor last; do :; done\n'
                       f"printf '{start}' > \"$last\"\n")
    program.chmod(0o755)
    monkeypatch.setenv("PATH", f"{program.parent}{os.pathsep}{path}")
    shell = tmp_path / "plate.inp"
    run = thinpart("size", parts / "plate.brep", "--shell", shell)
    assert run.returncode == 1 and not shell.exists() and "Traceback" not in run.stderr
    assert "mid-surface of plate could not be meshed (its mesh is incomplete: is the disk full?)" in run.stderr
    monkeypatch.setenv("PATH", path)
    assert thinpart("size", parts / "plate.brep", "--shell", shell).returncode == 0 and shell.exists()


def test_the_advice_agrees_with_what_is_refused(parts):
    """A thin plate of triangles: a shell would suit it, and cannot be made."""
    line, _ = record(parts / "triangles.stl")
    assert line["idealisation"]["advice"] == "solid" and "made of triangles" in line["idealisation"]["no_shell"]
    run = thinpart("size", parts / "triangles.stl")
    assert "Shell or solid: a solid" in run.stdout and "No shell: " in run.stdout and "use its STEP file" in run.stdout
    line, _ = record(parts / "plate.brep")
    assert line["idealisation"]["advice"] == "shell" and line["idealisation"]["no_shell"] == ""


def test_freecad_reads_the_universal_file_in_millimetres_with_its_groups(parts, tmp_path):
    import Fem

    line, _ = record(parts / "angle.step", "--shell", tmp_path / "angle.unv")
    mesh = Fem.read(str(tmp_path / "angle.unv"))
    assert (mesh.NodeCount, mesh.FaceCount) == (line["shell"]["nodes"], line["shell"]["elements"])
    assert max(point.x for point in mesh.Nodes.values()) == pytest.approx(60.0)
    assert [mesh.getGroupName(each) for each in mesh.Groups] == ["thickness_2_mm"]


def sheet_with_a_sharp_bend(thick=2.0, inner=0.4):
    """Two legs of sheet metal, with a bend that is narrower than a wall."""
    import FreeCAD
    import Part

    def bend(radius):
        middle = inner + thick - radius * np.sqrt(0.5)
        far = inner + thick - radius
        return Part.Arc(FreeCAD.Vector(inner + thick, 0, far), FreeCAD.Vector(middle, 0, middle),
                        FreeCAD.Vector(far, 0, inner + thick)).toShape()

    outer = inner + thick
    corners = [(outer, 0), (50, 0), (50, thick), (outer, thick)], [(thick, outer), (thick, 40), (0, 40), (0, outer)]
    lines = [Part.makeLine(*(FreeCAD.Vector(x, 0, z) for x, z in ends)) for row in corners for ends in zip(row, row[1:])]
    wire = Part.Wire(Part.__sortEdges__([*lines, bend(inner), bend(outer)]))
    return Part.Face(wire).extrude(FreeCAD.Vector(0, 30, 0))


def plate_with_a_rounded_rim():
    """A rim on a plate, round outside and sharp inside: its walls end before the middle of the plate."""
    import FreeCAD
    import Part

    rim = Part.makeBox(60, 60, 20).cut(Part.makeBox(56, 56, 18, FreeCAD.Vector(2, 2, 2)))
    return rim.makeFillet(3.0, [edge for edge in rim.Edges if edge.BoundBox.ZMax < 1e-6])


@pytest.mark.parametrize("shape", [sheet_with_a_sharp_bend, plate_with_a_rounded_rim])
def test_walls_meet_where_the_joint_between_them_is_narrow(shape, tmp_path):
    shape().exportBrep(str(tmp_path / "part.brep"))
    line, run = record(tmp_path / "part.brep", "--shell", tmp_path / "part.inp")
    assert run.returncode == 0, line["shell"]["reason"]
    nodes, elements = read_inp(tmp_path / "part.inp")
    piece = {node: node for node in nodes}

    def root(node):
        while piece[node] != node:
            node = piece[node]
        return node

    for corners in elements.values():
        for node in corners[1:]:
            piece[root(node)] = root(corners[0])
    assert len({root(node) for node in nodes}) == 1
    assert line["shell"]["volume_share"] == pytest.approx(1.0, abs=0.12)


def test_another_ending_is_refused_before_anything_is_measured(parts, tmp_path):
    run = thinpart("size", parts / "plate.brep", "--shell", tmp_path / "plate.vtk")
    assert run.returncode == 2 and ".inp, .msh, .unv" in run.stderr


def test_the_table_names_what_was_idealised(parts, tmp_path):
    thinpart("size", parts / "plate.brep", "--shell", tmp_path / "plate.unv", "--csv", tmp_path / "table.csv")
    row, = csv.DictReader((tmp_path / "table.csv").read_text().splitlines())
    assert row["advice"] == "shell" and int(row["shell_mesh_elements"]) > 10 and row["left_solid"] == ""
    assert float(row["shell_mesh_volume_share"]) == pytest.approx(1.0, rel=1e-3)

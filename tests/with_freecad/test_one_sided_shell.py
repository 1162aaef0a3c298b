# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shells of walls that no two faces with a surface half-way between them make: a vase of revolved splines, its file, its
frequencies."""

import shutil
import subprocess

import numpy as np
import pytest

from thinpart_workbench.api.mesh_sizes import shell_of
from thinpart_workbench.core.analysis_settings import AnalysisSettings
from thinpart_workbench.core.errors import ThinPartError
from thinpart_workbench.core.shells.shell_settings import ShellSettings
from thinpart_workbench.core.thickness.measurement import measure
from thinpart_workbench.storage.exchange.shell_files import inp_text

SOLID = [1679.2, 1679.6, 3068.3, 3068.6, 4686.3, 4686.8]
"""Elastic frequencies of the vase, Hz, from 31,671 nodes of tetrahedra of second order; 18,662 are within 0.3 %."""

pytestmark = pytest.mark.skipif(shutil.which("gmsh") is None, reason="gmsh is not installed")


def vase(thick=2.0, taper=0.0):
    """A solid of revolution between two splines, which are a thickness from each other; it may grow towards the top."""
    import FreeCAD
    import Part

    height = np.linspace(0.0, 100.0, 21)
    radius = 30.0 + 8.0 * np.sin(height / 18.0)
    slope = 8.0 / 18.0 * np.cos(height / 18.0)
    across = np.column_stack([np.ones(21), -slope]) / np.hypot(1.0, slope)[:, None]
    inner = np.column_stack([radius, height]) - (thick + taper * height / 100.0)[:, None] * across
    inner[:, 1] = np.clip(inner[:, 1], 0.0, 100.0)
    inner[[0, -1], 1] = 0.0, 100.0

    def edge(points):
        spline = Part.BSplineCurve()
        spline.interpolate([FreeCAD.Vector(x, 0, z) for x, z in points])
        return spline.toShape()

    outer, within = edge(np.column_stack([radius, height])), edge(inner)
    ends = [Part.makeLine(*(FreeCAD.Vector(x, 0, z) for x, z in pair)) for pair in (
        (inner[0], (radius[0], 0.0)), (inner[-1], (radius[-1], 100.0)))]
    wire = Part.Wire(Part.__sortEdges__([outer, ends[1], within, ends[0]]))
    return Part.Face(wire).revolve(FreeCAD.Vector(), FreeCAD.Vector(0, 0, 1), 360).Solids[0]


def measured(shape):
    from thinpart_workbench.freecad_adapter.shapes.part import SolidPart

    settings, part = AnalysisSettings(), SolidPart("vase", "Vase", shape=shape)
    surface, _ = part.surface_mesh(settings, settings.linear_deflection)
    return part, measure(surface, settings)


@pytest.fixture(scope="module")
def made():
    shape = vase(np.full(21, 2.0))
    part, measurement = measured(shape)
    return shape, part, measurement, shell_of(part, measurement)


def test_it_lies_half_way_and_has_the_thickness_and_the_volume(made):
    import Part
    from FreeCAD import Vector

    shape, _, _, shell = made
    assert shell.is_moved and 500 < len(shell.mesh.points) < 5000
    assert shell.mesh.pieces == 1 and not shell.left_solid and not shell.warnings
    assert shell.volume_share == pytest.approx(1.0, abs=0.02)
    assert shell.mesh.thickness.mean() == pytest.approx(2.0, rel=0.01)
    assert np.quantile(shell.mesh.thickness, [0.02, 0.98]) == pytest.approx(2.0, rel=0.1)
    sides = sorted(shape.Faces, key=lambda face: -face.Area)[:2]
    used = np.unique(shell.mesh.triangles)[::7]
    for node in shell.mesh.points[used]:
        if 3.0 < node[2] < 97.0:
            place = Part.Vertex(Vector(*node))
            assert [face.distToShape(place)[0] for face in sides] == pytest.approx([1.0, 1.0], rel=0.08)


def test_thickness_that_varies_along_the_wall_is_in_the_file():
    shape = vase(np.full(21, 2.0), taper=np.full(21, 1.5))
    shell = shell_of(*measured(shape))
    assert shell.volume_share == pytest.approx(1.0, abs=0.02)
    centre = shell.mesh.points[shell.mesh.triangles[:, :3]].mean(axis=1)
    for low, high, thickness in ((10.0, 20.0, 2.225), (80.0, 90.0, 3.275)):
        own = (centre[:, 2] > low) & (centre[:, 2] < high)
        assert np.median(shell.mesh.thickness[own]) == pytest.approx(thickness, rel=0.08)
    text = inp_text(shell.mesh, "vase")
    assert "NODAL THICKNESS\n" in text
    given = {int(a): float(b) for a, b in (line.split(",") for line in text.split("*NODAL THICKNESS\n")[1].split())}
    assert set(given) == set(np.unique(shell.mesh.triangles) + 1)
    low, high = (np.mean([given[row + 1] for row in np.flatnonzero(own)]) for own in (
        shell.mesh.points[:, 2] < 5.0, shell.mesh.points[:, 2] > 95.0))
    assert 1.85 < low < 2.3 and 3.2 < high < 3.6


@pytest.mark.skipif(shutil.which("ccx") is None, reason="calculix-ccx is not installed")
def test_calculix_finds_the_frequencies_of_the_solid(made, tmp_path):
    (tmp_path / "vase.inp").write_text(inp_text(made[3].mesh, "vase") + "*STEP\n*FREQUENCY\n12\n*END STEP\n")
    end = subprocess.run(["ccx", "vase"], cwd=tmp_path, capture_output=True, text=True, timeout=50)
    assert "Job finished" in end.stdout, end.stdout[-1000:]
    lines = (tmp_path / "vase.dat").read_text().split("P A R T I C I P A T I O N")[0].splitlines()
    found = [float(line.split()[3]) for line in lines if len(line.split()) == 5 and line.split()[0].isdigit()]
    assert found[5] < 2.0 and found[6:] == pytest.approx(SOLID, rel=0.02)


def test_freecads_fem_is_told_that_it_has_no_faces_to_refer_to(made):
    _, part, measurement, _ = made
    with pytest.raises(ThinPartError) as caught:
        shell_of(part, measurement, ShellSettings(on_faces=True))
    assert caught.value.kind == "no_shell" and "As a file it may have a shell" in str(caught.value)

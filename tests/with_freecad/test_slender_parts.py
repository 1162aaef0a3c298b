# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rods, tubes, rings and coils from 1:10 to 1:50,000, against closed forms."""

import json
import math

import numpy as np
import pytest
from program import thinpart

from thinpart_workbench.core.analysis_settings import AnalysisSettings
from thinpart_workbench.core.descriptors.descriptor_table import Descriptors, quantity_named
from thinpart_workbench.core.descriptors.distribution import Distribution
from thinpart_workbench.core.judging.classification import classify
from thinpart_workbench.core.judging.criteria import Condition, load_profile
from thinpart_workbench.core.mesh.bounds import minimal_box
from thinpart_workbench.core.mesh.mass_properties import area, volume
from thinpart_workbench.core.record.part_record import descriptors_of
from thinpart_workbench.freecad_adapter.shapes.part import SolidPart
from thinpart_workbench.workflow.analysis.analyse_part import analyse_part

PAPER = load_profile("paper")
SLENDERNESS = (10, 100, 300, 1000, 3000, 10_000, 50_000)


def analysed(shape):
    return analyse_part(SolidPart("Part", "Part", shape=shape), AnalysisSettings(), PAPER)[1]


def turned(shape):
    import FreeCAD

    shape = shape.copy()
    shape.rotate(FreeCAD.Vector(1, 2, 3), FreeCAD.Vector(1, -2, 0.7), 37.0)
    return shape


def ring(length):
    import Part

    return Part.makeTorus(length / (2 * math.pi), 0.5)


def tube(length):
    import Part

    return Part.makeCylinder(0.5, length).cut(Part.makeCylinder(0.4, length))


def coil(turns, radius, pitch=3.0):
    """A wire of 1 mm."""
    import Part

    helix = Part.makeHelix(pitch, pitch * turns, radius)
    edge = helix.Edges[0]
    start = edge.FirstParameter
    circle = Part.makeCircle(0.5, edge.valueAt(start), edge.tangentAt(start))
    return Part.Wire(helix.Edges).makePipeShell([Part.Wire(circle)], True, True)


def check(record, volume, area, wall, box, thin_share, scale=1.0):
    """Everything lies within what the record says of itself; `thin_share` is F[0;0.25]."""
    measured = record["descriptors"]
    error = measured["thickness_mm"]["error_bound"]
    share = error / (2 * volume / area) / scale
    assert share < 0.11
    assert measured["volume_mm3"] == pytest.approx(volume * scale ** 3, rel=share)
    assert measured["area_mm2"] == pytest.approx(area * scale ** 2, rel=share)
    assert abs(measured["thickness_mm"]["min"] - wall * scale) <= error < 0.1 * wall * scale
    if box is not None:
        assert measured["box_mm"] == pytest.approx([side * scale for side in box], abs=error)
    assert measured["F"]["0:0.25"] == pytest.approx(thin_share, abs=0.005)
    assert measured["shares"]["parallel"] > thin_share - 0.005
    assert record["warnings"] == [] and record["reason"] == ""
    assert record["category"] == "thin"
    assert descriptors_of(record).length_error == 0.0


@pytest.mark.parametrize("length", SLENDERNESS)
def test_rod(length):
    import Part

    volume, side = math.pi / 4 * length, math.pi * length
    area = side + math.pi / 2
    for shape in (Part.makeCylinder(0.5, length), turned(Part.makeCylinder(0.5, length))):
        record = analysed(shape)
        check(record, volume, area, 1.0, (length, 1.0, 1.0), side / area)
        assert 4 in record["criteria"]


@pytest.mark.parametrize("length", SLENDERNESS)
def test_tube(length):
    side, ends = math.pi * 1.8 * length, 2 * math.pi * 0.09
    record = analysed(turned(tube(length)))
    check(record, math.pi * 0.09 * length, side + ends, 0.1, (length, 1.0, 1.0), side / (side + ends))


@pytest.mark.parametrize("length", SLENDERNESS[1:])
def test_ring(length):
    wide = length / math.pi + 1.0
    record = analysed(ring(length))
    check(record, math.pi / 4 * length, math.pi * length, 1.0, (wide, wide, 1.0), 1.0)


@pytest.mark.parametrize("turns, radius", [(1, 10.0), (2, 10.0), (5, 10.0), (8, 10.0), (4, 50.0)])
def test_coil(turns, radius):
    length = turns * math.hypot(2 * math.pi * radius, 3.0)
    record = analysed(coil(turns, radius))
    side = math.pi * length
    check(record, math.pi / 4 * length, side + math.pi / 2, 1.0, None, side / (side + math.pi / 2))


@pytest.mark.parametrize("scale", [1e-3, 1e3])
@pytest.mark.parametrize("shape", ["rod", "ring"])
def test_scale_changes_nothing(shape, scale):
    import Part

    made = Part.makeCylinder(0.5, 3000) if shape == "rod" else ring(3000)
    side, ends = math.pi * 3000, math.pi / 2 if shape == "rod" else 0.0
    made.scale(scale)
    record = analysed(made)
    record["warnings"] = [each for each in record["warnings"] if "unit" not in each]
    check(record, math.pi / 4 * 3000, side + ends, 1.0, None, side / (side + ends), scale)


@pytest.mark.timeout(120)  # OCC makes 400,000 triangles of the longest
@pytest.mark.parametrize("length", [300, 1000, 5000])
def test_a_rod_that_has_more_than_four_sided_faces(length):
    """A round end is no grid: OCC's mesher makes it, finer."""
    import FreeCAD
    import Part

    rod = Part.makeCylinder(0.5, length).fuse(Part.makeSphere(0.5, FreeCAD.Vector(0, 0, length)))
    volume = math.pi / 4 * length + math.pi / 12
    area = math.pi * length + math.pi / 4 + math.pi / 2
    check(analysed(rod.removeSplitter()), volume, area, 1.0, (length + 0.5, 1.0, 1.0), math.pi * length / area)


def test_a_wire_with_bends():
    """Straight pieces and arcs that share their circles."""
    import FreeCAD
    import Part

    path = Part.Wire([
        Part.makeLine((0, 0, 0), (0, 0, 2000)),
        Part.Arc(FreeCAD.Vector(0, 0, 2000), FreeCAD.Vector(5 * (1 - math.sqrt(0.5)), 0, 2000 + 5 * math.sqrt(0.5)),
                 FreeCAD.Vector(5, 0, 2005)).toShape(),
        Part.makeLine((5, 0, 2005), (3000, 0, 2005)),
    ])
    wire = path.makePipe(Part.Face(Part.Wire(Part.makeCircle(0.5))))
    length = 2000 + 2995 + 2.5 * math.pi
    check(analysed(wire), math.pi / 4 * length, math.pi * length + math.pi / 2, 1.0, None, 1.0)


def test_what_would_need_too_many_triangles_is_unknown_and_says_why():
    """As of a coil 50,000 times as long as thick, without the minutes that it takes to make one."""
    import Part

    part = SolidPart("Part", "Part", shape=Part.makeCylinder(0.5, 50_000))
    part.finest_deflection = lambda *_: None
    _, record = analyse_part(part, AnalysisSettings(), PAPER)
    assert record["category"] == "unknown"
    assert "too slender" in record["reason"] and "400,000 triangles" in record["reason"]
    assert record["warnings"]
    assert classify(descriptors_of(record), PAPER).reason == record["reason"]


@pytest.mark.parametrize("quantity, sides, threshold", [
    ("d2_d3", (30, 12, 1), 12.0), ("d2_d3", (12_000, 12, 1), 12.0), ("d1_d2", (21, 12, 2), 1.75)])
def test_a_box_exactly_at_a_threshold_stays_there(quantity, sides, threshold):
    import FreeCAD
    import Part

    named, random = quantity_named(quantity), np.random.default_rng(3)
    for _ in range(30):
        shape = Part.makeBox(*sides)
        shape.rotate(FreeCAD.Vector(), FreeCAD.Vector(*random.normal(size=3)), random.uniform(0, 360))
        shape.scale(10.0 ** random.uniform(-3, 3))
        mesh, _ = SolidPart("Part", "Part", shape=shape).surface_mesh(AnalysisSettings(), 0.001)
        shares = Distribution(*[np.array([], int)] * 4, np.array([]), 0.0, 0.0, 1.0, 0.0)
        measured = Descriptors(volume(mesh), area(mesh), minimal_box(mesh.vertices), shares, None)
        for comparison in "<>":
            assert Condition(named, comparison, threshold).check(measured, 1e-4).holds is False


def test_by_the_command_line(tmp_path):
    import Part

    for name, shape in (("rod", Part.makeCylinder(0.5, 3000)), ("coil", coil(2, 10.0))):
        shape.exportStep(str(tmp_path / f"{name}.step"))
    result = thinpart("classify", "--json", "--no-info", tmp_path)
    assert result.returncode == 0, result.stderr
    records = [json.loads(line) for line in result.stdout.splitlines()]
    assert [record["paper"]["category"] for record in records] == ["thin", "thin"]
    assert next(record["category"] for record in records if "rod" in record["file"]) == "normal"
    for record in records:
        length = 3000 if "rod" in record["file"] else 2 * math.hypot(20 * math.pi, 3.0)
        assert record["descriptors"]["volume_mm3"] == pytest.approx(math.pi / 4 * length, rel=5e-3)
        assert record["descriptors"]["thickness_mm"]["min"] == pytest.approx(1.0, rel=5e-3)

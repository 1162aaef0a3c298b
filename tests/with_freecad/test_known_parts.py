# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts of FreeCAD with known answers, in three tessellations and several places."""

import math
from dataclasses import replace

import pytest

from thinpart_workbench.core.analysis_settings import AnalysisSettings
from thinpart_workbench.core.judging.criteria import load_profile
from thinpart_workbench.freecad_adapter.shapes.part import SolidPart
from thinpart_workbench.workflow.analysis.analyse_part import analyse_part

PAPER = load_profile("paper")
DENSITIES = {
    "coarse": AnalysisSettings(linear_deflection=0.004, angular_deflection=5.0),
    "default": AnalysisSettings(),
    "fine": AnalysisSettings(linear_deflection=0.0003, angular_deflection=2.5),
}


def analysed(shape, density="default", **changes):
    settings = replace(DENSITIES[density], **changes)
    _, record = analyse_part(SolidPart("Part", "Part", shape=shape), settings, PAPER)
    record.update({key: record["descriptors"][key] for key in ("box_mm", "volume_ratio", "F")})
    record["wall"] = record["descriptors"]["thickness_mm"]
    return record


def turned(shape, shift=0.0):
    import FreeCAD

    shape = shape.copy()
    shape.rotate(FreeCAD.Vector(1, 2, 3), FreeCAD.Vector(1, -2, 0.7), 37.0)
    shape.translate(FreeCAD.Vector(shift, -shift, 2 * shift))
    return shape


def block():
    import Part

    return Part.makeBox(100, 60, 40)


def rib():
    import FreeCAD
    import Part

    return block().fuse(Part.makeBox(100, 6, 20, FreeCAD.Vector(0, 27, 40))).removeSplitter()


def block_with_web():
    """A hole of radius 10 whose edge leaves a web of 1 mm under the top face."""
    import FreeCAD
    import Part

    hole = Part.makeCylinder(10, 60, FreeCAD.Vector(50, 0, 29), FreeCAD.Vector(0, 1, 0))
    return block().cut(hole)


def plates_joined_by_a_pin():
    import FreeCAD
    import Part

    shape = Part.makeBox(100, 100, 2)
    shape = shape.fuse(Part.makeBox(100, 100, 2, FreeCAD.Vector(0, 0, 32)))
    return shape.fuse(Part.makeCylinder(4, 30, FreeCAD.Vector(50, 50, 2))).removeSplitter()


@pytest.mark.parametrize("density", DENSITIES)
@pytest.mark.parametrize("shift", [0.0, 1e6])
def test_tube(density, shift):
    import Part

    shape = Part.makeCylinder(20, 60).cut(Part.makeCylinder(18, 60))
    record = analysed(turned(shape, shift), density)
    assert record["criteria"] == [3, 4] and record["category"] == "thin"
    assert abs(record["wall"]["min"] - 2.0) <= record["wall"]["error_bound"]
    assert record["wall"]["max"] == pytest.approx(60, abs=record["wall"]["error_bound"] + 1e-3)
    assert record["box_mm"] == pytest.approx([60, 40, 40], rel=1e-3)


@pytest.mark.parametrize("density", DENSITIES)
def test_spherical_shell(density):
    import Part

    record = analysed(turned(Part.makeSphere(20).cut(Part.makeSphere(19))), density)
    assert record["criteria"] == [3, 4]
    assert record["volume_ratio"] == pytest.approx(0.0747, rel=5e-3)
    assert abs(record["wall"]["min"] - 1.0) <= record["wall"]["error_bound"] < 0.1
    assert abs(record["wall"]["median"] - 1.0) <= record["wall"]["error_bound"]
    assert record["descriptors"]["shares"]["parallel"] == pytest.approx(1.0, abs=1e-6)


@pytest.mark.parametrize("density", DENSITIES)
def test_sphere_and_rod(density):
    import Part

    sphere = analysed(turned(Part.makeSphere(20)), density)
    assert (sphere["category"], sphere["criteria"]) == ("normal", [])
    assert sphere["volume_ratio"] == pytest.approx(math.pi / 6, rel=3e-3)
    rod = analysed(turned(Part.makeCylinder(5, 100)), density)
    assert rod["category"] == "thin" and 4 in rod["criteria"]
    assert rod["wall"]["median"] == pytest.approx(10, abs=0.05)


@pytest.mark.parametrize("density", DENSITIES)
@pytest.mark.parametrize("dress", ["plain", "filleted", "chamfered"])
def test_block_is_normal_with_dressed_edges_too(density, dress):
    shape = block()
    if dress == "filleted":
        shape = shape.makeFillet(5, shape.Edges)
    elif dress == "chamfered":
        shape = shape.makeChamfer(5, shape.Edges)
    record = analysed(turned(shape), density)
    assert (record["category"], record["criteria"]) == ("normal", [])
    assert record["box_mm"] == pytest.approx([100, 60, 40], rel=1e-5)


@pytest.mark.parametrize("density", DENSITIES)
@pytest.mark.parametrize("shift", [0.0, 1e6])
def test_ribbed_block(density, shift):
    record = analysed(turned(rib(), shift), density)
    assert record["category"] == "thin_features" and 5 in record["criteria"]
    assert record["wall"]["min"] == pytest.approx(6.0, abs=record["wall"]["error_bound"])
    thin = [face for face in record["faces"] if face["thin_share"] > 0.5]
    assert len(thin) == 2
    assert [face["area_mm2"] for face in thin] == pytest.approx([2000, 2000], rel=1e-5)


@pytest.mark.parametrize("density", DENSITIES)
def test_web_beside_a_hole(density):
    import FreeCAD

    record = analysed(block_with_web(), density)
    assert record["category"] == "thin_features" and 5 in record["criteria"]
    assert abs(record["wall"]["min"] - 1.0) <= record["wall"]["error_bound"]
    thinnest = min((face for face in record["faces"] if face["witness"]),
                   key=lambda face: face["min"])
    start, end = (FreeCAD.Vector(*point) for point in thinnest["witness"]["points"])
    assert {round(start.z, 1), round(end.z, 1)} == {39.0, 40.0}
    assert abs(start.x - 50) < 2
    assert start.distanceToPoint(end) == pytest.approx(thinnest["min"], rel=1e-6)


@pytest.mark.parametrize("density", DENSITIES)
def test_wedge(density):
    import FreeCAD
    import Part

    half = math.radians(15)
    tip, low, high = (FreeCAD.Vector(x, y, 0) for x, y in (
        (0, 0), (100 * math.cos(half), -100 * math.sin(half)),
        (100 * math.cos(half), 100 * math.sin(half))))
    face = Part.Face(Part.makePolygon([tip, low, high, tip]))
    record = analysed(turned(face.extrude(FreeCAD.Vector(0, 0, 60))), density)
    assert record["category"] == "thin_features" and 7 in record["criteria"]
    assert record["descriptors"]["teeth"] == 1


def test_gap_between_plates_is_no_wall():
    record = analysed(turned(plates_joined_by_a_pin()))
    bins = record["descriptors"]["distribution"]
    diagonal = record["descriptors"]["diagonal_mm"]
    share = {}
    for index, area in zip(bins["bins"], bins["area"]):
        share[round(index / 1000 * diagonal)] = share.get(
            round(index / 1000 * diagonal), 0) + area
    assert not any(27 < wall < 33 for wall in share)
    assert share[2] > 0.9
    pin = math.pi * 16 * 2 / record["descriptors"]["area_mm2"]
    assert sum(area for wall, area in share.items() if 33 <= wall <= 35) == pytest.approx(
        pin, rel=0.2)


@pytest.mark.parametrize("density", DENSITIES)
@pytest.mark.parametrize("scale", [0.001, 1000.0])
def test_scale_changes_lengths_and_nothing_else(density, scale):
    reference = analysed(rib(), density)
    shape = rib()
    shape.scale(scale)
    record = analysed(shape, density)
    assert record["criteria"] == reference["criteria"]
    assert record["margin"] == pytest.approx(reference["margin"], rel=1e-3)
    assert record["wall"]["min"] == pytest.approx(6 * scale, rel=1e-5)


def test_a_thin_wall_on_a_large_curved_part_is_tessellated_finer():
    import Part

    shape = Part.makeCylinder(300, 400).cut(Part.makeCylinder(299.8, 400))
    record = analysed(shape)
    assert abs(record["wall"]["min"] - 0.2) <= record["wall"]["error_bound"] <= 0.1 * 0.2 * 1.05
    unrefined = analysed(shape, wall_deflection=1e9)
    assert unrefined["triangles"] < record["triangles"]


def test_a_finer_triangulation_on_the_shape_is_not_reused():
    import MeshPart
    import Part

    shape = Part.makeSphere(20)
    fresh = analysed(shape.copy())
    finer = MeshPart.meshFromShape(Shape=shape, LinearDeflection=0.02, AngularDeflection=0.06)
    assert finer.CountFacets > 1.2 * fresh["triangles"]
    assert analysed(shape)["triangles"] == fresh["triangles"]


def test_same_input_gives_the_same_record():
    first, second = analysed(rib()), analysed(rib())
    first.pop("seconds")
    second.pop("seconds")
    assert first == second


@pytest.mark.parametrize("measure", ["rays", "pairs"])
def test_both_measures_agree_on_a_plate(measure):
    import Part

    record = analysed(turned(Part.makeBox(100, 100, 2)), measure=measure)
    assert record["criteria"] == [1, 4, 5]
    assert record["F"]["0:0.05"] == pytest.approx(20000 / 20800, abs=0.005)


def test_the_papers_box_can_be_chosen():
    import Part

    assert analysed(Part.makeBox(30, 20, 10), box="principal")["box_mm"] == pytest.approx(
        [30, 20, 10], rel=1e-6)


@pytest.mark.parametrize("place", ["straight", "turned"])
def test_the_box_of_a_round_part_is_that_of_its_surface_not_of_its_facets(place):
    import FreeCAD
    import Part

    washer = Part.makeCylinder(49, 3).cut(Part.makeCylinder(25, 3))
    tube = Part.makeCylinder(20, 60).cut(Part.makeCylinder(18, 60))
    cut_off = Part.makeCylinder(20, 60).cut(Part.makeBox(100, 100, 100, FreeCAD.Vector(5, -50, -10)))
    for shape, box, exact in ((washer, (98, 98, 3), 1e-6), (tube, (60, 40, 40), 1e-6), (cut_off, (60, 40, 25), 1e-6),
                              (Part.makeCone(20, 10, 60), (60, 40, 40), 1e-6), (Part.makeSphere(20), (40, 40, 40), 1e-6),
                              (block(), (100, 60, 40), 1e-6)):
        record = analysed(turned(shape) if place == "turned" else shape)
        assert record["box_mm"] == pytest.approx(box, rel=exact)
        assert record["box_mm"] == pytest.approx(box, abs=record["wall"]["error_bound"])

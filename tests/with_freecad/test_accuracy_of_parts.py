# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a coarse mesh costs, and when a part is measured again."""

import math

import pytest

from thinpart_workbench.core.analysis_settings import AnalysisSettings
from thinpart_workbench.core.judging.criteria import profile_from
from thinpart_workbench.core.mesh.mass_properties import volume
from thinpart_workbench.freecad_adapter.shapes.part import SolidPart
from thinpart_workbench.workflow.analysis.analyse_part import analyse_part


def judged_by(symbol, threshold):
    return profile_from({
        "format": "thinpart-profile", "version": 1, "name": "one", "categories": [
            {"name": "thin", "criteria": [{"id": 1, "conditions": [
                {"quantity": symbol, "comparison": ">", "value": threshold}]}]}]})


def analysed(shape, symbol="V/VBB", threshold=0.5, **settings):
    part, judged = SolidPart("Part", "Part", shape=shape), judged_by(symbol, threshold)
    return analyse_part(part, AnalysisSettings(**settings), judged)[1]


def shapes():
    import Part

    return {
        "rod": (Part.makeCylinder(10, 200), 20.0),
        "tube": (Part.makeCylinder(20, 60).cut(Part.makeCylinder(18, 60)), 2.0),
        "shell": (Part.makeSphere(30).cut(Part.makeSphere(29)), 1.0),
        "ring": (Part.makeTorus(30, 3), 6.0),
    }


@pytest.mark.parametrize("name", ["rod", "tube", "shell", "ring"])
@pytest.mark.parametrize("angle", [4.0, 9.0, 12.0])
def test_walls_of_round_parts_are_as_thick_on_a_coarse_mesh(name, angle):
    shape, wall = shapes()[name]
    record = analysed(shape, angular_deflection=angle)
    found = record["descriptors"]["thickness_mm"]
    assert found["min"] == pytest.approx(wall, rel=2e-3) and found["median"] == pytest.approx(wall, rel=2e-3)
    # Two ends of the rod and of the tube see each other, or a rim; nothing else is slanted.
    ends = 2 * math.pi * (20**2 - 18**2) / shape.Area if name == "tube" else 0.0
    assert record["descriptors"]["shares"]["parallel"] >= 0.995 - ends


@pytest.mark.parametrize("angle", [6.0, 9.0, 12.0])
def test_the_volume_of_round_parts_is_that_of_the_solid(angle):
    for shape, _ in shapes().values():
        mesh, _ = SolidPart("Part", "Part", shape=shape).surface_mesh(AnalysisSettings(angular_deflection=angle), 0.001)
        assert volume(mesh) == pytest.approx(shape.Volume, rel=2e-4)


def test_a_part_is_measured_more_finely_only_where_its_verdict_needs_it():
    import FreeCAD
    import Part

    ribbed = Part.makeBox(60, 40, 30).fuse(Part.makeBox(60, 2, 30, FreeCAD.Vector(0, 20, 30))).removeSplitter()
    sure = analysed(ribbed, "F[0;0.05]", 0.05)
    value = sure["descriptors"]["F"]["0:0.05"]
    assert 0.1 < value < 0.9 and sure["descriptors"]["precision"]["accuracy"] == "standard"
    coarse = analysed(ribbed, "F[0;0.05]", 0.05, accuracy="verdict", minimum_samples=4000)
    assert coarse["descriptors"]["precision"]["accuracy"] == "verdict" and coarse["samples"] < sure["samples"]
    # Within the error of few samples, beyond that of many.
    near = value + 0.5 * coarse["evidence"][0]["conditions"][0]["error"]
    unsure = analysed(ribbed, "F[0;0.05]", near, accuracy="verdict", minimum_samples=4000)
    assert unsure["descriptors"]["precision"]["accuracy"] == "fine" and unsure["samples"] > 2 * sure["samples"]
    # Its walls are planes: a finer mesh would say nothing new.
    assert unsure["triangles"] == sure["triangles"]
    row = unsure["evidence"][0]["conditions"][0]
    assert abs(row["value"] - row["threshold"]) < 0.01 and 0.0 < row["error"] < 0.01


def test_a_part_that_no_accuracy_decides_is_borderline_and_measured_once():
    import FreeCAD
    import Part

    block = Part.makeBox(60, 40, 30).fuse(Part.makeBox(60, 2, 30, FreeCAD.Vector(0, 20, 30))).removeSplitter()
    value = analysed(block, "F[0;0.05]", 0.05)["descriptors"]["F"]["0:0.05"]
    undecided = analysed(block, "F[0;0.05]", value)
    row = undecided["evidence"][0]["conditions"][0]
    assert undecided["borderline"] and undecided["descriptors"]["precision"]["accuracy"] == "standard"
    assert abs(row["value"] - row["threshold"]) < row["error"] < 0.01


@pytest.mark.parametrize("wall, mesh_is_finer", [("flat", False), ("round", True)])
def test_a_thin_wall_is_waited_for_where_its_own_faces_are_too_coarse(wall, mesh_is_finer):
    import FreeCAD
    import Part

    # A cylinder of 300 mm whose chord error is half a millimetre, beside a wall of 1 mm between planes or between cylinders.
    body = Part.makeCylinder(150.0, 100.0)
    thin = Part.makeBox(300.0, 1.0, 100.0, FreeCAD.Vector(140.0, -0.5, 0.0)) if wall == "flat" else \
        Part.makeCylinder(151.0, 300.0).cut(Part.makeCylinder(150.0, 300.0, FreeCAD.Vector(0, 0, -1)))
    record = analysed(body.fuse(thin).removeSplitter(), linear_deflection=0.002, angular_deflection=12.0)
    found = record["descriptors"]["thickness_mm"]
    assert found["min"] == pytest.approx(1.0, abs=max(found["error_bound"], 1e-4))
    assert found["error_bound"] <= 0.1
    assert (record["deflection_mm"] < 0.05) is mesh_is_finer


def test_every_quantity_states_its_error():
    shape, _ = shapes()["ring"]
    record = analysed(shape)
    errors = {row["quantity"]: row["error"] for row in record["descriptors"]["precision"]["errors"]}
    assert {"V", "A", "D1", "D2", "D3", "V/VBB", "F[0;0.05]", "plate_share", "parallel"} <= set(errors)
    assert abs(record["descriptors"]["volume_mm3"] - shape.Volume) <= errors["V"] < 0.01 * shape.Volume
    assert abs(record["descriptors"]["area_mm2"] - shape.Area) <= errors["A"] < 0.02 * shape.Area
    assert abs(record["descriptors"]["box_mm"][0] - 66.0) <= errors["D1"] < 0.1

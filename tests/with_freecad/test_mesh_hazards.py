# SPDX-License-Identifier: LGPL-2.1-or-later
"""What makes parts hard to mesh, on solids of which it is known."""

import math

import numpy as np
import pytest

from thinpart_workbench.core.analysis_settings import AnalysisSettings
from thinpart_workbench.core.judging.criteria import load_profile
from thinpart_workbench.freecad_adapter.shapes.part import MeshedPart, SolidPart
from thinpart_workbench.workflow.analysis.analyse_part import analyse_part

PROFILE = load_profile("calibrated")


def descriptors_of(part, **settings):
    return analyse_part(part, AnalysisSettings(**settings), PROFILE)[1]["descriptors"]


def hazards(shape, **settings):
    return descriptors_of(SolidPart("Part", "Part", shape=shape), **settings)["hazards"]


def box(*sides):
    import Part

    return Part.makeBox(*sides)


def wedge(degrees):
    """A prism of a triangle with two equal sides of 60 mm, which meet at an angle; 50 mm long."""
    import FreeCAD
    import Part

    far = [(60 * math.cos(math.radians(turn)), 60 * math.sin(math.radians(turn)), 0) for turn in (0, degrees)]
    corners = [FreeCAD.Vector(*corner) for corner in ((0, 0, 0), *far, (0, 0, 0))]
    return Part.Face(Part.makePolygon(corners)).extrude(FreeCAD.Vector(0, 0, 50))


def tube(thickness):
    import FreeCAD
    import Part

    start = FreeCAD.Vector(0, 0, -10)
    return Part.makeCylinder(60, 20).cut(Part.makeCylinder(60 - thickness, 40, start))


def chamfered():
    """A block with a chamfer of 0.05 mm along one of its longest edges."""
    block = box(100, 60, 40)
    return block.makeChamfer(0.05, [next(edge for edge in block.Edges if math.isclose(edge.Length, 100))])


def moved(shape, scale):
    import FreeCAD

    placed = shape.copy()
    placed.rotate(FreeCAD.Vector(1, 2, 3), FreeCAD.Vector(1, -2, 0.7), 37.0)
    matrix = FreeCAD.Matrix()
    matrix.scale(scale, scale, scale)
    return placed.transformGeometry(matrix)


def test_a_block_has_none():
    found = hazards(box(100, 60, 40))
    assert found == {"faces": 6, "shortest_edge_mm": 40.0, "short_edges": 0, "narrowest_face_mm": pytest.approx(24.0),
                     "narrow_faces": 0, "knife_edges": 0.0, "tight_share": 0.0, "flattened_share": 0.0,
                     "thin_x": pytest.approx(0.3, abs=0.05)}


def test_a_small_chamfer_is_a_narrow_face_between_two_short_edges():
    found, across = hazards(chamfered()), 0.05 * math.sqrt(2)
    assert (found["faces"], found["short_edges"], found["narrow_faces"]) == (7, 2, 1)
    assert found["shortest_edge_mm"] == pytest.approx(across)
    assert found["narrowest_face_mm"] == pytest.approx(100 * across / (100 + across), rel=1e-3)


def test_a_plate_has_short_edges_and_narrow_faces_all_round():
    found = hazards(box(100, 60, 2))
    assert (found["short_edges"], found["narrow_faces"]) == (4, 4)
    assert found["shortest_edge_mm"] == pytest.approx(2) and found["knife_edges"] == found["flattened_share"] == 0.0


@pytest.mark.parametrize("degrees, length", [(20, 50.0), (28, 50.0), (32, 0.0), (60, 0.0)])
def test_faces_that_meet_at_less_than_30_degrees_are_a_knifes_edge(degrees, length):
    found = descriptors_of(SolidPart("Part", "Part", shape=wedge(degrees)))
    assert found["hazards"]["knife_edges"] * found["diagonal_mm"] == pytest.approx(length)


def test_a_groove_is_no_knifes_edge():
    import FreeCAD
    import Part

    half = 30 * math.tan(math.radians(10))
    corners = [FreeCAD.Vector(x, y, -10) for x, y in ((50, 20), (50 + half, 50), (50 - half, 50), (50, 20))]
    groove = Part.Face(Part.makePolygon(corners)).extrude(FreeCAD.Vector(0, 0, 50))
    cut = box(100, 40, 30).cut(groove)
    assert cut.Volume == pytest.approx(100 * 40 * 30 - 20 * 20 * math.tan(math.radians(10)) * 30)
    assert hazards(cut)["knife_edges"] == 0.0


def test_a_tip_of_a_cone_is_no_edge():
    import Part

    found = hazards(Part.makeCone(5, 0, 60))
    assert found["knife_edges"] == 0.0 and found["shortest_edge_mm"] == pytest.approx(10 * math.pi)


@pytest.mark.parametrize("thickness, is_changed", [(0.2, True), (5.0, True), (20.0, False)])
def test_flat_elements_change_a_curved_wall_by_more_than_a_twentieth_where_it_is_thin(thickness, is_changed):
    # Elements of 17 mm on a radius of 60 mm lie 0.6 mm off it, on one of 40 mm 0.9 mm.
    sides, ends = 2 * math.pi * (120 - thickness) * 20, 2 * math.pi * (120 - thickness) * thickness
    share = sides / (sides + ends) if is_changed else 0.0
    assert hazards(tube(thickness))["flattened_share"] == pytest.approx(share, abs=0.005)


def test_a_rod_is_tightly_curved():
    import Part

    side, ends = 2 * math.pi * 100, 2 * math.pi
    assert hazards(Part.makeCylinder(1, 100))["tight_share"] == pytest.approx(side / (side + ends), rel=1e-3)
    assert hazards(Part.makeCylinder(3, 100))["tight_share"] == 0.0


@pytest.mark.parametrize("made", [chamfered, lambda: wedge(20), lambda: tube(0.2)])
@pytest.mark.parametrize("scale", [0.01, 1.0, 1000.0])
def test_neither_scale_nor_place_changes_them(made, scale):
    shape = made()
    plain, other = hazards(shape), hazards(moved(shape, scale))
    for key, value in plain.items():
        expected = value * scale if key.endswith("_mm") else value
        near = 0.06 if key == "thin_x" else 2e-3  # local thickness is of samples, whose places differ
        assert other[key] == pytest.approx(expected, rel=near, abs=2e-3 if key.endswith("share") else None), key


def test_triangles_without_faces_have_unknown_ones():
    points, triangles = box(100, 60, 2).tessellate(0.1)
    part = MeshedPart("Mesh", "Mesh", points=np.array([tuple(point) for point in points]), triangles=np.array(triangles))
    assert set(descriptors_of(part)["hazards"].values()) == {None}

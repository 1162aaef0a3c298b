# SPDX-License-Identifier: LGPL-2.1-or-later
"""The one thinnest wall, at any angle: parts with known answers, turned and in two tessellations, and real ones."""

import math
import os
from pathlib import Path

import numpy as np
import pytest
from program import SAMPLES

from thinpart_workbench.cli.part_rows import TABLE
from thinpart_workbench.core.analysis_settings import ACCURACIES, AnalysisSettings
from thinpart_workbench.core.judging.criteria import load_profile
from thinpart_workbench.core.judging.wall_check import check_walls
from thinpart_workbench.core.judging.wall_limits import WallLimits
from thinpart_workbench.core.record.region_groups import region_groups
from thinpart_workbench.core.record.thinnest_sentence import thinnest_sentence
from thinpart_workbench.freecad_adapter.reading.part_files import read_parts
from thinpart_workbench.freecad_adapter.shapes.part import SolidPart
from thinpart_workbench.workflow.analysis.analyse_part import analyse_part

PROFILE = load_profile("calibrated")
DENSITIES = {**{accuracy: AnalysisSettings.at(accuracy) for accuracy in ACCURACIES},
             "smooth": AnalysisSettings(linear_deflection=0.0003, angular_deflection=2.5)}
TRAINING = Path(os.environ.get("THINPART_TRAINING", Path(__file__).resolve().parents[3] / "shared" / "training")) / "parts"


def vector(*coordinates):
    import FreeCAD

    return FreeCAD.Vector(*coordinates)


def extruded(corners, length):
    import Part

    points = [vector(x, y, 0) for x, y in corners]
    return Part.Face(Part.makePolygon([*points, points[0]])).extrude(vector(0, 0, length))


def analysed(shape, density="standard"):
    shape = shape.copy()
    shape.rotate(vector(1, 2, 3), vector(1, -2, 0.7), 37.0)
    _, record = analyse_part(SolidPart("Part", "Part", shape=shape), DENSITIES[density], PROFILE)
    return record


def plate():
    import Part

    return Part.makeBox(100, 60, 2)


def with_chamfers(size):
    solid = plate()
    return solid.makeChamfer(size, [edge for edge in solid.Edges if abs(edge.BoundBox.ZMin - 2) < 1e-6])


def with_fillets():
    solid = plate()
    return solid.makeFillet(0.5, [edge for edge in solid.Edges if abs(edge.BoundBox.ZMin - 2) < 1e-6])


def web():
    """A bore that is 1 mm away from a side and 10 mm long, in a block of 100 x 60 x 40."""
    import Part

    block = Part.makeBox(100, 60, 40)
    return block.cut(Part.makeCylinder(3, 10, vector(50, 4, 30), vector(0, 0, 1)))


def countersunk():
    """A countersink that leaves a land of 0.5 mm."""
    import Part

    return plate().cut(Part.makeCylinder(4, 5, vector(50, 30, -1))).cut(Part.makeCone(4, 5.5, 1.5, vector(50, 30, 0.5)))


def drafted_rib():
    """A rib of 6 mm that is 1.5 mm wide at its top, on a block: its sides lean by 12.7 degrees."""
    return extruded([(0, 0), (60, 0), (60, 30), (33, 30), (30.75, 40), (29.25, 40), (27, 30), (0, 30)], 80)


def cone_of_halves():
    """A cone from 20 to 10 mm wide and 20 mm high, whose side is two faces: they meet in edges that are not sharp."""
    import Part

    half, other = (Part.makeCone(10, 5, 20, vector(0, 0, 0), vector(0, 0, 1), 180) for _ in range(2))
    other.rotate(vector(0, 0, 0), vector(0, 0, 1), 180)
    return half.fuse(other)


def floor_between_pockets():
    """A floor of 1 x 1 mm that is 0.3 mm thick, between a pocket and a hole from below: few samples of the part meet it."""
    import Part

    block = Part.makeBox(100, 60, 40).cut(Part.makeBox(30, 20, 20.3, vector(35, 20, 19.7)))
    return block.cut(Part.makeBox(1, 1, 19.4, vector(45, 30, 0)))


def corner_of_pocket():
    """Two pockets of equal depth, one beneath the other one's edge: they overlap by 0.02 mm, less than the depth."""
    import Part

    block = Part.makeBox(100, 60, 40).cut(Part.makeBox(30, 20, 15, vector(35, 20, 25)))
    return block.cut(Part.makeBox(20, 20, 24.5, vector(64.98, 20, 0)))


def pin_near_a_side():
    """A pin of 12 mm on a block, 1 mm from a side of it: between these two, there is nothing."""
    import Part

    return Part.makeBox(60, 40, 20).fuse(Part.makeCylinder(6, 10, vector(30, 7, 20))).removeSplitter()


def square_hole_in_a_bar():
    """A bar of 20 mm with a hole of 12 x 12 mm: its corners are nearest to the outside, and no broken edges."""
    import Part

    return Part.makeCylinder(10, 30).cut(Part.makeBox(12, 12, 40, vector(-6, -6, -5)))


def rounded_in_two_steps():
    """A plate of 4 mm with an edge that is rounded by two faces: below the first one, it gets thinner and thinner."""
    import Part

    way = [vector(0, 0, 0), vector(0, 0, 4), vector(57, 0, 4)]
    arcs = [Part.Arc(*(vector(57 + 3 * math.sin(turn), 0, 1 + 3 * math.cos(turn)) for turn in np.radians([low, mid, high])))
            for low, mid, high in ((0, 20, 40), (40, 65, 90))]
    end = Part.makePolygon([vector(60, 0, 1), vector(60, 0, 0), way[0]])
    outline = Part.Wire([*Part.makePolygon(way).Edges, *(arc.toShape() for arc in arcs), *end.Edges])
    return Part.Face(outline).extrude(vector(0, 100, 0))


LEAN, SLOPE = math.atan(2.25 / 10), math.atan(5 / 20)


def blade(angle):
    height = 40 * math.tan(math.radians(angle))
    return extruded([(0, 0), (40, 0), (0, height)], 80)


KNOWN = {
    "plate": (plate, "parallel", 2.0),
    "broken edge": (lambda: with_chamfers(0.5), "parallel", 2.0),
    "rounded edge": (with_fillets, "parallel", 2.0),
    "chamfer that leaves a land": (lambda: with_chamfers(1.4), "tapered", 0.6),
    "web beside a bore": (web, "parallel", 1.0),
    "countersink": (countersunk, "tapered", 0.5),
    # A wall is measured straight across from one side, which is a little more than the top is wide.
    "cone of two halves": (cone_of_halves, "tapered", 10.0 / (math.cos(SLOPE) - 0.25 * math.sin(SLOPE))),
    "floor between pockets": (floor_between_pockets, "parallel", 0.3),
    "pockets that hardly overlap": (corner_of_pocket, "parallel", 15.02),
    "pin near a side": (pin_near_a_side, "parallel", 12.0),
    "square hole in a bar": (square_hole_in_a_bar, "tapered", 10.0 - 6.0 * math.sqrt(2.0)),
    "edge rounded in two steps": (rounded_in_two_steps, "parallel", 4.0),
    "rib with a draft": (drafted_rib, "tapered", 1.5 * math.cos(LEAN) / math.cos(2 * LEAN)),
}


@pytest.mark.parametrize("density", DENSITIES)
@pytest.mark.parametrize("name", KNOWN)
def test_known_walls(name, density):
    make, kind, thickness = KNOWN[name]
    record = analysed(make(), density)
    place, walls = record["thinnest"], record["descriptors"]["thickness_mm"]
    assert walls["min"] == pytest.approx(thickness, rel=0.01), place
    assert (place["kind"], place["edges_mm"]) == (kind, 0.0)
    assert place["walls_mm"] == walls["min"] == min(face["min"] for face in record["faces"] if face["min"] is not None)


@pytest.mark.parametrize("angle", [10, 20, 35])
def test_a_blade_is_as_thin_as_it_is_at_the_stated_depth(angle):
    record = analysed(blade(angle))
    place = record["thinnest"]
    assert place["kind"] == "edge" and place["edges_mm"] == pytest.approx(80.0, rel=1e-6)
    assert place["depth_mm"] == pytest.approx(record["descriptors"]["box_mm"][1] / 200, rel=1e-6)
    least = place["depth_mm"] * math.tan(math.radians(angle))
    assert record["descriptors"]["thickness_mm"]["min"] == pytest.approx(least, rel=0.01)
    assert "beside a sharp edge; sharp edges are 80 mm long" in str(thinnest_sentence(record))
    # In the table, the thinnest wall apart from it follows.
    in_table = next(cell for title, cell, _ in TABLE if title == "Thinnest mm")
    assert in_table(record) == f"{record['descriptors']['thickness_mm']['min']:.4g} edge, wall {place['walls_mm']:.4g}"


def test_a_sharp_edge_is_no_error_of_the_model_and_a_sliver_beside_it_may_be_one():
    record = analysed(blade(10))
    walls, place = record["descriptors"]["thickness_mm"], record["thinnest"]
    walls["median"], place["walls_mm"] = 100.0 * walls["min"], 10.0 * walls["min"]
    assert "error of the model" not in str(thinnest_sentence(record))
    place["walls_mm"] = 1.5 * walls["min"]
    assert "So thin a place, 1.5\u00a0% of the median" in str(thinnest_sentence(record))
    place["kind"] = "parallel"
    assert "So thin a place, 1.0\u00a0% of the median" in str(thinnest_sentence(record))


@pytest.mark.parametrize("shape", [lambda: blade(45), lambda: extruded([(0, 0), (40, 0), (20, 33)], 80)])
def test_an_edge_of_45_degrees_and_more_is_no_thin_wall(shape):
    place = analysed(shape())["thinnest"]
    assert place is None or (place["kind"], place["edges_mm"]) == ("parallel", 0.0)


@pytest.mark.parametrize("accuracy", ACCURACIES)
def test_a_taper_is_followed_along_the_border_of_its_face(accuracy):
    """A blind hole whose floor ends 0.58 mm over a bore: nearest at its border, and straight across the bore alone."""
    import Part

    block = Part.makeBox(60, 43, 42, vector(-30, -21.5, -21))
    block = block.cut(Part.makeCylinder(11.5, 60, vector(-30, 0, 0), vector(1, 0, 0)))
    record = analysed(block.cut(Part.makeCylinder(1.95, 20, vector(3.3, 4.65 + 1.95, 11.15))), accuracy)
    assert record["thinnest"]["kind"] == "tapered"
    assert record["thinnest"]["witness"]["distance"] == pytest.approx(math.hypot(4.65, 11.15) - 11.5, rel=1e-4)


@pytest.mark.parametrize("accuracy", ACCURACIES)
def test_a_ridge_runs_out_into_an_edge_however_far_that_is(accuracy):
    """A ridge of 0.4 mm on a block, whose sides meet under 10 degrees in an edge as short as it is high."""
    import Part

    ridge = extruded([(0, 0), (40, 0), (40, 40 * math.tan(math.radians(10)))], 0.4)
    ridge.translate(vector(10, 20, 40))
    place = analysed(Part.makeBox(100, 60, 40).fuse(ridge), accuracy)["thinnest"]
    assert (place["kind"], place["walls_mm"]) == ("edge", pytest.approx(40.0, rel=1e-6))
    assert place["witness"]["distance"] == pytest.approx(place["depth_mm"] * math.tan(math.radians(10)), rel=1e-3)


@pytest.mark.parametrize("accuracy", ACCURACIES)
def test_the_land_at_the_top_of_a_drafted_rib_is_told_from_any_sample(accuracy):
    """A rib whose top is 0.05 mm wide: samples on its sides have multiples of that."""
    rib = extruded([(0, 0), (60, 0), (60, 30), (33, 30), (30.025, 40), (29.975, 40), (27, 30), (0, 30)], 80)
    record = analysed(rib, accuracy)
    lean = math.atan(2.975 / 10)
    assert record["thinnest"]["kind"] == "tapered"
    assert record["thinnest"]["witness"]["distance"] == pytest.approx(
        0.05 * math.cos(lean) / math.cos(2 * lean), rel=0.01)


def undercut(width, length=3.0):
    """A block of 60 x 40 x 20 whose corner above a slanted cut is 1 mm thick at its end, and 45 degrees steep.

    Parameters
    ----------
    width : float, mm
        Of the slanted face, measured along the top of the block.
    length : float, mm
        Along the side of the block: so short that few samples lie there.
    """
    import Part

    cut = extruded([(0, 0), (width, 0), (width, 19 - width), (0, 19)], length)
    cut.rotate(vector(0, 0, 0), vector(1, 0, 0), 90)
    cut.translate(vector(0, 20 + length / 2, 0))
    return Part.makeBox(60, 40, 20).cut(cut)


@pytest.mark.parametrize("accuracy", ACCURACIES)
def test_a_taper_that_few_samples_see_is_told_from_any(accuracy):
    record = analysed(undercut(3.0), accuracy)
    assert (record["thinnest"]["kind"], record["thinnest"]["walls_mm"]) == ("tapered", pytest.approx(1.0, rel=1e-3))


@pytest.mark.parametrize("accuracy", ACCURACIES)
def test_a_taper_that_is_narrower_than_thick_is_a_broken_edge(accuracy):
    record = analysed(undercut(0.6), accuracy)
    assert record["thinnest"]["walls_mm"] > 1.5


@pytest.mark.parametrize("accuracy", ACCURACIES)
def test_the_wall_that_has_a_face_of_the_thinnest_place_is_as_thin(accuracy):
    """No region has both faces of the floor between two pockets: too few samples met it."""
    record = analysed(floor_between_pockets(), accuracy)
    assert min(region["min"] for region in record["regions"]["listed"]) == record["thinnest"]["walls_mm"]


def test_places_are_counted():
    import Part

    block = Part.makeBox(100, 60, 40)
    for x in (15, 35, 55, 75):
        block = block.cut(Part.makeCylinder(3, 60, vector(x, 4, -10), vector(0, 0, 1)))
    record = analysed(block)
    assert (record["thinnest"]["places"], record["thinnest"]["below_mm"]) == (4, 1.3)
    assert "4 places below 1.3 mm" in str(thinnest_sentence(record))


REAL = """
    p048 t022 t225 t206 t209 t145 t040 t286 t198 p082 t117 t070 p100 t162 p023 t084 p069 p078 t108 p071 t007 t043
    t199 t147 t152 p073 t376 t159 p059 t235 p084 p009 t234 t151 t219 p070 t382 t381 t061 t004 t031 t353
""".split()
"""Parts to train on: nozzles, lips, webs over slots and bores, countersinks, threads of screws and nuts, teeth, blends."""


@pytest.mark.parametrize("accuracy", ACCURACIES)
def test_the_run_out_of_a_worm_is_as_thin_from_any_sample(accuracy):
    """Normals of one flank miss the other one where the two are nearest: the wall ends on the way there."""
    _, record = analyse_part(read_parts(SAMPLES / "worm_run_out.FCStd").parts[0], AnalysisSettings.at(accuracy), PROFILE)
    assert (record["thinnest"]["kind"], record["thinnest"]["walls_mm"]) == ("tapered", pytest.approx(0.9985, rel=0.01))


@pytest.mark.parametrize("accuracy", ACCURACIES)
def test_a_chamfer_beside_a_hole_is_no_thinnest_wall(accuracy):
    """Round the circle of the chamfer the part gets thicker, not across it."""
    _, record = analyse_part(read_parts(SAMPLES / "flange.FCStd").parts[0], AnalysisSettings.at(accuracy), PROFILE)
    assert (record["thinnest"]["kind"], record["thinnest"]["walls_mm"]) == ("parallel", pytest.approx(12.5, rel=1e-3))


def test_all_teeth_of_a_gear_are_as_thin_and_counted():
    _, record = analyse_part(read_parts(SAMPLES / "spur_gear_on_hub.FCStd").parts[0], AnalysisSettings(), PROFILE)
    thinnest = record["descriptors"]["thickness_mm"]["min"]
    assert record["thinnest"]["places"] == 18 and thinnest == pytest.approx(4.9028, rel=1e-3)
    flanks = [face for face in record["faces"] if face["min"] is not None and face["min"] < 1.001 * thinnest]
    assert len(flanks) == 36 and all(face["witness"]["distance"] == face["min"] for face in flanks)
    kept = {"area_mm2": flanks[-1]["area_mm2"], "surface": flanks[-1]["surface"], "reason": "tooth", "min_mm": 5.5}
    limited = {**record, "face_limits": [{"face": flanks[-1]["face"], **kept}]}
    assert check_walls(limited, WallLimits("", "", 0.8, None)).holds is False


def test_the_ball_of_a_worm_reaches_over_its_thread_which_is_no_thicker_than_across():
    _, record = analyse_part(read_parts(SAMPLES / "worm_run_out.FCStd").parts[0], AnalysisSettings(), PROFILE)
    thread, = (group for group in region_groups(record) if group.word == "thread")
    flanks = [record["faces"][face] for face in thread.faces]
    assert all(face["ball_mm"] < 7.0 for face in flanks)
    check = check_walls(record, WallLimits("", "", None, 13.0))
    assert check.thick_holds is False and 0.5 < check.thick_share < 0.8
    assert not {face["face"] for face in flanks} & set(check.thick_faces)


def test_what_is_thinner_than_the_thinnest_wall_is_no_row():
    """Beside an edge of 45 degrees, a part is as thick as one is deep: no wall."""
    record = analysed(extruded([(0, 0), (40, 0), (20, 33)], 80))
    thinnest = record["descriptors"]["thickness_mm"]["min"]
    assert thinnest == pytest.approx(80.0, rel=1e-3)
    assert all(group.least >= 0.95 * thinnest for group in region_groups(record))


def trained_on(name):
    [file] = TRAINING.glob(f"{name}_*")
    return read_parts(file).parts[0]


# A floor over a bore, a gear's teeth whose sides meet under more than 60 degrees at the tip, lands of chamfers, and tapers
# so small that coarse samples say nothing of their width.
@pytest.mark.skipif(not TRAINING.is_dir(), reason="the parts to train on are not here")
@pytest.mark.parametrize("name, thickness", [
    ("t219", 0.5808), ("p003", 0.9950), ("t004", 0.65), ("t061", 0.2), ("t382", 0.0688), ("t352", 0.3257),
    ("t095", 0.5), ("t031", 1.723), ("t357", 0.9497), ("t049", 1.379)])
@pytest.mark.parametrize("accuracy", ACCURACIES)
def test_real_walls_are_as_thin_at_every_accuracy(name, thickness, accuracy):
    _, record = analyse_part(trained_on(name), AnalysisSettings.at(accuracy), PROFILE)
    assert record["thinnest"]["walls_mm"] == pytest.approx(thickness, rel=0.002)


@pytest.mark.skipif(not TRAINING.is_dir(), reason="the parts to train on are not here")
@pytest.mark.parametrize("name", REAL)
def test_real_tapers_are_confirmed_by_lines_through_the_shape(name):
    import Part

    part = trained_on(name)
    _, record = analyse_part(part, AnalysisSettings(), PROFILE)
    start, end = map(np.array, record["thinnest"]["witness"]["points"])
    along = (end - start) / np.linalg.norm(end - start)
    length = record["descriptors"]["thickness_mm"]["min"]
    beside = 1e-3 * length * np.linalg.svd(along[None])[2][1:]

    def length_inside(moved):
        line = Part.makeLine(vector(*(start - 0.5 * length * along + moved)), vector(*(end + 0.2 * length * along + moved)))
        middle = Part.Vertex(vector(*(0.5 * (start + end) + moved)))
        return sum(edge.Length for edge in part.shape.common(line).Edges if edge.distToShape(middle)[0] < 1e-3 * length)

    # Where the wall ends at its thinnest place, lines on the one side of it lie inside.
    moves = [np.zeros(3), *beside, *-beside, beside[0] + beside[1], beside[0] - beside[1]]
    assert any(length_inside(moved) == pytest.approx(length, rel=0.01) for moved in moves)

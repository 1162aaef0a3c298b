# SPDX-License-Identifier: LGPL-2.1-or-later
"""Walls of parts with known answers against limits."""

from dataclasses import replace

import made_library
import made_meshes
import pytest
from test_equal_features import perforated

from thinpart_workbench.core.analysis_settings import AnalysisSettings
from thinpart_workbench.core.descriptors.packed_distribution import packed_slanted, packed_walls
from thinpart_workbench.core.figures import Length
from thinpart_workbench.core.judging.packed_check import packed_walls_pass
from thinpart_workbench.core.judging.wall_check import check_sentence, check_walls
from thinpart_workbench.core.judging.wall_limits import WallLimits

PLATE = made_library.measured_record("plate", made_meshes.box(100, 80, 2))
SMALL_PLATE_ON_BLOCK = made_library.measured_record("two", made_meshes.joined(
    made_meshes.box(40, 40, 40), made_meshes.moved(made_meshes.box(40, 30, 2), shift=(100.0, 0.0, 0.0))))


def limits(least=None, most=None):
    return WallLimits("test", "Test", least, most)


def with_walls(record, **changes):
    descriptors = record["descriptors"]
    return {**record, "descriptors": {**descriptors, "thickness_mm": {**descriptors["thickness_mm"], **changes}}}


@pytest.mark.parametrize("least, most, holds", [
    (1.0, None, True), (2.0, None, True), (2.5, None, False), (None, 2.5, True), (None, 2.0, True), (None, 1.5, False),
    (1.0, 3.0, True), (2.5, 3.0, False),
])
def test_a_plate_of_two_millimetres(least, most, holds):
    assert check_walls(PLATE, limits(least, most)).holds is holds


def test_the_edges_of_a_plate_do_not_make_it_thick():
    check = check_walls(PLATE, limits(1.0, 3.0))
    assert check.holds and (check.thick_share, check.thick_faces) == (0.0, ())
    assert check.thickest_mm == pytest.approx(2.0, rel=0.01)


def test_what_fails_is_told_with_its_share_and_faces():
    check = check_walls(PLATE, limits(2.5))
    low, high = check.thin_share
    assert low - 1e-6 <= 16000 / 16720 <= high + 1e-6 and high - low < 0.02
    assert len(check.faces) == 2 and check.thinnest_face in check.faces
    assert str(check_sentence(check)) == (
        f"Test: fails: 96\u00a0% of the surface is under 2.5 mm, thinnest 2 mm on {check.thinnest_face}.")


@pytest.mark.parametrize("limit", [2.0, 2.02, 2.05, 3.0, 10.0, 39.0])
def test_the_share_brackets_the_truth_wherever_the_limit_cuts_a_bin(limit):
    check = check_walls(SMALL_PLATE_ON_BLOCK, limits(limit))
    truth = 2400 / (9600 + 2400 + 280) if limit > 2.0 else 0.0
    if limit > 30.0:
        truth += 2 * 40 * 2 / (9600 + 2400 + 280)  # the plate's edges are 30 mm apart
    low, high = check.thin_share
    assert low - 1e-9 <= truth <= high + 1e-9
    assert check.holds is (limit <= 2.0)


def test_a_thick_body_beside_a_thin_plate_fails_the_greatest_wall():
    check = check_walls(SMALL_PLATE_ON_BLOCK, limits(1.0, 10.0))
    assert (check.thin_holds, check.thick_holds, check.holds) == (True, False, False)


@pytest.mark.parametrize("shape, most, holds", [
    (made_meshes.tube(20, 18, 60), 2.5, True), (made_meshes.tube(20, 18, 60), 1.5, False),
    (made_meshes.spherical_shell(20, 1, 40), 1.5, True), (made_meshes.sphere(20, 40), 10.0, False),
    (made_meshes.box(100, 60, 40), 20.0, False), (made_meshes.box(100, 60, 40), 41.0, True),
])
def test_round_and_solid_parts_and_the_greatest_wall(shape, most, holds):
    assert check_walls(made_library.measured_record("part", shape), limits(None, most)).holds is holds


def bar_beside_a_plate(length):
    """A bar of 20 mm beside a plate of 4 mm."""
    return made_library.measured_record("part", made_meshes.joined(
        made_meshes.box(100, 100, 4), made_meshes.moved(made_meshes.box(length, 20, 20), shift=(200.0, 0.0, 0.0))))


@pytest.mark.parametrize("length, holds", [(2.0, True), (20.0, False), (200.0, False)])
def test_the_largest_ball_says_where_a_part_is_too_thick(length, holds):
    record = bar_beside_a_plate(length)
    check = check_walls(record, limits(None, 4.2))
    assert (check.thin_holds, check.thick_holds, check.holds) == (True, holds, holds)
    balls = {face["face"]: face["ball_mm"] for face in record["faces"]}
    assert sorted(check.thick_faces) == sorted(face for face, ball in balls.items() if ball > 4.3)
    assert len(check.thick_faces) == (0 if holds else 6)


@pytest.mark.parametrize("length, holds", [(2.0, True), (20.0, None), (200.0, False)])
def test_records_without_balls_are_told_by_volume(length, holds):
    """0, 14 and 66 % of the volume lie deeper than the limit allows."""
    record = bar_beside_a_plate(length)
    before = {**record, "descriptors": {key: value for key, value in record["descriptors"].items() if key != "local"}}
    check = check_walls(before, limits(None, 4.2))
    assert (check.thin_holds, check.thick_holds, check.holds) == (True, holds, holds)


@pytest.mark.parametrize("most, holds", [(3.2, True), (3.0, True), (2.8, False), (2.2, False)])
def test_where_walls_of_one_thickness_meet_they_are_not_too_thick(most, holds):
    """A T, a corner and an end of walls of 3 mm: the largest ball is 3.75 mm where one wall ends on the other."""
    outline = [(0, 0), (60, 0), (60, 40), (57, 40), (57, 3), (31.5, 3), (31.5, 43), (28.5, 43), (28.5, 3), (0, 3)]
    record = made_library.measured_record("profile", made_meshes.prism(outline, 100))
    assert check_walls(record, limits(None, most)).thick_holds is holds
    assert check_walls(record, limits(None, 3.2)).thickest_mm > 3.3


@pytest.mark.parametrize("most, holds", [(1.6, True), (1.4, False)])
def test_the_sides_of_holes_and_rims_of_a_sheet_are_as_thick_as_the_sheet(most, holds):
    points, triangles, _ = perforated()
    check = check_walls(made_library.measured_record("sheet", (points, triangles), AnalysisSettings()), limits(None, most))
    assert check.thick_holds is holds and check.thickest_mm == pytest.approx(1.5, rel=0.02)


@pytest.mark.parametrize("thinnest, error, holds, within", [
    (2.0, 0.01, True, True), (1.99, 0.02, True, True), (1.99, 0.005, False, False), (1.9, 0.2, False, True),
    (2.1, 0.2, True, True), (2.3, 0.2, True, False), (1.9, 1.2, None, False), (0.2, 1.2, False, False),
])
def test_an_error_bound_that_spans_the_limit(thinnest, error, holds, within):
    check = check_walls(with_walls(PLATE, min=thinnest, error_bound=error), limits(2.0))
    assert (check.holds, check.within_tolerance) == (holds, within)
    if holds and within:
        assert "within tolerance" in check_sentence(check)
    if within:
        assert "give or take" in check_sentence(check)


def test_a_part_without_walls_and_an_open_one_cannot_be_told():
    assert check_walls(with_walls(PLATE, min=None), limits(1.0)).holds is None
    opened = made_library.record_of("open_box")
    assert check_walls(opened, limits(1.0)).holds is None and "open" in check_sentence(check_walls(opened, limits(1.0)))
    assert check_walls(opened, limits(50.0)).holds is False


def test_a_wall_that_ends_in_a_sharp_edge_is_as_thin_as_beside_it_and_is_told_apart():
    wedge = made_library.record_of("wedge")
    place = wedge["thinnest"]
    thinnest = wedge["descriptors"]["thickness_mm"]["min"]
    assert place["kind"] == "edge" and place["walls_mm"] > 5.0 > thinnest
    check = check_walls(wedge, limits(5.0))
    assert check.holds is False and check.is_only_at_edges and check.tapered_share > 0.01
    said = f"thinnest {Length(thinnest)} on {place['face']}, {Length(place['depth_mm']):.2g} beside a sharp edge"
    assert "fails, but only where walls end in sharp edges: " in check_sentence(check) and said in check_sentence(check)
    above = check_walls(wedge, limits(1.1 * place["walls_mm"]))
    assert above.holds is False and not above.is_only_at_edges and said in check_sentence(above)
    below = check_walls(wedge, limits(0.9 * thinnest))
    assert below.holds and below.tapered_share > 0.0


@pytest.mark.parametrize("scale", [0.01, 1000.0])
def test_scale_changes_nothing(scale):
    part = made_library.measured_record("part", made_meshes.moved(made_meshes.ribbed_block(), scale=scale))
    same = made_library.record_of("ribbed_block")
    for least, most in ((5.0, None), (7.0, None), (None, 30.0)):
        one = check_walls(with_walls(same, error_bound=0.0), limits(least, most))
        other = check_walls(with_walls(part, error_bound=0.0), limits(least and least * scale, most and most * scale))
        assert one.holds is other.holds and one.thin_share == pytest.approx(other.thin_share, abs=1e-6)


@pytest.mark.parametrize("shape", made_library.SHAPES)
@pytest.mark.parametrize("least, most", [(1.0, None), (2.0, None), (5.0, 30.0), (None, 2.5), (3.0, 8.0)])
def test_the_index_checks_alike(shape, least, most):
    record = made_library.record_of(shape)
    content = record["descriptors"]
    packed = (*packed_walls(content["distribution"]),
              *[column for number, column in enumerate(packed_slanted(content["nonparallel"])) if number != 1])
    found = packed_walls_pass(
        content["thickness_mm"]["min"], content["thickness_mm"]["error_bound"], content["volume_mm3"],
        content["area_mm2"], content["diagonal_mm"],
        content["shares"]["unmeasured"], content["shares"]["unmet"], *packed, None, content["local"]["T99"],
        content["box_mm"][1], least, most)
    holds = check_walls(record, limits(least, most)).holds
    assert found == (None if holds is None else int(holds))


def test_content_is_json():
    content = check_walls(PLATE, replace(limits(2.5, 40.0), name="FDM")).content()
    assert content["process"] == "FDM" and content["passes"] is False and content["faces"]

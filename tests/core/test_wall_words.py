# SPDX-License-Identifier: LGPL-2.1-or-later
"""Walls in the words of a workshop."""

import math
from dataclasses import replace

import made_library
import made_meshes
import pytest

from thinpart_workbench.core.analysis_settings import AnalysisSettings
from thinpart_workbench.core.descriptors.equal_walls import WallSize
from thinpart_workbench.core.descriptors.region_kinds import called, is_rib
from thinpart_workbench.core.descriptors.ridges import wall_row
from thinpart_workbench.core.judging.verdict_sentence import verdict_sentence
from thinpart_workbench.core.judging.wall_words import features_of_a_solid, run_out_of, thin_features, walls_it_is_made_of
from thinpart_workbench.core.record.region_groups import RegionGroup, region_groups


def group(kind, thickness, count=1, least=None, length=20.0, share=0.1, volume=0.01):
    return RegionGroup(kind, count, least or thickness, thickness, length, 5.0, volume, (), share, ())


@pytest.mark.parametrize("height, said", [
    (2.0, "2 mm sheet, 95\u00a0% of the surface"), (3.0, "3 mm plate, 93\u00a0% of the surface")])
def test_a_sheet_is_named_with_the_share_that_its_two_sides_have(height, said):
    record = made_library.measured_record("Plate", made_meshes.box(100.0, 60.0, height))
    share = 12000.0 / (12000.0 + 320.0 * height)
    assert f"{100 * share:.0f}" in said
    assert walls_it_is_made_of(record, region_groups(record), 7.2) == said


def test_a_block_is_made_of_no_walls():
    record = made_library.measured_record("Block", made_meshes.box(100.0, 60.0, 40.0))
    assert walls_it_is_made_of(record, region_groups(record), 7.2) is None


def test_features_are_counted_and_named():
    core = group("block", 40.0, share=0.5, volume=0.8)
    walls = group("plate", 2.0, 3), group("tube", 2.01, share=0.05)
    found = thin_features([core, *walls, group("bar", 1.5, share=0.2)], 3.0, 60.0)
    assert found.has_core and not found.are_teeth
    assert found.words == "a bar of 1.5 mm (2.5\u00a0% of the width) and 4 walls of 2 mm (3.3\u00a0% of the width)"


def test_a_thread_is_told_from_teeth_by_its_turns():
    core = group("bar", 20.0, share=0.5, volume=0.8)
    thread = group("tooth", 5.4, least=2.6, length=5 * math.pi * 42.0)
    found = thin_features([core, thread], 5.0, 42.0)
    assert (found.words, found.are_teeth) == ("thread 2.6 mm to 5.4 mm thick", True)
    # Nor are the walls of a housing a thread that run into each other, however long they are together.
    assert thin_features([core, group("tooth", 10.1, least=0.19, length=5 * math.pi * 42.0)], 8.0, 42.0).words == (
        "a taper 0.19 mm to 10.1 mm thick")
    assert thin_features([core, group("tooth", 5.4, 20, least=1.0)], 2.0, 20.0).words == "20 teeth 1 mm to 5.4 mm thick"
    assert thin_features([core, group("tooth", 2.5)], 2.6, 38.0).words == "a wall of 2.5 mm (6.6\u00a0% of the width)"
    few = thin_features([core, group("tooth", 5.4, 4, least=1.0)], 2.0, 20.0)
    assert (few.words, few.are_teeth) == ("4 tapers 1 mm to 5.4 mm thick", False)
    assert thin_features([core, group("tooth", 7.0, least=1.0)], 2.0, 20.0) is None  # a body that ends in an edge


def test_a_thread_says_that_it_runs_out_into_a_sharp_edge():
    thread = replace(group("tooth", 5.4, least=2.6, length=5 * math.pi * 42.0), faces=(3, 4))
    core = group("bar", 20.0, share=0.5, volume=0.8)
    place = {"kind": "edge", "face": "Face8", "witness": {"opposite_face": "Face4"}}
    assert run_out_of({"thinnest": place}) == {7, 3}
    assert not any(map(run_out_of, ({"thinnest": {**place, "kind": "tapered"}}, {"thinnest": None}, {})))
    said = [str(thin_features([core, thread], 5.0, 42.0, faces).words) for faces in ({7, 3}, {7, 8}, set())]
    assert said == ["thread 2.6 mm to 5.4 mm thick, with a run-out to a sharp edge", *2 * ["thread 2.6 mm to 5.4 mm thick"]]


def test_equal_bars_that_get_thinner_are_teeth():
    teeth, pins = ([WallSize("bar", least, 6.9, 32.0, 9.6, 610.0, (30.0, 200.0))] * 18 for least in (4.9, 6.9))
    faces = [(number,) for number in range(18)]
    words = [wall_row(sizes[:count], [0.01] * count, faces[:count], 79.0, on_core=False).word
             for sizes, count in ((teeth, 18), (pins, 18), (teeth, 4))]
    assert words == ["tooth", "bar", "bar"]
    gear = replace(group("bar", 6.9, 18, least=4.9), word="tooth")
    assert thin_features([group("block", 40.0, volume=0.8), gear], 7.2, 79.0).words == "18 teeth 4.9 mm to 6.9 mm thick"


def test_the_table_calls_them_what_the_sentence_does():
    groups = region_groups(made_library.measured_record("Screw", made_meshes.screw(10.0, 1.5, 20, 0.92), AnalysisSettings()))
    assert [each.word for each in groups] == ["thread", "bar"]
    assert str(thin_features(groups, 2.0, 10.0).words).startswith("thread ")
    assert called("tooth", 1) == "taper" and str(thin_features([group("tooth", 5.4, least=1.0)], 2.0, 20.0).words) == (
        "a taper 1 mm to 5.4 mm thick")
    assert called("tooth", 20) == "tooth" and called("tooth", 4) == "taper" and called("bar", 1) == "bar"


def ridge(length, faces, median=0.27):
    return {"kind": "tooth", "min": 0.4 * median, "median": median, "length_mm": length, "width_mm": 0.12,
            "area_mm2": length / 5, "volume_share": 0.01, "faces": [f"Face{face}" for face in faces]}


@pytest.mark.parametrize("others, words", [
    ((), ["thread"]),
    ([ridge(8.0, (30, 31))], ["taper", "thread"]),  # on other faces
    ([ridge(8.0, (15, 31), 0.5)], ["thread", "taper"]),  # thicker
])
def test_the_pieces_of_a_thread_are_one_row(others, words):
    pieces = [ridge(8.1, (15, 19, 20)), ridge(4.3, (15, 19)), ridge(10.0, (11, 15, 19)), ridge(8.6, (19, 20, 24))]
    record = {"regions": {"listed": [*pieces, *others]}, "faces": [],
              "descriptors": {"area_mm2": 75.0, "box_mm": [5.0, 3.03, 3.03]}}
    groups = region_groups(record)
    assert sorted(group.word for group in groups) == sorted(words)
    thread = next(group for group in groups if group.word == "thread")
    assert (thread.count, len(thread.regions)) == (1, 4) and thread.length == pytest.approx(31.0)
    assert thread.faces == (10, 14, 18, 19, 23)
    # Teeth that have a face in common are too short together to go round the part.
    few = {**record, "regions": {"listed": pieces[:2]}}
    assert all(group.word == "taper" for group in region_groups(few))


def test_walls_of_several_thicknesses_are_none_thinner_than_the_thinnest():
    record = made_library.measured_record("Sheets", made_meshes.joined(
        made_meshes.box(100.0, 60.0, 2.01), made_meshes.moved(made_meshes.box(100.0, 60.0, 4.01), shift=(0.0, 0.0, 40.0))))
    assert record["descriptors"]["thickness_mm"]["min"] == pytest.approx(2.01, abs=1e-6)
    said = walls_it_is_made_of(record, [], 7.2)
    assert str(said).startswith("Walls 2.01 mm to 4.") and said.template.startswith("Walls {low} to {high} thick")


def test_more_than_three_are_summed_up():
    several = [group("plate", 1.0 + 0.3 * number, number + 1, share=0.2 - 0.01 * number) for number in range(5)]
    assert str(thin_features(several, 3.0, 60.0).words).endswith(" and 9 more")


def judged_normal(record, **more):
    condition = {"quantity": "P[0;0.05]", "value": 0.0, "comparison": ">", "threshold": 0.01, "holds": False, "margin": -1.0,
                 "error": 0.0}
    record["evidence"] = [{"criterion": "thin_places", "category": "thin_features", "title": "", "holds": False,
                           "margin": -1.0, "conditions": [condition]}]
    return {**record, "category": "normal", **more}


UNSURE = {"borderline": True, "margin": 0.01, "probabilities": [
    {"category": "thin", "probability": 0.1}, {"category": "thin_features", "probability": 0.4},
    {"category": "normal", "probability": 0.5}]}


def test_a_normal_part_says_its_thinnest_wall():
    record = made_library.measured_record("Block", made_meshes.box(100.0, 60.0, 40.0))
    assert verdict_sentence(judged_normal(record)) == (
        "Solid: no wall is thinner than 40 mm, 67\u00a0% of the width of 60 mm: mesh it with solids.")
    assert verdict_sentence(judged_normal(record, **UNSURE)) == (
        "Neither clearly solid nor clearly thin: no wall is thinner than 40 mm, 67\u00a0% of the width of 60 mm.")


def test_an_unsure_part_says_which_walls_it_has_nearly_enough_of():
    record = judged_normal(made_library.measured_record("Block", made_meshes.box(100.0, 60.0, 40.0)), **UNSURE)
    near = {**record["evidence"][0]["conditions"][0],
            "quantity": "K[0;0.12]", "value": 0.63, "threshold": 0.7, "margin": -0.1}
    record["evidence"].append({**record["evidence"][0], "conditions": [near]})
    assert verdict_sentence(record) == (  # a block has no such walls: only its edges can be so thin
        "Neither clearly solid nor clearly thin: beside edges, 63\u00a0% of the surface is thinner than 7.2 mm, "
        "12\u00a0% of the width of 60 mm.")
    record["descriptors"]["thickness_mm"]["min"] = 5.0
    assert verdict_sentence(record) == (
        "Neither clearly solid nor clearly thin: 63\u00a0% of the surface lies over walls thinner than 7.2 mm, "
        "12\u00a0% of the width of 60 mm.")
    near["value"] = 0.0
    assert "no wall is thinner than 5 mm" in verdict_sentence(record)
    near.update(value=None, holds=None)
    assert "no wall is thinner than 5 mm" in verdict_sentence(record)


def test_a_normal_part_names_the_rib_on_its_core():
    record = made_library.measured_record("Ribbed", made_meshes.ribbed_block())
    assert [each.word for each in region_groups(record)] == ["rib", "block"]
    assert verdict_sentence(judged_normal(record)) == (
        "Solid but for a rib of 6 mm (10\u00a0% of the width): mesh it with solids, and refine there.")
    assert verdict_sentence(judged_normal(record, **UNSURE)) == (
        "Neither clearly solid nor clearly thin: a rib of 6 mm (10\u00a0% of the width).")
    # So is a thread, however much of the part it is; a ring of a third of it is what the part consists of.
    thread = group("tooth", 5.3, least=3.0, length=5 * math.pi * 42.0, volume=0.2)
    core = group("bar", 36.0, share=0.5, volume=0.6)
    assert features_of_a_solid([core, thread], 2.1, 42.0).words == "thread 3 mm to 5.3 mm thick"
    assert features_of_a_solid([core, group("bar", 5.3, volume=0.3)], 2.1, 42.0) is None
    # A wall as high as the body is none, nor is what most of the part consists of.
    assert not is_rib("plate", 40.0, 6.0, 0.05) and not is_rib("plate", 20.0, 6.0, 0.5) and is_rib("plate", 20.0, 6.0, 0.05)

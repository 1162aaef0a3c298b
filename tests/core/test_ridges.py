# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ridges, the ribs, pins, threads and teeth on a core: how thick they are, and the verdict on a part that has them."""

import copy

import made_library
import made_meshes
import numpy as np
import pytest
from test_known_answers import PLACES

from thinpart_workbench.core.analysis_settings import AnalysisSettings
from thinpart_workbench.core.descriptors.equal_walls import WallSize
from thinpart_workbench.core.descriptors.region_kinds import BAR, BLOCK, PLATE, TOOTH
from thinpart_workbench.core.descriptors.ridges import NO_RIDGE, ridge_ratio
from thinpart_workbench.core.judging.classification import classify
from thinpart_workbench.core.judging.criteria import load_profile, profile_from
from thinpart_workbench.core.judging.older_record import is_to_be_measured
from thinpart_workbench.core.judging.verdict_sentence import verdict_sentence
from thinpart_workbench.core.mesh.surface_mesh import surface_mesh
from thinpart_workbench.core.record.part_record import descriptors_of, judge_again
from thinpart_workbench.core.thickness.measurement import measure

CALIBRATED = load_profile("calibrated")


def descriptors(shape, **place):
    return measure(surface_mesh(*made_meshes.moved(shape, **place)), AnalysisSettings()).descriptors


def size(kind, thickness, area=1000.0, length=100.0, width=20.0):
    return WallSize(kind, thickness, thickness, length, width, area)


@pytest.mark.parametrize("place", PLACES)
@pytest.mark.parametrize("rib, height, is_thin", [(6.0, 20.0, True), (8.0, 20.0, True), (10.0, 23.0, False)])
def test_a_rib_is_known_by_its_thickness(rib, height, is_thin, place):
    found = descriptors(made_meshes.ribbed_block(rib=rib, rib_height=height), **PLACES[place])
    assert found.value("ridge_ratio") == pytest.approx(rib / max(60.0, 40.0 + height), rel=1e-6)
    verdict = classify(found, CALIBRATED)
    assert (verdict.category, verdict.criteria) == (("thin_features", ("thin_ridges",)) if is_thin else ("normal", ()))
    if is_thin:  # what is thinner than the rib's limit is shown as thin, the rib with it
        assert verdict.thin_limit_x * found.box.diagonal == pytest.approx(0.15 * float(found.box.dimensions[1]), rel=1e-6)


@pytest.mark.parametrize("shape", [
    made_meshes.box(100, 60, 40), made_meshes.box(200, 100, 2), made_meshes.tube(), made_meshes.sphere(20, 60),
    made_meshes.wedge(30), made_meshes.ribbed_block(rib=6.0, rib_height=80.0)],
    ids=["block", "plate", "tube", "ball", "wedge", "wall on a block"])
def test_there_is_none_without_a_core_or_where_it_is_a_wall(shape):
    assert descriptors(shape).value("ridge_ratio") == NO_RIDGE


def test_a_thread_is_one():
    thread, core = size(TOOTH, 5.3, 3000.0, length=440.0), size(BAR, 36.0, 3000.0)
    assert ridge_ratio([thread, core], [0.2, 0.5], [("Face1",), ("Face2",)], 42.0, 10000.0) == pytest.approx(5.3 / 42.0)
    once_about = size(TOOTH, 5.3, 3000.0, length=140.0)
    assert ridge_ratio([once_about, core], [0.2, 0.5], [("Face1",), ("Face2",)], 42.0, 10000.0) == NO_RIDGE


def test_teeth_are_some_only_from_five_on_and_on_a_core_twice_as_thick():
    core, tooth = size(BLOCK, 40.0, 9000.0), size(TOOTH, 5.0, 300.0)

    def ratio(*sizes, surface=12000.0, share=0.5):
        return ridge_ratio(sizes, [share if each.kind in (BAR, BLOCK) else 0.02 for each in sizes],
                           [(f"Face{number}",) for number in range(len(sizes))], 50.0, surface)

    assert ratio(core, *[tooth] * 5) == pytest.approx(0.1)
    assert ratio(core, *[tooth] * 4) == NO_RIDGE
    assert ratio(core, *[tooth] * 5, share=0.3) == NO_RIDGE  # no body has most of the part
    assert ratio(core, *[tooth] * 5, surface=1e6) == NO_RIDGE  # next to nothing of the surface
    assert ratio(size(BAR, 9.0, 9000.0), *[tooth] * 5) == NO_RIDGE  # of a wire
    assert ratio(core, size(PLATE, 5.0, 4000.0)) == pytest.approx(0.1)


def test_four_bars_of_one_thickness_are_pins_whatever_their_lengths():
    core, long, short = size(BLOCK, 40.0, 9000.0), size(BAR, 5.0, 300.0, 30.0), size(BAR, 5.1, 150.0, 15.0)
    thicker = size(BAR, 6.0, 300.0, 30.0)

    def ratio(*sizes, pin=0.02):
        return ridge_ratio(sizes, [0.5, *[pin] * (len(sizes) - 1)], [(f"Face{number}",) for number in range(len(sizes))],
                           50.0, 12000.0)

    assert ratio(core, long, long, long, long) == ratio(core, long, long, short, short) == pytest.approx(0.1)
    assert ratio(core, long, long, short) == ratio(core, long, long, thicker, thicker) == NO_RIDGE  # arms of a fork
    assert ratio(core, long, long, long, long, pin=0.11) == NO_RIDGE  # legs that are a good part of it


def test_a_record_of_before_says_the_same_without_measuring():
    record = made_library.record_of("ribbed_block")
    older = copy.deepcopy(record)
    del older["descriptors"]["regions"]["ridge_ratio"]
    assert descriptors_of(older).value("ridge_ratio") == descriptors_of(record).value("ridge_ratio") == pytest.approx(0.1)
    verdict = classify(descriptors_of(older), CALIBRATED)
    assert verdict.criteria == ("thin_ridges",) and not is_to_be_measured(older, verdict)
    oldest = copy.deepcopy(older)  # before regions were found
    del oldest["regions"], oldest["descriptors"]["regions"]
    verdict = classify(descriptors_of(oldest), CALIBRATED)
    assert verdict.category == "unknown" and is_to_be_measured(oldest, verdict)


def test_the_sentence_names_the_ridge():
    record = made_library.record_of("ribbed_block")
    judge_again(record, classify(descriptors_of(record), CALIBRATED))
    assert verdict_sentence({**record, "borderline": False}) == (
        "Solid but for a rib of 6 mm (10\u00a0% of the width): mesh it with solids, and refine there.")
    assert verdict_sentence(record) == "Neither clearly solid nor clearly thin: a rib of 6 mm (10\u00a0% of the width)."


def test_a_profile_without_it_judges_as_before():
    content = copy.deepcopy(CALIBRATED.content)
    content["categories"][1]["criteria"].pop()
    assert classify(descriptors(made_meshes.ribbed_block()), profile_from(content)).category == "normal"
    assert np.isfinite(descriptors(made_meshes.box(10, 10, 10)).value("ridge_ratio"))

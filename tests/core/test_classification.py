# SPDX-License-Identifier: LGPL-2.1-or-later
import copy
import json

import pytest
from made_descriptors import part

from thinpart_workbench.core.descriptors.descriptor_table import (
    QUANTITIES,
    quantity_named,
)
from thinpart_workbench.core.errors import ProfileError
from thinpart_workbench.core.judging.classification import classify
from thinpart_workbench.core.judging.criteria import PROFILES, load_profile, profile_from

PAPER = load_profile("paper")


@pytest.mark.parametrize("criterion, holds, fails", [
    (1, part((13, 13, 1), 0.51), part((12, 12, 1), 0.51)),
    (1, part((13, 13, 1), 0.51), part((13, 13, 1), 0.5)),
    (2, part((7, 7, 1), 0.79), part((7, 4, 1), 0.79)),
    (2, part((7, 7, 1), 0.79), part((6, 6, 1), 0.79)),
    (2, part((7, 7, 1), 0.79), part((7, 7, 1), 0.8)),
    (3, part(fill=0.199), part(fill=0.2)),
    (4, part(walls=[(0.249, 0.61)]), part(walls=[(0.25, 0.61)])),
    (4, part(walls=[(0.1, 0.61)]), part(walls=[(0.1, 0.6)])),
    (5, part(walls=[(0.049, 0.001)]), part(walls=[(0.05, 0.001)])),
    (5, part(walls=[(0.01, 0.00011)]), part(walls=[(0.01, 0.00009)])),
    (6, part(walls=[(0.05, 0.1), (0.3, 0.3)]), part(walls=[(0.29, 0.1), (0.3, 0.3)])),
    (6, part(walls=[(0.289, 0.1), (0.699, 0.3)]), part(walls=[(0.289, 0.1), (0.7, 0.3)])),
    (6, part(walls=[(0.1, 0.1), (0.5, 0.21)]), part(walls=[(0.1, 0.1), (0.5, 0.2)])),
    (7, part(slanted=[(0.049, 10, 0.001)]), part(slanted=[(0.05, 10, 0.001)])),
    (7, part(slanted=[(0.01, 50, 0.001)]), part(slanted=[(0.01, 55, 0.001)])),
    (7, part(slanted=[(0.01, 50, 0.0001)]), part(slanted=[(0.01, 50, 0.00009)])),
])
def test_each_threshold_of_the_paper(criterion, holds, fails):
    assert criterion in classify(holds, PAPER).criteria
    assert criterion not in classify(fails, PAPER).criteria


def test_the_first_category_wins_and_every_criterion_is_recorded():
    verdict = classify(part((13, 13, 1), 0.9, walls=[(0.02, 0.9)]), PAPER)
    assert verdict.category == "thin" and verdict.criteria == (1, 4, 5)


def test_normal_has_the_margin_of_the_nearest_criterion():
    verdict = classify(part(fill=0.21, walls=[(0.5, 0.9)]), PAPER)
    assert verdict.category == "normal"
    assert verdict.margin == pytest.approx(0.05) and verdict.borderline


def test_thin_has_the_margin_of_its_strongest_criterion():
    verdict = classify(part(fill=0.19, walls=[(0.1, 0.9)]), PAPER)
    assert verdict.criteria[:2] == (3, 4)
    assert verdict.margin == pytest.approx(0.5) and not verdict.borderline


def test_thin_features_are_borderline_when_thin_is_near():
    verdict = classify(part(fill=0.5, walls=[(0.01, 0.59), (0.8, 0.4)]), PAPER)
    assert verdict.category == "thin_features"
    assert verdict.margin == pytest.approx(0.01 / 0.6) and verdict.borderline


def test_without_volume_a_part_is_never_normal():
    verdict = classify(part(fill=None, walls=[(0.5, 0.9)]), PAPER)
    assert verdict.category == "unknown" and verdict.margin is None
    assert "V/VBB" in verdict.reason and "3" in verdict.reason


def test_what_nothing_is_known_about_may_be_thin():
    walls = [(0.5, 0.35)]
    assert classify(part(walls=walls), PAPER).category == "normal"
    assert classify(part(walls=walls, unmet=0.65), PAPER).category == "unknown"


def test_thin_limit_is_the_bound_of_the_criteria_that_decided():
    assert classify(part(walls=[(0.1, 0.7)]), PAPER).thin_limit_x == 0.25
    assert classify(part(walls=[(0.02, 0.5), (0.2, 0.3)]), PAPER).thin_limit_x == 0.05
    assert classify(part(walls=[(0.01, 0.1)]), PAPER).thin_limit_x == 0.05
    assert classify(part(walls=[(0.2, 0.1), (0.4, 0.3)]), PAPER).thin_limit_x == 0.29
    assert classify(part(fill=0.1), PAPER).thin_limit_x == 0.05


def test_a_new_category_is_data():
    content = copy.deepcopy(PAPER.content)
    content["name"] = "house"
    content["categories"].insert(0, {"name": "flat", "criteria": [
        {"id": "f1", "conditions": [{"quantity": "d2_d3", "comparison": ">", "value": 3}]},
    ]})
    verdict = classify(part((4, 4, 1), 0.9, walls=[(0.9, 1.0)]), profile_from(content))
    assert (verdict.category, verdict.criteria) == ("flat", ("f1",))


def test_shipped_profiles_are_the_paper_verbatim():
    conditions = {
        criterion.id: [(c.quantity.symbol, c.comparison, c.value) for c in criterion.conditions]
        for criterion in PAPER.criteria
    }
    assert conditions == {
        1: [("V/VBB", ">", 0.5), ("D2/D3", ">", 12)],
        2: [("V/VBB", "<", 0.8), ("D1/D2", "<", 1.75), ("D2/D3", ">", 6)],
        3: [("V/VBB", "<", 0.2)],
        4: [("F[0;0.25]", ">", 0.6)],
        5: [("V/VBB", ">", 0.2), ("F[0;0.05]", ">", 0)],
        6: [("V/VBB", ">", 0.2), ("F[0.05;0.29]", ">", 0), ("F[0.3;0.7]", ">", 0.2)],
        7: [("min_nonparallel[10;55]", "<", 0.05)],
    }


@pytest.mark.parametrize("spoil, says", [
    (lambda c: c.update(format="x"), "not a ThinPart profile"),
    (lambda c: c.update(version=9), "version 9"),
    (lambda c: c.pop("categories"), "categories"),
    (lambda c: c["categories"][0].update(name="normal"), "'normal'"),
    (lambda c: c["categories"][1]["criteria"][0].update(id=1), "id twice"),
    (lambda c: c["categories"][0]["criteria"][0].update(conditions=[]), "always hold"),
    (lambda c: c["categories"][0]["criteria"][0]["conditions"][0].update(quantity="Q"), "Q"),
    (lambda c: c["categories"][0]["criteria"][0]["conditions"][0].update(comparison=">="), ">="),
    (lambda c: c["categories"][0]["criteria"][0]["conditions"][0].update(value="x"), "x"),
])
def test_a_wrong_profile_says_what_is_wrong(spoil, says):
    content = copy.deepcopy(PAPER.content)
    spoil(content)
    with pytest.raises(ProfileError, match=says):
        profile_from(content)


def test_profile_files_that_cannot_be_read(tmp_path):
    with pytest.raises(ProfileError, match="one of calibrated, paper"):
        load_profile("no-such")
    broken = tmp_path / "broken.json"
    broken.write_text("{")
    with pytest.raises(ProfileError, match="cannot be read"):
        load_profile(broken)


def test_every_shipped_profile_loads():
    for path in PROFILES.glob("*.json"):
        assert load_profile(path.stem).content == json.loads(path.read_text(encoding="utf-8"))


def test_every_quantity_can_be_evaluated_by_name_and_symbol():
    measured = part(walls=[(0.1, 0.5)], slanted=[(0.2, 20, 0.1)])
    for quantity in QUANTITIES:
        bounds = "[{:g};{:g}]".format(*quantity.bounds) if quantity.bounds else ""
        by_name = measured.value(quantity.name + bounds)
        assert by_name == measured.value(quantity.symbol + bounds)
        assert by_name is not None and quantity.meaning


@pytest.mark.parametrize("text", ["F", "V/VBB[0;1]", "F[0.3;0.1]", "F[a;b]", "", "volume"])
def test_a_quantity_that_is_not_there(text):
    with pytest.raises(KeyError):
        quantity_named(text)

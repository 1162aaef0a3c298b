# SPDX-License-Identifier: LGPL-2.1-or-later
"""Probabilities of the categories, and verdicts that are unsure."""

import copy
import math

import numpy as np
import pytest
from made_descriptors import part

from thinpart_workbench.core.errors import ProfileError
from thinpart_workbench.core.judging.classification import classify
from thinpart_workbench.core.judging.criteria import load_profile, profile_from

CALIBRATED = load_profile("calibrated")


def classified(measured, profile=CALIBRATED):
    return classify(measured, profile)


def test_probabilities_are_of_all_categories_and_sum_to_one():
    for measured in (part(), part(walls=[(0.01, 1.0)]), part(walls=[(0.02, 0.2)], plates=0.1)):
        found = classified(measured).probabilities
        assert list(found) == ["thin", "thin_features", "normal"]
        assert math.fsum(found.values()) == pytest.approx(1.0) and min(found.values()) >= 0.0


def test_a_plate_a_block_with_a_rib_and_a_block_are_sure():
    plate = classified(part((10, 10, 0.1), 1.0, walls=[(0.007, 0.98)], plates=0.98))
    ribbed = classified(part((1, 1, 1), 0.6, walls=[(0.02, 0.2)], plates=0.2))
    block = classified(part((1, 1, 1), 1.0, walls=[(0.577, 1.0)], plates=0.0))
    assert [each.category for each in (plate, ribbed, block)] == ["thin", "thin_features", "normal"]
    for each in (plate, ribbed, block):
        assert each.probabilities[each.category] > 0.7 and not each.borderline


def test_a_part_between_two_categories_is_unsure():
    # 72 % over thin walls that are little wider than thick: barely thin.
    verdict = classified(part((1, 1, 1), 0.5, walls=[(0.05, 0.72)], ratio=0.6))
    assert verdict.category == "thin" and verdict.borderline
    assert verdict.probabilities["thin"] < CALIBRATED.probability.unsure_under


def test_the_formula():
    content = copy.deepcopy(CALIBRATED.content)
    content["probability"]["steps"] = [
        {"category": "thin", "intercept": 1.0, "terms": [{"quantity": "V/VBB", "weight": -2.0}]},
        {"category": "thin_features", "intercept": 0.0,
         "terms": [{"quantity": "plate_share", "weight": 3.0, "log_offset": 0.01}]}]
    found = classified(part(fill=0.25, plates=0.09), profile_from(content)).probabilities
    thin = 1.0 / (1.0 + math.exp(-0.5))
    features = 1.0 / (1.0 + math.exp(3.0))
    assert found["thin"] == pytest.approx(thin)
    assert found["thin_features"] == pytest.approx((1.0 - thin) * features)


def test_what_was_not_measured_has_no_probability_and_the_margin_decides():
    verdict = classified(part(walls=[(0.577, 1.0)], plates=None), load_profile("paper"))
    assert verdict.probabilities is None
    content = copy.deepcopy(CALIBRATED.content)
    content["probability"]["steps"][0]["terms"].append({"quantity": "plate_share", "weight": 1.0})
    measured = part(walls=[(0.577, 1.0)], plates=None)
    assert profile_from(content).probability.probabilities(measured, 1e-4) is None


def test_walls_of_an_open_surface_count_as_plates():
    walls = [(0.05, 0.8)]
    closed, wire, open_surface = (part(fill=fill, walls=walls, ratio=ratio)
                                  for fill, ratio in ((0.5, 1.0), (0.5, 0.5), (None, 1.0)))
    assert [classified(each).category for each in (closed, wire, open_surface)] == ["thin", "normal", "thin"]
    assert classified(closed).probabilities == classified(open_surface).probabilities


def test_probabilities_do_not_overflow():
    content = copy.deepcopy(CALIBRATED.content)
    for step in content["probability"]["steps"]:
        step["intercept"] = -1e5
    assert classified(part(), profile_from(content)).probabilities["normal"] == 1.0
    content["probability"]["steps"][0]["intercept"] = 1e5
    assert classified(part(), profile_from(content)).probabilities["thin"] == 1.0


@pytest.mark.parametrize("spoil, says", [
    (lambda model: model.pop("unsure_under"), "unsure_under"),
    (lambda model: model.update(unsure_under=1.5), "unsure_under"),
    (lambda model: model["steps"].pop(), "categories, in their order"),
    (lambda model: model["steps"].reverse(), "categories, in their order"),
    (lambda model: model["steps"][0].update(intercept=math.inf), "finite"),
    (lambda model: model["steps"][0]["terms"][0].update(weight="x"), "x"),
    (lambda model: model["steps"][0]["terms"][0].update(quantity="Q"), "Q"),
    (lambda model: model["steps"][1]["terms"][0].update(log_offset=0), "log_offset"),
    (lambda model: model.update(steps=3), "well formed"),
])
def test_a_wrong_model_says_what_is_wrong(spoil, says):
    content = copy.deepcopy(CALIBRATED.content)
    spoil(content["probability"])
    with pytest.raises(ProfileError, match=says):
        profile_from(content)


def test_verdict_and_probabilities_are_the_same_whatever_the_scale():
    small, large = (part(np.array((1, 2, 3)) * scale, 0.4, walls=[(0.03, 0.3)], plates=0.2) for scale in (1.0, 1000.0))
    assert classified(small).probabilities == pytest.approx(classified(large).probabilities)

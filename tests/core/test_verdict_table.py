# SPDX-License-Identifier: LGPL-2.1-or-later
"""Many parts judged at once get the same categories as one by one."""

import copy

import numpy as np
import pytest
from made_descriptors import part

from thinpart_workbench.core.judging import verdict_table
from thinpart_workbench.core.judging.classification import classify
from thinpart_workbench.core.judging.criteria import load_profile, profile_from
from thinpart_workbench.core.judging.verdict_table import VerdictTable

PARTS = [
    part(box, fill, walls=walls, slanted=slanted, unmet=unmet, plates=plates)
    for box in ((13, 13, 1), (7, 7, 1), (1, 1, 1)) for fill in (None, 0.1, 0.51) for plates in (None, 0.1, 0.9)
    for walls, slanted, unmet in (([(0.02, 0.9)], [], 0.0), ([(0.4, 0.35)], [], 0.65), ([(0.1, 0.1), (0.5, 0.3)], [], 0.0),
                                  ([(0.9, 0.5)], [(0.03, 20, 0.3)], 0.0))
]


def filled():
    table = VerdictTable()
    table.add(PARTS)
    return table


def changed(name, value):
    content = copy.deepcopy(load_profile(name).content)
    content["categories"][1]["criteria"][0]["conditions"][0]["value"] = value
    return profile_from(content)


@pytest.mark.parametrize("profile", [load_profile("paper"), load_profile("calibrated"), changed("paper", 0.6),
                                     changed("calibrated", 0.5)])
def test_the_categories_are_those_of_classify(profile):
    names, numbers, _ = filled().categories(profile)
    assert [names[number] for number in numbers] == [classify(each, profile).category for each in PARTS]
    assert len(set(numbers.tolist())) > 2


def test_one_profile_after_another_and_more_parts_in_between():
    table = VerdictTable()
    table.add(PARTS[:40])
    for name in ("paper", "calibrated", "paper"):
        table.categories(load_profile(name))
    table.add(PARTS[40:])
    names, numbers, _ = table.categories(load_profile("paper"))
    assert [names[number] for number in numbers] == [classify(each, load_profile("paper")).category for each in PARTS]


def test_what_is_unknown_has_the_conditions_that_are_undecided():
    names, numbers, undecided = filled().categories(load_profile("calibrated"))
    unknown = numbers == names.index("unknown")
    assert unknown.any() and (np.logical_or.reduce(list(undecided.values())) == unknown).all()
    wide = profile_from({**load_profile("paper").content, "categories": [{
        "name": "thin", "criteria": [{"id": "wide", "conditions": [
            {"quantity": "plate_share", "comparison": ">", "value": 0.5}]}]}]})
    plates, = filled().categories(wide)[2].values()
    assert {PARTS[number].plate_share for number in np.flatnonzero(plates)} == {None}


def test_a_profile_without_categories_makes_all_parts_normal():
    names, numbers, _ = filled().categories(profile_from({**load_profile("paper").content, "categories": []}))
    assert names == ["normal", "unknown"] and not numbers.any()


def test_it_can_be_stopped_and_goes_on(monkeypatch):
    monkeypatch.setattr(verdict_table, "_PARTS_AT_ONCE", 10)
    calls = []

    def stop():
        calls.append(1)
        if len(calls) == 3:
            raise KeyboardInterrupt

    table = filled()
    with pytest.raises(KeyboardInterrupt):
        table.categories(load_profile("paper"), stop)
    names, numbers, _ = table.categories(load_profile("paper"))
    assert [names[number] for number in numbers] == [classify(each, load_profile("paper")).category for each in PARTS]

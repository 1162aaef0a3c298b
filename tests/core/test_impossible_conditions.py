# SPDX-License-Identifier: LGPL-2.1-or-later
"""Profiles whose conditions no part can meet are refused, with the place and the reason."""

import copy
import json

import pytest

from thinpart_workbench.core.errors import ProfileError
from thinpart_workbench.core.judging.criteria import PROFILES, given_profile, load_profile, profile_from, usable_profile
from thinpart_workbench.core.judging.impossible_conditions import impossible_conditions


def profile(*conditions, **entries):
    return {"format": "thinpart-profile", "version": 1, "name": "own", **entries, "categories": [
        {"name": "flat", "criteria": [{"id": "a", "conditions": [
            {"quantity": "D1/D2", "comparison": ">", "value": 2}]}]},
        {"name": "thin", "criteria": [{"id": "b", "conditions": [
            dict(zip(("quantity", "comparison", "value"), condition)) for condition in conditions]}]},
    ]}


@pytest.mark.parametrize("conditions, says", [
    ([("V/VBB", ">", 0.7), ("V/VBB", "<", 0.5)], "V/VBB > 0.7 and V/VBB < 0.5 exclude each other"),
    ([("V/VBB", "<", 0.5), ("V/VBB", ">", 0.5)], "V/VBB < 0.5 and V/VBB > 0.5 exclude each other"),
    ([("d2_d3", ">", 7), ("V/VBB", "<", 0.5), ("D2/D3", "<", 6)], "D2/D3 > 7 and D2/D3 < 6 exclude each other"),
    ([("F[0;0.05]", ">", 0.6), ("F[0;0.25]", "<", 0.5)], "exclude each other"),
    ([("P[0;0.05]", ">", 0.6), ("K[0;0.05]", "<", 0.6)], "exclude each other"),
    ([("F[0;0.05]", ">", 0), ("F[0;0.05]", "<", 0.00005)], "exclude each other"),
    ([("K[0;0.12]", ">", 70)], "K[0;0.12] > 70 never holds, because it is never above 1"),
    ([("plate_share", ">", 1)], "never above 1"),
    ([("V/VBB", ">", 1.2)], "never above 1"),
    ([("D2/D3", "<", 1)], "D2/D3 < 1 never holds, because it is never below 1"),
    ([("F[0;0.05]", "<", -0.1)], "never below 0"),
    ([("min_nonparallel[10;55]", "<", 0)], "never below 0"),
    ([("D3", "<", 0)], "never below 0"),
    ([("regions", "<", 0)], "never below 0"),
])
def test_what_no_part_can_meet_is_refused(conditions, says):
    content = profile(*conditions)
    with pytest.raises(ProfileError) as caught:
        usable_profile(content, "own.json")
    assert says in str(caught.value) and str(caught.value).startswith("own.json cannot be used: ")
    assert f"categories[1].criteria[0].conditions[{len(conditions) - 1}]" in str(caught.value)
    with pytest.raises(ProfileError):
        given_profile(content)
    assert profile_from(content).name == "own", "an info file that has it can be read"


@pytest.mark.parametrize("conditions", [
    [("V/VBB", ">", 0.5), ("V/VBB", "<", 0.7)],
    [("F[0;0.25]", ">", 0.6), ("F[0;0.05]", "<", 0.5)],
    [("K[0;0.05]", ">", 0.6), ("P[0;0.05]", "<", 0.5)],
    [("F[0;0.05]", ">", 0.6), ("K[0;0.05]", "<", 0.5)],
    [("F[0;0.05]", "<", 0)],  # less than the area floor: no thin wall
    [("min_nonparallel[10;55]", ">", 2)],  # there are no such walls
    [("region_mm", "<", 0.5), ("regions", ">", 3)],
    [("volume_mm3", "<", 5), ("area_mm2", ">", 1e7)],
])
def test_what_some_part_meets_is_allowed(conditions):
    assert impossible_conditions(usable_profile(profile(*conditions))) == []


def test_shipped_profiles_are_possible():
    for path in PROFILES.glob("*.json"):
        assert impossible_conditions(load_profile(path.stem)) == []


def test_a_file_is_refused_with_its_name(tmp_path):
    file = tmp_path / "house.json"
    file.write_text(json.dumps(profile(("V/VBB", ">", 0.7), ("V/VBB", "<", 0.5))))
    with pytest.raises(ProfileError, match=r"house.json cannot be used: .*categories\[1\].criteria\[0\]"):
        load_profile(file)


@pytest.mark.parametrize("spoil, says", [
    (lambda c: c["categories"][1]["criteria"][0]["conditions"][0].update(quantity="F[0.3;0.1]"),
     "categories[1].criteria[0].conditions[0] names 'F[0.3;0.1]', which is no quantity"),
    (lambda c: c["categories"][1]["criteria"][0]["conditions"][0].update(quantity="K[0;1.2.3]"), "is no quantity"),
    (lambda c: c["categories"][1]["criteria"][0]["conditions"][0].update(quantity="Q"), "there are V, A, D1"),
    (lambda c: c["categories"][1]["criteria"][0]["conditions"][0].update(value="0.7"),
     "categories[1].criteria[0].conditions[0].value is '0.7', not a finite number"),
    (lambda c: c["categories"][1]["criteria"][0]["conditions"][0].update(value=True), "conditions[0].value is true"),
    (lambda c: c["categories"][1]["criteria"][0]["conditions"][0].pop("value"), "conditions[0].value is missing"),
    (lambda c: c["categories"][1]["criteria"][0].update(conditions=[]), "categories[1].criteria[0].conditions is empty"),
    (lambda c: c["categories"][1]["criteria"][0].update(id=None), "categories[1].criteria[0].id is null"),
    (lambda c: c["categories"][1].update(name="flat"), "categories has 'flat' twice"),
    (lambda c: c["categories"][1]["criteria"][0].update(id="a"), "id twice: 'a'"),
    (lambda c: c.update(categories={}), "categories is an object"),
    (lambda c: c.update(area_floor=2), "area_floor is 2"),
    (lambda c: c.update(name=7), "name is 7"),
])
def test_what_is_not_well_formed_has_its_place_and_reason(spoil, says):
    content = copy.deepcopy(profile(("V/VBB", "<", 0.5)))
    spoil(content)
    with pytest.raises(ProfileError) as caught:
        profile_from(content)
    assert says in str(caught.value)


def test_wrong_json_has_its_line(tmp_path):
    file = tmp_path / "own.json"
    file.write_text('{"format": "thinpart-profile",\n "version": 1,,}')
    with pytest.raises(ProfileError, match="own.json cannot be read .*line 2 column 15"):
        load_profile(file)

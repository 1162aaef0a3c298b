# SPDX-License-Identifier: LGPL-2.1-or-later
"""What people say of wall regions: kept in info files, found again after measuring anew, without effect on verdicts."""

import copy
import json

import made_library
import pytest
from test_regions_in_records import RIBS

from thinpart_workbench.api.annotations import note_regions, region_notes
from thinpart_workbench.core.errors import ThinPartError
from thinpart_workbench.core.record.record_types import PART
from thinpart_workbench.core.record.region_groups import features_of, region_groups
from thinpart_workbench.core.record.region_notes import notes_of_regions
from thinpart_workbench.storage.info.annotations import carry_annotations, has_annotation, set_region_note

REASON = "crush rib, thin on purpose"


@pytest.fixture(scope="module")
def measured():
    return made_library.measured_record("ribs", RIBS)


@pytest.fixture
def ribbed(measured):
    return copy.deepcopy(measured)


def moved(record, share):
    """The record of another measurement: places differ by a share of the length, one face of each region is another one."""
    other = copy.deepcopy(record)
    for region in other["regions"]["listed"]:
        region["place"][2] += share * region["length_mm"]
        region["min"] *= 1.01
    return other


def test_both_ribs_are_excluded_and_each_has_its_own_note(ribbed):
    before = {key: copy.deepcopy(ribbed[key]) for key in ("category", "criteria", "margin", "evidence")}
    group = region_groups(ribbed)[0]
    assert group.count == 2 and group.excluded == "" and group.mesh_size is None
    assert set_region_note(ribbed, group.regions, "Anna", excluded=REASON)
    assert PART.fault(json.loads(json.dumps(ribbed)), "part") is None
    assert len(ribbed["region_notes"]) == 2 and has_annotation(ribbed)
    assert [(each.count, each.excluded) for each in region_groups(ribbed)] == [(2, REASON), (1, "")]
    assert {key: ribbed[key] for key in before} == before
    assert not set_region_note(ribbed, group.regions, "Anna", excluded=REASON), "the same again is no change"


def test_regions_with_different_notes_are_in_different_rows(ribbed):
    first, second, _ = ribbed["regions"]["listed"]
    set_region_note(ribbed, [first], "Anna", excluded=REASON)
    set_region_note(ribbed, [second], "Bert", mesh_size_mm=0.5)
    assert [(each.count, each.excluded, each.mesh_size) for each in region_groups(ribbed)] == [
        (1, REASON, None), (1, "", 0.5), (1, "", None)]
    set_region_note(ribbed, [first], "Bert", mesh_size_mm=0.25)
    assert [(note["person"], note.get("excluded"), note.get("mesh_size_mm")) for note in ribbed["region_notes"]] == [
        ("Bert", REASON, 0.25), ("Bert", None, 0.5)]
    set_region_note(ribbed, [first, second], "Anna", mesh_size_mm=0.0)
    assert [note.get("excluded") for note in ribbed["region_notes"]] == [REASON]
    set_region_note(ribbed, [first], "Anna", excluded="")
    assert "region_notes" not in ribbed and not has_annotation(ribbed)


@pytest.mark.parametrize("share, is_found", [(0.1, True), (-0.3, True), (0.9, False)])
def test_notes_are_found_again_by_place_and_faces(ribbed, share, is_found):
    set_region_note(ribbed, ribbed["regions"]["listed"][:1], "Anna", excluded=REASON)
    again = moved(ribbed, share)
    found = notes_of_regions(again["regions"]["listed"], ribbed["region_notes"])
    assert [note is not None for note in found] == [is_found, False, False]


def test_a_region_with_other_faces_is_another_one(ribbed):
    set_region_note(ribbed, ribbed["regions"]["listed"][:1], "Anna", excluded=REASON)
    again = moved(ribbed, 0.0)
    again["regions"]["listed"][0]["faces"] = ["Face90", "Face91"]
    assert notes_of_regions(again["regions"]["listed"], ribbed["region_notes"]) == [None, None, None]


def test_a_new_analysis_keeps_the_notes(ribbed):
    set_region_note(ribbed, ribbed["regions"]["listed"][:1], "Anna", excluded=REASON)
    new = {"parts": [moved(ribbed, 0.05)]}
    new["parts"][0].pop("region_notes")
    carry_annotations(new, {"parts": [ribbed]})
    assert region_groups(new["parts"][0])[0].excluded == REASON


def test_notes_are_written_to_info_files(ribbed, tmp_path):
    path = made_library.store(tmp_path, "ribs.step", [ribbed])
    assert region_notes(tmp_path / "none.json") is None
    record = note_regions(path, ribbed["regions"]["listed"][:1], "Anna", excluded=REASON)
    assert region_notes(path) == {ribbed["name"]: record["region_notes"]}
    with pytest.raises(ThinPartError):
        note_regions(path, ribbed["regions"]["listed"][:1], "Anna", excluded="a\0b")
    with pytest.raises(ThinPartError):
        note_regions(path, ribbed["regions"]["listed"][:1], "x\ny", excluded=REASON)
    assert region_notes(path) == {ribbed["name"]: record["region_notes"]}


def test_the_feature_with_most_of_the_area_comes_first(ribbed):
    group = region_groups(ribbed)[0]
    features = ["Pad"] * len(ribbed["faces"])
    features[group.faces[0]] = "Rib"
    features[group.faces[1]] = ""
    assert sorted(features_of(group, ribbed, features)) == ["Pad", "Rib"]
    assert features_of(group, ribbed, []) == []
    areas = {int(face["face"][4:]) - 1: face["area_mm2"] for face in ribbed["faces"]}
    by_area = {name: sum(areas[face] for face in group.faces if features[face] == name) for name in ("Pad", "Rib")}
    assert features_of(group, ribbed, features)[0] == max(by_area, key=by_area.get)

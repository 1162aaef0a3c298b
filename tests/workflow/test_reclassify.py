# SPDX-License-Identifier: LGPL-2.1-or-later
"""Judging again gives what a new analysis by that profile would give, and touches nothing else."""

import copy
import json
import os
from pathlib import Path

import made_library
import pytest

from thinpart_workbench.api.annotations import annotate_part
from thinpart_workbench.core.judging.classification import classify
from thinpart_workbench.core.judging.criteria import load_profile, profile_from
from thinpart_workbench.core.record.part_record import descriptors_of
from thinpart_workbench.storage.info.info_file import SUFFIX, change_info, is_current, read_info
from thinpart_workbench.workflow.library.reclassify import described_document, reclassify_files

PAPER = load_profile("paper").content


@pytest.fixture
def info_files(tmp_path):
    library = made_library.make_library(tmp_path / "library")
    return sorted(str(path) for path in library.rglob(f"*{SUFFIX}"))


@pytest.fixture
def strict():
    """No part is thin by it, whatever could not be measured."""
    profile = copy.deepcopy(PAPER)
    profile["name"] = "strict"
    for category in profile["categories"]:
        for criterion in category["criteria"]:
            criterion["conditions"].append({"quantity": "D1", "comparison": ">", "value": 1e9})
    return profile


def categories(info_files):
    return {(path, part["name"]): part["category"] for path in info_files for part in read_info(path)["parts"]}


def test_the_same_profile_changes_nothing_not_even_a_byte(info_files):
    before = [Path(path).read_bytes() for path in info_files]
    for file in reclassify_files(info_files, PAPER, write=True):
        assert file.error is None and not any(part.differs for part in file.parts)
    assert [Path(path).read_bytes() for path in info_files] == before


@pytest.mark.parametrize("jobs", [1, 2])
def test_another_profile(info_files, strict, jobs, monkeypatch):
    from thinpart_workbench.workflow.library import reclassify

    monkeypatch.setattr(reclassify, "FILES_AT_ONCE", 2)
    before = categories(info_files)
    told = list(reclassify_files(info_files, strict, jobs=jobs))
    assert [file.info_file for file in told] == info_files and categories(info_files) == before
    for file in told:
        for part in file.parts:
            record, = (each for each in read_info(file.info_file)["parts"] if each["name"] == part.name)
            expected = classify(descriptors_of(record), profile_from(strict))
            assert part.before["category"] == before[file.info_file, part.name]
            assert part.after["category"] == expected.category == "normal"


def test_written_atomically_with_everything_else_as_it_was(info_files, strict):
    annotate_part(info_files[0], "Solid1", notes="stays")
    before = [read_info(path) for path in info_files]
    list(reclassify_files(info_files, strict, write=True))
    for path, old in zip(info_files, before):
        new = read_info(path)
        assert new["profile"] == strict
        changed = {"category", "criteria", "margin", "borderline", "reason", "evidence"}
        for part, was in zip(new["parts"], old["parts"]):
            assert {key: part[key] for key in part if key not in changed} == {
                key: was[key] for key in was if key not in changed}
        assert {key: new[key] for key in new if key not in ("profile", "parts")} == {
            key: old[key] for key in old if key not in ("profile", "parts")}
    assert set(categories(info_files).values()) == {"normal"}
    assert not [name for path in info_files for name in os.listdir(os.path.dirname(path))
                if name.endswith(".tmp")]
    list(reclassify_files(info_files, PAPER, write=True))
    for path, old in zip(info_files, before):
        new = read_info(path)
        assert new["profile"] == old["profile"]
        for part, was in zip(new["parts"], old["parts"]):
            assert part["margin"] == pytest.approx(was["margin"], rel=1e-6)
            assert (part["category"], part["criteria"], part["reason"]) == (
                was["category"], was["criteria"], was["reason"])


def test_a_damaged_info_file_is_one_sentence_and_the_rest_goes_on(info_files, strict):
    damaged = {info_files[0]: "{", info_files[2]: json.dumps({**read_info(info_files[2]), "parts": [{}]})}
    for path, text in damaged.items():
        Path(path).write_text(text)
    for write in (False, True):
        told = {file.info_file: file for file in reclassify_files(info_files, strict, write)}
        assert set(told) == set(info_files)
        assert {path for path in told if told[path].error} == set(damaged)
        assert all(told[path].error.endswith(".") for path in damaged)
        assert {path: Path(path).read_text() for path in damaged} == damaged


@pytest.fixture
def before(tmp_path):
    """An info file of a version that did not measure the local thickness, of a plate and a cube."""
    precision = {"accuracy": "standard", "samples": 6000, "wall_mm": 0.001, "chord_mm": 0.001, "mean_chord_mm": 0.0005,
                 "area_share": 0.0, "plate_share": 0.0, "errors": []}
    records = [made_library.record_of("plate", name="Solid1"), made_library.record_of("cube", name="Solid2")]
    for record in records:
        record["descriptors"]["precision"] = precision
        for key in ("local", "plate_ratio"):
            del record["descriptors"][key]
    return str(made_library.store(tmp_path / "library", "two.step", records))


def by_local_thickness(categories):
    """The conditions of the paper for a thin part, then one on the local thickness."""
    profile = copy.deepcopy(PAPER)
    profile.update(name="local", categories=[profile["categories"][0], {"name": "thin_features", "criteria": [
        {"id": "local", "conditions": [{"quantity": "L[0;0.08]", "comparison": ">", "value": 0.03}]}]}][:categories])
    return profile


def is_taken(info_file):
    """Whether an analysis by the profile of an info file takes its verdicts instead of measuring."""
    content = read_info(info_file)
    return is_current(content, described_document(info_file, content), content["settings"], content["profile"], info_file)


def test_what_an_earlier_version_measured_is_enough_where_it_decides(before):
    shipped = load_profile("calibrated").content
    file, = reclassify_files([before], shipped, write=True)
    assert [(part.after["category"], part.measure_again) for part in file.parts] == [("thin", False), ("normal", False)]
    assert read_info(before)["profile"] == shipped and is_taken(before)


def test_what_it_did_not_measure_is_measured_again(before):
    file, = reclassify_files([before], by_local_thickness(2), write=True)
    assert [(part.after["category"], part.measure_again) for part in file.parts] == [("thin", False), ("unknown", True)]
    assert not is_taken(before)
    list(reclassify_files([before], by_local_thickness(1), write=True))  # asks for nothing that is not there
    assert is_taken(before)


@pytest.mark.parametrize("share, has_errors, enough", [(0.5, True, True), (0.999, True, False), (0.5, False, False)])
def test_a_less_exact_quantity_is_enough_where_its_error_cannot_turn_the_verdict(before, share, has_errors, enough):
    value = descriptors_of(read_info(before)["parts"][0]).named_value("plate_ratio")
    profile = by_local_thickness(1)
    profile["categories"][0]["criteria"] = [{"id": "near", "conditions": [
        {"quantity": "plate_ratio", "comparison": ">", "value": value * share}]}]
    if not has_errors:  # a version before that
        change_info(before, lambda content: [part["descriptors"].update(precision=None) for part in content["parts"]])
    file, = reclassify_files([before], profile, write=True)
    assert file.parts[0].after["category"] == "thin" and is_taken(before) == enough

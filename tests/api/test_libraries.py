# SPDX-License-Identifier: LGPL-2.1-or-later
"""Libraries searched and judged again by a program."""

import json
import os
import shutil

import made_library
import pytest
from program import records
from program import thinpart as command

import thinpart_workbench as thinpart
from thinpart_workbench.core.record.record_types import PART

FLAT = {"format": "thinpart-profile", "version": 1, "name": "flat", "categories": [
    {"name": "flat", "criteria": [{"id": "F1", "conditions": [{"quantity": "D2/D3", "comparison": ">", "value": 10}]}]}]}


def labels(found):
    return sorted(part.label for part in found)


@pytest.mark.parametrize("asked, options", [
    ({}, []),
    ({"category": "thin"}, ["--category", "thin"]),
    ({"category": ["thin", "normal"], "limit": 3}, ["--category", "thin,normal", "-n", "3"]),
    ({"criterion": 3}, ["--criterion", "3"]),
    ({"where": "D2/D3 > 6 and F[0;0.05] >= 0.5"}, ["--where", "D2/D3 > 6 and F[0;0.05] >= 0.5"]),
    ({"where": ("V/VBB > 0.9", "D1 < 50")}, ["--where", "V/VBB > 0.9", "--where", "D1 < 50"]),
    ({"text": "deckel süd"}, ["--text", "deckel süd"]),
    ({"thickness": (None, 2.5), "size": (50, None)}, ["--max-thickness", "2.5", "--min-size", "50"]),
    ({"sort": "thinnest_mm", "descending": True}, ["--sort", "thinnest_mm", "--reverse"]),
    ({"failed": True}, ["--failed"]),
    ({"has_notes": True}, ["--notes"]),
    ({"borderline": False}, ["--no-borderline"]),
    ({"changed_since": "1d"}, ["--changed-since", "1d"]),
])
def test_what_is_found_is_what_the_command_line_finds(library, asked, options):
    found = thinpart.find(library, **asked)
    told = records(command("find", library, *options, "--json"))
    assert list(found.records()) == told and len(found) == len(told)
    assert [part.label for part in found] == [line["label"] for line in told]
    assert found.problems == () and found.total >= len(found)


def test_a_found_part_has_what_its_record_has(library):
    part, = thinpart.find(library, text="Deckel")
    record = part.record()
    assert PART.fault(record, "part") is None and part.failure is None and part.score is None
    assert (part.name, part.label, part.instances, part.category) == ("Solid1", "Deckel Süd", 4, "thin")
    assert part.criteria == tuple(map(str, record["criteria"])) and part.margin == pytest.approx(record["margin"])
    assert part.box_mm == pytest.approx(tuple(record["descriptors"]["box_mm"])) and part.thinnest_mm == pytest.approx(2.0)
    assert part.volume_mm3 == pytest.approx(20000.0) and part.area_mm2 == pytest.approx(20800.0)
    assert (part.notes, part.mesh, part.link) == ("", None, None)
    assert os.path.basename(part.file) == "assembly.step" and part.info_file == part.file + ".thinpart.json"
    assert repr(part) == f"<FoundPart 'Deckel Süd' of {part.file!r}: thin>"


def test_a_failure_is_found_as_one(library):
    failed, = thinpart.find(library, failed=True)
    assert (failed.failure.kind, failed.failure.message) == ("no_solid", "broken bounds no solid.")
    assert failed.category is None and failed.box_mm is None and "failed: no_solid" in repr(failed)
    with pytest.raises(thinpart.ThinPartError, match="broken bounds no solid") as refused:
        failed.record()
    assert refused.value.kind == "no_solid"


def test_a_part_that_has_gone_since_is_one_sentence(tmp_path):
    made_library.store(tmp_path, "cube.step", [made_library.record_of("cube")])
    part, = thinpart.find(tmp_path)
    made_library.store(tmp_path, "cube.step", [made_library.record_of("cube", name="Other")])
    with pytest.raises(thinpart.ThinPartError, match="is no longer in"):
        part.record()


def test_several_folders_are_searched_and_each_part_told_once(library):
    both = thinpart.find([library, library / "group 0"])
    assert [part.info_file for part in both] == [part.info_file for part in thinpart.find(library)]
    assert len(both) == both.total


def test_what_cannot_be_searched_is_told(library, tmp_path):
    made_library.store(tmp_path, "cube.step", [made_library.record_of("cube")])
    (tmp_path / "bad.step.thinpart.json").write_text("{")
    found = thinpart.find([tmp_path, tmp_path / "gone"])
    assert labels(found) == [made_library.record_of("cube")["label"]]
    assert [(problem.kind, problem.root) for problem in found.problems] == [
        ("info_file", str(tmp_path)), ("folder", str(tmp_path / "gone"))]
    assert all(problem.message.endswith(".") for problem in found.problems)
    with pytest.raises(thinpart.ThinPartError, match="There is no folder") as refused:
        thinpart.find(tmp_path / "gone")
    assert refused.value.kind == "missing"


@pytest.mark.parametrize("asked, words", [
    ({"where": "D9 > 3"}, "There is no quantity 'D9'"), ({"where": "D2 is 3"}, "is not understood"),
    ({"sort": "files.path; DROP TABLE parts"}, "Parts are not sorted by"),
    ({"changed_since": "yesterday"}, "'yesterday' is no date"), ({"changed_since": "999999y"}, "'999999y' is no date"),
])
def test_what_is_not_understood_is_one_sentence(library, asked, words):
    with pytest.raises(thinpart.ThinPartError, match=words) as refused:
        thinpart.find(library, **asked)
    assert refused.value.kind == "usage"


def test_similar_parts_are_those_of_the_command_line(library):
    part = library / "group 0" / "plate.step"
    found = thinpart.similar(part, library, 3)
    told = records(command("similar", part, library, "-n", "3", "--json"))
    assert [(each.label, round(each.score, 2), each.reasons) for each in found] == [
        (line["label"], line["score"], line["reasons"]) for line in told] and len(told) == 3
    assert found[0].label == "Deckel Süd" and found[0].score > 99
    stored, = [each for each in thinpart.find(library, text="group plate.step") if each.file == str(part)]
    for way in (stored, str(part) + ".thinpart.json"):
        assert [each.stored for each in thinpart.similar(way, library, 3)] == [each.stored for each in found]
    # A record, or what was classified just now, is not known to be one of the library: it is most like itself.
    for way in (stored.record(), thinpart.ClassifiedPart(stored.record())):
        assert thinpart.similar(way, library, 1)[0].score > 99


def test_what_others_are_compared_with_must_be_clear(library):
    with pytest.raises(thinpart.ThinPartError, match="holds 2 parts"):
        thinpart.similar(library / "assembly.step", library)
    nearest = thinpart.similar(library / "assembly.step", library, 1, name="foot")[0]
    assert nearest.label == made_library.record_of("cube")["label"]
    with pytest.raises(thinpart.ThinPartError, match="This is not a part record: the part.label is missing"):
        thinpart.similar({"name": "x"}, library)
    with pytest.raises(thinpart.ThinPartError) as refused:
        thinpart.similar(library / "gone.step", library)
    assert refused.value.kind == "missing"


def test_stored_parts_are_judged_again_by_a_dict(library, tmp_path):
    folder = tmp_path / "library"
    shutil.copytree(library, folder)
    (tmp_path / "flat.json").write_text(json.dumps(FLAT))
    told = records(command("reclassify", folder, "--profile", tmp_path / "flat.json", "--json"))
    judged = thinpart.reclassify(folder, FLAT)
    files = list(judged)
    assert len(files) == len(judged) and judged.problems == [] and judged.profile.name == "flat"
    assert [(file.document, part.name, part.before, part.after) for file in files for part in file.parts] == [
        (line["file"], line["name"], line["before"],
         {key: line[key] for key in ("category", "criteria", "margin", "borderline")}) for line in told]
    assert thinpart.find(folder, category="flat").total == 0, "it was only told"
    thinpart.reclassify(folder, FLAT, write=True)
    assert thinpart.find(folder, category="flat").total == 0, "nothing happens before it is iterated"
    assert all(file.error is None for file in thinpart.reclassify(folder, FLAT, write=True))
    assert "plate" in labels(thinpart.find(folder, category="flat"))


def test_nothing_to_judge_is_one_sentence(tmp_path):
    with pytest.raises(thinpart.ThinPartError, match="There are no info files") as refused:
        thinpart.reclassify(tmp_path)
    assert refused.value.kind == "empty"

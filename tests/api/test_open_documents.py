# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the window has done with open documents, by a program: measured from a snapshot, stored, compared."""

import os

import pytest

import thinpart_workbench as thinpart
from thinpart_workbench.api import snapshots
from thinpart_workbench.api.classified_parts import PartFailure
from thinpart_workbench.api.document_info import file_stamp, write_document_info
from thinpart_workbench.api.saved_documents import classify_saved
from thinpart_workbench.api.snapshots import FirstMap, SnapshotMap, SnapshotPart, measure_snapshot
from thinpart_workbench.core.judging.criteria import load_profile
from thinpart_workbench.freecad_adapter.objects.snapshot import write_snapshot
from thinpart_workbench.freecad_adapter.reading.document_parts import document_parts
from thinpart_workbench.storage.info.info_file import read_info
from thinpart_workbench.storage.map_file import read_maps

SETTINGS = thinpart.AnalysisSettings()
PAPER = load_profile("paper")


@pytest.fixture
def plates(document):
    """A document with two plates of 3 and 8 mm."""
    import Part

    for name, height in (("First", 3), ("Second", 8)):
        document.addObject("Part::Feature", name).Shape = Part.makeBox(40, 30, height)
    return document


def snapshot_of(document, folder, **options):
    list(write_snapshot(document_parts(document), str(folder), SETTINGS, PAPER.content, **options))
    return str(folder)


def test_a_snapshot_is_measured_as_the_document_is(plates, tmp_path):
    told = []
    found = list(measure_snapshot(snapshot_of(plates, tmp_path), 4000, lambda *progress: told.append(progress)))
    assert [type(each) for each in found] == [SnapshotPart, SnapshotPart]
    expected = thinpart.classify(plates, PAPER)
    assert [(each.record["name"], each.record["category"]) for each in found] == [
        (part.name, part.category) for part in expected]
    assert [each.record["descriptors"]["thickness_mm"]["min"] for each in found] == pytest.approx([3, 8])
    assert [(each.thin_limit_mm, each.thin_shares) for each in found] == [(None, None)] * 2
    assert {(name, stage) for name, stage, fraction in told if fraction == 1.0} >= {
        ("First", "measure"), ("Second", "measure")}


def test_maps_follow_their_parts_and_thin_faces_are_by_the_limit_asked_for(plates, tmp_path):
    folder = snapshot_of(plates, tmp_path, thin_limit={"millimetres": 5.0}, maps="ray")
    found = list(measure_snapshot(folder, 4000))
    assert [type(each) for each in found] == [SnapshotPart, SnapshotMap] * 2
    thin, thick = found[0], found[2]
    assert thin.thin_limit_mm == thick.thin_limit_mm == 5.0
    assert sum(share > 0.9 for share in thin.thin_shares) == 2 and max(thick.thin_shares) == 0.0
    mapped, = read_maps(found[1].file)
    assert mapped.record["name"] == found[1].part == "First" and os.path.dirname(found[1].file) == folder


def test_first_maps_of_all_parts_come_before_anything_is_measured(plates, tmp_path):
    folder = snapshot_of(plates, tmp_path, maps="ray", first_maps=True)
    found = list(measure_snapshot(folder, 4000))
    assert [type(each) for each in found] == [FirstMap, FirstMap, *[SnapshotPart, SnapshotMap] * 2]
    # The larger one first.
    assert [each.part for each in found[:2]] == ["Second", "First"]
    for first, thickness in zip(found, (8, 3)):
        coarse, = read_maps(first.file)
        assert coarse.record == {"name": first.part, "label": first.part}, "nothing that could be taken for a verdict"
        assert coarse.map.thickness[abs(coarse.map.normals[:, 2]) > 0.9] == pytest.approx(thickness, abs=1e-3)


def test_the_largest_parts_of_an_assembly_have_first_maps_first_and_all_have_one_in_the_end(document, tmp_path, monkeypatch):
    import Part

    for name, side in (("Small", 10), ("Large", 40), ("Middle", 20), ("Least", 5)):
        document.addObject("Part::Feature", name).Shape = Part.makeBox(side, side, 1)
    folder = snapshot_of(document, tmp_path, maps="ray", first_maps=True)
    assert [each.part for each in measure_snapshot(folder, 4000) if isinstance(each, FirstMap)] == [
        "Large", "Middle", "Small", "Least"]
    # Where there is no time for all before measuring begins, the others follow between the parts.
    monkeypatch.setattr(snapshots, "FIRST_MAPS_SECONDS", 0.0)
    found = list(measure_snapshot(folder, 4000))
    assert [each.part for each in found if isinstance(each, FirstMap)] == ["Large", "Middle", "Small", "Least"]
    assert [type(each) for each in found[:3]] == [SnapshotPart, SnapshotMap, FirstMap]
    assert [each.record["name"] for each in found if isinstance(each, SnapshotPart)] == ["Small", "Large", "Middle", "Least"]


def test_a_part_without_a_first_map_is_reported_once_and_the_others_have_theirs(plates, tmp_path):
    folder = snapshot_of(plates, tmp_path, maps="ray", first_maps=True)
    (tmp_path / "0.brep").write_text("no shape")
    found = list(measure_snapshot(folder, 4000))
    assert [type(each) for each in found] == [FirstMap, PartFailure, SnapshotPart, SnapshotMap]
    assert found[0].part == "Second" and found[1].part == "First"


def test_first_maps_are_made_only_together_with_maps(plates, tmp_path):
    found = list(measure_snapshot(snapshot_of(plates, tmp_path, first_maps=True), 4000))
    assert [type(each) for each in found] == [SnapshotPart] * 2


def test_a_part_that_cannot_be_read_is_a_failure_and_the_next_is_measured(plates, tmp_path):
    folder = snapshot_of(plates, tmp_path)
    (tmp_path / "0.brep").write_text("no shape")
    failure, second = measure_snapshot(folder, 4000)
    assert isinstance(failure, PartFailure) and (failure.part, failure.kind) == ("First", "failed")
    assert failure.message.startswith("First failed (") and second.record["name"] == "Second"


def test_what_was_measured_is_stored_and_compared_and_taken_from_there(plates, tmp_path):
    file = str(tmp_path / "plates.FCStd")
    plates.saveAs(file)
    (tmp_path / "snapshot").mkdir()
    records = [each.record for each in measure_snapshot(snapshot_of(plates, tmp_path / "snapshot"), 4000)]
    first = write_document_info(file, file_stamp(file), records, [], "paper", SETTINGS)
    assert first.before is None and list(first.now) == ["First", "Second"]
    assert [part["name"] for part in read_info(first.path)["parts"]] == ["First", "Second"]
    again = write_document_info(file, file_stamp(file), records, [], PAPER, SETTINGS)
    assert again.before == again.now == first.now and again.path == first.path
    saved = classify_saved(file, PAPER, measure=False)
    assert saved.current and saved.verdicts == saved.before == first.now and saved.failures == []
    other = classify_saved(file, settings=thinpart.AnalysisSettings(minimum_samples=5000), measure=False)
    assert not other.current and other.verdicts is None and other.before == first.now
    stale = [file_stamp(file)[0], 1]
    with pytest.raises(thinpart.ThinPartError, match="was saved again"):
        write_document_info(file, stale, records, [], "paper", SETTINGS)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Wall regions in part records, in files of versions that lack them, in the search index and in groups."""

import copy
import json

import made_library
import made_meshes
import pytest

from thinpart_workbench.api.annotations import keep_mesh_settings, settings_that_worked
from thinpart_workbench.core.judging.conditions import search_conditions
from thinpart_workbench.core.record.part_record import descriptors_of
from thinpart_workbench.core.record.record_types import PART
from thinpart_workbench.core.record.region_groups import equal_regions, region_groups
from thinpart_workbench.storage.index.library_index import LibraryIndex
from thinpart_workbench.storage.index.part_query import PartQuery
from thinpart_workbench.storage.index.written_query import SORTABLE
from thinpart_workbench.workflow.library.find_parts import find_parts

RIBS = made_meshes.prism([(0, 0), (60, 0), (60, 40), (50, 40), (50, 70), (48, 70), (48, 40), (12, 40), (12, 70), (10, 70),
                          (10, 40), (0, 40)], 80)


@pytest.fixture(scope="module")
def ribbed():
    return made_library.measured_record("ribs", RIBS)


def without_regions(record):
    older = copy.deepcopy(record)
    del older["regions"], older["descriptors"]["regions"]
    return older


def test_a_record_has_the_regions_and_their_counts(ribbed):
    regions = ribbed["regions"]
    assert [(region["kind"], region["min"], len(region["faces"])) for region in regions["listed"]] == [
        ("plate", 2.0, 2), ("plate", 2.0, 2), ("block", 40.0, 4)]
    assert (regions["others"], regions["others_share"]) == (0, 0.0)
    assert ribbed["descriptors"]["regions"] == {
        "thinnest_mm": 2.0, "count": 3, "plate": 2, "tube": 0, "bar": 0, "block": 1, "taper": 0, "tooth": 0,
        "ridge_ratio": 1.0}
    assert PART.fault(json.loads(json.dumps(ribbed)), "part") is None
    names = {face["face"] for face in ribbed["faces"]}
    assert all(set(region["faces"]) <= names for region in regions["listed"])


@pytest.mark.parametrize("key, value", [("kind", "blob"), ("faces", None), ("volume_share", 1.5), ("place", [0, 0])])
def test_wrong_regions_are_refused(ribbed, key, value):
    wrong = copy.deepcopy(ribbed)
    wrong["regions"]["listed"][0][key] = value
    assert PART.fault(wrong, "part").startswith(f"part.regions.listed[0].{key} ")


def test_files_of_earlier_versions_are_read_without_regions(ribbed):
    older = without_regions(ribbed)
    assert PART.fault(older, "part") is None
    assert descriptors_of(older).value("regions") is None and descriptors_of(ribbed).value("regions") == 3
    assert region_groups(older) == []


def test_groups_begin_with_what_is_thinnest_anywhere(ribbed):
    record = copy.deepcopy(ribbed)
    record["regions"]["listed"][2]["min"] = 1.0  # thick for the most part, and thinner than the ribs at its end
    assert [group.least for group in region_groups(record)] == [1.0, 2.0]
    assert [group.least for group in region_groups(ribbed)] == [2.0, 40.0]


def test_equal_regions_are_one_group(ribbed):
    ribs, block = region_groups(ribbed)
    assert (ribs.kind, ribs.count, ribs.least, len(ribs.faces)) == ("plate", 2, 2.0, 4)
    assert ribs.volume_share == pytest.approx(2 * 60 / (2400 + 2 * 60), rel=0.05)
    assert (block.kind, block.count) == ("block", 1)


def test_libraries_are_searched_by_regions(ribbed, tmp_path):
    tube = made_library.measured_record("tube", made_meshes.tube())
    older = {**without_regions(tube), "name": "older", "label": "older"}
    made_library.store(tmp_path, "ribs.step", [ribbed])
    made_library.store(tmp_path, "tube.step", [tube])
    made_library.store(tmp_path, "older.step", [older])
    with LibraryIndex(tmp_path, tmp_path / "cache") as index:
        index.refresh()

        def found(text):
            return [part.label for part in find_parts(index, PartQuery(conditions=search_conditions(text)))]

        assert found("tube_regions >= 1") == ["tube"]
        assert found("plate_regions > 1 and block_regions >= 1 and region_mm < 3") == ["ribs"]
        assert found("regions >= 1") == ["ribs", "tube"]
        # Numbers that no descriptor gives: both parts are 2 mm thin, the ribs at two places.
        assert found("places >= 2 and walls_mm < 2.1") == ["ribs"]
        assert found("thinnest_mm < 2.1 and places < 2") == ["older", "tube"]
    assert {"region_mm", "regions", "tube_regions"} <= set(SORTABLE)


def test_sizes_that_worked_are_offered_alike_for_equal_walls(tmp_path):
    record = made_library.measured_record("ribs", RIBS)
    listed = record["regions"]["listed"]
    equal = equal_regions(record)[0]
    assert len(equal) == 2
    listed[equal[1]]["median"] *= 1.01  # as measures scatter
    path = made_library.store(tmp_path, "ribs.step", [record])
    figures = {"elements": 5000, "poor_share": 0.001, "gamma_least": 0.2, "layers_share": 0.97, "tries": []}
    rows = [{"kind": listed[equal[0]]["kind"], "thickness": listed[equal[0]]["median"], "size": 0.5, "is_changed": True}]
    settings = {"order": 1, "error": None, "layers": 2.0, "growth": 1.3, "size": None, "budget": None}
    keep_mesh_settings(path, "Solid1", settings, 8.0, record["descriptors"]["diagonal_mm"], rows, figures)
    sizes = dict(settings_that_worked(record, [], path)["sizes"])
    assert [sizes[number] for number in equal] == [0.5, 0.5]

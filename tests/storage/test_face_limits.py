# SPDX-License-Identifier: LGPL-2.1-or-later
"""Limits of the wall for single faces: kept in info files, respected by checks, found again or said to be gone."""

import copy
import json

import made_library
import pytest
from test_regions_in_records import RIBS

from thinpart_workbench.api.annotations import limit_faces
from thinpart_workbench.core.errors import ThinPartError
from thinpart_workbench.core.judging.wall_check import check_sentence, check_walls
from thinpart_workbench.core.judging.wall_limits import WallLimits
from thinpart_workbench.core.record.record_types import PART
from thinpart_workbench.storage.index.library_index import LibraryIndex
from thinpart_workbench.storage.info.annotations import carry_annotations, set_face_limit
from thinpart_workbench.workflow.library.find_parts import PartQuery, find_parts

REASON = "crush rib, thin on purpose"


def limits(least=None, most=None):
    return WallLimits("test", "Test", least, most)


@pytest.fixture(scope="module")
def measured():
    return made_library.measured_record("ribs", RIBS)


@pytest.fixture
def ribbed(measured):
    return copy.deepcopy(measured)


@pytest.fixture
def ribs(ribbed):
    """Names of the faces of both ribs, one side of each first."""
    one, other = (region["faces"] for region in ribbed["regions"]["listed"][:2])
    return [one[0], other[0], one[1], other[1]]


def test_a_rib_of_2_mm_passes_at_3_where_its_face_may_be_thinner(ribbed, ribs):
    assert check_walls(ribbed, limits(3.0)).holds is False
    assert set_face_limit(ribbed, ribs[:1], "Anna", REASON, min_mm=1.5)
    assert PART.fault(json.loads(json.dumps(ribbed)), "part") is None
    check = check_walls(ribbed, limits(3.0))
    assert check.holds is False and check.thinnest_mm == pytest.approx(2.0), "the other rib has no limit of its own"
    set_face_limit(ribbed, ribs[1:2], "Anna", REASON, min_mm=1.5)
    check = check_walls(ribbed, limits(3.0))
    assert check.holds is True and check.thinnest_mm > 9.0, "the sides opposite have the same walls"
    assert str(check_sentence(check)).endswith(f"Within a limit of its own ({REASON}): {ribs[0]}, {ribs[1]}.")
    assert [each["passes"] for each in check.content()["face_limits"]] == [True, True]


@pytest.mark.parametrize("least, most, holds", [(1.5, None, True), (2.0, None, True), (2.5, None, False), (None, 3.0, True),
                                                (None, 1.5, False), (1.5, 2.5, True)])
def test_a_face_fails_its_own_limit(ribbed, ribs, least, most, holds):
    set_face_limit(ribbed, ribs[:1], "Anna", REASON, least, most)
    check = check_walls(ribbed, limits(1.0))
    assert check.holds is holds and check.own[0].holds is holds
    sentence = str(check_sentence(check))
    assert ("fails its own limit" in sentence) is not holds
    if not holds:
        assert sentence.partition(":")[2].startswith(f" fails: {ribs[0]} fails its own limit")
        assert sentence.endswith(" All other faces pass.") and sentence.count("limits") <= 1


def test_thick_faces_may_be_thicker(ribbed):
    thick = check_walls(ribbed, limits(None, 10.0))
    assert thick.holds is False and thick.thick_faces
    set_face_limit(ribbed, list(thick.thick_faces), "Anna", "the foot", max_mm=60.0)
    assert check_walls(ribbed, limits(None, 10.0)).holds is True


def test_the_limit_is_found_again_by_area_or_said_to_be_gone(ribbed, ribs):
    set_face_limit(ribbed, ribs[:1], "Anna", REASON, min_mm=1.5)
    again = copy.deepcopy(ribbed)
    del again["face_limits"]
    content = {"parts": [again]}
    carry_annotations(content, {"parts": [ribbed]})
    assert check_walls(again, limits(1.0)).own[0].face == ribs[0]
    for face in again["faces"]:
        if face["face"] == ribs[0]:
            face["area_mm2"] *= 1.3
    check = check_walls(again, limits(1.0))
    assert check.own[0].is_gone and check.holds is True
    assert f"Not found any more, though with a limit of its own ({REASON}): {ribs[0]}:" in str(check_sentence(check))


def test_a_face_with_another_number_is_found_where_only_one_fits(ribbed):
    areas = [round(face["area_mm2"], 3) for face in ribbed["faces"]]
    single = next(face for face in ribbed["faces"] if areas.count(round(face["area_mm2"], 3)) == 1)
    set_face_limit(ribbed, [single["face"]], "Anna", REASON, min_mm=0.5)
    single["face"] = "Face99"
    check, = check_walls(ribbed, limits(0.4)).own
    assert (check.face, check.is_gone) == ("Face99", False)


@pytest.mark.parametrize("least, most", [(None, None), (1.5, None), (2.5, None), (None, 3.0), (None, 1.5), (1.5, 3.0)])
def test_a_search_finds_what_passes_as_the_check_says(ribbed, ribs, least, most, tmp_path):
    path = made_library.store(tmp_path / "library", "ribs.step", [ribbed])
    allowed = limit_faces(path, list(check_walls(ribbed, limits(None, 10.0)).thick_faces), "the foot", max_mm=60.0)
    if least or most:
        allowed = limit_faces(path, ribs, REASON, least, most)
    processes = [limits(least=3.0), limits(least=1.0), limits(most=10.0), limits(3.0, 10.0), limits(most=2.5)]
    with LibraryIndex(tmp_path / "library", tmp_path / "cache") as index:
        index.refresh()
        for process in processes:
            holds = check_walls(allowed, process).holds
            found = [bool(list(find_parts(index, PartQuery(**{name: (process,)})))) for name in ("passes", "fails")]
            assert found == [holds is True, holds is False], process


def test_a_changed_limit_is_found_by_the_next_search(ribbed, ribs, tmp_path):
    path = made_library.store(tmp_path / "library", "ribs.step", [ribbed])
    with LibraryIndex(tmp_path / "library", tmp_path / "cache") as index:
        for faces, least, count in ((ribs, 1.5, 1), (ribs[:1], 2.5, 0), (ribs, None, 0)):
            limit_faces(path, faces, REASON, least)
            index.refresh()
            assert len(list(find_parts(index, PartQuery(passes=(limits(3.0),))))) == count


def test_it_is_kept_in_the_info_file_and_removed(ribbed, ribs, tmp_path):
    path = made_library.store(tmp_path, "ribs.step", [ribbed])
    record = limit_faces(path, ribs[:2], REASON, min_mm=1.5, person="Anna")
    assert [(each["face"], each["min_mm"], each["reason"], each["person"]) for each in record["face_limits"]] == [
        (ribs[0], 1.5, REASON, "Anna"), (ribs[1], 1.5, REASON, "Anna")]
    assert [each["face"] for each in limit_faces(path, ribs[:1])["face_limits"]] == [ribs[1]]
    assert "face_limits" not in limit_faces(path, ribs[1:2])


@pytest.mark.parametrize("faces, reason, least, most", [
    (["Face99"], REASON, 1.0, None), (["Face1"], " ", 1.0, None), (["Face1"], REASON, 3.0, 1.0),
    (["Face1"], REASON, -1.0, None), (["Face1"], REASON, float("nan"), None)])
def test_what_cannot_be_kept_is_refused(ribbed, tmp_path, faces, reason, least, most):
    path = made_library.store(tmp_path, "ribs.step", [ribbed])
    with pytest.raises(ThinPartError) as told:
        limit_faces(path, faces, reason, least, most)
    assert told.value.kind == "usage"

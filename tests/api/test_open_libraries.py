# SPDX-License-Identifier: LGPL-2.1-or-later
"""Libraries that stay open find what a search that opens them finds, also after they were refreshed."""

import json
import os
import queue

import made_library
import pytest
import time_limit

import thinpart_workbench as thinpart
from thinpart_workbench.api.found_parts import record_and_profile
from thinpart_workbench.api.libraries import Libraries
from thinpart_workbench.api.open_libraries import OpenLibraries
from thinpart_workbench.api.reclassification import reclassify_folders
from thinpart_workbench.core.judging.criteria import load_profile, profile_version


@pytest.fixture
def opened(library):
    """The library, open and refreshed; and what its thread has posted and nobody has taken."""
    posted = queue.Queue()
    libraries = OpenLibraries(posted.put)
    libraries.open([str(library)])
    refresh(libraries, posted)
    yield libraries, posted
    libraries.open([])


def refresh(libraries, posted):
    """Take over what is posted until the refresh has ended; what was told of its progress."""
    told = []

    def ended():
        told.append(posted.get(timeout=20))
        event = dict(told[-1])
        return event.pop("ask") == "refreshed" and libraries.refreshed(**event)

    time_limit.wait_until(ended, "the end of a refresh")
    return told


def names(parts):
    return [(part.info_file, part.name) for part in parts]


def test_they_find_what_a_search_finds(library, opened):
    libraries, _ = opened
    for conditions in ("", "V/VBB < 0.5"):
        expected = thinpart.find(library, where=conditions, failed=None)
        found = libraries.find(conditions)
        assert names(libraries.rows(0, 1000)) == names(expected)
        assert found.count == found.choices.count == len(expected) and found.total >= found.count
        assert sum(found.choices.categories.values()) == found.count
    with pytest.raises(thinpart.ThinPartError, match="D9"):
        libraries.find("D9 > 1")


def test_they_find_similar_parts_and_where_a_part_is(library, opened):
    libraries, _ = opened
    part = thinpart.find(library, text="Deckel")[0]
    own = os.path.realpath(part.info_file), part.name
    expected = thinpart.similar(part, library, 100)
    found = libraries.find(like=part.record(), excluding=own, sort="score")
    rows = libraries.rows(0, 100)
    assert names(rows) == names(expected) and [each.score for each in rows] == [each.score for each in expected]
    assert found.count == len(expected) < found.choices.count
    assert {libraries.root_of(each) for each in rows} == {str(library)}
    assert libraries.position_of(str(library), *names(rows)[2]) == 2
    by_size = libraries.find(like=part.record(), excluding=own, sort="d1_mm")
    sizes = [each.box_mm[0] for each in libraries.rows(0, 100)]
    assert sizes == sorted(sizes) and by_size.count == len(sizes) == len(expected)
    assert sorted(each.score for each in libraries.rows(0, 100)) == sorted(each.score for each in expected)
    assert libraries.position_of(str(library), *names(libraries.rows(0, 100))[1]) == 1
    libraries.find(like=part.record(), excluding=own, sort="score")
    assert libraries.position_of(str(library), *own) is None and libraries.position_of("gone", *own) is None


def test_a_refresh_brings_what_is_new_and_says_what_is_gone(tmp_path):
    posted, library = queue.Queue(), tmp_path / "library"
    libraries = OpenLibraries(posted.put)
    libraries.open([str(library)])
    state, = libraries.states
    assert state.busy and state.parts == 0 and str(library) in libraries
    refresh(libraries, posted)
    state, = libraries.states
    assert not state.busy and f"The folder {library}" in state.problems[0]
    made_library.store(library, "plate.step", [made_library.record_of("plate")])
    libraries.refresh()
    assert libraries.states[0].busy
    refresh(libraries, posted)
    state, = libraries.states
    assert (state.parts, state.problems, state.busy) == (1, [], False) and libraries.find().count == 1
    libraries.open([])
    assert libraries.states == [] and not libraries.refreshed(str(library), None, [], False)


def test_a_record_comes_with_the_profile_that_it_was_judged_by(library):
    part = thinpart.find(library, text="Deckel")[0]
    record, profile = record_and_profile(part.info_file, part.name)
    assert record == {key: value for key, value in part.record().items() if key not in ("file", "info_file")}
    assert profile["name"] == "paper"
    with pytest.raises(thinpart.ThinPartError, match="has no part 'Other'"):
        record_and_profile(part.info_file, "Other")


def test_libraries_are_judged_again_also_where_one_is_gone(library, tmp_path):
    run = reclassify_folders([str(library), str(tmp_path / "gone")], "paper")
    assert "gone" in run.problems[0] and len(run.problems) == 1
    files = list(run)
    parts = [part for file in files for part in file.parts]
    assert len(files) == len(run) > 0 and not any(file.differs for file in files)
    assert len(parts) == len(thinpart.find(library)) and not any(part.differs for part in parts)
    assert len(reclassify_folders([str(tmp_path)])) == 0


def test_they_say_what_another_version_of_a_shipped_profile_has_judged(library, opened):
    libraries, posted = opened
    state, = libraries.states
    assert state.judged_otherwise == []
    files = sorted(library.rglob("*.thinpart.json"))
    for number, change in enumerate(({"area_floor": 0.002}, {"borderline_margin": 0.2}, {"name": "house"})):
        content = json.loads(files[number].read_text())
        content["profile"].update(change)
        files[number].write_text(json.dumps(content))
    libraries.refresh()
    refresh(libraries, posted)
    state, = libraries.states
    assert state.judged_otherwise == [
        {"profile": "paper", "version": profile_version(load_profile("paper").content), "files": 2}]
    with Libraries([library]) as same:
        assert same.judged_otherwise() == {"paper": 2}
    list(reclassify_folders([str(library)], "paper", write=True))
    libraries.refresh()
    refresh(libraries, posted)
    state, = libraries.states
    assert state.judged_otherwise == []

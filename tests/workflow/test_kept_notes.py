# SPDX-License-Identifier: LGPL-2.1-or-later
"""What people keep with a part is theirs: nothing that the program does loses it."""

import json
import multiprocessing
import os

import made_library
import pytest

from thinpart_workbench.api.annotations import annotate_part, mesh_settings
from thinpart_workbench.core.errors import ThinPartError
from thinpart_workbench.storage.index.library_index import LibraryIndex
from thinpart_workbench.storage.info.info_file import read_info
from thinpart_workbench.storage.info.stored_records import stored_records
from thinpart_workbench.workflow.library.find_parts import PartQuery, find_parts


@pytest.fixture
def document(tmp_path):
    made_library.store(tmp_path, "part.step", [made_library.record_of("cube")])
    return tmp_path / "part.step"


def test_set_shown_found_and_removed(document, tmp_path):
    settings = mesh_settings('{"size": 2.5}')
    annotate_part(document, notes="three layers", mesh=settings, link="https://intranet/42")
    record, = stored_records(document)
    assert (record["notes"], record["mesh"], record["link"]) == (
        "three layers", {"settings": {"size": 2.5}}, "https://intranet/42")
    with LibraryIndex(tmp_path, tmp_path / "cache") as index:
        index.refresh()
        for words in ("three layers", "intranet", "size"):
            assert len(find_parts(index, PartQuery(words=words))) == 1
        assert len(find_parts(index, PartQuery(has_notes=True))) == 1
        annotate_part(document, notes="", mesh={}, link="")
        index.refresh()
        assert len(find_parts(index, PartQuery(has_notes=True))) == 0
    record, = stored_records(document)
    assert record["notes"] == "" and "mesh" not in record and "link" not in record


def test_kept_over_a_new_analysis_and_given_back_when_the_part_returns(tmp_path):
    two = [made_library.record_of("cube", name="Solid1"), made_library.record_of("plate", name="Solid2")]
    info = made_library.store(tmp_path, "part.step", two)
    annotate_part(info, "Solid1", notes="first")
    annotate_part(info, "Solid2", notes="second", mesh={"file": "/share/mesh.geo"})
    made_library.store(tmp_path, "part.step", two[:1])
    assert [each["notes"] for each in stored_records(info)] == ["first"]
    made_library.store(tmp_path, "part.step", two[:1])
    assert read_info(info)["kept_of_missing_parts"][0]["notes"] == "second"
    made_library.store(tmp_path, "part.step", two)
    assert [each["notes"] for each in stored_records(info)] == ["first", "second"]
    assert stored_records(info, "Solid2")[0]["mesh"] == {"file": "/share/mesh.geo"}
    assert "kept_of_missing_parts" not in read_info(info)


def test_which_part_is_meant(tmp_path):
    info = made_library.store(tmp_path, "part.step", [
        made_library.record_of("cube", name="Solid1", label="foot"),
        made_library.record_of("cube", name="Solid2", label="hand")])
    annotate_part(info, "hand", notes="by label")
    assert [each["notes"] for each in stored_records(info)] == ["", "by label"]
    for part in (None, "nose"):
        with pytest.raises(ThinPartError, match="Solid1, Solid2") as error:
            annotate_part(info, part, notes="whose?")
        assert error.value.kind == "usage"
    with pytest.raises(ThinPartError, match="classify other.step first"):
        annotate_part(tmp_path / "other.step", notes="x")


def test_mesh_settings_are_an_object_a_json_file_or_the_name_of_a_file(tmp_path):
    settings, field = tmp_path / "mesh.json", tmp_path / "field.geo"
    settings.write_text('{"layers": 3}')
    field.write_text("Field[1] = Distance;")
    assert mesh_settings(str(settings)) == {"settings": {"layers": 3}}
    assert mesh_settings(str(field)) == {"file": str(field)}
    assert mesh_settings(" ") == {}
    (tmp_path / "list.json").write_text("[1]")
    (tmp_path / "latin.json").write_bytes(b'{"a": "\xe9"}')
    for text in ("{broken", '{"size": NaN}', str(tmp_path / "gone.json"), str(tmp_path / "list.json"),
                 str(tmp_path / "latin.json"), '{"a":' * 100_000):
        with pytest.raises(ThinPartError):
            mesh_settings(text)


def _append(info, letter):
    for _ in range(20):
        notes = stored_records(info)[0]["link"]
        annotate_part(info, link=notes, notes=letter)


def test_notes_and_classifications_at_once_lose_nothing(document):
    annotate_part(document, notes="start", link="stays")
    info = document.with_name(document.name + ".thinpart.json")
    context = multiprocessing.get_context("fork")
    writers = [context.Process(target=_append, args=(info, letter)) for letter in "ab"]
    for each in writers:
        each.start()
    for _ in range(40):
        # A classification knows nothing of notes; what is there when it writes must survive.
        made_library.store(document.parent, "part.step", [made_library.record_of("cube")])
        assert stored_records(info)[0]["link"] == "stays"
    for each in writers:
        each.join(60)
        assert each.exitcode == 0
    assert stored_records(info)[0]["notes"] in "ab"
    json.loads(info.read_text(encoding="utf-8"))
    assert sorted(os.listdir(document.parent)) == ["part.step", info.name]

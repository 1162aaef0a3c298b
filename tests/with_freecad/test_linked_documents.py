# SPDX-License-Identifier: LGPL-2.1-or-later
"""Documents that take shapes from other documents."""

import json
import os
from pathlib import Path

import jsonschema
import pytest
from program import SCHEMA, failures, records, thinpart

from thinpart_workbench.freecad_adapter.reading.linked_files import linked_files


def save(freecad, file, *linked, size=None):
    """Save a document with links to objects, or with a box of a size, and leave it open."""
    file.parent.mkdir(parents=True, exist_ok=True)
    document = freecad.newDocument("Made")
    document.saveAs(str(file))
    if size:
        made = document.addObject("Part::Box", "Box")
        made.Length = made.Width = 100
        made.Height = size
    for target in linked:
        document.addObject("App::Link", "Link").LinkedObject = target
    document.recompute()
    document.save()
    return document


def shut(freecad):
    for name in list(freecad.listDocuments()):
        freecad.closeDocument(name)


@pytest.fixture
def assembly(tmp_path, freecad):
    """A document that links into a second, which links into a third in another folder."""
    third = save(freecad, tmp_path / "lib & co" / "bölt \"1\".FCStd", size=100)
    second = save(freecad, tmp_path / "unit.FCStd", third.Box)
    save(freecad, tmp_path / "assembly.FCStd", second.Link)
    shut(freecad)
    return tmp_path / "assembly.FCStd", tmp_path / "lib & co" / "bölt \"1\".FCStd"


def info_of(file):
    content = json.loads(Path(f"{file}.thinpart.json").read_text(encoding="utf-8"))
    jsonschema.validate(content, SCHEMA)
    return content


def category(file):
    record, = records(thinpart("classify", file, "--json"))
    return record["category"]


def test_a_change_in_a_linked_document_is_noticed(assembly, freecad):
    file, bolt = assembly
    assert category(file) == "normal"
    source = info_of(file)["source"]
    assert {each["file"] for each in source["links"]} == {"unit.FCStd", "lib & co/bölt \"1\".FCStd"}
    written = os.stat(f"{file}.thinpart.json").st_mtime_ns
    os.utime(bolt, (5, 5))  # the hash decides
    assert category(file) == "normal"
    assert os.stat(f"{file}.thinpart.json").st_mtime_ns == written
    save(freecad, bolt, size=2)
    shut(freecad)
    assert category(file) == "thin"
    assert info_of(file)["source"]["sha256"] == source["sha256"]


def test_a_missing_linked_document_is_a_failure_as_long_as_it_is_missing(tmp_path, freecad):
    gone = save(freecad, tmp_path / "gone.FCStd", size=2)
    made = save(freecad, tmp_path / "assembly.FCStd", gone.Box, size=100)
    made.Link.Label = "Plate"
    made.save()
    shut(freecad)
    file = tmp_path / "assembly.FCStd"
    (tmp_path / "gone.FCStd").rename(tmp_path / "away.FCStd")
    for _ in range(2):
        run = thinpart("classify", file, "--json")
        assert run.returncode == 1 and failures(run) == {"assembly.FCStd": "missing"}
        assert "'Plate'" in run.stderr and "gone.FCStd" in run.stderr
        assert [line["category"] for line in records(run) if "category" in line] == ["normal"]
        assert info_of(file)["source"]["links"] == [
            {"file": "gone.FCStd", "sha256": None, "bytes": None, "modified": None}]
    (tmp_path / "away.FCStd").rename(tmp_path / "gone.FCStd")
    run = thinpart("classify", file, "--json")
    assert run.returncode == 0
    assert sorted(line["category"] for line in records(run)) == ["normal", "thin"]


def test_a_link_that_lost_its_object_and_arrays_of_it(tmp_path, document):
    for name in ("Good", "Lost"):
        document.addObject("Part::Box", name)
    document.addObject("App::Link", "One").LinkedObject = document.Lost
    array = document.addObject("App::Link", "Many")
    array.LinkedObject, array.ElementCount = document.Lost, 3
    document.recompute()
    document.removeObject("Lost")
    document.recompute()
    document.saveAs(str(tmp_path / "made.FCStd"))
    run = thinpart("classify", tmp_path / "made.FCStd", "--json", "--no-info")
    kinds = {line["label"]: line.get("error", {}).get("kind") for line in records(run)}
    assert kinds == {"Good": None, "One": "missing", "Many": "missing"}


def test_documents_that_link_into_each_other_and_what_is_none(tmp_path, assembly):
    file, bolt = assembly
    assert [each.name for each in linked_files(file)] == [bolt.name, "unit.FCStd"]
    assert linked_files(bolt) == []
    (tmp_path / "bad.FCStd").write_bytes(b"PK\x03\x04 nothing")
    assert linked_files(tmp_path / "bad.FCStd") == linked_files(tmp_path / "no.step") == []

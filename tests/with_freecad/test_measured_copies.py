# SPDX-License-Identifier: LGPL-2.1-or-later
"""Copies of a document are recognised before they are measured, and what nobody measured is never taken for one."""

import json
import os
import shutil

import pytest
from folder_runs import TUBE
from program import thinpart

from thinpart_workbench.storage.info.info_file import read_info, write_info
from thinpart_workbench.storage.info.measured_copies import keep_measured


@pytest.fixture
def classified(tmp_path, monkeypatch):
    """A classified tube in a folder, with a cache of its own."""
    monkeypatch.setenv("THINPART_CACHE", str(tmp_path / "cache"))
    (tmp_path / "parts").mkdir()
    shutil.copy(TUBE, tmp_path / "parts" / "tube.step")
    return classify(tmp_path / "parts" / "tube.step")


def classify(file, *options):
    run = thinpart("classify", file, *options)
    assert run.returncode == 0, run.stderr
    return file


def content_of(file):
    return read_info(f"{file}.thinpart.json")


def is_measured(file):
    return all(part["seconds"]["tessellate"] + part["seconds"]["measure"] > 0.0 for part in content_of(file)["parts"])


def test_a_copy_is_not_measured_and_has_the_same_record(classified, tmp_path):
    assert is_measured(classified)
    write_info(f"{classified}.thinpart.json", {**content_of(classified), "parts": [
        {**part, "notes": "mine", "link": "https://example.org"} for part in content_of(classified)["parts"]]})
    copy = shutil.copy(classified, tmp_path / "parts" / "copy of it.step")
    (part,), (known,) = (content_of(each)["parts"] for each in (classify(copy), classified))
    assert not is_measured(copy) and part["notes"] == "" and "link" not in part and known["notes"] == "mine"
    own = {"label", "notes", "link", "seconds"}
    assert {key: part[key] for key in part.keys() - own} == {key: known[key] for key in known.keys() - own}
    assert content_of(copy)["source"]["file"] == "copy of it.step"


def test_a_copy_is_found_from_a_path_of_another_folder(tmp_path, monkeypatch):
    monkeypatch.setenv("THINPART_CACHE", str(tmp_path / "cache"))
    for folder in ("one", "two"):
        (tmp_path / folder).mkdir()
        monkeypatch.chdir(tmp_path / folder)
        copy = classify(shutil.copy(TUBE, "tube.step"))
    assert not is_measured(copy)


def test_a_copy_is_named_after_its_own_file(classified, tmp_path):
    mesh = tmp_path / "parts" / "one.off"
    mesh.write_text("OFF\n4 4 0\n0 0 0\n9 0 0\n0 9 0\n0 0 9\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n")
    other = shutil.copy(classify(mesh), tmp_path / "parts" / "other.off")
    assert content_of(classify(other))["parts"][0]["label"] == "other" and not is_measured(other)


@pytest.mark.parametrize("options", [("--force",), ("--profile", "paper"), ("--angular", "8")])
def test_other_settings_are_measured(classified, tmp_path, options):
    copy = shutil.copy(classified, tmp_path / "parts" / "copy.step")
    assert is_measured(classify(copy, *options))


def test_what_another_document_says_of_itself_is_no_proof(classified, tmp_path):
    other = tmp_path / "parts" / "other.step"
    other.write_bytes(TUBE.read_bytes() + b"\n")
    # A reader that was taken over names the hash of the tube as that of its own document.
    source = content_of(classified)["source"]
    kept, = (tmp_path / "cache" / "measured").rglob("*.json")
    kept.unlink()
    keep_measured(str(other), source, f"{other}.thinpart.json")
    assert not kept.exists()
    # An info file that is about another document proves nothing either.
    shutil.copy(f"{classified}.thinpart.json", f"{other}.thinpart.json")
    content = json.loads((tmp_path / "parts" / "other.step.thinpart.json").read_text())
    content["source"]["sha256"] = "0" * 64
    (tmp_path / "parts" / "other.step.thinpart.json").write_text(json.dumps(content))
    kept.write_text(json.dumps({"info_file": os.fspath(other) + ".thinpart.json"}))
    copy = shutil.copy(classified, tmp_path / "parts" / "copy.step")
    assert is_measured(classify(copy))


@pytest.mark.parametrize("content", [b"", b"[]", b'{"info_file": 7}', b'{"info_file": "gone.json"}', b'{"info_file"'])
def test_a_damaged_cache_costs_only_time(classified, tmp_path, content):
    kept, = (tmp_path / "cache" / "measured").rglob("*.json")
    kept.write_bytes(content)
    copy = shutil.copy(classified, tmp_path / "parts" / "copy.step")
    assert is_measured(classify(copy))

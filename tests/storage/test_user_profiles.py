# SPDX-License-Identifier: LGPL-2.1-or-later
"""A user's own profiles are files in a folder of settings; nothing else is overwritten."""

import json
import os
import sys

import pytest

from thinpart_workbench.core.errors import ThinPartError
from thinpart_workbench.core.judging.criteria import PROFILES, load_profile
from thinpart_workbench.storage.user_profiles import user_profiles, user_profiles_folder, write_profile

CONTENT = {**load_profile("paper").content, "name": "h\u00e4user"}


@pytest.fixture(autouse=True)
def folder(tmp_path, monkeypatch):
    monkeypatch.setenv("THINPART_PROFILES", str(tmp_path / "own" / "profiles"))
    return tmp_path / "own" / "profiles"


def test_what_is_written_is_listed_and_loads(folder):
    assert user_profiles_folder() == folder and user_profiles() == []
    write_profile(CONTENT, folder / "house.json")
    (folder / "notes.txt").write_text("mine")
    assert user_profiles() == [folder / "house.json"]
    assert load_profile(folder / "house.json").content == CONTENT
    write_profile({**CONTENT, "title": "Again"}, folder / "house.json")
    assert load_profile(folder / "house.json").title == "Again" and len(list(folder.iterdir())) == 2


def test_the_folder_of_settings_is_the_default(tmp_path, monkeypatch):
    monkeypatch.delenv("THINPART_PROFILES")
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path))
    if sys.platform == "linux":
        assert user_profiles_folder() == tmp_path / "thinpart" / "profiles"


@pytest.mark.parametrize("name", ["paper.json", "Calibrated.json", os.fspath(PROFILES / "paper.json")])
def test_a_shipped_profile_and_its_name_are_refused(folder, name):
    before = (PROFILES / "paper.json").read_bytes()
    with pytest.raises(ThinPartError, match="comes with ThinPart"):
        write_profile(CONTENT, folder / name)
    assert (PROFILES / "paper.json").read_bytes() == before and not folder.exists()


@pytest.mark.parametrize("content", [b"my letters", b"{}", json.dumps({"format": "thinpart-info"}).encode()])
def test_what_is_no_profile_is_not_overwritten(folder, content):
    folder.mkdir(parents=True)
    (folder / "letters.json").write_bytes(content)
    with pytest.raises(ThinPartError, match="is no profile and is not overwritten|is an info file"):
        write_profile(CONTENT, folder / "letters.json")
    assert (folder / "letters.json").read_bytes() == content


def test_a_place_that_cannot_be_written_is_told(tmp_path):
    (tmp_path / "file").write_text("")
    with pytest.raises(ThinPartError, match="could not be written"):
        write_profile(CONTENT, tmp_path / "file" / "house.json")

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Limits of the wall by process: the shipped table, a user's own, and what is refused."""

import json

import pytest

from thinpart_workbench.core.errors import ThinPartError
from thinpart_workbench.core.judging.wall_limits import chosen_limits, read_limits, shipped_limits
from thinpart_workbench.core.kinds.file_marks import LIMITS
from thinpart_workbench.storage.user_limits import known_limits, limits_named, user_limits_file

FDM = {"id": "FDM", "title": "Our FDM", "min_mm": 1.2, "max_mm": None}


def table(*processes, **changes):
    return {"format": LIMITS.format, "version": 1, "processes": list(processes), **changes}


def written(path, content):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(content if isinstance(content, str) else json.dumps(content), encoding="utf-8")
    return path


def test_every_process_of_the_shipped_table_has_a_source_and_sensible_limits():
    known = shipped_limits()
    assert {name for name in known if ":" not in name} == {
        "injection_molding", "die_casting", "sand_casting", "sheet_metal", "machining", "FDM", "SLA", "SLS"}
    for limits in known.values():
        assert "https://" in limits.source and 0.1 < limits.min_mm < (limits.max_mm or 1e9) and limits.title


def test_people_write_names_in_any_case_and_each_counts_once():
    known = shipped_limits()
    chosen = chosen_limits(known, ["fdm", " Die_Casting:ZINC", "", "FDM"])
    assert [each.name for each in chosen] == ["FDM", "die_casting:zinc"]
    zinc = known["die_casting:zinc"]
    assert (zinc.min_mm, zinc.max_mm) == (0.38, 13.0) and zinc.full_title == "Die casting (Zinc, small casting)"


@pytest.mark.parametrize("name, listed", [("wood", "SLS"), ("die_casting:gold", "die_casting:brass")])
def test_an_unknown_name_is_told_with_those_that_are_known(name, listed):
    with pytest.raises(ThinPartError, match=name) as told:
        chosen_limits(shipped_limits(), [name])
    assert listed in str(told.value) and told.value.kind == "usage"


def test_a_users_file_replaces_processes_and_adds_others(tmp_path, monkeypatch):
    monkeypatch.delenv("THINPART_LIMITS", raising=False)
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path))
    assert known_limits() == shipped_limits()
    written(user_limits_file(), table(FDM, {**FDM, "id": "wax", "min_mm": None, "max_mm": 30}))
    known = known_limits()
    assert known["FDM"].min_mm == 1.2 and known["wax"].max_mm == 30 and known["SLS"] == shipped_limits()["SLS"]
    other = written(tmp_path / "other.json", table({**FDM, "id": "die_casting"}))
    assert not any(name.startswith("die_casting:") for name in known_limits(other))
    assert known_limits(other)["FDM"].min_mm == 0.8


def test_no_file_is_read_for_no_name(tmp_path, monkeypatch):
    monkeypatch.setenv("THINPART_LIMITS", str(written(tmp_path / "damaged.json", "{")))
    assert limits_named([""]) == ()
    with pytest.raises(ThinPartError, match="damaged.json"):
        limits_named(["FDM"])


@pytest.mark.parametrize("content, words", [
    ("{", "cannot be read"), ([], "format is not"), (table(version=2), "version is 2"),
    (table({**FDM, "min_mm": "thin"}), r"processes\[0\].min_mm is 'thin'"),
    (table({**FDM, "min_mm": -1}), r"processes\[0\].min_mm"), (table({**FDM, "id": "a,b"}), r"processes\[0\].id"),
    (table({**FDM, "min_mm": None}), r"processes\[0\] has neither"), (table(FDM, FDM), "FDM"),
    (table({**FDM, "max_mm": 1.2}), "not below its max_mm of 1.2"),
    (table({**FDM, "materials": [{**FDM, "min_mm": None}]}), r"processes\[0\].materials\[0\] has neither"),
    (table({"id": "x", "title": "X", "min_mm": 1}), r"processes\[0\].max_mm is missing"),
])
def test_what_is_wrong_is_told_with_its_place(tmp_path, content, words):
    file = written(tmp_path / "own.json", content)
    with pytest.raises(ThinPartError, match=words) as told:
        read_limits(file)
    assert "own.json" in str(told.value) and told.value.kind == "usage"


def test_a_missing_file_says_what_to_copy(tmp_path):
    with pytest.raises(ThinPartError, match="copy .*wall_limits.json"):
        read_limits(tmp_path / "none.json")


def test_braces_in_a_title_are_text(tmp_path):
    limits = read_limits(written(tmp_path / "own.json", table({**FDM, "title": "{0} {x}"})))
    assert limits["FDM"].full_title == "{0} {x}"

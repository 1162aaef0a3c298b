# SPDX-License-Identifier: LGPL-2.1-or-later
"""What people say of parts stays with them, is found again, and thresholds are learned from it."""

import csv
import json

import made_library
import numpy as np
import pytest

import thinpart_workbench as thinpart
from thinpart_workbench.api.annotations import annotate_part, label_part
from thinpart_workbench.api.learning import export_labels
from thinpart_workbench.cli import main
from thinpart_workbench.core.errors import ThinPartError
from thinpart_workbench.storage.info.info_file import read_info
from thinpart_workbench.storage.info.stored_records import stored_records
from thinpart_workbench.storage.labels_file import read_labels
from thinpart_workbench.system.user import user_name

FILLS = [*np.linspace(0.10, 0.50, 12), *np.linspace(0.53, 0.95, 12)]
FIRST = {"format": "thinpart-profile", "version": 1, "name": "first", "categories": [
    {"name": "thin", "criteria": [{"id": 1, "conditions": [{"quantity": "V/VBB", "comparison": "<", "value": 0.3}]}]}]}
CATEGORIES = ["thin", "normal"]


@pytest.fixture(autouse=True)
def cache(monkeypatch, tmp_path):
    monkeypatch.setenv("THINPART_CACHE", str(tmp_path / "cache"))


@pytest.fixture
def document(tmp_path):
    made_library.store(tmp_path / "parts", "part.step", [made_library.record_of("cube")])
    return tmp_path / "parts" / "part.step"


@pytest.fixture
def library(tmp_path):
    """Parts in three folders, labelled by Anna as their fill says."""
    folder = tmp_path / "library"
    for number, fill in enumerate(FILLS):
        record = made_library.record_of("cube", label="part")
        record["descriptors"]["volume_mm3"] = 1000.0 * fill
        info = made_library.store(folder / f"group {number % 3}", f"p{number:02d}.step", [record])
        label_part(info, "thin" if fill < 0.52 else "normal", "Anna")
    return folder


def labels(path, part=None):
    record, = stored_records(path, part)
    return [(each["person"], each["category"], each["sure"]) for each in record.get("labels", [])]


# Keeping them

def test_answers_of_several_people_are_kept_side_by_side_and_replaced_by_their_own(document):
    label_part(document, "thin", "Anna")
    label_part(document, "normal", "Bert", False)
    assert labels(document) == [("Anna", "thin", True), ("Bert", "normal", False)]
    label_part(document, "thin_features", "Anna", False)
    assert labels(document) == [("Bert", "normal", False), ("Anna", "thin_features", False)]
    label_part(document, "", "Bert")
    assert labels(document) == [("Anna", "thin_features", False)]
    label_part(document, "", "Anna")
    assert "labels" not in stored_records(document)[0]


def test_when_it_was_said_is_kept_and_the_same_answer_is_no_new_one(document):
    label_part(document, "thin", "Anna")
    first, = stored_records(document)[0]["labels"]
    assert first["when"].endswith("+00:00") and len(first["when"]) == 25
    info = document.with_name("part.step.thinpart.json")
    before = info.read_bytes()
    label_part(document, "thin", "Anna")
    assert info.read_bytes() == before


def test_they_survive_measuring_and_judging_again_and_return_with_the_part(tmp_path):
    two = [made_library.record_of("cube", name="Solid1"), made_library.record_of("plate", name="Solid2")]
    info = made_library.store(tmp_path, "part.step", two)
    label_part(info, "thin", "Anna", part="Solid2")
    annotate_part(info, "Solid2", notes="mine")
    made_library.store(tmp_path, "part.step", two)
    assert labels(info, "Solid2") == [("Anna", "thin", True)]
    made_library.store(tmp_path, "part.step", two[:1])
    assert read_info(info)["kept_of_missing_parts"][0]["labels"][0]["person"] == "Anna"
    made_library.store(tmp_path, "part.step", two)
    list(thinpart.reclassify(tmp_path, "paper", write=True))
    assert labels(info, "Solid2") == [("Anna", "thin", True)]


def test_what_is_no_category_or_no_name_is_refused(document):
    with pytest.raises(ThinPartError, match="'slim' is no category: there are thin, thin_features, normal"):
        label_part(document, "slim", "Anna")
    with pytest.raises(ThinPartError, match="cannot be kept as a person's name"):
        label_part(document, "thin", "A" * 300)
    assert labels(document) == []


BAD = {
    "twice the same person": [{"person": "Anna", "category": category, "sure": True, "when": "2026-01-01T00:00:00Z"}
                              for category in ("thin", "normal")],
    "no time": [{"person": "Anna", "category": "thin", "sure": True, "when": "yesterday"}],
    "no person": [{"person": " ", "category": "thin", "sure": True, "when": "2026-01-01T00:00:00Z"}],
    "sure is no flag": [{"person": "Anna", "category": "thin", "sure": "yes", "when": "2026-01-01T00:00:00Z"}],
}


@pytest.mark.parametrize("case", BAD)
def test_bad_labels_of_an_info_file_are_refused_with_their_place(case, document):
    info = document.with_name("part.step.thinpart.json")
    content = json.loads(info.read_text())
    content["parts"][0]["labels"] = BAD[case]
    info.write_text(json.dumps(content))
    with pytest.raises(ThinPartError, match=r"part\.step\.thinpart\.json.*parts\[0\]\.labels"):
        read_info(info)


# Finding them

def test_they_are_found_by_category_and_by_disagreement_with_the_verdict(tmp_path, capsys):
    made_library.store(tmp_path, "a.step", [made_library.record_of("cube")])  # normal
    made_library.store(tmp_path, "b.step", [made_library.record_of("cube")])
    made_library.store(tmp_path, "c.step", [made_library.record_of("cube")])
    label_part(tmp_path / "a.step", "thin", "Anna")
    label_part(tmp_path / "b.step", "normal", "Anna")
    label_part(tmp_path / "b.step", "thin_features", "Bert", False)

    def found(**query):
        return [part.file[-6:] for part in thinpart.find(tmp_path, **query)]

    verdict = thinpart.find(tmp_path)[0].category
    assert verdict == "normal"
    assert found(labelled=True) == ["a.step", "b.step"] and found(labelled=False) == ["c.step"]
    assert found(said="thin") == ["a.step"] and found(said=("thin", "normal")) == ["a.step", "b.step"]
    assert found(disputed=True) == ["a.step", "b.step"] and found(disputed=False) == ["c.step"]
    label_part(tmp_path / "b.step", "", "Bert")
    assert found(disputed=True) == ["a.step"] and found(disputed=False) == ["b.step", "c.step"]
    part, = thinpart.find(tmp_path, said="thin")
    assert [(each["person"], each["category"]) for each in part.labels] == [("Anna", "thin")]
    assert main(["find", str(tmp_path), "--disputed"]) == 0
    assert "labelled thin (Anna)" in " ".join(capsys.readouterr().out.split())


def test_note_sets_shows_and_removes_them(document, capsys):
    assert main(["note", str(document), "--label", "thin", "--unsure"]) == 0
    assert f"{user_name()}: thin, not sure" in capsys.readouterr().out
    assert main(["note", str(document), "--label", "normal", "--person", "Eva", "--json"]) == 0
    assert {each["person"] for each in json.loads(capsys.readouterr().out)["labels"]} == {user_name(), "Eva"}
    assert main(["note", str(document), "--label", ""]) == 0
    assert labels(document) == [("Eva", "normal", True)]
    assert main(["note", str(document), "--unsure"]) == 2
    assert "--unsure and --person go with --label" in capsys.readouterr().err


# Learning from them

def test_thresholds_are_learned_from_kept_labels(library):
    pytest.importorskip("sklearn")
    learned = thinpart.learn(library, profile=FIRST)
    assert learned.people == ("Anna",) and learned.counts == {"thin": 12, "normal": 12} and learned.folds == 3
    assert [(each.before, each.after) for each in learned.changes] == [("V/VBB < 0.3", "V/VBB < 0.52")]


def written(path, rows):
    with path.open("w", newline="") as file:
        csv.writer(file).writerows([("file", "category", "person", "second"), *rows])
    return path


def test_kept_labels_and_tables_are_merged_and_either_can_be_left_out(library, tmp_path):
    pytest.importorskip("sklearn")
    bert = written(tmp_path / "bert.csv", [("p00.step", "normal", "Bert", ""), ("p01.step", "thin", "Bert", "")])
    learned = thinpart.learn(library, bert, FIRST)
    assert learned.people == ("Anna", "Bert")
    assert learned.disagreement.pairs.count == 1 and learned.disagreement.pairs.total == 2
    assert learned.disagreement.parts == (
        {"file": "group 0/p00.step", "part": "Solid1", "answers": {"Anna": "thin", "Bert": "normal"}},)
    with pytest.raises(ThinPartError, match="No part is|too few"):
        thinpart.learn(library, bert, FIRST, kept_labels=False)


def test_the_same_answer_in_a_table_is_taken_once_and_another_one_is_refused(library, tmp_path):
    pytest.importorskip("sklearn")
    same = written(tmp_path / "same.csv", [("p00.step", "thin", "Anna", "normal")])
    assert thinpart.learn(library, same, FIRST).people == ("Anna",)
    other = written(tmp_path / "other.csv", [("p00.step", "normal", "Anna", "")])
    with pytest.raises(ThinPartError, match=r"p00\.step\.thinpart\.json, part Solid1: Anna calls this part thin here and "
                                            r"normal before \(other\.csv, line 2\)"):
        thinpart.learn(library, other, FIRST)


def test_a_label_of_no_category_of_the_start_is_refused_with_its_place(library):
    pytest.importorskip("sklearn")
    label_part(library / "group 0" / "p00.step", "thin_features", "Bert")
    with pytest.raises(ThinPartError, match=r"group 0.p00\.step\.thinpart\.json, part Solid1: Bert calls it "
                                            "'thin_features', which is no category of the start: there are thin, normal"):
        thinpart.learn(library, profile=FIRST)


def test_a_library_without_labels_is_one_sentence(document):
    pytest.importorskip("sklearn")
    with pytest.raises(ThinPartError, match="There are no labels in .*parts: label parts in the window"):
        thinpart.learn(document.parent)


def test_progress_is_reported(library):
    pytest.importorskip("sklearn")
    reported = []
    thinpart.learn(library, profile=FIRST, report=lambda *step: reported.append(step))
    assert ("read", 24, 24) in reported
    assert [step for step in reported if step[0] == "learn"] == [("learn", done, 4) for done in range(4)]


# Writing them as a table

def test_all_labels_are_written_as_a_table_that_is_read_again(library, tmp_path):
    table, again = tmp_path / "all.csv", tmp_path / "again.csv"
    label_part(library / "group 0" / "p00.step", "normal", "=Bert", False)
    assert export_labels(library, table, profile=FIRST) == 25
    rows = [row for row in read_labels(table, CATEGORIES) if row.file.endswith("p00.step")]
    assert [(row.file, row.part, row.category, row.person, row.is_sure) for row in rows] == [
        ("group 0/p00.step", "Solid1", "thin", "Anna", True), ("group 0/p00.step", "Solid1", "normal", "=Bert", False)]
    assert "'=Bert" in table.read_text(), "no spreadsheet evaluates a name"
    assert export_labels(library, again, table, FIRST, kept_labels=False) == 25
    assert again.read_bytes() == table.read_bytes()


def test_the_command_line_writes_the_table_and_overwrites_nothing_else(library, tmp_path, capsys):
    (tmp_path / "first.json").write_text(json.dumps(FIRST))
    command = ["learn", str(library), "--profile", str(tmp_path / "first.json"), "--export-labels"]
    assert main([*command, str(tmp_path / "all.csv")]) == 0
    assert "24 labels were written to" in " ".join(capsys.readouterr().out.split())
    assert main([*command, str(tmp_path / "all.csv")]) == 0, "its own table is written anew"
    (tmp_path / "thesis.csv").write_text("mine")
    assert main([*command, str(tmp_path / "thesis.csv")]) == 2
    assert "was not written by ThinPart" in capsys.readouterr().err and (tmp_path / "thesis.csv").read_text() == "mine"
    assert main([*command, str(tmp_path / "x.csv"), "-o", str(tmp_path / "y.json")]) == 2
    assert not (tmp_path / "x.csv").exists()


def test_a_table_of_parts_has_their_labels(library):
    part, = thinpart.find(library, text="p00.step")
    assert part.stored.said == ",thin," and json.loads(part.stored.labels)[0]["person"] == "Anna"

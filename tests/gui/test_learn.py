# SPDX-License-Identifier: LGPL-2.1-or-later
"""Thresholds learned in the window, from labels of people."""

import csv
import json

import FreeCAD as App
import pytest
import window_actions as window
from made_library import record_of, store

from thinpart_workbench.api.annotations import label_part
from thinpart_workbench.core.judging.criteria import load_profile
from thinpart_workbench.freecad_adapter.preferences import preference, set_preference, set_preference_list
from thinpart_workbench.gui.application.qt import QtWidgets

FILLS = [0.10 + 0.026 * number for number in range(16)] + [0.53 + 0.026 * number for number in range(16)]
"""Fills of the box: those below 0.52 are labelled thin."""

FIRST = {"format": "thinpart-profile", "version": 1, "name": "first", "title": "First", "categories": [
    {"name": "thin", "criteria": [{"id": 1, "conditions": [{"quantity": "V/VBB", "comparison": "<", "value": 0.3}]}]}]}


@pytest.fixture(autouse=True)
def preferences(monkeypatch, tmp_path):
    monkeypatch.setenv("THINPART_CACHE", str(tmp_path / "cache"))
    yield
    set_preference_list("Libraries", [])
    set_preference("Profile", None)


@pytest.fixture
def library(tmp_path):
    """Parts in four folders, by their fill, each labelled by Anna in its info file."""
    folder = tmp_path / "library"
    for number, fill in enumerate(FILLS):
        record = record_of("cube", label="part")
        record["descriptors"]["volume_mm3"] = 1000.0 * fill
        info = store(folder / f"group {number % 4}", f"p{number:02d}.step", [record])
        content = json.loads(info.read_text())
        content["profile"]["categories"] = FIRST["categories"]
        info.write_text(json.dumps(content))
        label_part(info, "thin" if fill < 0.52 else "normal", "Anna")
    set_preference_list("Libraries", [str(folder)])
    return folder


@pytest.fixture
def first(tmp_path):
    path = tmp_path / "first.json"
    path.write_text(json.dumps(FIRST))
    set_preference("Profile", str(path))
    return path


def opened():
    window.press("ThinPart_LearnThresholds")
    window.wait_until(lambda: window.is_shown("ThinPart_LearnDialog"))
    return window.widget("ThinPart_LearnDialog")


def message():
    return window.text("ThinPart_LearnMessage")


def learn():
    window.click("ThinPart_LearnStart")
    assert window.is_shown("ThinPart_LearnProgress")
    wait_for_end()


def wait_for_end():
    window.wait_until(lambda: window.widget("ThinPart_LearnStart").isEnabled())


def cells(name):
    model = window.widget(name).model()
    return [[model.index(row, column).data() for column in range(model.columnCount())] for row in range(model.rowCount())]


def test_the_command_has_a_button_and_needs_no_document():
    button = window.tool_button("ThinPart_LearnThresholds")
    assert button.toolTip() and not button.icon().isNull()
    assert not opened().isModal() and not App.listDocuments()


def test_thresholds_are_learned_from_kept_labels_shown_saved_and_used(library, first, tmp_path):
    pytest.importorskip("sklearn")
    dialog = opened()
    assert window.widget("ThinPart_LearnFolder").currentText() == str(library)
    assert not window.widget("ThinPart_LearnSave").isEnabled()
    learn()
    assert message() == "" and not window.is_shown("ThinPart_LearnProgress")
    summary = window.text("ThinPart_LearnSummary")
    assert "agrees with" in summary and "first does with 24 of 32" in summary
    assert cells("ThinPart_LearnBefore") == [["thin", "8 \u2713", "8", "0"], ["normal", "0", "16 \u2713", "0"]]
    assert cells("ThinPart_LearnChanges") == [["thin", "1", "V/VBB < 0.3", "V/VBB < 0.52"]]
    assert "32 labelled parts: thin 16, normal 16; by Anna." in window.widget("ThinPart_LearnPeople").text()
    dialog.save_as(str(tmp_path / "house.json"))
    wait_for_end()
    assert str(tmp_path / "house.json") in message()
    content = load_profile(tmp_path / "house.json").content
    assert (content["name"], content["title"]) == ("house", "house")
    window.click("ThinPart_LearnUse")
    assert preference("Profile") == str(tmp_path / "house.json") and "From now on" in message()


def test_using_it_asks_for_a_file_first(library, first, tmp_path):
    pytest.importorskip("sklearn")
    opened()
    learn()
    window.answer("ThinPart_LearnSaveDialog", lambda box: (
        box.findChild(QtWidgets.QLineEdit).setText(str(tmp_path / "mine.json")), box.accept()))
    window.click("ThinPart_LearnUse")
    window.wait_until(lambda: preference("Profile") == str(tmp_path / "mine.json"))
    assert (tmp_path / "mine.json").is_file()


def test_tables_of_labels_are_taken_too_and_disagreement_is_shown(library, first, tmp_path):
    pytest.importorskip("sklearn")
    with (tmp_path / "bert.csv").open("w", newline="") as file:
        csv.writer(file).writerows([("file", "category", "person"), ("p00.step", "normal", "Bert"),
                                    ("p01.step", "thin", "Bert")])
    dialog = opened()
    dialog.findChild(QtWidgets.QWidget, "ThinPart_LearnFiles").parent().add_label_file(str(tmp_path / "bert.csv"))
    learn()
    people = window.widget("ThinPart_LearnPeople").text()
    assert "by Anna, Bert" in people and "differ in 1 of 2" in people
    assert cells("ThinPart_LearnDifferent") == [["group 0/p00.step", "Solid1", "Anna: thin, Bert: normal"]]


def test_what_cannot_be_learned_from_is_one_sentence(library, first, tmp_path):
    pytest.importorskip("sklearn")
    dialog = opened()
    form = dialog.findChild(QtWidgets.QWidget, "ThinPart_LearnFiles").parent()
    (tmp_path / "few.csv").write_text("file,category\np00.step,slim\n")
    form.add_label_file(str(tmp_path / "few.csv"))
    learn()
    assert "few.csv, line 2: 'slim' is no category" in message() and not window.is_shown("ThinPart_LearnSummary")
    (tmp_path / "few.csv").write_text("file,category\np00.step,thin\n")
    window.widget("ThinPart_LearnKept").setChecked(False)
    learn()
    assert "No part is labelled normal: label at least 10 parts of every category." in message()
    window.widget("ThinPart_LearnFolder").setCurrentText("")
    window.click("ThinPart_LearnStart")
    assert "Choose the folder" in message()


def test_it_never_overwrites_what_is_no_profile(library, first, tmp_path):
    pytest.importorskip("sklearn")
    dialog = opened()
    learn()
    (tmp_path / "thesis.json").write_text("mine")
    dialog.save_as(str(tmp_path / "thesis.json"))
    wait_for_end()
    assert "is no profile and is not overwritten" in message() and (tmp_path / "thesis.json").read_text() == "mine"
    dialog.save_as(str(tmp_path / "paper.json"))
    wait_for_end()
    assert "name of a profile that comes with ThinPart" in message()


def test_it_can_be_cancelled_and_begun_again(library, first):
    pytest.importorskip("sklearn")
    opened()
    window.click("ThinPart_LearnStart")
    window.click("ThinPart_LearnCancel")
    assert message() == "Cancelled. Nothing was written." and window.widget("ThinPart_LearnStart").isEnabled()
    learn()
    assert window.is_shown("ThinPart_LearnSummary")

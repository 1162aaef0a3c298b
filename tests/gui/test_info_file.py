# SPDX-License-Identifier: LGPL-2.1-or-later
"""The info file beside the document."""

import fcntl
import json
import os

import FreeCAD as App
import FreeCADGui as Gui
import Part
import pytest
import window_actions as window

from thinpart_workbench.core.judging.criteria import load_profile
from thinpart_workbench.freecad_adapter.preferences import set_preference
from thinpart_workbench.gui.application.qt import QtWidgets
from thinpart_workbench.storage.info.info_file import read_info, source_is_unchanged
from thinpart_workbench.storage.info.info_location import info_location


@pytest.fixture
def saved(document, tmp_path):
    """A saved document with two parts, the second of them selected."""
    window.add_ribbed_block(document)
    window.add(document, "Plate", Part.makeBox(100, 100, 2))
    document.saveAs(str(tmp_path / "parts.FCStd"))
    Gui.runCommand("Std_Save")
    Gui.Selection.addSelection(document.Name, "Plate")
    return tmp_path / "parts.FCStd"


def info(file):
    return file.with_name(file.name + ".thinpart.json")


def test_it_describes_the_whole_document(saved):
    window.classify()
    assert info(saved).name in window.text("ThinPart_InfoText")
    assert window.widget("ThinPart_InfoText").toolTip() == str(info(saved))
    content = read_info(info(saved))
    assert [part["name"] for part in content["parts"]] == ["Ribbed", "Plate"]
    assert [part["category"] for part in content["parts"]] == ["thin_features", "thin"]
    assert content["profile"] == load_profile("paper").content
    assert source_is_unchanged(content["source"], saved)
    assert window.text("ThinPart_PartLabel") == "Plate"


def test_it_names_what_is_broken_beside_the_good_parts(saved):
    document = App.ActiveDocument
    window.add(document, "Cover", Part.makeShell(Part.makeBox(9, 9, 9).Faces[:5]))
    document.save()
    Gui.runCommand("Std_Save")
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(document.Name, "Plate")
    window.classify()
    content = read_info(info(saved))
    assert [part["name"] for part in content["parts"]] == ["Ribbed", "Plate"]
    failure, = content["failures"]
    assert (failure["label"], failure["kind"]) == ("Cover", "no_solid")


def test_notes_are_kept(saved):
    window.classify()
    content = json.loads(info(saved).read_text())
    content["parts"][0]["notes"] = "meshed with 3 layers"
    info(saved).write_text(json.dumps(content))
    window.classify()
    assert read_info(info(saved))["parts"][0]["notes"] == "meshed with 3 layers"


def test_colours_do_not_count_as_a_change(saved):
    window.classify()
    info(saved).unlink()
    window.classify()
    assert info(saved).is_file()


def test_an_opened_document_counts_as_saved(saved):
    name = App.ActiveDocument.Name
    App.closeDocument(name)
    document = App.openDocument(str(saved))
    Gui.Selection.addSelection(document.Name, "Plate")
    window.classify()
    assert info(saved).is_file()


def test_unsaved_changes_save_and_write(saved):
    document = App.ActiveDocument
    document.getObject("Plate").Label = "Lid"
    window.classify()
    assert "not saved" in window.text("ThinPart_InfoText")
    assert not info(saved).exists()
    window.click("ThinPart_SaveButton")
    window.wait_until_measured()
    content = read_info(info(saved))
    assert content["parts"][1]["label"] == "Lid"
    assert source_is_unchanged(content["source"], saved)
    assert "Info file" in window.text("ThinPart_InfoText")
    assert not window.is_shown("ThinPart_SaveButton")


def test_a_document_never_saved_asks_where(document, tmp_path):
    window.add_ribbed_block(document)
    window.classify()
    assert "not saved" in window.text("ThinPart_InfoText")

    def name_it(dialog):
        edit = dialog.findChild(QtWidgets.QLineEdit)
        edit.setText(str(tmp_path / "new.FCStd"))
        dialog.accept()

    window.answer("", name_it)
    window.click("ThinPart_SaveButton")
    window.wait_until(lambda: info(tmp_path / "new.FCStd").is_file())
    assert [part["name"] for part in read_info(info(tmp_path / "new.FCStd"))["parts"]] == ["Ribbed"]


def test_declining_to_save_changes_nothing(document):
    window.add_ribbed_block(document)
    window.classify()
    window.answer("", lambda dialog: dialog.reject())
    window.click("ThinPart_SaveButton")
    window.settle(200)
    assert not document.FileName and "not saved" in window.text("ThinPart_InfoText")


def test_a_document_changed_meanwhile_is_not_described_by_old_records(saved):
    document = App.ActiveDocument
    document.getObject("Plate").Label = "Lid"
    window.classify()
    document.getObject("Plate").Shape = Part.makeBox(100, 100, 50)
    window.click("ThinPart_SaveButton")
    window.settle(100)
    assert "has changed since" in window.text("ThinPart_InfoText")
    assert not info(saved).exists()
    window.click("ThinPart_AgainButton")
    window.wait_until_measured()
    assert [part["category"] for part in read_info(info(saved))["parts"]] == [
        "thin_features", "normal"]


def test_what_is_no_info_file_is_left_alone_and_said(saved):
    info(saved).write_text("mine")
    window.classify()
    assert window.text("ThinPart_InfoText").startswith("No info file")
    assert info(saved).read_text() == "mine"


def test_a_place_that_cannot_be_written_is_said(saved):
    info(saved).mkdir()
    window.classify()
    assert window.text("ThinPart_InfoText").startswith("No info file")
    assert window.text("ThinPart_Headline") == "Thin part"


@pytest.fixture
def store(tmp_path):
    """A folder for info files that the preferences name."""
    set_preference("InfoFolder", str(tmp_path / "store"))
    yield tmp_path / "store"
    set_preference("InfoFolder", None)


def test_a_folder_for_info_files_that_is_gone_is_said(saved, store):
    window.classify()
    assert "cannot be reached" in window.text("ThinPart_InfoText") and not store.exists()
    assert window.text("ThinPart_Headline") == "Thin part" and not info(saved).exists()


def test_a_slow_folder_holds_nobody_up(saved, store):
    place = info_location(str(saved), str(store))
    place.parent.mkdir(parents=True)
    handle = os.open(place.parent, os.O_RDONLY)
    fcntl.flock(handle, fcntl.LOCK_EX)  # as if another computer were writing there
    window.press("ThinPart_Classify")
    window.wait_until(lambda: window.text("ThinPart_InfoText").startswith("Writing"))
    window.settle(1000)
    assert window.text("ThinPart_InfoText").startswith("Writing") and not place.exists()
    os.close(handle)
    window.wait_until_measured()
    assert "in the preferred folder" in window.text("ThinPart_InfoText") and place.exists()

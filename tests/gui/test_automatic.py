# SPDX-License-Identifier: LGPL-2.1-or-later
"""Documents that are classified in the background when they are saved."""

import fcntl
import os

import FreeCAD as App
import FreeCADGui as Gui
import Part
import pytest
import window_actions as window

from thinpart_workbench.api.classification import classify
from thinpart_workbench.freecad_adapter.preferences import set_preference, set_preference_list
from thinpart_workbench.gui.application import lifelong
from thinpart_workbench.gui.application.qt import QtWidgets
from thinpart_workbench.storage.info.info_file import change_info, read_info, source_is_unchanged
from thinpart_workbench.storage.info.info_location import info_location

CHANGED = ("AutomaticClassification", "WarnOfCategory", "WarnWallUnder", "InfoFolder", "Seconds", "KnownPartsOnSave")


@pytest.fixture(autouse=True)
def switched_on():
    """The preference is set, as the page sets it."""
    set_preference("AutomaticClassification", True)
    window.settle(50)
    yield
    for name in CHANGED:
        set_preference(name, None)
    window.settle(50)


def label():
    return window.text("ThinPart_StatusVerdict")


def reason():
    return window.widget("ThinPart_StatusVerdict").toolTip()


def notice():
    return "\n".join(window.notices())


def status():
    return Gui.getMainWindow().statusBar().currentMessage()


def report():
    window.settle(50)  # FreeCAD writes it when it has nothing else to do
    # Qt 5 keeps the no-break spaces of a text, Qt 6 does not.
    texts = Gui.getMainWindow().findChildren(QtWidgets.QTextEdit)
    return "\n".join(each.toPlainText().replace("\u00a0", " ") for each in texts if each.objectName() == "Report view")


def info(file):
    return file.with_name(file.name + ".thinpart.json")


def wait():
    """Until nothing is being classified any more."""
    window.settle(50)
    window.wait_until(lambda: not lifelong.auto_classifier.is_busy)


def save(document, file=None):
    if file is None:
        document.save()
    else:
        document.saveAs(str(file))
    wait()


def reshape(document, height):
    document.getObject("Plate").Shape = Part.makeBox(100, 100, height)
    document.recompute()


@pytest.fixture
def plate(document, tmp_path):
    """A saved document with a plate 2 mm thick, classified once."""
    window.add(document, "Plate", Part.makeBox(100, 100, 2))
    save(document, tmp_path / "plate.FCStd")
    return tmp_path / "plate.FCStd"


def test_saving_returns_while_the_part_is_being_measured(document, tmp_path):
    file = tmp_path / "sieve.FCStd"
    feature = window.add(document, "Sieve", window.slow_shape())
    before = feature.ViewObject.DiffuseColor
    other = App.newDocument("Other")
    Gui.Selection.addSelection(document.Name, "Sieve", "Face1")
    set_preference("AutomaticClassification", False)
    document.saveAs(str(file))
    set_preference("AutomaticClassification", True)
    App.setActiveDocument(document.Name)
    window.settle(20)
    Gui.runCommand("Std_Save")
    saved = file.stat().st_mtime_ns
    assert not info(file).exists(), "save has returned before anything was measured"
    window.wait_until(window.workers)
    window.settle(20)
    assert lifelong.auto_classifier.is_busy and "measuring" in label() and not info(file).exists()
    App.setActiveDocument(other.Name)
    wait()
    content = read_info(info(file))
    assert [part["name"] for part in content["parts"]] == ["Sieve"]
    assert source_is_unchanged(content["source"], file)
    assert "sieve.FCStd" in status() and file.stat().st_mtime_ns == saved
    # The document was not touched, nor was what the user is at.
    assert not Gui.getDocument(document.Name).Modified and feature.ViewObject.DiffuseColor == before
    assert App.ActiveDocument is other and not Gui.Control.activeDialog()
    assert [each.SubElementNames for each in Gui.Selection.getSelectionEx(document.Name)] == [("Face1",)]
    assert "Colour thin faces" not in document.UndoNames


def test_the_label_has_the_verdict_of_the_active_document_and_its_reason(document, plate):
    assert label() == "ThinPart: Thin part"
    assert "Plate: Thin part. Why: plate (rule 1), " in reason()
    assert "Thin part" in status() and "plate.FCStd" in status()
    other = App.newDocument("Other")
    window.settle(50)
    assert label() == "ThinPart: \u2013"
    App.setActiveDocument(document.Name)
    window.settle(50)
    assert label() == "ThinPart: Thin part"
    App.closeDocument(other.Name)
    window.settle(50)
    set_preference("AutomaticClassification", False)
    window.settle(50)
    assert not window.is_shown("ThinPart_StatusVerdict")
    reshape(document, 90)
    save(document)
    assert read_info(info(plate))["parts"][0]["category"] == "thin", "it is switched off"


def test_several_parts(document, tmp_path):
    window.add(document, "Plate", Part.makeBox(100, 100, 2))
    window.add(document, "Sheet", Part.makeBox(100, 80, 2))
    window.add(document, "Cube", Part.makeBox(10, 10, 10))
    window.add(document, "Cover", Part.makeShell(Part.makeBox(9, 9, 9).Faces[:5]))
    save(document, tmp_path / "several.FCStd")
    assert label().replace("\u00a0", " ") == "ThinPart: 2 \u00d7 Thin part, 1 \u00d7 Normal part"
    assert reason().count(": Thin part. ") == 2 and "Cube: Normal part. " in reason()
    assert "several.FCStd: 'Cover'" in report()
    assert not window.is_shown("ThinPart_Notice")


def test_the_label_opens_the_panel(document, plate):
    window.click("ThinPart_StatusVerdict")
    window.wait_until_measured()
    assert window.text("ThinPart_Headline") == "Thin part"
    window.mouse_click(window.close_button())
    App.closeDocument(document.Name)
    window.settle(50)
    window.click("ThinPart_StatusVerdict")
    assert "open a document" in status()


def test_a_changed_category_is_warned_of_once(document, plate):
    assert notice() == "" and "was 'Thin part'" not in report(), "the first time there is nothing to compare"
    reshape(document, 90)
    save(document)
    sentence = "plate.FCStd: 'Plate' was 'Thin part' and is 'Normal part' now; its thinnest wall is 90\u00a0mm."
    assert label() == "ThinPart: Normal part"
    assert notice().startswith(sentence) and sentence.replace("\u00a0", " ") in report()
    assert QtWidgets.QApplication.activeModalWidget() is None
    window.settle(300)
    assert notice().startswith(sentence), "it stays"
    window.dismiss_notices()
    document.getObject("Plate").Label = "Block"
    save(document)
    assert notice() == "", "nothing has changed since"
    set_preference("WarnOfCategory", False)
    reshape(document, 2)
    save(document)
    assert label() == "ThinPart: Thin part" and notice() == ""


def test_a_wall_under_the_limit_is_warned_of(document, plate):
    set_preference("WarnWallUnder", 1.5)
    set_preference("WarnOfCategory", False)
    reshape(document, 1.5)
    save(document)
    assert notice() == "", "a wall of just that thickness is not under it"
    reshape(document, 1.25)
    save(document)
    assert notice().startswith(
        "plate.FCStd: 'Plate' (Thin part) has a wall of 1.25\u00a0mm, below the limit of 1.5\u00a0mm.")
    window.dismiss_notices()
    reshape(document, 1)
    save(document)
    assert notice() == "", "it was under the limit before"
    reshape(document, 90)
    save(document)
    set_preference("WarnOfCategory", True)
    reshape(document, 1)
    save(document)
    assert ("'Plate' was 'Normal part' and is 'Thin part' now; its thinnest wall of 1\u00a0mm is below the limit "
            "of 1.5\u00a0mm.") in notice()


def test_a_new_part_under_the_limit_is_warned_of(document, tmp_path):
    set_preference("WarnWallUnder", 3.0)
    window.add(document, "Plate", Part.makeBox(100, 100, 2))
    save(document, tmp_path / "new.FCStd")
    assert "has a wall of 2\u00a0mm, below the limit of 3\u00a0mm" in notice()


def test_documents_without_a_part_say_nothing(document, tmp_path):
    before = report()
    save(document, tmp_path / "empty.FCStd")
    window.add(document, "Wire", Part.makeLine((0, 0, 0), (9, 0, 0)))
    Gui.getMainWindow().statusBar().clearMessage()
    save(document)
    assert label() == "ThinPart: \u2013" and "no closed solid" in reason()
    assert report() == before and status() == "" and not list(tmp_path.glob("*.json"))


def test_closing_the_document_ends_it(document, tmp_path):
    file = tmp_path / "sieve.FCStd"
    window.add(document, "Sieve", window.slow_shape())
    document.saveAs(str(file))
    window.wait_until(window.workers)
    App.closeDocument(document.Name)
    window.settle(50)
    assert not lifelong.auto_classifier.is_busy
    window.wait_until(lambda: not window.workers())
    assert not info(file).exists() and label() == "ThinPart: \u2013"


def test_saved_twice_quickly_only_the_last_one_counts(document, tmp_path):
    file = tmp_path / "sieve.FCStd"
    feature = window.add(document, "Sieve", window.slow_shape())
    document.saveAs(str(file))
    window.wait_until(window.workers)
    first = set(window.workers())
    feature.Shape = Part.makeBox(10, 10, 10)
    document.save()
    wait()
    window.wait_until(lambda: not first & set(window.workers()))
    content = read_info(info(file))
    assert [part["category"] for part in content["parts"]] == ["normal"]
    assert source_is_unchanged(content["source"], file) and label() == "ThinPart: Normal part"


def test_many_documents_are_classified_one_after_the_other(tmp_path):
    shapes = [window.slow_shape(), Part.makeBox(10, 10, 10), Part.makeBox(10, 10, 11)]
    documents = [App.newDocument(f"Part{number}") for number in range(3)]
    for number, (document, shape) in enumerate(zip(documents, shapes)):
        window.add(document, "Part", shape)
        document.saveAs(str(tmp_path / f"part{number}.FCStd"))
    window.settle(100)
    # One that was looking something up may still be ending.
    window.wait_until(lambda: len(window.workers()) == 1)
    assert lifelong.auto_classifier.is_busy and not list(tmp_path.glob("*.json"))
    App.closeDocument(documents[1].Name)
    wait()
    assert {each.name[:5] for each in tmp_path.glob("*.json")} == {"part0", "part2"}


def test_a_copy_does_not_count(document, plate, tmp_path):
    written = info(plate).stat().st_mtime_ns
    document.saveCopy(str(tmp_path / "copy.FCStd"))
    wait()
    assert not info(tmp_path / "copy.FCStd").exists() and info(plate).stat().st_mtime_ns == written


def test_what_is_known_of_an_opened_document_is_shown_and_not_measured(document, plate):
    App.closeDocument(document.Name)
    written = info(plate).stat().st_mtime_ns
    again = App.openDocument(str(plate))
    window.wait_until(lambda: label() == "ThinPart: Thin part")
    # Told that it was saved, though its file is the same: nothing is measured.
    lifelong.observer.slotFinishSaveDocument(again, again.FileName)
    wait()
    assert info(plate).stat().st_mtime_ns == written and label() == "ThinPart: Thin part"
    assert "plate.FCStd" in status()
    App.closeDocument(again.Name)
    info(plate).unlink()
    App.openDocument(str(plate))
    window.wait_until(lambda: label() == "ThinPart: not classified")
    assert not info(plate).exists()


@pytest.mark.default_profile
def test_what_an_earlier_version_measured_and_is_not_enough_is_said_once(document, plate):
    def as_of_an_earlier_version(content):
        content["software"]["version"] = "0.0.1"
        for part in content["parts"]:
            part["descriptors"]["precision"] = None
            for key in ("local", "plate_ratio"):
                del part["descriptors"][key]
        return True

    change_info(str(info(plate)), as_of_an_earlier_version)
    sentence = ("plate.FCStd: an earlier version of ThinPart has measured this document, but not all that decides today: "
                "classify it again.")

    def opened():
        App.closeDocument(App.ActiveDocument.Name)
        window.settle(50)
        again = App.openDocument(str(plate))
        window.wait_until(lambda: label() == "ThinPart: not classified")
        return again

    set_preference("AutomaticClassification", False)
    App.closeDocument(document.Name)
    again = App.openDocument(str(plate))
    window.settle(1000)
    assert notice() == "", "it is switched off"
    set_preference("AutomaticClassification", True)
    window.wait_until(lambda: label() == "ThinPart: not classified")
    assert notice().startswith(sentence) and sentence in report() and sentence in reason()
    assert QtWidgets.QApplication.activeModalWidget() is None
    window.dismiss_notices()
    again = opened()
    assert notice() == "" and sentence in reason(), "it was said"
    lifelong.observer.slotFinishSaveDocument(again, again.FileName)
    wait()
    assert label() == "ThinPart: Thin part" and "plate_ratio" in read_info(info(plate))["parts"][0]["descriptors"]


def test_a_place_that_cannot_be_written_is_one_sentence(document, tmp_path):
    window.add(document, "Plate", Part.makeBox(100, 100, 2))
    info(tmp_path / "plate.FCStd").mkdir()
    save(document, tmp_path / "plate.FCStd")
    assert "plate.FCStd: The info file" in report()
    assert label() == "ThinPart: Thin part" and not window.is_shown("ThinPart_Notice")
    assert QtWidgets.QApplication.activeModalWidget() is None


def test_a_folder_that_is_gone_is_one_sentence_and_one_that_is_there_is_used(document, tmp_path):
    store = tmp_path / "store"
    set_preference("InfoFolder", str(store))
    window.add(document, "Plate", Part.makeBox(100, 100, 2))
    save(document, tmp_path / "plate.FCStd")
    assert "cannot be reached" in report() and not store.exists()
    assert label() == "ThinPart: Thin part"
    store.mkdir()
    save(document)
    assert read_info(info_location(document.FileName, str(store)))["parts"]
    assert not info(tmp_path / "plate.FCStd").exists()


def test_a_slow_folder_holds_nobody_up(document, plate, tmp_path):
    store = tmp_path / "store"
    place = info_location(document.FileName, str(store))
    place.parent.mkdir(parents=True)
    set_preference("InfoFolder", str(store))
    handle = os.open(place.parent, os.O_RDONLY)
    fcntl.flock(handle, fcntl.LOCK_EX)  # as if another computer were writing there
    document.save()
    window.wait_until(window.workers)
    window.settle(3000)
    assert lifelong.auto_classifier.is_busy and not place.exists(), "it waits, and the window does not"
    os.close(handle)
    wait()
    assert place.exists() and label() == "ThinPart: Thin part"


def test_the_time_limit_is_told(document, tmp_path):
    set_preference("Seconds", 1)
    window.add(document, "Sieve", window.slow_shape())
    save(document, tmp_path / "sieve.FCStd")
    assert "ThinPart: sieve.FCStd took longer than 1 s" in report() and label() == "ThinPart: failed"
    assert "longer than 1 s" in reason()


def test_a_part_that_the_panel_measures_is_not_measured_twice(document, plate):
    reshape(document, 90)
    save(document)
    window.dismiss_notices()
    document.getObject("Plate").Shape = window.slow_shape()
    document.recompute()
    document.save()
    window.wait_until(window.workers)
    automatic, = window.workers()
    window.press("ThinPart_Classify")
    window.wait_until(lambda: automatic not in window.workers())
    document.save()  # while it is being measured, as it is
    window.settle(100)
    assert len(window.workers()) == 1 and not lifelong.auto_classifier.is_busy and "measuring" in label()
    window.wait_until_measured()
    content = read_info(info(plate))
    assert content["parts"][0]["triangles"] > 1000 and source_is_unchanged(content["source"], plate)
    assert label() != "ThinPart: measuring\u2026"
    assert "was 'Normal part' and is 'Thin part'" in notice(), "the panel's result is compared too"
    document.getObject("Plate").Label = "Sieve"
    document.save()  # now the panel shows what was
    window.wait_until(window.workers)
    wait()
    assert read_info(info(plate))["parts"][0]["label"] == "Sieve"


def test_what_the_panel_has_measured_is_kept_when_the_document_is_saved(document, tmp_path):
    window.add_ribbed_block(document)
    window.classify()
    assert "not saved" in window.text("ThinPart_InfoText")
    window.wait_until(lambda: window.workers() == [])  # the one that has measured takes a moment to end
    document.saveAs(str(tmp_path / "ribbed.FCStd"))
    window.settle(100)
    assert window.workers() == []
    window.wait_until(info(tmp_path / "ribbed.FCStd").exists)
    window.wait_until_measured()
    assert "Info file" in window.text("ThinPart_InfoText")
    assert label() == "ThinPart: Part with thin features"


@pytest.mark.parametrize("how", ["cancel", "close"])
def test_what_the_panel_leaves_is_taken_over(document, tmp_path, how):
    file = tmp_path / "sieve.FCStd"
    window.add(document, "Sieve", window.slow_shape())
    document.saveAs(str(file))
    window.wait_until(window.workers)
    window.press("ThinPart_Classify")
    window.wait_until(lambda: window.is_shown("ThinPart_CancelButton"))
    assert not lifelong.auto_classifier.is_busy
    if how == "cancel":
        window.click("ThinPart_CancelButton")
    else:
        window.mouse_click(window.close_button())
    wait()
    assert info(file).exists() and "measuring" not in label()


def test_what_was_saved_is_classified_also_where_the_panel_measures_something_newer(document, tmp_path):
    file = tmp_path / "sieve.FCStd"
    feature = window.add(document, "Sieve", window.slow_shape())
    document.saveAs(str(file))
    window.wait_until(window.workers)
    feature.Shape = Part.makeBox(10, 10, 10)
    window.classify()
    assert window.text("ThinPart_Headline") == "Normal part"
    assert "not saved" in window.text("ThinPart_InfoText")
    wait()
    assert read_info(info(file))["parts"][0]["category"] == "thin"
    assert window.text("ThinPart_Headline") == "Normal part" and label() == "ThinPart: Thin part"


def test_switching_it_off_ends_what_is_under_way(document, tmp_path):
    window.add(document, "Sieve", window.slow_shape())
    document.saveAs(str(tmp_path / "sieve.FCStd"))
    window.wait_until(window.workers)
    set_preference("AutomaticClassification", False)
    window.wait_until(lambda: not window.workers())
    assert not lifelong.auto_classifier.is_busy and not info(tmp_path / "sieve.FCStd").exists()


@pytest.fixture
def library(tmp_path, monkeypatch):
    """A library with a plate that is 100 mm long."""
    monkeypatch.setenv("THINPART_CACHE", str(tmp_path / "cache"))
    folder = tmp_path / "library"
    folder.mkdir()
    Part.makeBox(100, 90, 2).cut(Part.makeCylinder(6, 9, App.Vector(30, 20, -2))).exportStep(str(folder / "sieve.step"))
    classify(folder / "sieve.step", write_info=True)
    set_preference_list("Libraries", [str(folder)])
    yield folder
    set_preference_list("Libraries", [])


def test_what_libraries_have_already_is_said_on_save_where_that_is_wanted(document, library, tmp_path):
    plate = window.add(document, "Plate", Part.makeBox(100, 90, 2).cut(
        Part.makeCylinder(6, 9, App.Vector(30, 20, -2))))
    save(document, tmp_path / "mine.FCStd")
    window.settle(500)
    assert "sieve.step" not in notice()
    set_preference("KnownPartsOnSave", True)
    plate.Placement.Base.x = 7
    document.recompute()
    save(document)
    window.wait_until(lambda: "mine.FCStd: Your libraries have this part: sieve.step." in notice())
    plate.Placement.Base.x = 9
    document.recompute()
    save(document)
    window.settle(1500)
    assert notice().count("sieve.step") == 1

"""A whole folder from the window: choosing, running, the table, and everything that can go wrong."""

import csv

import os
import shutil
import signal
import sys
from pathlib import Path

import FreeCAD as App
import FreeCADGui as Gui
import pytest
import window_actions as window

from thinpart_workbench.freecad_adapter.settings import GROUP
from thinpart_workbench.gui import classify_folder, folder_run
from thinpart_workbench.gui.folder_settings import FORMATS
from thinpart_workbench.gui.qt import QtCore, QtGui, QtWidgets
from thinpart_workbench.gui.result_table import (
    BOX, CATEGORY, CRITERIA, FILE, INSTANCES, PART, RATIO, THINNEST,
)
from thinpart_workbench.storage.info_file import read_info
from thinpart_workbench.storage.part_table import PartRow
from thinpart_workbench.workflow.find_documents import ENDINGS

MANY = 8
CANCELLED = "cancelled: what was done is kept, Start does the rest"


@pytest.fixture(autouse=True)
def no_choices():
    """Nothing is known of earlier choices, before and after."""
    _forget_choices()
    yield
    _forget_choices()


def _forget_choices():
    group = App.ParamGet(GROUP)
    for kind, name, _ in group.GetContents() or ():
        if name.startswith("Folder"):
            {"String": group.RemString, "Integer": group.RemInt}[kind](name)


@pytest.fixture
def dialog():
    """The dialog, opened as a user does."""
    window.press("ThinPart_ClassifyFolder")
    window.wait_until(lambda: window.is_shown("ThinPart_FolderDialog"), 10)
    return window.widget("ThinPart_FolderDialog")


@pytest.fixture
def folder(tmp_path):
    """Three documents with five parts, and a damaged file."""
    parts = tmp_path / "parts"
    (parts / "inner").mkdir(parents=True)
    for name, place in (("block.FCStd", "block.FCStd"), ("plate.step", "inner/plate.step"),
                        ("assembly_of_three.FCStd", "assembly.FCStd")):
        shutil.copyfile(window.SAMPLES / name, parts / place)
    (parts / "damaged.step").write_text("ISO-10303-21;\nthis is no STEP file\n")
    return parts


@pytest.fixture
def many(tmp_path):
    """So many documents that some are left when the first is done."""
    parts = tmp_path / "many"
    parts.mkdir()
    for number in range(MANY):
        shutil.copyfile(window.SAMPLES / "flange.FCStd", parts / f"flange{number:02}.FCStd")
    return parts


def choose(folder, **choices):
    """Fill the form."""
    window.widget("ThinPart_Folder").setCurrentText(str(folder))
    window.widget("ThinPart_FolderJobs").setValue(choices.pop("jobs", 2))
    for name, text in choices.items():
        window.widget(f"ThinPart_Folder{name}").setText(text)


def start(folder, **choices):
    choose(folder, **choices)
    window.click("ThinPart_FolderStart")


def message():
    return window.text("ThinPart_FolderMessage")


def progress():
    return window.text("ThinPart_FolderProgress")


def wait_for_end():
    window.wait_until(lambda: window.widget("ThinPart_FolderStart").isEnabled(), 120)


def run(folder, **choices):
    start(folder, **choices)
    wait_for_end()


def model():
    return window.widget("ThinPart_FolderTable").model()


def column(number):
    return [model().index(row, number).data() for row in range(model().rowCount())]


def count_of(category):
    """The count beside a category's check box."""
    return int(window.widget(f"ThinPart_Show_{category}").text().rpartition("(")[2].rstrip(")"))


def sort_by(number, order=QtCore.Qt.AscendingOrder):
    window.widget("ThinPart_FolderTable").sortByColumn(number, order)


def select(part):
    row = column(PART).index(part)
    view = window.widget("ThinPart_FolderTable")
    view.selectRow(row)
    return view.model().index(row, FILE)


def press_key(target, key):
    for kind in (QtCore.QEvent.KeyPress, QtCore.QEvent.KeyRelease):
        QtWidgets.QApplication.sendEvent(target, QtGui.QKeyEvent(kind, key, QtCore.Qt.NoModifier))


def info_files(folder):
    return sorted(folder.rglob("*.thinpart.json"))


def press_answer(name):
    return lambda box: window.mouse_click(next(
        each for each in box.buttons() if each.objectName() == f"ThinPart_Folder{name}"))


def test_the_command_opens_one_dialog_and_brings_it_back(dialog):
    assert not dialog.isModal()
    press_key(dialog, QtCore.Qt.Key_Escape)
    assert not dialog.isVisible()
    window.press("ThinPart_ClassifyFolder")
    assert dialog.isVisible()
    named = [each for each in QtWidgets.QApplication.allWidgets()
             if each.objectName() == "ThinPart_FolderDialog"]
    assert named == [dialog]


def test_the_formats_are_all_that_can_be_taken_from_a_folder():
    assert sorted(sum(FORMATS.values(), ())) == sorted(ENDINGS)


def test_a_folder_becomes_rows_counts_and_info_files(dialog, folder):
    run(folder)
    assert message() == ""
    assert progress().startswith("4 of 4 files, 1 failed, in ")
    assert sorted(column(FILE)) == ["assembly.FCStd"] * 3 + ["block.FCStd", "damaged.step",
                                                            str(Path("inner", "plate.step"))]
    index = select("Cover plate")
    cells = [index.siblingAtColumn(number).data() for number in range(model().columnCount())]
    assert cells[CATEGORY] == "Thin part" and cells[CRITERIA] == "1, 4, 5"
    assert cells[BOX] == "100 \u00d7 70 \u00d7 5" and cells[THINNEST] == "5"
    assert cells[RATIO] == "0.965" and cells[INSTANCES] == "1"
    red = index.siblingAtColumn(CATEGORY).data(QtCore.Qt.DecorationRole)
    assert (red.redF(), red.greenF()) == pytest.approx((0.84, 0.15), abs=0.01)
    counts = {name: count_of(name) for name in ("thin", "thin_features", "normal", "unknown", "failed")}
    assert counts == {"thin": 2, "thin_features": 1, "normal": 2, "unknown": 0, "failed": 1}
    assert [each.name for each in info_files(folder)] == [
        "assembly.FCStd.thinpart.json", "block.FCStd.thinpart.json", "plate.step.thinpart.json"]
    assert window.widget("ThinPart_FolderRetry").isEnabled()


def test_a_failure_is_red_and_says_what_happened(dialog, folder):
    run(folder)
    index = model().index(column(FILE).index("damaged.step"), CATEGORY)
    assert "Failed: " in index.data()
    assert index.data(QtCore.Qt.ForegroundRole).color().redF() > 0.7
    assert "damaged.step" in index.data(QtCore.Qt.ToolTipRole)
    window.click("ThinPart_OnlyFailures")
    assert column(FILE) == ["damaged.step"]


def test_sorting_is_by_number_and_absent_ones_come_last(dialog, folder):
    run(folder)
    chosen = select("Dowel pin")
    sort_by(THINNEST)
    rising = [float(each) for each in column(THINNEST) if each]
    assert rising == sorted(rising) and len(set(rising)) > 2
    assert rising != sorted(rising, key=str), "sorting texts would do as well"
    assert column(FILE)[-1] == "damaged.step"
    sort_by(THINNEST, QtCore.Qt.DescendingOrder)
    assert [float(each) for each in column(THINNEST) if each] == rising[::-1]
    assert column(FILE)[-1] == "damaged.step"
    selected, = window.widget("ThinPart_FolderTable").selectionModel().selectedRows()
    assert selected.siblingAtColumn(PART).data() == "Dowel pin" and chosen.isValid()


def test_filter_and_check_boxes_hide_rows_and_leave_the_counts(dialog, folder):
    run(folder)
    window.widget("ThinPart_FolderFilter").setText("ASSEMBLY plate")
    window.wait_until(lambda: model().rowCount() == 1, 10)
    assert column(PART) == ["Cover plate"]
    window.widget("ThinPart_FolderFilter").clear()
    window.wait_until(lambda: model().rowCount() == 6, 10)
    window.click("ThinPart_Show_thin")
    assert "Thin part" not in column(CATEGORY) and model().rowCount() == 4
    assert count_of("thin") == 2


def test_formats_and_patterns_choose_the_files(dialog, folder):
    window.click("ThinPart_FolderFormatSTEP")
    run(folder, Exclude="block")
    assert set(column(FILE)) == {"assembly.FCStd"}
    window.click("ThinPart_FolderFormatSTEP")
    run(folder, Include="*plate*; block*", Exclude="inner/*")
    assert set(column(FILE)) == {"block.FCStd"}


def test_a_name_that_is_no_text_is_a_row_like_others(dialog, tmp_path):
    strange = os.fsdecode(b"pl\xe4tte.step")
    (tmp_path / strange).write_text("ISO-10303-21;\nthis is no STEP file\n")
    run(tmp_path)
    assert model().rowCount() == 1 and count_of("failed") == 1
    window.widget("ThinPart_FolderTable").selectRow(0)
    window.click("ThinPart_FolderOpen")
    assert "cannot open" in message()
    shutil.copyfile(window.SAMPLES / "plate.step", tmp_path / strange)
    window.click("ThinPart_FolderRetry")
    wait_for_end()
    assert column(CATEGORY) == ["Thin part"]


def test_info_files_go_into_another_folder(dialog, folder, tmp_path):
    window.click("ThinPart_FolderInfoInFolder")
    run(folder, InfoFolder=str(tmp_path / "info"))
    assert info_files(folder) == []
    places = [str(each.relative_to(tmp_path / "info")) for each in info_files(tmp_path / "info")]
    assert str(Path("inner", "plate.step.thinpart.json")) in places and len(places) == 3


def test_what_has_not_changed_is_not_measured_again_unless_asked(dialog, folder):
    run(folder)
    run(folder)
    assert "3 unchanged" in progress()
    window.click("ThinPart_FolderForce")
    run(folder)
    assert "unchanged" not in progress()


def test_choices_are_kept(dialog, folder):
    window.click("ThinPart_FolderFormatMesh")
    window.widget("ThinPart_FolderSeconds").setValue(77)
    run(folder, Exclude="*.step")
    classify_folder.end_folder_dialog()
    window.settle()
    window.press("ThinPart_ClassifyFolder")
    assert window.widget("ThinPart_Folder").currentText() == str(folder)
    assert not window.widget("ThinPart_FolderFormatMesh").isChecked()
    assert window.widget("ThinPart_FolderSeconds").value() == 77
    assert window.widget("ThinPart_FolderExclude").text() == "*.step"


def test_pausing_and_going_on(dialog, many):
    start(many, jobs=1)
    window.wait_until(lambda: model().rowCount() > 0)
    window.click("ThinPart_FolderPause")
    window.wait_until(lambda: progress().endswith(", paused"))
    waiting = model().rowCount()
    window.settle(3000)
    # The one file that was at work may have ended meanwhile, and no other.
    assert waiting <= model().rowCount() <= waiting + 1 < MANY
    assert progress().endswith(", paused")
    window.click("ThinPart_FolderPause")
    wait_for_end()
    assert model().rowCount() == MANY and progress().startswith(f"{MANY} of {MANY} files")


def test_cancelling_keeps_what_was_done_and_a_second_run_does_the_rest(dialog, many):
    start(many, jobs=1)
    window.wait_until(lambda: model().rowCount() > 0)
    window.click("ThinPart_FolderCancel")
    wait_for_end()
    assert progress().endswith(CANCELLED) and message() == ""
    done = len(info_files(many))
    assert 0 < done < MANY and window.workers() == []
    for file in info_files(many):
        read_info(file)
    run(many)
    assert f"{MANY} of {MANY} files, {done} unchanged" in progress()


def test_failed_files_are_tried_again_alone(dialog, folder):
    run(folder)
    shutil.copyfile(window.SAMPLES / "plate.step", folder / "damaged.step")
    window.click("ThinPart_FolderRetry")
    wait_for_end()
    assert progress().startswith("1 of 1 files") and count_of("failed") == 0
    assert len(column(FILE)) == 6 and "damaged.step" in column(FILE)
    assert not window.widget("ThinPart_FolderRetry").isEnabled()


def test_the_time_limit_can_be_raised_for_those_that_failed(dialog, tmp_path):
    endless = tmp_path / "tube.step"
    os.mkfifo(endless)
    window.widget("ThinPart_FolderSeconds").setValue(1)
    run(tmp_path)
    assert count_of("failed") == 1
    endless.unlink()
    shutil.copyfile(window.SAMPLES / "tube.step", endless)
    window.widget("ThinPart_FolderSeconds").setValue(300)
    window.click("ThinPart_FolderRetry")
    wait_for_end()
    assert count_of("failed") == 0 and model().rowCount() == 1


def _export_as(name, act=lambda dialog: None):
    def choose_name(dialog):
        dialog.findChild(QtWidgets.QLineEdit).setText(str(name))
        act(dialog)
        dialog.accept()

    window.answer("ThinPart_FolderExportDialog", choose_name)
    window.click("ThinPart_FolderExport")
    window.wait_until(lambda: message() != "")


def test_the_rows_that_are_shown_are_exported(dialog, folder, tmp_path):
    run(folder)
    sort_by(FILE)
    window.click("ThinPart_Show_normal")
    _export_as(tmp_path / "table")
    assert "4 rows" in message()
    with open(tmp_path / "table.csv", newline="", encoding="utf-8") as file:
        rows = [PartRow(**each) for each in csv.DictReader(file)]
    assert [row.file for row in rows] == column(FILE)
    assert [row.category for row in rows] == ["thin_features", "thin", "", "thin"]
    assert rows[2].error_kind and "damaged.step" in rows[2].error


def test_a_part_is_not_overwritten_by_a_table(dialog, folder):
    run(folder)
    before = (folder / "block.FCStd").read_bytes()
    _export_as(folder / "block.FCStd", lambda box: window.answer("", lambda sure: sure.button(
        QtWidgets.QMessageBox.Yes).click()))
    assert "ends with .csv" in message()
    assert (folder / "block.FCStd").read_bytes() == before


def test_opening_a_part_selects_it_in_its_document(dialog, folder):
    run(folder)
    select("Block")
    window.click("ThinPart_FolderOpen")
    assert App.ActiveDocument.FileName == str(folder / "block.FCStd")
    assert [each.Label for each in Gui.Selection.getSelection()] == ["Block"]
    select("Cover plate")
    window.widget("ThinPart_FolderTable").setFocus()
    press_key(window.widget("ThinPart_FolderTable"), QtCore.Qt.Key_Return)
    assert App.ActiveDocument.FileName == str(folder / "assembly.FCStd")
    assert not dialog.is_running, "Enter in the table must not start anew"


def test_a_step_file_is_imported_once(dialog, folder):
    run(folder)
    select(next(each for each in column(PART) if each.casefold() == "plate"))
    window.click("ThinPart_FolderOpen")
    assert len(App.ActiveDocument.Objects) > 0
    assert round(App.ActiveDocument.Objects[0].Shape.BoundBox.DiagonalLength) == 200
    window.click("ThinPart_FolderOpen")
    assert len(App.listDocuments()) == 1


def test_what_cannot_be_opened_is_said(dialog, folder):
    run(folder)
    (folder / "block.FCStd").unlink()
    select("Block")
    window.click("ThinPart_FolderOpen")
    assert "There is no file" in message() and not App.listDocuments()


def test_the_info_files_folder_is_shown_or_named(dialog, folder):
    run(folder)
    view = window.widget("ThinPart_FolderTable")
    view.selectRow(column(FILE).index("damaged.step"))
    window.click("ThinPart_FolderShowInfo")
    assert "has no info file" in message()


@pytest.mark.parametrize("answer, running", [("GoOn", True), ("Stop", False)])
def test_closing_while_it_runs_asks(dialog, many, answer, running):
    start(many, jobs=1)
    window.wait_until(lambda: model().rowCount() > 0)
    window.answer("ThinPart_FolderQuestion", press_answer("Stay"))
    press_key(dialog, QtCore.Qt.Key_Escape)
    assert dialog.isVisible() and dialog.is_running
    window.answer("ThinPart_FolderQuestion", press_answer(answer))
    window.click("ThinPart_FolderClose")
    assert not dialog.isVisible()
    window.wait_until(lambda: not dialog.is_running)
    assert (len(info_files(many)) == MANY) == running
    ended = Gui.getMainWindow().statusBar().currentMessage()
    assert (f"{MANY} of {MANY} files" in ended) == running
    window.press("ThinPart_ClassifyFolder")
    assert dialog.isVisible() and model().rowCount() == len(info_files(many))


def test_a_process_that_is_killed_is_told_and_nothing_is_lost(dialog, many):
    start(many, jobs=1)
    window.wait_until(lambda: model().rowCount() > 0)
    process, = window.workers()
    os.kill(process, signal.SIGKILL)
    wait_for_end()
    assert "ended unexpectedly" in message()
    done = len(info_files(many))
    assert 0 < done < MANY
    run(many)
    assert message() == "" and progress().startswith(f"{MANY} of {MANY} files")


def test_a_process_that_cannot_start_is_told(dialog, folder, monkeypatch, tmp_path):
    monkeypatch.setattr(folder_run, "python_program", lambda: str(tmp_path / "no_python"))
    run(folder)
    assert "could not be started" in message()


@pytest.mark.parametrize("name, sentence", [
    ("", "Choose the folder"), ("missing", "There is no folder"), ("empty", "no parts"),
])
def test_folders_that_cannot_be_classified_are_told(dialog, tmp_path, name, sentence):
    (tmp_path / "empty").mkdir()
    run(str(tmp_path / name) if name else "")
    assert sentence in message() and name in message()
    assert model().rowCount() == 0


def test_an_info_folder_that_cannot_be_written_is_told(dialog, folder, tmp_path):
    (tmp_path / "occupied").write_text("a file, no folder")
    window.click("ThinPart_FolderInfoInFolder")
    run(folder, InfoFolder=str(tmp_path / "occupied" / "info"))
    assert "Info files cannot be written" in message()
    run(folder, InfoFolder="")
    assert message() == "\u26a0 Choose the folder for the info files."


def test_no_format_and_a_damaged_profile_are_told(dialog, folder, tmp_path):
    (tmp_path / "mine.json").write_text("{}")
    dialog._form._profile.choose(str(tmp_path / "mine.json"))
    run(folder)
    assert "is not a ThinPart profile" in message()
    for name in FORMATS:
        window.click(f"ThinPart_FolderFormat{name}")
    run(folder)
    assert message() == "\u26a0 Choose at least one format."


def test_the_enter_key_starts(dialog, folder):
    choose(folder)
    window.widget("ThinPart_Folder").setFocus()
    press_key(window.widget("ThinPart_Folder"), QtCore.Qt.Key_Return)
    assert dialog.is_running
    wait_for_end()
    assert model().rowCount() == 6
    window.widget("ThinPart_FolderFilter").setFocus()
    press_key(window.widget("ThinPart_FolderFilter"), QtCore.Qt.Key_Return)
    assert not dialog.is_running


BURST = 2000


def test_thousands_of_lines_at_once_do_not_stop_the_window(dialog, folder, tmp_path, monkeypatch):
    """A stand-in prints real records faster than any folder could be classified."""
    run(folder)
    record = read_info(folder / "block.FCStd.thinpart.json")["parts"][0]
    record["warnings"] = ["x" * 20000]
    program = tmp_path / "stand_in"
    program.write_text(f"#!{sys.prefix}/bin/python3\n" + f'''
import json, sys
rest = json.dumps({record!r})[1:]
total = {BURST}
progress = {{"done": total, "total": total, "failed": 0, "reused": 0, "seconds": 1.0,
            "seconds_left": None, "file": None}}
print(json.dumps({{"progress": dict(progress, done=0)}}), file=sys.stderr, flush=True)
for number in range(total):
    print('{{"file": "{folder}/part%d.step", ' % number + rest)
sys.stdout.flush()
print(json.dumps({{"progress": progress}}), file=sys.stderr, flush=True)
''')
    program.chmod(0o755)
    monkeypatch.setattr(folder_run, "python_program", lambda: str(program))
    sort_by(FILE)
    seen = set()
    timer = QtCore.QTimer(interval=5)
    timer.timeout.connect(lambda: seen.add(model().rowCount()))
    timer.start()
    run(folder)
    timer.stop()
    window.settle(700)
    assert model().rowCount() == BURST and message() == ""
    assert column(FILE) == sorted(column(FILE))
    # However slow the machine is, the window had its turn again and again while rows came in.
    assert len(seen) > 10
    steps = sorted(seen)
    assert max(after - before for before, after in zip(steps, steps[1:])) < BURST / 4

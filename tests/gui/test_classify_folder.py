# SPDX-License-Identifier: LGPL-2.1-or-later
"""A whole folder from the window: choosing, running, and the table."""

import os
import shutil
from pathlib import Path

import pytest
import window_actions as window
from folder_dialog_use import (  # noqa: F401 - fixtures among them
    BOX,
    CANCELLED,
    CATEGORY,
    CRITERIA,
    FILE,
    INSTANCES,
    MANY,
    PART,
    RATIO,
    THINNEST,
    column,
    count_of,
    dialog,
    folder,
    info_files,
    many,
    message,
    model,
    no_choices,
    press_key,
    progress,
    run,
    select,
    sort_by,
    start,
    wait_for_end,
)
from slow_files import make_endless

from thinpart_workbench.freecad_adapter.preferences import preference_list, set_preference_list
from thinpart_workbench.gui.application.qt import QtCore, QtWidgets
from thinpart_workbench.gui.widgets.single_dialog import end_single_dialog
from thinpart_workbench.storage.info.info_file import read_info


def test_the_command_opens_one_dialog_and_brings_it_back(dialog):
    assert not dialog.isModal()
    press_key(dialog, QtCore.Qt.Key_Escape)
    assert not dialog.isVisible()
    window.press("ThinPart_ClassifyFolder")
    assert dialog.isVisible()
    named = [each for each in QtWidgets.QApplication.allWidgets()
             if each.objectName() == "ThinPart_FolderDialog"]
    assert named == [dialog]


def test_a_folder_becomes_rows_counts_and_info_files(dialog, folder):
    run(folder)
    assert message() == ""
    assert progress().startswith("4 of 4 files, 1 failed, in ")
    assert sorted(column(FILE)) == ["assembly.FCStd"] * 3 + ["block.FCStd", "damaged.step",
                                                            str(Path("inner", "plate.step"))]
    index = select("Cover plate")
    cells = [index.siblingAtColumn(number).data() for number in range(model().columnCount())]
    assert cells[CATEGORY] == "Thin part" and cells[CRITERIA].split(", ") == [
        "Plate", "Thin walls over most of its surface", "Very thin wall on a filled part"]
    assert cells[BOX] == "100 \u00d7 70 \u00d7 5" and cells[THINNEST] == "5"
    assert cells[RATIO] == "0.965" and cells[INSTANCES] == "1"
    red = index.siblingAtColumn(CATEGORY).data(QtCore.Qt.DecorationRole).toImage().pixelColor(5, 5)
    assert (red.redF(), red.greenF()) == pytest.approx((0.84, 0.15), abs=0.01)
    counts = {name: count_of(name) for name in ("thin", "thin_features", "normal", "unknown", "failed")}
    assert counts == {"thin": 2, "thin_features": 1, "normal": 2, "unknown": 0, "failed": 1}
    assert [each.name for each in info_files(folder)] == [
        "assembly.FCStd.thinpart.json", "block.FCStd.thinpart.json", "plate.step.thinpart.json"]
    assert window.widget("ThinPart_FolderRetry").isEnabled()


def test_the_run_is_in_the_status_bar_and_the_folder_is_searched_in_find_parts(dialog, folder):
    set_preference_list("Libraries", [])
    start(folder)
    window.wait_until(lambda: window.is_shown("ThinPart_RunningJobs"))
    dialog.hide()
    window.click("ThinPart_RunningJobs")
    assert dialog.isVisible()
    wait_for_end()
    assert not window.is_shown("ThinPart_RunningJobs")
    window.click("ThinPart_FolderAddLibrary")
    assert preference_list("Libraries") == [str(folder)]
    assert not window.is_shown("ThinPart_FolderAddLibrary") and not dialog.isVisible()
    window.wait_until(lambda: window.text("ThinPart_FindStatus").startswith("5 of 5"))
    set_preference_list("Libraries", [])


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
    rising = [float(each.split()[0]) for each in column(THINNEST) if each]
    assert rising == sorted(rising) and len(set(rising)) > 2
    assert rising != sorted(rising, key=str), "sorting texts would do as well"
    assert column(FILE)[-1] == "damaged.step"
    sort_by(THINNEST, QtCore.Qt.DescendingOrder)
    assert [float(each.split()[0]) for each in column(THINNEST) if each] == rising[::-1]
    assert column(FILE)[-1] == "damaged.step"
    selected, = window.widget("ThinPart_FolderTable").selectionModel().selectedRows()
    assert selected.siblingAtColumn(PART).data() == "Dowel pin" and chosen.isValid()


def test_filter_and_check_boxes_hide_rows_and_leave_the_counts(dialog, folder):
    run(folder)
    window.widget("ThinPart_FolderFilter").setText("ASSEMBLY plate")
    window.wait_until(lambda: model().rowCount() == 1)
    assert column(PART) == ["Cover plate"]
    window.widget("ThinPart_FolderFilter").clear()
    window.wait_until(lambda: model().rowCount() == 6)
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
    end_single_dialog("FolderDialog")
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
    make_endless(endless)
    window.widget("ThinPart_FolderSeconds").setValue(1)
    run(tmp_path)
    assert count_of("failed") == 1
    endless.unlink()
    shutil.copyfile(window.SAMPLES / "tube.step", endless)
    window.widget("ThinPart_FolderSeconds").setValue(300)
    window.click("ThinPart_FolderRetry")
    wait_for_end()
    assert count_of("failed") == 0 and model().rowCount() == 1

# SPDX-License-Identifier: LGPL-2.1-or-later
"""A whole folder from the window: what is done with the results, and everything that can go wrong."""

import csv
import os
import signal
import sys

import FreeCAD as App
import FreeCADGui as Gui
import pytest
import window_actions as window
from folder_dialog_use import (  # noqa: F401 - fixtures among them
    FILE,
    MANY,
    PART,
    choose,
    column,
    dialog,
    folder,
    info_files,
    many,
    message,
    model,
    no_choices,
    press_answer,
    press_key,
    progress,
    run,
    select,
    sort_by,
    start,
    wait_for_end,
)

from thinpart_workbench.core.file_formats import CHOICES
from thinpart_workbench.gui.application.qt import QtCore, QtGui, QtWidgets
from thinpart_workbench.gui.processes import child_process
from thinpart_workbench.gui.record.thumbnails import Thumbnails
from thinpart_workbench.storage.info.info_file import read_info
from thinpart_workbench.storage.part_table import PartRow


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
    assert "no longer exists" in message() and not App.listDocuments()


def test_the_info_files_folder_is_shown_or_named(dialog, folder):
    run(folder)
    view = window.widget("ThinPart_FolderTable")
    view.selectRow(column(FILE).index("damaged.step"))
    window.click("ThinPart_FolderShowInfo")
    window.wait_until(lambda: "has no info file" in message())


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
    monkeypatch.setattr(child_process, "python_program", lambda: str(tmp_path / "no_python"))
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
    window.widget("ThinPart_FolderProfile").choose(str(tmp_path / "mine.json"))
    run(folder)
    assert "is not a ThinPart profile" in message()
    for name in CHOICES:
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


def picture_of(row):
    """What stands before the name of a part: QImage."""
    return model().index(row, PART).data(QtCore.Qt.DecorationRole).toImage()


def drawn(row):
    """The file of its picture, as large as it is shown: QImage."""
    pictures, file = model().pictures, QtGui.QPixmap(model().row_at(row).thumbnail)
    assert not file.isNull()
    return file.scaled(pictures.size * pictures.ratio, QtCore.Qt.KeepAspectRatio, QtCore.Qt.SmoothTransformation).toImage()


def test_parts_are_seen_where_they_are_labelled(dialog, folder):
    start(folder)
    view = window.widget("ThinPart_FolderTable")
    height = view.verticalHeader().defaultSectionSize()
    wait_for_end()
    parts = [row for row in range(model().rowCount()) if not model().row_at(row).error_kind]
    before = [view.columnWidth(number) for number in range(model().columnCount())], picture_of(0).size()
    window.wait_until(lambda: all(picture_of(row) == drawn(row) for row in parts))
    assert len(parts) == 5 and before == (
        [view.columnWidth(number) for number in range(model().columnCount())], picture_of(0).size())
    assert view.verticalHeader().defaultSectionSize() == height == view.rowHeight(0)
    failed = column(FILE).index("damaged.step")
    assert not picture_of(failed).isNull() and picture_of(failed) not in [picture_of(row) for row in parts]
    select("Cover plate")
    next(action for action in window.widget("ThinPart_FolderLabel").menu().actions()
         if action.objectName() == "ThinPart_Label_normal").trigger()
    row = column(PART).index("Cover plate")
    window.wait_until(lambda: model().row_at(row).said)
    assert picture_of(row) == drawn(row)  # the row is another one, with the label


def test_of_very_many_parts_only_pictures_of_seen_ones_are_loaded(dialog, folder, tmp_path, monkeypatch):
    run(folder)
    window.settle(100)
    part = next(row for row in model().all_rows if not row.error_kind)
    asked, picture = set(), Thumbnails.picture

    def noted(self, part):
        asked.add(getattr(part, "thumbnail", None))
        return picture(self, part)

    monkeypatch.setattr(Thumbnails, "picture", noted)
    rows = []
    for number in range(10_000):
        row = part._replace(file=f"{number}.step")
        row.thumbnail = str(tmp_path / f"{number}.png")
        rows.append(row)
    model().add(rows)
    view = window.widget("ThinPart_FolderTable")
    view.scrollToBottom()
    window.settle(200)
    view.scrollToTop()
    window.settle(200)
    seen = view.viewport().height() // view.rowHeight(0) + 2
    assert str(tmp_path / "9999.png") in asked and str(tmp_path / "5000.png") not in asked
    assert len(asked) < 2 * seen + 200, (len(asked), seen)  # and some by which the width of the column is chosen


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
    monkeypatch.setattr(child_process, "python_program", lambda: str(program))
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


def test_the_last_column_is_not_cut_off(dialog, folder):
    run(folder)
    window.settle(100)
    table = window.widget("ThinPart_FolderTable")
    assert table.horizontalHeader().length() <= table.viewport().width()

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tables of rows: sorted and filtered while they grow, fetched when they are shown, copied, chosen and written to files."""

import csv
import random
from collections import namedtuple

import pytest
import window_actions as window

from thinpart_workbench.core.kinds.file_marks import TABLE
from thinpart_workbench.core.length_unit import INCH
from thinpart_workbench.core.maps.map_summary import FaceSummary
from thinpart_workbench.gui.application.qt import QtCore, QtGui, QtWidgets
from thinpart_workbench.gui.tables.column import Column, count, figures, length
from thinpart_workbench.gui.tables.fetched_rows import PAGE, WAITING, FetchedRows
from thinpart_workbench.gui.tables.kept_rows import KeptRows
from thinpart_workbench.gui.tables.small_table import SmallTable
from thinpart_workbench.gui.tables.table_view import TableView
from thinpart_workbench.gui.thickness.face_table import FaceTable
from thinpart_workbench.storage.output_file import bears_mark

Row = namedtuple("Row", "number label thickness")
UP, DOWN = QtCore.Qt.AscendingOrder, QtCore.Qt.DescendingOrder
COLUMNS = (Column("label", "Label", lambda row: row.label),
           figures("thickness", "Thick, {}", lambda row: row.thickness, length),
           figures("number", "No.", lambda row: row.number, count, is_hidden=True))


def made(many, seed):
    """Rows with many equal and absent values."""
    chance = random.Random(seed)
    return [Row(number, chance.choice(["lid", "Plate", "bolt"]), chance.choice([None, 1.0, 2.0, 10.0]))
            for number in range(many)]


def sorted_plainly(rows, order):
    known = [row for row in rows if row.thickness is not None]
    return (sorted(known, key=lambda row: row.thickness, reverse=order == DOWN)
            + [row for row in rows if row.thickness is None])


@pytest.mark.parametrize("order", [UP, DOWN])
@pytest.mark.parametrize("seed", range(3))
def test_growing_sorted_and_filtered_is_the_same_as_all_at_once(seed, order):
    model, rows = KeptRows(COLUMNS), made(200, seed)
    model.sort(1, order)
    model.select(lambda row: row.label == "Plate")
    for first in range(0, len(rows), 7):
        model.add(rows[first:first + 7])
    chosen = [row for row in rows if row.label == "Plate"]
    window.wait_until(lambda: model.rows == sorted_plainly(chosen, order))
    model.select(None)
    assert model.rows == sorted_plainly(rows, order)
    model.sort(-1)
    assert model.rows == rows == model.all_rows
    model.sort(0)
    assert [row.label for row in model.rows] == sorted((row.label for row in rows), key=str.casefold)


def test_other_rows_are_sorted_like_the_former_and_a_replaced_one_stays_where_it_is():
    model, rows = KeptRows(COLUMNS), made(200, 1)
    model.add(rows)
    model.sort(1)
    model.set_rows([row for row in rows if row.label != "lid"])
    left = [row for row in rows if row.label != "lid"]
    assert model.rows == sorted_plainly(left, UP)
    model.replace(3, left[3]._replace(label="cap"))
    place = sorted_plainly(left, UP).index(left[3])
    assert [number for number, row in enumerate(model.rows) if row.label == "cap"] == [place]
    model.select(None)
    assert len(model.rows) == len(left)


@pytest.fixture
def table():
    rows = [Row(1, "lid", 2.0), Row(2, "-plate\tof\x1b steel", None), Row(3, "bolt", 1.0)]
    view = SmallTable("Walls", COLUMNS, 6)
    view.resize(400, 200)
    view.show_rows(rows)
    view.show()
    yield view
    view.hide()
    view.deleteLater()


def test_the_selected_row_stays_selected_when_it_is_sorted_and_in_another_unit(table):
    table.selectRow(0)
    table.sortByColumn(1, UP)
    assert [row.label for row in table.rows][:2] == ["bolt", "lid"] and table.current_row.label == "lid"
    table.show_rows(table.rows[::-1], COLUMNS, INCH, lambda one, other: one.number == other.number)
    assert table.current_row.label == "lid" and table.model().index(1, 1).data() == "0.0787"
    assert table.model().headerData(1, QtCore.Qt.Horizontal) == "Thick, in"
    table.show_rows(table.rows)
    assert table.current_row is None


def test_selected_rows_are_copied_as_they_are_shown(table):
    table.setSelectionMode(QtWidgets.QAbstractItemView.ExtendedSelection)
    table.setFocus()
    table.selectAll()
    event = QtGui.QKeyEvent(QtCore.QEvent.ShortcutOverride, QtCore.Qt.Key_C, QtCore.Qt.ControlModifier)
    event.ignore()
    QtWidgets.QApplication.sendEvent(table, event)
    assert event.isAccepted(), "FreeCAD would copy objects"
    window.key(table, QtCore.Qt.Key_C, QtCore.Qt.ControlModifier)
    assert QtWidgets.QApplication.clipboard().text() == "lid\t2\n-plate of\x1b steel\t\u2013\nbolt\t1"
    table.show_columns({"number": True, "thickness": False})
    table.copy()
    assert QtWidgets.QApplication.clipboard().text().splitlines()[0] == "lid\t1"


def test_columns_are_chosen_from_the_menu(table):
    assert table.isColumnHidden(2)
    menu = table.column_menu()
    shown = {action.text(): action for action in menu.actions()}
    assert {text: action.isChecked() for text, action in shown.items()} == {"Label": True, "Thick, mm": True, "No.": False}
    shown["No."].trigger()
    assert not table.isColumnHidden(2)
    table.show_rows(table.rows, COLUMNS[::-1])
    assert not table.isColumnHidden(0), "a choice is of a column, wherever it is"


def written(table, path, said):
    def choose(dialog):
        dialog.setOption(QtWidgets.QFileDialog.DontConfirmOverwrite, True)
        dialog.findChild(QtWidgets.QLineEdit).setText(str(path))
        dialog.accept()

    table.message.connect(said.append)
    table.failed.connect(said.append)
    window.answer("Walls_CsvDialog", choose)
    table.save_csv()
    window.wait_until(lambda: said)
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.reader(file))


def test_a_file_has_all_columns_of_the_shown_rows_and_nothing_that_a_spreadsheet_computes(table, tmp_path):
    table.sortByColumn(1, UP)
    table.model().show_unit(INCH)
    said = []
    assert written(table, tmp_path / "walls.csv", said) == [
        ["label", "thickness", "number"], ["bolt", "1.0", "3"], ["lid", "2.0", "1"], ["'-plate\tof\\x1b steel", "", "2"]]
    assert said == [f"The 3 rows that are shown were written to {tmp_path / 'walls.csv'}."]


def test_a_table_of_walls_says_of_which_part_and_is_written_again_without_a_question(tmp_path):
    faces = FaceTable()
    faces.setObjectName("Walls")
    summaries = [FaceSummary(10, 8.0, 0.5, 2.0, 0.25, 0.0, 3), FaceSummary(1, 8.0, None, None, 0.0, 1.0, 4)]
    faces.show_faces(summaries, [], INCH, {"name": "Body", "label": "Lid"}, str(tmp_path / "lid.FCStd"))
    faces.sortByColumn(0, UP)
    faces.csv_dialog = "Walls_CsvDialog"
    for _ in range(2):
        titles, *rows = written(faces, tmp_path / "faces.csv", [])
        assert [row[3] for row in rows] == ["Face2", "Face11"]
        assert dict(zip(titles, rows[1])) == {
            "file": str(tmp_path / "lid.FCStd"), "part": "Body", "label": "Lid", "face": "Face11", "thinnest_mm": "0.5",
            "median_mm": "2.0", "thin_share": "0.25", "unmeasured_share": "0.0", "area_mm2": "8.0"}
        assert bears_mark(tmp_path / "faces.csv", TABLE)
    (tmp_path / "costs.csv").write_text("part,costs\n")
    seen = []

    def decline(box):
        seen.append(box.text())
        box.button(QtWidgets.QMessageBox.Cancel).click()

    window.answer("ThinPart_OverwriteQuestion", decline)
    faces.write_csv(str(tmp_path / "costs.csv"))
    assert seen and (tmp_path / "costs.csv").read_text() == "part,costs\n"
    said = []
    faces.failed.connect(said.append)
    faces.write_csv(str(tmp_path / "part.step.csv.txt"))
    assert "ends with .csv" in said[0]
    faces.deleteLater()


@pytest.fixture
def query():
    """A view of many rows of a query, and what it was asked for."""
    rows, asked = made(25 * PAGE, 3), []
    model = FetchedRows(COLUMNS, "label")
    model.rows_requested.connect(lambda start, end: asked.append((start, end)))
    view = TableView("Found", model)
    model.show_result(len(rows), rows[:PAGE])
    view.resize(300, 300)
    view.show()
    window.settle(50)
    yield view, rows, asked
    view.hide()
    view.deleteLater()
    window.settle(10)


def test_rows_of_a_query_are_fetched_when_they_are_shown(query):
    view, rows, asked = query
    model = view.model()
    assert asked == [] and model.index(0, 0).data() == rows[0].label
    assert model.index(3 * PAGE + 5, 0).data() == WAITING and model.index(3 * PAGE + 6, 1).data() is None
    assert asked == [(3 * PAGE, 4 * PAGE)], "each page is asked for once"
    model.set_rows(3 * PAGE, rows[3 * PAGE:4 * PAGE])
    assert model.index(3 * PAGE + 5, 0).data() == rows[3 * PAGE + 5].label


def test_all_rows_of_a_query_are_fetched_for_a_file_and_again_when_they_have_changed(query):
    view, rows, asked = query
    model, collected = view.model(), []
    model.collect(collected.append)
    (start, end), = asked
    model.set_rows(start, rows[start:end])
    assert len(asked) == 2 and collected == []
    rows[:] = rows[::-1]
    rows[7] = None  # gone meanwhile
    model.show_result(len(rows), rows[:PAGE])
    while len(asked) > 2 and not collected:
        start, end = asked[-1]
        model.set_rows(start, rows[start:end])
    assert collected == [rows] and len(asked) < 8


def test_a_query_is_sorted_where_it_comes_from(query):
    view, _, _ = query
    asked = []
    view.model().sort_requested.connect(lambda key, descending: asked.append((key, descending)))
    view.sortByColumn(1, DOWN)
    assert set(asked) == {("thickness", True)}


def test_in_a_narrow_panel_headings_give_way_before_names_and_figures():
    Wall = namedtuple("Wall", "kind thick area long")
    columns = (Column("wall", "Wall", lambda row: row.kind, stretches=True),
               *(figures(key, f"{title}, {{}}", lambda row, key=key: getattr(row, key), length)
                 for key, title in (("thick", "Thickness"), ("area", "Surface area"), ("long", "Length"))))
    table = SmallTable("ThinPart_NarrowTable", columns, 4)
    table.show_rows([Wall("18 \u00d7 plate", 1.25, 37658.0, 327.0), Wall("tube", 15.0, 10001.0, 40.1)])
    for wide in (600, 250):
        table.resize(wide, 120)
        table.show()
        window.settle(30)
        assert all(table.columnWidth(number) >= table.sizeHintForColumn(number) for number in range(4)), wide
        assert table.horizontalScrollBar().maximum() == 0, wide
    assert table.columnWidth(2) < table.horizontalHeader().sectionSizeHint(2)
    table.deleteLater()

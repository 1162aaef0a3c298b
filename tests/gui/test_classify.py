# SPDX-License-Identifier: LGPL-2.1-or-later
"""One press of the button: panel, colours, other parts, cancelling, crashes."""

import os
import signal
import tempfile
from dataclasses import replace
from pathlib import Path

import FreeCAD as App
import FreeCADGui as Gui
import Part
import pytest
import window_actions as window

from thinpart_workbench.gui.application.qt import QtCore, QtWidgets
from thinpart_workbench.gui.document.active_task import open_session

RED = (0.84, 0.15, 0.12)


def test_ribbed_block(document):
    feature = window.add_ribbed_block(document)
    before = window.rgb(feature)[0]
    window.classify()
    assert window.text("ThinPart_Headline") == "Part with thin features"
    assert "rule 5" in window.text("ThinPart_Why")
    assert "from the limit" in window.text("ThinPart_HowSure")
    assert "100 \u00d7 60 \u00d7 60" in window.text("ThinPart_Box")
    assert "Wall thickness: min 6, median " in window.text("ThinPart_Walls")
    sides = [number for number, face in enumerate(feature.Shape.Faces)
             if abs(face.Area - 2000) < 1 and abs(face.normalAt(0, 0).y) > 0.99]
    assert len(sides) == 2
    for number, colour in enumerate(window.rgb(feature)):
        assert colour == (RED if number in sides else before), number


def test_plate(document):
    window.add(document, "Plate", Part.makeBox(100, 100, 2))
    window.classify()
    assert window.text("ThinPart_Headline") == "Thin part"
    assert window.text("ThinPart_PartLabel") == "Plate"


def test_a_normal_part_keeps_its_colours(document):
    feature = window.add(document, "Cube", Part.makeBox(10, 10, 10))
    before = feature.ViewObject.DiffuseColor
    window.classify()
    assert window.text("ThinPart_Headline") == "Normal part"
    assert feature.ViewObject.DiffuseColor == before
    assert not window.is_shown("ThinPart_Legend")
    assert "Colour thin faces" not in document.UndoNames


def test_the_table_has_a_row_per_condition_and_the_chart_its_bars(document):
    window.add_ribbed_block(document)
    window.classify()
    assert not window.is_shown("ThinPart_CriteriaTable")
    window.click("ThinPart_CriteriaFold")
    assert window.is_shown("ThinPart_CriteriaTable")
    table = window.widget("ThinPart_CriteriaTable")
    groups = [table.topLevelItem(index) for index in range(table.topLevelItemCount())]
    assert [group.childCount() for group in groups] == [2, 3, 1, 1, 2, 3, 1]
    fifth = [groups[4].child(row) for row in range(2)]
    assert [fifth[1].text(column) for column in (0, 2)] == ["F[0;0.05]", "> 0.0001"]
    assert fifth[1].text(3) == "\u2713 yes" and "%" in fifth[1].text(4)
    assert groups[0].child(1).text(3) == "\u2717 no"
    chart = window.widget("ThinPart_DistributionChart")
    assert sum(bar.area for bar in chart.bars) == pytest.approx(1.0, abs=0.01)
    thin = [bar for bar in chart.bars if bar.area > 0][0]
    assert "of the area" in chart.bar_text(thin)
    assert chart.grab().toImage().width() >= 180


@pytest.mark.parametrize("width", [320, 420])
def test_nothing_is_cut_off_in_a_narrow_task_view(document, width):
    window.add_ribbed_block(document)
    window.classify()
    form = window.widget("ThinPart_Panel")
    # The task view needs 36 for itself, its scroll bar included.
    width -= 40
    assert form.minimumSizeHint().width() <= width
    form.setParent(None)
    form.resize(width, 900)
    form.show()
    form.findChild(QtWidgets.QToolButton, "ThinPart_CriteriaFold").click()
    window.settle(100)
    assert form.width() == width
    assert form.findChild(QtWidgets.QWidget, "ThinPart_CriteriaTable").horizontalScrollBar().maximum() == 0
    for label in form.findChildren(QtWidgets.QLabel):
        if label.isVisible():
            assert label.height() >= label.heightForWidth(label.width()) - 1, label.objectName()
    form.hide()


def test_a_borderline_part_is_said_to_be_close_to_what_else_it_might_be(document):
    # 20000 / 30400 of its area lies over 26 mm, hardly more than the 0.6 of criterion 4.
    window.add(document, "Slab", Part.makeBox(100, 100, 26))
    window.classify()
    assert window.text("ThinPart_Headline") == "Thin part"
    assert window.text("ThinPart_HowSure") == (
        "Confidence: borderline, close to 'Part with thin features' (9.6\u00a0% from the limit)")


@pytest.mark.timeout(120)  # a worker has to load FreeCAD first
def test_the_window_has_its_turn_while_a_part_is_measured(document):
    window.add(document, "Sieve", window.slow_shape())
    with window.Turns() as turns:
        window.classify()
    assert turns.count > 50


def test_cancel_half_way(document):
    feature = window.add(document, "Sieve", window.slow_shape())
    before = feature.ViewObject.DiffuseColor
    folders = _temporary_folders()
    window.press("ThinPart_Classify")
    window.wait_until(lambda: window.widget("ThinPart_ProgressBar").value() > 0)
    assert window.workers() and _temporary_folders() > folders
    window.click("ThinPart_CancelButton")
    assert window.text("ThinPart_Message").startswith("Cancelled")
    window.wait_until(lambda: window.workers() == [])
    assert _temporary_folders() == folders
    assert feature.ViewObject.DiffuseColor == before
    assert not window.is_shown("ThinPart_Progress")


def test_after_cancelling_it_can_be_asked_for_again(document):
    window.add_ribbed_block(document)
    window.press("ThinPart_Classify")
    window.wait_until(lambda: window.is_shown("ThinPart_CancelButton"))
    window.click("ThinPart_CancelButton")
    window.click("ThinPart_AgainButton")
    window.wait_until_measured()
    assert window.text("ThinPart_Headline") == "Part with thin features"


def test_a_worker_that_dies_is_one_sentence(document):
    window.add(document, "Sieve", window.slow_shape())
    folders = _temporary_folders()
    window.press("ThinPart_Classify")
    window.wait_until(window.workers)
    os.kill(window.workers()[0], signal.SIGKILL)
    window.wait_until_measured()
    assert "ended unexpectedly" in window.text("ThinPart_Message")
    assert _temporary_folders() == folders


def test_a_worker_that_cannot_begin_is_one_sentence(document, monkeypatch):
    from thinpart_workbench.freecad_adapter.preferences import PREFERENCES, set_preference

    # Less than people can set. The C library of newer systems has kept up to 64 MB by then: this part needs more.
    monkeypatch.setitem(PREFERENCES, "MemoryMegabytes", replace(
        PREFERENCES["MemoryMegabytes"], range=(10, 1000)))
    window.add(document, "Sieve", window.slow_shape(20))
    set_preference("MemoryMegabytes", 20)
    try:
        window.classify()
    finally:
        monkeypatch.undo()
        set_preference("MemoryMegabytes", None)
    assert window.text("ThinPart_Message")
    assert not window.is_shown("ThinPart_Headline")


def test_a_part_that_takes_all_memory_is_told_with_the_limit(document):
    import made_meshes
    import Mesh

    from thinpart_workbench.freecad_adapter.preferences import set_preference

    # No surface can be made of so many triangles in what is left beside FreeCAD and numpy.
    points, triangles = made_meshes.sphere(20, 900)
    document.addObject("Mesh::Feature", "Ball").Mesh = Mesh.Mesh(points[triangles].reshape(-1, 3).tolist())
    set_preference("MemoryMegabytes", 700)
    try:
        window.classify()
    finally:
        set_preference("MemoryMegabytes", None)
    assert "more than 700 MB of memory" in window.text("ThinPart_Message")
    assert not window.is_shown("ThinPart_Headline")


def test_closing_the_document_stops_the_worker_and_takes_the_panel_away(document):
    window.add(document, "Sieve", window.slow_shape())
    window.press("ThinPart_Classify")
    window.wait_until(window.workers)
    App.closeDocument(document.Name)
    window.wait_until(lambda: not Gui.Control.activeDialog() and window.workers() == [])


def test_closing_the_panel_stops_the_worker(document):
    window.add(document, "Sieve", window.slow_shape())
    window.press("ThinPart_Classify")
    window.wait_until(window.workers)
    window.mouse_click(window.close_button())
    window.wait_until(lambda: not Gui.Control.activeDialog() and window.workers() == [])


def test_two_documents(document):
    window.add_ribbed_block(document)
    other = App.newDocument("Other")
    plate = window.add(other, "Plate", Part.makeBox(100, 100, 2))
    window.classify()
    assert window.text("ThinPart_Headline") == "Thin part"
    App.setActiveDocument(document.Name)
    window.classify()
    assert window.text("ThinPart_Headline") == "Part with thin features"
    App.closeDocument(document.Name)
    window.settle(100)
    assert not Gui.Control.activeDialog()
    assert RED in window.rgb(plate)
    App.setActiveDocument(other.Name)
    assert Gui.isCommandActive("ThinPart_ClearColours")


def test_damaged_profile_is_one_sentence(document, tmp_path):
    from thinpart_workbench.freecad_adapter.preferences import set_preference

    window.add_ribbed_block(document)
    set_preference("Profile", str(tmp_path / "missing.json"))
    try:
        window.classify()
    finally:
        set_preference("Profile", None)
    assert "There is no profile" in window.text("ThinPart_Message")


def test_a_mesh_is_classified_and_coloured(document):
    import Mesh

    feature = document.addObject("Mesh::Feature", "Soup")
    feature.Mesh = Mesh.createBox(100, 100, 2)
    before = tuple(round(part, 2) for part in feature.ViewObject.ShapeColor[:3])
    window.classify()
    assert window.text("ThinPart_Headline") == "Thin part"
    assert window.is_shown("ThinPart_Legend")
    assert tuple(round(part, 2) for part in feature.ViewObject.ShapeColor[:3]) == RED
    window.press("ThinPart_ClearColours")
    assert tuple(round(part, 2) for part in feature.ViewObject.ShapeColor[:3]) == before


def _temporary_folders():
    return {each.name for each in Path(tempfile.gettempdir()).glob("thinpart-*")
            if not each.name.startswith("thinpart-gui-")}



def test_a_click_on_a_wall_selects_its_faces(document):
    feature = window.add_ribbed_block(document)
    window.classify()
    table = window.widget("ThinPart_RegionsTable")
    cells = [[table.model().index(row, column).data() for column in range(4)] for row in range(table.model().rowCount())]
    assert [row[:2] for row in cells] == [["rib", "6"], ["block", "40"]]
    assert cells[0][2:] == ["4000", "100"]
    table.selectRow(0)
    selected, = Gui.Selection.getSelectionEx(document.Name)
    assert selected.ObjectName == feature.Name and len(selected.SubObjects) == 2
    assert all(abs(face.Area - 2000) < 1 and abs(face.normalAt(0, 0).y) > 0.99 for face in selected.SubObjects)


def test_equal_walls_are_one_row(document):
    fins = [Part.makeBox(60, 1.5, 30, App.Vector(0, 5.5 * number, 0)) for number in range(6)]
    window.add(document, "HeatSink", Part.makeBox(60, 29, 5).multiFuse(fins).removeSplitter())
    window.classify()
    table = window.widget("ThinPart_RegionsTable")
    assert table.model().index(0, 0).data() == "6 \u00d7 plate"
    table.selectRow(0)
    selected, = Gui.Selection.getSelectionEx(document.Name)
    assert len(selected.SubObjects) == 12


def finned_block():
    """A block of 120 mm with 18 fins, four ribs of other thicknesses and a long wall."""
    block = Part.makeBox(120, 80, 12)
    for number in range(18):
        block = block.fuse(Part.makeBox(1.25, 60, 25, window.V(2 + 5 * number, 2, 12)))
    for number, thick in enumerate((1.1, 1.6, 2.2, 2.9)):
        block = block.fuse(Part.makeBox(thick, 60, 12, window.V(93 + 7 * number, 2, 12)))
    return block.fuse(Part.makeBox(120, 1.8, 30, window.V(0, 70, 12))).removeSplitter()


def assert_fits(table):
    """No cell and no heading of a table is cut off, and all of its columns are in view."""
    header, model = table.horizontalHeader(), table.model()
    shown = [number for number in range(model.columnCount()) if not table.isColumnHidden(number)]
    assert table.horizontalScrollBar().maximum() == 0
    for number in shown:
        heading = model.headerData(number, QtCore.Qt.Horizontal)
        assert header.fontMetrics().boundingRect(heading).width() <= table.columnWidth(number), heading
        assert table.sizeHintForColumn(number) <= table.columnWidth(number), heading
        assert model.columns[number].heading(model.unit) in model.headerData(
            number, QtCore.Qt.Horizontal, QtCore.Qt.ToolTipRole) or model.columns[number].meaning


@pytest.mark.parametrize("width", [300, 420])
def test_many_walls_are_whole_in_the_table_of_a_narrow_panel(document, width):
    window.add(document, "Finned", finned_block())
    window.classify()
    form, table = window.widget("ThinPart_Panel"), window.widget("ThinPart_RegionsTable")
    form.setParent(None)
    form.resize(width - 40, 900)
    form.show()
    window.settle(100)
    walls = [table.model().index(row, 0).data() for row in range(table.model().rowCount())]
    assert any(wall.endswith(" \u00d7 plate") for wall in walls) and len(walls) >= 4
    assert_fits(table)
    # The features that made them give way to the rest, and are whole in their tool tips.
    record = open_session().record_of(document.Name, "Finned")
    table.show_regions(record, table.model().unit, ["Pad of the upper fins"] * len(record["faces"]))
    window.settle(50)
    assert table.horizontalScrollBar().maximum() == 0
    for number, column in enumerate(table.model().columns):
        if column.key in ("wall", "area_mm2", "length_mm"):
            assert table.sizeHintForColumn(number) <= table.columnWidth(number), column.key
        assert table.model().index(0, number).data(QtCore.Qt.ToolTipRole) == table.model().index(0, number).data()
    form.hide()


def test_long_names_of_parts_give_way_to_their_figures(document):
    for number in range(4):
        block = window.add(document, f"Block{number}", Part.makeBox(30, 20, 1 + number))
        block.Label = f"Upper left bracket of the housing, version {number}"
    window.classify()
    form, table = window.widget("ThinPart_Panel"), window.widget("ThinPart_PartTable")
    form.setParent(None)
    form.resize(260, 900)
    form.show()
    window.settle(100)
    assert table.horizontalScrollBar().maximum() == 0
    for number in range(1, 4):
        assert table.sizeHintForColumn(number) <= table.columnWidth(number)
    assert table.model().index(0, 0).data(QtCore.Qt.ToolTipRole).startswith("Upper left bracket of the housing, version")
    form.hide()

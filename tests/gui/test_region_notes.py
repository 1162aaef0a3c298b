# SPDX-License-Identifier: LGPL-2.1-or-later
"""Wall regions of a map: the mouse over a row, a click, the menu, and what is kept in the info file."""

import FreeCAD as App
import FreeCADGui as Gui
import numpy as np
import Part
import pytest
import window_actions as window
from thickness_window import view_of

from thinpart_workbench.api.document_maps import parts_of
from thinpart_workbench.freecad_adapter.objects.thickness_object import thickness_objects
from thinpart_workbench.freecad_adapter.preferences import set_preference
from thinpart_workbench.gui.application import lifelong
from thinpart_workbench.gui.application.qt import QtCore, QtWidgets
from thinpart_workbench.gui.scene.drawn_triangles import drawn_triangles
from thinpart_workbench.storage.info.stored_records import stored_records

REASON = "crush rib, thin on purpose"


@pytest.fixture(autouse=True)
def person():
    set_preference("Person", "Anna")
    yield
    set_preference("Person", None)


@pytest.fixture
def sink(document):
    fins = [Part.makeBox(60, 1.5, 30, App.Vector(0, 5.5 * number, 0)) for number in range(6)]
    return window.add(document, "HeatSink", Part.makeBox(60, 29, 5).multiFuse(fins).removeSplitter())


@pytest.fixture
def saved(sink, tmp_path):
    """The path of a saved document, whose map is shown."""
    path = tmp_path / "sink.FCStd"
    sink.Document.saveAs(str(path))
    Gui.runCommand("Std_Save")
    window.show_thickness()
    window.wait_until(lambda: window.text("ThinPart_InfoText").startswith("Info file, beside"))
    settled()
    return path


def settled():
    window.wait_until(lambda: not lifelong.requests.is_busy)
    window.settle(100)


def table():
    return window.widget("ThinPart_RegionsTable")


def middle_of(row):
    return table().visualRect(table().model().index(row, 0)).center()


def choose(name, row=0, answer=None):
    """Open the menu of a row, take an entry with the mouse, and answer what it asks."""
    def take():
        menu = QtWidgets.QApplication.activePopupWidget()
        action = next(each for each in menu.actions() if each.objectName() == f"ThinPart_Region_{name}")
        if answer is not None:
            QtCore.QTimer.singleShot(200, reply)
        window.mouse_click(menu, menu.actionGeometry(action).center())

    def reply():
        dialog = QtWidgets.QApplication.activeModalWidget()
        if isinstance(answer, str):
            dialog.setTextValue(answer)
        else:
            dialog.setDoubleValue(answer)
        dialog.accept()

    QtCore.QTimer.singleShot(100, take)
    table().customContextMenuRequested.emit(middle_of(row))
    window.wait_until(lambda: QtWidgets.QApplication.activePopupWidget() is None)
    window.settle(500 if answer is not None else 100)
    settled()


def struck(row, column=0):
    font = table().model().index(row, column).data(QtCore.Qt.FontRole)
    return font is not None and font.strikeOut()


def titles():
    return [table().model().headerData(column, QtCore.Qt.Horizontal) for column in range(table().model().columnCount())
            if not table().isColumnHidden(column)]


def test_the_row_under_the_mouse_is_highlighted_until_it_leaves(sink):
    window.show_thickness()
    shown = thickness_objects(sink.Document)[0].ViewObject.Proxy
    before = shown.highlighting
    table().entered.emit(table().model().index(0, 0))
    assert shown.colours.faces == {0: set(table().rows[0].faces)}
    QtWidgets.QApplication.sendEvent(table(), QtCore.QEvent(QtCore.QEvent.Leave))
    assert shown.highlighting == before and shown.colours.faces is None


def test_a_click_flies_there_and_the_highlight_stays(sink):
    window.show_thickness()
    shown = thickness_objects(sink.Document)[0].ViewObject.Proxy
    view = view_of(sink.Document)
    before = np.array(view.getCameraNode().position.getValue().getValue())
    table().entered.emit(table().model().index(0, 0))
    window.mouse_click(table().viewport(), middle_of(0))
    window.settle(1500)
    after = np.array(view.getCameraNode().position.getValue().getValue())
    assert np.linalg.norm(after - before) > 1.0
    QtWidgets.QApplication.sendEvent(table(), QtCore.QEvent(QtCore.QEvent.Leave))
    assert shown.colours.faces == {0: set(table().rows[0].faces)}


def test_isolated_walls_alone_are_drawn_until_all_are_shown_again(sink):
    window.show_thickness()
    window.settle(500)
    thickness, = thickness_objects(sink.Document)
    part, = parts_of(thickness)
    root = thickness.ViewObject.RootNode
    choose("isolate")
    faces = np.array(table().rows[0].faces)
    assert len(drawn_triangles(root)) == np.isin(part.map.face, faces).sum() < part.map.count
    window.mouse_click(window.widget("ThinPart_ShowAllWalls"))
    assert len(drawn_triangles(root)) == part.map.count and not window.widget("ThinPart_ShowAllWalls").isEnabled()
    choose("isolate")
    Gui.Control.closeDialog()
    window.settle(100)
    assert len(drawn_triangles(root)) == part.map.count


def test_rows_have_thickness_area_and_length_the_thinnest_first(sink):
    window.show_thickness()
    assert titles() == ["Wall", "Thick, mm", "Area, mm\u00b2", "Long, mm"]
    rows = table().rows
    assert [row.least for row in rows] == sorted(row.least for row in rows)
    fins = rows[0]
    assert (fins.count, fins.least, fins.length) == (6, pytest.approx(1.5), pytest.approx(60, rel=0.05))
    assert fins.area == pytest.approx(6 * 2 * 60 * 25, rel=0.1)


def test_an_unsaved_document_keeps_nothing(sink):
    window.show_thickness()
    assert "info file" in window.widget("ThinPart_RegionBox")._refusal
    table().customContextMenuRequested.emit(middle_of(0))
    menu = QtWidgets.QApplication.activePopupWidget()
    enabled = {action.objectName()[len("ThinPart_Region_"):]: action.isEnabled() for action in menu.actions()
               if action.objectName().startswith("ThinPart_Region_")}
    offered = [action.objectName() for action in menu.actions()]
    menu.close()
    assert enabled == {"isolate": True, "show_all": False, "exclude": False, "size": False}
    assert offered[-1] == "ThinPart_TableCsv", "the rows can be written to a file"


def test_excluded_walls_are_struck_through_with_the_reason_and_the_verdict_stays(saved):
    verdict = window.text("ThinPart_Headline")
    choose("exclude", 0, REASON)
    record, = stored_records(saved)
    assert [note["excluded"] for note in record["region_notes"]] == [REASON] * 6
    assert {note["person"] for note in record["region_notes"]} == {"Anna"}
    assert struck(0, 0) and struck(0, 1) and not struck(1, 0)
    assert f"excluded: {REASON}" in window.text("ThinPart_RegionNotes")
    assert window.text("ThinPart_Headline") == verdict
    choose("include", 0)
    assert not struck(0) and not window.is_shown("ThinPart_RegionNotes") and "region_notes" not in stored_records(saved)[0]


def test_a_note_survives_measuring_again_and_opening_again(saved):
    choose("size", 0, 0.4)
    choose("exclude", 0, REASON)
    document = App.ActiveDocument
    thickness, = thickness_objects(document)
    window.widget("ThinPart_Measure").setCurrentIndex(1)  # measures again, by balls
    window.wait_until(lambda: thickness.Measure == "sphere")
    window.settle(500)
    settled()
    assert struck(0) and "0.4\u00a0mm" in window.text("ThinPart_RegionNotes")
    Gui.runCommand("Std_Save")
    Gui.Control.closeDialog()
    App.closeDocument(document.Name)
    window.settle(100)
    thickness, = thickness_objects(App.openDocument(str(saved)))
    window.settle(100)
    thickness.ViewObject.Proxy.doubleClicked(thickness.ViewObject)
    window.wait_until(lambda: window.is_shown("ThinPart_RegionNotes"))
    settled()
    assert struck(0) and REASON in window.text("ThinPart_RegionNotes")
    record, = stored_records(saved)
    assert {note["mesh_size_mm"] for note in record["region_notes"]} == {0.4}

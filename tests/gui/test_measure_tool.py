# SPDX-License-Identifier: LGPL-2.1-or-later
"""Wall thickness as a measurement of FreeCAD's own tool, and our panels beside that tool."""

import FreeCAD as App
import FreeCADGui as Gui
import Part
import pytest
import window_actions as window
from window_actions import V

from thinpart_workbench.freecad_adapter.objects.wall_measurement import ID
from thinpart_workbench.gui.application.qt import QtCore, QtWidgets

pytestmark = pytest.mark.skipif(not hasattr(App, "MeasureManager"), reason="this FreeCAD has no measure tool")


@pytest.fixture
def box(document):
    """A box 3 mm thick that stands askew."""
    return window.add(document, "Box", Part.makeBox(20, 10, 3), App.Placement(V(5, 6, 7), App.Rotation(V(1, 2, 3), 33)))


def mode_box():
    return next(each for each in Gui.getMainWindow().findChildren(QtWidgets.QComboBox)
                if each.isVisible() and each.findText("Wall thickness") >= 0)


def open_tool():
    Gui.runCommand("Std_Measure")
    window.settle(100)
    return mode_box()


def choose_wall(modes):
    modes.setCurrentIndex(modes.findText("Wall thickness"))
    modes.activated.emit(modes.currentIndex())
    window.settle(100)


def measured(document):
    return [each for each in document.Objects if each.TypeId == "Measure::MeasurePython"]


def save_measurement():
    button, = [each for each in Gui.getMainWindow().findChildren(QtWidgets.QPushButton)
               if each.isVisible() and each.text().replace("&", "") in ("Save", "Annotate")]
    window.mouse_click(button)
    window.settle(100)


def test_it_is_the_last_mode_and_not_the_automatic_one(document, box):
    modes = open_tool()
    assert modes.itemText(modes.count() - 1) == "Wall thickness"
    assert [each[0] for each in App.MeasureManager.getMeasureTypes()].count(ID) == 1
    Gui.Selection.addSelection(document.Name, "Box", "Face6")
    window.settle(100)
    assert measured(document) == [], "a face is measured by its area"


@pytest.mark.parametrize("face, place, thickness", [
    ("Face6", (4, 5, 3), 3.0), ("Face5", (4, 5, 0), 3.0), ("Face1", (0, 5, 1), 20.0), ("Face6", None, 3.0)])
def test_a_wall_is_measured_where_it_is_clicked(document, box, face, place, thickness):
    choose_wall(open_tool())
    clicked = box.Placement.multVec(V(*place)) if place else V()
    Gui.Selection.addSelection(document.Name, "Box", face, *clicked)
    window.settle(100)
    measurement, = measured(document)
    assert measurement.Thickness.Value == pytest.approx(thickness)
    assert measurement.Placement.Base.distanceToPoint(clicked if place else box.Placement.multVec(V(10, 5, 3))) < 1e-6
    assert measurement.Opposite.distanceToPoint(measurement.Placement.Base) == pytest.approx(thickness)
    result, = [each.text() for each in Gui.getMainWindow().findChildren(QtWidgets.QLineEdit)
               if each.isVisible() and each.text().startswith("t = ")]
    assert result == f"t = {measurement.Thickness.UserString}"


def test_it_is_saved_opened_and_measured_again(document, box, tmp_path):
    choose_wall(open_tool())
    place = V(2, 2, 3)
    Gui.Selection.addSelection(document.Name, "Box", "Face6", *box.Placement.multVec(place))
    window.settle(100)
    save_measurement()
    Gui.Control.closeDialog()
    window.settle(50)
    name = measured(document)[0].Name
    assert measured(document)[0].Label.endswith("t = " + measured(document)[0].Thickness.UserString)
    document.saveAs(str(tmp_path / "measured.FCStd"))
    App.closeDocument(document.Name)
    document = App.openDocument(str(tmp_path / "measured.FCStd"))
    window.settle(100)
    measurement, box = document.getObject(name), document.getObject("Box")
    assert measurement.Thickness.Value == pytest.approx(3.0)
    box.Shape = Part.makeBox(20, 10, 2)
    box.Placement = App.Placement(V(100, 0, 0), App.Rotation(V(1, 0, 0), 90))
    document.recompute()
    assert measurement.Thickness.Value == pytest.approx(2.0), "the place on the face goes with it"
    assert measurement.Placement.Base.distanceToPoint(box.Placement.multVec(V(2, 2, 2))) < 2.0
    assert "Invalid" not in measurement.State


@pytest.mark.complains("has no attribute 'getSubject'")  # FreeCAD asks what is not there
def test_one_that_was_saved_without_thinpart_is_measured_again(document, box, tmp_path):
    choose_wall(open_tool())
    Gui.Selection.addSelection(document.Name, "Box", "Face6", *box.Placement.multVec(V(2, 2, 3)))
    window.settle(100)
    save_measurement()
    Gui.Control.closeDialog()
    measurement, = measured(document)
    name, measurement.Proxy = measurement.Name, None  # as where the module cannot be imported
    document.saveAs(str(tmp_path / "measured.FCStd"))
    App.closeDocument(document.Name)
    document = App.openDocument(str(tmp_path / "measured.FCStd"))
    window.settle(100)
    assert document.getObject(name).Thickness.Value == pytest.approx(3.0)
    document.getObject("Box").Shape = Part.makeBox(20, 10, 2)
    document.recompute()
    assert document.getObject(name).Thickness.Value == pytest.approx(2.0)
    assert document.getObject(name).Proxy.getResultString(document.getObject(name)).startswith("t = 2")


def test_a_part_in_an_assembly_is_measured_where_it_stands(document, box):
    container = document.addObject("App::Part", "Container")
    container.Placement.Base = V(0, 0, 100)
    link = document.addObject("App::Link", "Link")
    link.LinkedObject = box
    container.addObject(link)
    document.recompute()
    choose_wall(open_tool())
    clicked = container.Placement.multVec(link.Placement.multVec(V(4, 5, 3)))
    Gui.Selection.addSelection(document.Name, "Container", "Link.Face6", *clicked)
    window.settle(100)
    measurement, = measured(document)
    assert measurement.Thickness.Value == pytest.approx(3.0)
    assert measurement.Placement.Base.distanceToPoint(clicked) < 1e-6


@pytest.mark.parametrize("shape, path", [
    (lambda: Part.makeBox(9, 9, 9), "Edge1"), (lambda: Part.makePlane(5, 5), "Face1")])
def test_what_has_no_wall_is_not_measured(document, shape, path):
    window.add(document, "Thing", shape())
    choose_wall(open_tool())
    Gui.Selection.addSelection(document.Name, "Thing", path, 1, 1, 0)
    window.settle(100)
    assert measured(document) == []


@pytest.mark.parametrize("command, panel", [
    ("ThinPart_Classify", "ThinPart_Panel"), ("ThinPart_ShowThickness", "ThinPart_ThicknessVerdict")])
def test_our_commands_say_that_the_tool_is_open(document, box, command, panel):
    open_tool()
    window.press(command)
    window.settle(100)
    assert "one task at a time" in Gui.getMainWindow().statusBar().currentMessage()
    assert mode_box().isVisible() and not window.is_shown(panel)
    Gui.Control.closeDialog()
    window.settle(100)
    Gui.runCommand(command)
    window.wait_until(lambda: window.is_shown(panel))


def by_button():
    window.mouse_click(window.tool_button("Std_Measure"))


def by_menu():
    action = Gui.Command.get("Std_Measure").getAction()[0]
    menu = next(each for each in Gui.getMainWindow().findChildren(QtWidgets.QMenu) if action in each.actions())
    menu.popup(Gui.getMainWindow().mapToGlobal(QtCore.QPoint(100, 100)))
    window.settle(100)
    menu.setActiveAction(action)
    window.mouse_click(menu, menu.actionGeometry(action).center())
    window.settle(50)
    assert not menu.isVisible()


@pytest.mark.parametrize("ask", [by_button, by_menu])
def test_our_panel_says_that_it_is_in_the_tools_way(document, box, ask):
    window.show_thickness()
    ask()
    window.settle(200)
    assert "one task at a time" in Gui.getMainWindow().statusBar().currentMessage()
    assert window.is_shown("ThinPart_ThicknessVerdict")
    window.mouse_click(window.close_button())
    window.settle(100)
    Gui.getMainWindow().statusBar().clearMessage()
    by_button()
    window.settle(200)
    assert Gui.getMainWindow().statusBar().currentMessage() == ""
    choose_wall(mode_box())
    Gui.Selection.addSelection(document.Name, "Box", "Face6", *box.Placement.multVec(V(4, 5, 3)))
    window.settle(100)
    measurement, = measured(document)
    assert measurement.Thickness.Value == pytest.approx(3.0)


def test_the_panel_of_another_workbench_is_watched_too(document, box):
    window.show_thickness()
    Gui.activateWorkbench("PartWorkbench")
    window.settle(100)
    by_button()
    window.settle(100)
    assert "one task at a time" in Gui.getMainWindow().statusBar().currentMessage()
    container = document.addObject("App::Part", "Container")
    Gui.Selection.addSelection(document.Name, container.Name)
    window.settle(50)
    assert Gui.Selection.getSelection() == [container], "no tool that nobody sees takes it back"

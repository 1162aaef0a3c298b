# SPDX-License-Identifier: LGPL-2.1-or-later
"""'Prepare mesh' in the window, as a shell: the mid-surface, its mesh, its thicknesses, and the analysis they are in."""

import shutil

import FemGui
import FreeCADGui as Gui
import ObjectsFem
import Part
import pytest
import window_actions as window
from window_actions import V

from thinpart_workbench.gui.application.qt import QtWidgets
from thinpart_workbench.gui.document.active_task import open_session

pytestmark = [pytest.mark.skipif(shutil.which("gmsh") is None, reason="gmsh is not installed"),
              pytest.mark.timeout(240)]  # each measures a part and makes its shell, one does so twice


def angle(document, name="Angle"):
    """Two legs of 2 and 4 mm, with a hole, apart from the origin."""
    shape = Part.makeBox(60, 40, 2).fuse(Part.makeBox(4, 40, 30)).removeSplitter()
    feature = window.add(document, name, shape.cut(Part.makeCylinder(8, 9, V(35, 20, -2))))
    feature.Placement.Base = V(100, 0, 0)
    document.recompute()
    return feature


def open_panel():
    window.press("ThinPart_MeshSizes")
    window.wait_until(lambda: window.is_shown("ThinPart_MeshAdvice") or window.text("ThinPart_Message"))


def choose_shell():
    window.widget("ThinPart_MeshKind").setCurrentIndex(1)


def meshes(document):
    return [each for each in document.Objects if each.isDerivedFrom("Fem::FemMeshObject")]


def thicknesses(document):
    return [each for each in document.Objects
            if getattr(getattr(each, "Proxy", None), "Type", "") == "Fem::ElementGeometry2D"]


def middles(document):
    return [each for each in document.Objects if hasattr(each, "ThinPartShellOf")]


def press_ok():
    boxes = [each for box in Gui.getMainWindow().findChildren(QtWidgets.QDialogButtonBox) for each in box.buttons()
             if each.isVisible() and box.standardButton(each) == QtWidgets.QDialogButtonBox.Ok]
    assert open_session() is not None and len(boxes) == 1
    boxes[0].click()
    window.wait_until(lambda: open_session() is None or window.text("ThinPart_Message"))


def test_the_panel_recommends_with_figures_for_both(document):
    angle(document)
    open_panel()
    advice = window.text("ThinPart_MeshAdvice")
    assert advice.startswith("Recommended: shell.") and "of the volume in plate-like walls" in advice
    assert "as a solid" in advice and "as a shell" in advice


def test_ok_makes_a_shell_with_its_thicknesses_in_one_step_of_undo_and_again_updates_it(document):
    document.UndoMode = 1
    feature = angle(document)
    analysis = ObjectsFem.makeAnalysis(document, "Analysis")
    FemGui.setActiveAnalysis(analysis)
    open_panel()
    choose_shell()
    steps = document.UndoCount
    press_ok()
    assert open_session() is None, window.text("ThinPart_Message")
    assert document.UndoCount == steps + 1
    (mesh,), (middle,) = meshes(document), middles(document)
    assert mesh.FemMesh.VolumeCount == 0 and mesh.FemMesh.FaceCount > 50 and mesh.ElementOrder == "2nd"
    assert {len(mesh.FemMesh.getElementNodes(face)) for face in mesh.FemMesh.Faces} == {6}
    box = middle.Shape.BoundBox
    assert (box.XMin, box.ZMin, box.ZMax) == (pytest.approx(102.0), pytest.approx(1.0), pytest.approx(30.0))
    xs = [point.x for point in mesh.FemMesh.Nodes.values()]
    assert (min(xs), max(xs)) == (pytest.approx(102.0), pytest.approx(160.0))
    groups = sorted(mesh.FemMesh.getGroupName(each) for each in mesh.FemMesh.Groups)
    assert groups == ["thickness_2_mm", "thickness_4_mm"]
    found = sorted(thicknesses(document), key=lambda each: each.Thickness.Value)
    assert [each.Thickness.Value for each in found] == [pytest.approx(2.0), pytest.approx(4.0)]
    # FEM finds the elements of a thickness by these faces: each element has exactly one.
    numbers = [_elements(mesh, each) for each in found]
    assert numbers[0] | numbers[1] == set(mesh.FemMesh.Faces) and not numbers[0] & numbers[1]
    assert set(analysis.Group) == {mesh, *found}
    assert not feature.Visibility and mesh.Visibility
    assert not mesh.ViewObject.BackfaceCulling  # every wall is seen from both sides
    document.undo()
    assert meshes(document) == middles(document) == thicknesses(document) == analysis.Group == []
    assert feature.Visibility
    document.redo()
    count = meshes(document)[0].FemMesh.FaceCount
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(feature)
    open_panel()
    choose_shell()
    window.widget("ThinPart_ShellSize").setValue(4.0)
    press_ok()
    (mesh,), (middle,) = meshes(document), middles(document)
    assert mesh.FemMesh.FaceCount > count and len(thicknesses(document)) == 2 and len(analysis.Group) == 3


def _elements(mesh, thickness):
    found = set()
    for owner, names in thickness.References:
        nodes = set()
        for name in names:
            nodes |= set(mesh.FemMesh.getNodesByFace(owner.Shape.getElement(name)))
        found |= {face for face in mesh.FemMesh.Faces if set(mesh.FemMesh.getElementNodes(face)) <= nodes}
    return found


def test_a_wall_without_its_check_mark_stays_solid(document):
    angle(document)
    open_panel()
    choose_shell()
    table = window.widget("ThinPart_ShellWalls")
    assert [(table.model().index(row, 0).data(), table.model().index(row, 1).data()) for row in range(len(table.rows))] == [
        ("shell", "2"), ("shell", "4")]
    window.check_cell("ThinPart_ShellWalls", 1, False)
    window.wait_until(lambda: table.model().index(1, 0).data() == "solid")
    window.click("ThinPart_ShellButton")
    window.wait_until(lambda: "triangles of up to" in window.text("ThinPart_ShellFigures"))
    assert [table.model().index(row, 0).data() for row in range(table.model().rowCount())] == ["shell", "left solid: plate"]
    assert [wall.is_in for wall in table.rows] == [True, False]
    press_ok()
    assert open_session() is None, window.text("ThinPart_Message")
    middle, = middles(document)
    assert (middle.Shape.BoundBox.ZMin, middle.Shape.BoundBox.ZMax) == (pytest.approx(1.0), pytest.approx(1.0))
    thickness, = thicknesses(document)
    assert thickness.Thickness.Value == pytest.approx(2.0)


def test_no_shell_is_made_of_walls_that_are_all_to_stay_solid(document):
    angle(document)
    open_panel()
    choose_shell()
    table = window.widget("ThinPart_ShellWalls")
    table.selectAll()
    window.check_cell("ThinPart_ShellWalls", 0, False)
    window.wait_until(lambda: [table.model().index(row, 0).data() for row in range(2)] == ["solid", "solid"])
    window.click("ThinPart_ShellButton")
    window.wait_until(lambda: "choose at least one" in window.text("ThinPart_Message"))


def test_a_shell_is_seen_before_ok_and_nothing_of_it_stays(document):
    feature = angle(document)
    open_panel()
    choose_shell()
    window.click("ThinPart_ShellButton")
    window.wait_until(lambda: "triangles of up to" in window.text("ThinPart_ShellFigures"))
    table = window.widget("ThinPart_ShellWalls")
    assert [table.model().index(row, 1).data() for row in range(table.model().rowCount())] == ["2", "4"]
    assert window.is_shown("ThinPart_ShellBar") and [text for _, text in window.widget("ThinPart_ShellBar").ticks] == [
        "2", "3", "4\u00a0mm"]
    switch = feature.ViewObject.SwitchNode.whichChild
    assert switch.getValue() == -1 and feature.Visibility
    window.widget("ThinPart_MeshKind").setCurrentIndex(0)
    assert switch.getValue() != -1
    choose_shell()
    open_session().close()
    window.settle(50)
    assert switch.getValue() != -1 and meshes(document) == middles(document) == []

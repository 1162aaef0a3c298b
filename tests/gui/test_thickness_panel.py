# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel of a thickness map: histogram, threshold, faces, probes, parts, with mouse and keys."""

import FreeCAD as App
import FreeCADGui as Gui
import numpy as np
import Part
import pytest
import window_actions as window
from window_actions import V

from thinpart_workbench.api.document_maps import parts_of
from thinpart_workbench.api.window.map_values import bar_edges
from thinpart_workbench.core.maps.map_summary import share_between
from thinpart_workbench.freecad_adapter.objects.thickness_object import thickness_objects
from thinpart_workbench.freecad_adapter.objects.thickness_probes import probes_of
from thinpart_workbench.gui.application.qt import QtCore, QtGui, QtWidgets
from thinpart_workbench.gui.colour_bar.colours import GREYED
from thinpart_workbench.gui.document.free_area import free_area
from thinpart_workbench.gui.scene.view_ray import line_of_sight


@pytest.fixture
def ribbed(document):
    """The map of a ribbed block, its panel open."""
    window.add_ribbed_block(document)
    window.show_thickness()
    window.settle(300)  # until the boxes have their sizes
    thickness, = thickness_objects(document)
    return thickness


def chart():
    return window.widget("ThinPart_ThicknessChart")


def bar_place(thickness):
    """The middle of the bar that holds a thickness in mm."""
    shown = chart()
    bar = int(np.searchsorted(shown.edges, thickness, side="right")) - 1
    return QtCore.QPoint(int(shown.x_of(shown.edges[bar:bar + 2].mean())), int(shown.plot().bottom()) - 3)


def selected_faces():
    return {name for each in Gui.Selection.getSelectionEx() for name in each.SubElementNames}


def rib_faces(feature):
    return {f"Face{number + 1}" for number, face in enumerate(feature.Shape.Faces)
            if abs(face.Area - 2000) < 1 and abs(face.normalAt(0, 0).y) > 0.99}


def test_a_bar_selects_the_faces_with_those_walls_and_esc_clears(ribbed):
    feature = ribbed.Document.getObject("Ribbed")
    window.mouse_click(chart(), bar_place(6.0))
    assert selected_faces() == rib_faces(feature)
    low, high = chart().chosen
    share = share_between(parts_of(ribbed), low, high)
    assert low <= 6.0 < high and f"{100 * share:.0f}\u00a0% of the area, on 2 faces" in window.text(
        "ThinPart_ChosenShare")
    assert ribbed.ViewObject.Proxy.colours.between == (low, high)
    window.key(chart(), QtCore.Qt.Key_Escape)
    assert selected_faces() == set() and ribbed.ViewObject.Proxy.colours.between is None
    assert Gui.Control.activeDialog()


def test_a_second_click_on_a_bar_clears_and_so_does_flying(ribbed):
    window.mouse_click(chart(), bar_place(6.0))
    assert selected_faces()
    window.mouse_click(chart(), bar_place(6.0))
    assert chart().chosen is None and selected_faces() == set()
    assert ribbed.ViewObject.Proxy.colours.between is None
    window.mouse_click(chart(), bar_place(6.0))
    window.click("ThinPart_FlyButton")
    assert chart().chosen is None and ribbed.ViewObject.Proxy.colours.between is None


def test_not_measured_and_deselected_are_told_apart(ribbed):
    unmeasured = [255 * part for part in ribbed.UnmeasuredColour[:3]]
    assert min(abs(one - other) for one, other in zip(unmeasured, GREYED)) > 40


def test_dragging_over_bars_selects_all_their_faces_and_a_click_beside_clears(ribbed):
    window.mouse_drag(chart(), [bar_place(1.0), bar_place(20.0), bar_place(41.0)])
    low, high = chart().chosen
    assert low <= 1.0 and high > 41.0
    faces = set()
    part, = parts_of(ribbed)
    for face, thickness in zip(part.map.face, part.map.thickness):
        if low <= thickness < high:
            faces.add(f"Face{face + 1}")
    assert selected_faces() == faces and len(faces) > 2
    window.mouse_click(chart(), QtCore.QPoint(2, 2))
    assert chart().chosen is None and selected_faces() == set()


def test_few_walls_that_are_much_thicker_share_the_last_bar(document):
    """A cup: seen through its rim or across its bottom, it is as thick as it is high or wide."""
    cup = Part.makeCylinder(20, 130).cut(Part.makeCylinder(18, 128, V(0, 0, 2)))
    window.add(document, "Cup", cup)
    window.show_thickness()
    window.settle(300)
    thickness, = thickness_objects(document)
    shown, last = chart(), chart().count - 1
    assert thickness.Thickest == pytest.approx(130.0, rel=1e-3)
    assert shown.edges[-1] < 20.0 and np.count_nonzero(shown.shares > 0.01) >= 2
    thick = 2 * np.pi * (20 ** 2 - 18 ** 2) + 2 * np.pi * 20 * 2
    assert shown.shares[last] == pytest.approx(thick / cup.Area, rel=0.05)
    assert (shown.colours[last] == thickness.ViewObject.Proxy.colours.of_values([130.0])[0]).all()
    assert shown.bar_text(last).startswith(f"{shown.edges[last]:.3g}\u00a0mm and more: ")
    window.mouse_click(shown, bar_place(shown.edges[-2:].mean()))
    assert shown.chosen[0] < 20.0 < 130.0 < shown.chosen[1] < 131.0
    assert selected_faces() == {
        f"Face{number + 1}" for number, face in enumerate(cup.Faces)
        if face.BoundBox.ZMax > 129.0 and face.BoundBox.XLength > 39.0 or face.BoundBox.ZMax < 1.0}


@pytest.mark.parametrize("last", [0.03, 1.0, 10.0, 54.5, 137.0, 2600.0])
def test_bars_lie_around_round_values_and_reach_the_thickest_wall(last):
    edges = bar_edges(last)
    widths = np.diff(edges)
    assert edges[0] == 0.0 and edges[-1] >= last and 20 <= len(widths) <= 42
    assert widths[1:] == pytest.approx(2.0 * widths[0]) and edges[-2] < last


def test_arrows_choose_bars(ribbed):
    window.key(chart(), QtCore.Qt.Key_Right)
    window.key(chart(), QtCore.Qt.Key_Right)
    window.key(chart(), QtCore.Qt.Key_Right, QtCore.Qt.ShiftModifier)
    assert chart().bars == (1, 2)


def test_dragging_the_threshold_recolours_at_once_and_measures_nothing(ribbed):
    window.mouse_click(window.widget("ThinPart_ThinOnly"), QtCore.QPoint(8, 10))
    window.settle(50)
    assert ribbed.ThinOnly
    shown, before = chart(), ribbed.Threshold
    y = int(shown.plot().center().y())
    start = QtCore.QPoint(round(shown.x_of(shown.threshold)), y)
    aim = QtCore.QPoint(round(shown.x_of(50.0)), y)
    names, seen = window.workers, []

    class Watch:
        def slotChangedObject(self, changed, name):
            if name == "Threshold":
                seen.append((changed.Threshold, names()))

    watch = Watch()
    App.addDocumentObserver(watch)
    try:
        steps = [start + (aim - start) * (step / 6.0) for step in range(7)]
        window.mouse_drag(shown, steps)
    finally:
        App.removeDocumentObserver(watch)
    assert len(seen) > 1 and not any(running for _, running in seen)
    window.settle(300)
    # The panel may get a scroll bar meanwhile, which makes the chart narrower: the line is where the mouse was.
    plot = shown.plot()
    at_mouse = (aim.x() - plot.left()) / plot.width() * shown.edges[-1]
    chosen = ribbed.Threshold
    assert any(chosen == pytest.approx(each, rel=0.05) for each in (50.0, at_mouse))
    ribbed.Document.undo()
    window.settle(300)
    assert ribbed.Threshold == pytest.approx(before)
    ribbed.Document.redo()
    window.settle(300)
    assert ribbed.Threshold == chosen
    share = share_between(parts_of(ribbed), 0.0, ribbed.Threshold)
    assert f"{100 * share:.0f}\u00a0%" in window.text("ThinPart_ThinShare")
    assert window.widget("ThinPart_Threshold").value() == pytest.approx(ribbed.Threshold, abs=1e-3)
    table = window.widget("ThinPart_FaceTable")
    assert max(row.summary.thin_share for row in table.rows) == pytest.approx(1.0, abs=1e-6)
    colours = ribbed.ViewObject.Proxy.colours.of_values([49.0, 60.0])
    assert (colours[1] == 205).all() and not (colours[0] == 205).all()


def test_a_threshold_as_share_of_the_diagonal(ribbed):
    field, unit = window.widget("ThinPart_Threshold"), window.widget("ThinPart_ThresholdUnit")
    unit.setCurrentIndex(1)
    field.setValue(0.1)
    window.settle(50)
    assert ribbed.Threshold == pytest.approx(0.1 * ribbed.Diagonal)


def test_the_scale_changes_map_bars_and_can_be_undone(ribbed):
    before = chart().colours.copy()
    combo = window.widget("ThinPart_ColourMap")
    combo.setCurrentIndex(combo.findData("magma"))
    window.settle(50)
    assert ribbed.ColourMap == "magma" and (chart().colours != before).any()
    window.widget("ThinPart_AutomaticRange").click()
    window.widget("ThinPart_High").setValue(20.0)
    window.widget("ThinPart_Bands").setValue(4)
    window.widget("ThinPart_Reversed").click()
    window.settle(50)
    assert (ribbed.AutomaticRange, ribbed.High, ribbed.Bands, ribbed.Reversed) == (False, 20.0, 4, True)
    Gui.runCommand("Std_Undo")
    window.settle(50)
    assert not ribbed.Reversed and not window.widget("ThinPart_Reversed").isChecked()


def test_the_table_of_faces_sorts_by_every_column_and_selects_both_ways(ribbed):
    table = window.widget("ThinPart_FaceTable")
    feature = ribbed.Document.getObject("Ribbed")
    assert len(table.rows) == len(feature.Shape.Faces)
    for column in range(table.model().columnCount()):
        for order in (QtCore.Qt.DescendingOrder, QtCore.Qt.AscendingOrder):
            table.sortByColumn(column, order)
            keys = [table.model().columns[column].sort_key(row) for row in table.rows]
            keys = [key for key in keys if key is not None]
            assert keys == sorted(keys, reverse=order == QtCore.Qt.DescendingOrder)
    table.sortByColumn(1, QtCore.Qt.AscendingOrder)
    assert {row.name for row in table.rows[:2]} == rib_faces(feature)
    place = table.visualRect(table.model().index(0, 0)).center()
    window.mouse_click(table.viewport(), place)
    assert selected_faces() == {table.rows[0].name}
    assert ribbed.ViewObject.Proxy.colours.faces == {0: {table.rows[0].summary.face}}
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(ribbed.Document.Name, "Ribbed", "Face3")
    assert table.current_row.name == "Face3"
    assert ribbed.ViewObject.Proxy.colours.faces == {0: {2}}


def test_a_click_on_the_map_in_the_view_selects_the_row_of_its_face(ribbed):
    feature, table = ribbed.Document.getObject("Ribbed"), window.widget("ThinPart_FaceTable")
    top = max(range(len(feature.Shape.Faces)), key=lambda face: feature.Shape.Faces[face].CenterOfMass.z)
    view = Gui.getDocument(ribbed.Document.Name).ActiveView
    view.viewTop()
    view.fitAll()
    window.settle(300)
    viewport = view.graphicsView().viewport()
    window.mouse_drag(viewport, [viewport.rect().center()])
    window.settle(100)
    assert table.current_row is not None and table.current_row.summary.face == top


def test_the_camera_flies_to_the_thinnest_wall(ribbed):
    view = Gui.getDocument(ribbed.Document.Name).ActiveView
    view.viewAxonometric()
    view.fitAll()
    window.settle(100)
    height = view.getCameraNode().height.getValue()
    window.click("ThinPart_FlyButton")
    window.settle(900)
    camera = view.getCameraNode()
    focus = view.getCameraNode().position.getValue().getValue()
    look = view.getViewDirection()
    focus = V(*focus) + look * camera.focalDistance.getValue()
    # In the middle of what no dock of FreeCAD's lies over.
    near, direction = (V(*each) for each in line_of_sight(view, free_area(view.graphicsView().viewport()).center()))
    middle = near + direction * ((focus - near).dot(look) / direction.dot(look))
    assert camera.height.getValue() < height and abs(middle.y - 30.0) == pytest.approx(3.0, abs=0.2) and middle.z > 40.0


def test_probes_are_pinned_listed_visited_and_removed(ribbed):
    view = Gui.getDocument(ribbed.Document.Name).ActiveView
    view.viewTop()
    view.fitAll()
    window.settle(300)
    window.click("ThinPart_ProbeButton")
    viewport = view.graphicsView().viewport()
    middle = viewport.rect().center()
    for count, place in enumerate((middle, middle + QtCore.QPoint(40, 0))):
        window.mouse_drag(viewport, [place])
        window.wait_until(lambda count=count: len(probes_of(ribbed)) == count + 1)
    assert [round(probe.value) for probe in probes_of(ribbed)] == [60, 60]
    table = window.widget("ThinPart_ProbeTable")
    window.wait_until(lambda: len(table.rows) == 2)
    assert [row.number for row in table.rows] == [0, 1]
    window.click("ThinPart_ProbeButton")
    view.viewAxonometric()
    window.settle(100)
    view.fitAll()
    window.settle(100)
    before = view.getCameraNode().height.getValue()
    table.activated.emit(table.model().index(1, 0))
    window.settle(900)
    assert view.getCameraNode().height.getValue() != pytest.approx(before, rel=0.01)
    table.selectRow(0)
    window.click("ThinPart_RemoveProbe")
    window.wait_until(lambda: len(table.rows) == 1)
    assert len(probes_of(ribbed)) == 1
    window.click("ThinPart_ClearProbes")
    window.wait_until(lambda: not table.rows)
    assert probes_of(ribbed) == [] and not window.widget("ThinPart_ClearProbes").isEnabled()
    Gui.runCommand("Std_Undo")
    window.wait_until(lambda: len(table.rows) == 1)


def test_a_mesh_has_no_faces_to_select_and_is_shown_all_the_same(document):
    import Mesh

    document.addObject("Mesh::Feature", "Soup").Mesh = Mesh.createBox(40, 30, 4)
    window.show_thickness()
    window.mouse_click(chart(), bar_place(4.0))
    assert selected_faces() == set() and "of the area" in window.text("ThinPart_ChosenShare")


def test_every_field_is_reached_by_tab(ribbed):
    wanted = {"ThinPart_FlyButton", "ThinPart_ThicknessChart", "ThinPart_Threshold", "ThinPart_ThinOnly",
              "ThinPart_ColourMap", "ThinPart_Bands", "ThinPart_Logarithmic", "ThinPart_Shaded",
              "ThinPart_RegionsTable", "ThinPart_ProbeButton", "ThinPart_ProbeTable"}
    begun = window.widget("ThinPart_FlyButton")
    names, each = set(), begun
    while True:
        each = each.nextInFocusChain()
        if each is begun:
            break
        if each.isVisible() and each.focusPolicy() & QtCore.Qt.TabFocus:
            names.add(each.objectName())
    assert wanted <= names | {"ThinPart_FlyButton"}
    assert "ThinPart_FaceTable" not in names, "regions come first, faces are folded"


@pytest.mark.parametrize("larger", [1.0, 1.5])
def test_nothing_is_cut_off_at_300_pixels(ribbed, larger):
    for name in ("ThinPart_ThicknessHead", "ThinPart_DistributionBox", "ThinPart_ScaleBox",
                 "ThinPart_FaceBox", "ThinPart_ProbeBox"):
        box = window.widget(name)
        font = box.font()
        font.setPointSizeF(font.pointSizeF() * larger)
        box.setFont(font)
        window.settle(20)
        assert box.minimumSizeHint().width() <= 300 - 36, name
        box.setParent(None)
        box.resize(264, 600)
        box.show()
        window.settle(50)
        for label in box.findChildren(QtWidgets.QLabel):
            if label.isVisible() and label.wordWrap():
                assert label.height() >= label.heightForWidth(label.width()) - 1, label.objectName()
        for button in box.findChildren(QtWidgets.QAbstractButton):
            if button.isVisible() and button.text():
                assert button.width() >= button.minimumSizeHint().width(), button.text()
        box.hide()
        box.deleteLater()


FIELDS = ("Threshold", "ThresholdUnit", "Low", "High", "RangeUnit", "ColourMap", "Bands")


def test_the_wheel_scrolls_the_panel_and_changes_no_field(ribbed):
    def shown(field):
        return field.currentIndex() if isinstance(field, QtWidgets.QComboBox) else field.value()

    chart().setFocus()
    for name in FIELDS:
        field = window.widget(f"ThinPart_{name}")
        before = shown(field)
        for turn in (120, -120):
            place = QtCore.QPointF(4, 4)
            QtWidgets.QApplication.sendEvent(field, QtGui.QWheelEvent(
                place, place, QtCore.QPoint(), QtCore.QPoint(0, turn), QtCore.Qt.NoButton, QtCore.Qt.NoModifier,
                QtCore.Qt.NoScrollPhase, False))
            assert shown(field) == before, name


def test_the_unit_of_the_threshold_is_not_cut_off(ribbed):
    unit = window.widget("ThinPart_ThresholdUnit")
    widest = max(unit.fontMetrics().boundingRect(unit.itemText(index)).width() for index in range(unit.count()))
    inner = unit.style().subControlRect(
        QtWidgets.QStyle.CC_ComboBox, _option_of(unit), QtWidgets.QStyle.SC_ComboBoxEditField, unit)
    assert inner.width() >= widest


def _option_of(combo):
    option = QtWidgets.QStyleOptionComboBox()
    option.initFrom(combo)
    option.editable = combo.isEditable()
    option.subControls = QtWidgets.QStyle.SC_All
    return option

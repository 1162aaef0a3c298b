# SPDX-License-Identifier: LGPL-2.1-or-later
"""The thickness under the mouse, and probes."""

import FreeCAD as App
import FreeCADGui as Gui
import numpy as np
import Part
import pytest
import window_actions as window
from thickness_window import (
    click_at,
    look_at,
    move_to,
    picture,
    pixel,
    place_of,
    show_map,
    view_of,
    widget_of,
)
from window_actions import V

from thinpart_workbench.freecad_adapter.objects.thickness_object import thickness_objects
from thinpart_workbench.gui.application.length_unit import MILLIMETRE
from thinpart_workbench.gui.application.qt import QtCore
from thinpart_workbench.gui.view3d.picking import (
    ThicknessPicker,
    probe_ends,
    remove_probe,
)
from thinpart_workbench.gui.view3d.wall_flight import PlacedWall, WallFlight


@pytest.fixture
def block(document):
    document.UndoMode = 1
    return window.add_ribbed_block(document)


@pytest.fixture
def picker(block):
    picker = ThicknessPicker(show_map(block.Document, block))
    picker.start()
    yield picker
    picker.stop()


def _hovered(picker, view, point):
    told = []
    picker.hovered.connect(told.append)
    move_to(view, place_of(view, point))
    window.wait_until(lambda: told)
    picker.hovered.disconnect(told.append)
    return told[-1]


def test_the_wall_under_the_cursor(picker, document):
    view = view_of(document)
    for point, value in (((50, 27, 52), 6.0), ((60, 12, 40), 40.0), ((60, 57, 40), 40.0),
                         ((50, 0, 20), 60.0)):
        wall = _hovered(picker, view, V(*point))
        assert wall["thickness"] == pytest.approx(value, abs=1e-3)
        assert np.linalg.norm(wall["point"] - point) < 1.0
        assert np.linalg.norm(wall["point"] - wall["opposite"]) == pytest.approx(value, abs=1e-3)
        assert window.text("ThinPart_Hover") == f"{value:g}\u00a0mm"
    view.viewBottom()
    view.fitAll()
    window.settle(60)
    assert _hovered(picker, view, V(50, 30, 0))["thickness"] == pytest.approx(60.0, abs=1e-3)  # over the rib
    assert _hovered(picker, view, V(50, 20, 0))["thickness"] == pytest.approx(40.0, abs=1e-3)  # beside it
    told = []
    picker.hovered.connect(told.append)
    move_to(view, QtCore.QPoint(widget_of(view).width() - 3, 3))
    window.wait_until(lambda: told)
    assert told == [None] and not window.is_shown("ThinPart_Hover")


def test_what_stands_before_the_map_hides_it(picker, document):
    view = view_of(document)
    place = place_of(view, V(60, 12, 40))
    assert picker.wall_at(view, place)["thickness"] == pytest.approx(40.0, abs=1e-3)
    screen = window.add(document, "Screen", Part.makeBox(4, 4, 4, V(86, -18, 66)))
    window.wait_until(lambda: picker.wall_at(view, place) is None)  # once the view is drawn anew
    screen.ViewObject.Visibility = False
    assert picker.wall_at(view, place) is not None
    behind = window.add(document, "Behind", Part.makeBox(4, 4, 4, V(20, 50, -20)))
    assert behind.ViewObject.Visibility and picker.wall_at(view, place) is not None


def test_a_click_pins_what_is_there_and_selects_nothing(picker, document, tmp_path):
    thickness, view = document.Thickness, view_of(document)
    place = place_of(view, V(50, 27, 52))
    before = picture(view, tmp_path)
    click_at(view, place)
    window.wait_until(lambda: thickness.ProbeValues)
    assert thickness.ProbeValues == pytest.approx([6.0], abs=1e-4)
    assert thickness.ProbePoints[0].y == pytest.approx(27.0) and thickness.ProbeOpposites[0].y == (
        pytest.approx(33.0, abs=1e-4))
    assert Gui.Selection.getSelection() == []
    # Away from the place, where the line through the wall under the mouse is drawn like a probe.
    move_to(view, QtCore.QPoint(3, 3))
    window.wait_until(lambda: not window.is_shown("ThinPart_Hover"))
    assert pixel(picture(view, tmp_path), place) != pixel(before, place)
    document.undo()
    assert thickness.ProbeValues == []
    assert pixel(picture(view, tmp_path), place) == pixel(before, place)
    document.redo()
    assert len(thickness.ProbeValues) == 1
    remove_probe(thickness, 0)
    assert thickness.ProbePoints == [] and thickness.ProbeOpposites == []
    document.undo()
    assert len(thickness.ProbePoints) == 1
    document.saveAs(str(tmp_path / "part.FCStd"))
    App.closeDocument(document.Name)
    window.settle()
    again = App.openDocument(str(tmp_path / "part.FCStd"))
    view = look_at(again)
    thickness, = thickness_objects(again)
    assert thickness.ProbeValues == pytest.approx([6.0], abs=1e-4)
    assert pixel(picture(view, tmp_path), place_of(view, thickness.ProbePoints[0])) == (217, 0, 89)


def test_a_drag_is_no_click(picker, document):
    thickness, view = document.Thickness, view_of(document)
    place = place_of(view, V(60, 12, 40))
    click_at(view, place, to=place + QtCore.QPoint(40, 10))
    window.settle(100)
    assert thickness.ProbeValues == []


def test_without_the_picker_a_click_selects_and_pins_nothing(picker, document):
    thickness, view = document.Thickness, view_of(document)
    picker.stop()
    click_at(view, place_of(view, V(60, 12, 40)))
    window.wait_until(Gui.Selection.getSelection)
    assert Gui.Selection.getSelection() == [thickness] and thickness.ProbeValues == []
    assert not window.is_shown("ThinPart_Hover")


def test_a_part_that_stands_at_three_places(document):
    feature = window.add(document, "Plate", Part.makeBox(40, 30, 2))
    places = [App.Placement(V(0, 0, 0), App.Rotation()), App.Placement(V(80, 0, 5), App.Rotation(90, 0, 0)),
              App.Placement(V(0, 80, -5), App.Rotation(V(1, 0, 0), 180))]
    links = []
    for place in places[1:]:
        link = document.addObject("App::Link", "Copy")
        link.LinkedObject, link.Placement = feature, place
        links.append(link)
    document.recompute()
    thickness = show_map(document, feature, *links)
    view = view_of(document)
    picker = ThicknessPicker(thickness)
    picker.start()
    try:
        seen = set()
        for place in places:
            top = place.multVec(V(20, 15, 2)) if place.Rotation.Angle < 3 else place.multVec(V(20, 15, 0))
            wall = _hovered(picker, view, top)
            assert wall["thickness"] == pytest.approx(2.0, abs=1e-4)
            assert wall["opposite"][2] == pytest.approx(top.z - 2.0, abs=1e-3)
            seen.add(wall["placement"])
        assert seen == {0, 1, 2}
        for place in places[1:]:
            click_at(view, place_of(view, place.multVec(V(20, 15, 1))))
        window.wait_until(lambda: len(thickness.ProbeValues) == 2)
    finally:
        picker.stop()


def test_a_probe_goes_with_its_part(picker, block, document):
    thickness, view = document.Thickness, view_of(document)
    block.Placement.Base = V(0, 0, 200)
    document.recompute()
    view.fitAll()
    window.settle(60)
    click_at(view, place_of(view, V(60, 12, 240)))
    window.wait_until(lambda: thickness.ProbeValues)
    point, opposite = probe_ends(thickness, 0)
    assert (point[2], opposite[2]) == pytest.approx((240.0, 200.0), abs=1e-3)
    block.Placement.Base = V(0, 0, 0)
    document.recompute()
    assert probe_ends(thickness, 0)[0][2] == pytest.approx(40.0, abs=1e-3)


@pytest.mark.parametrize("camera", ["Orthographic", "Perspective"])
def test_the_camera_flies_to_a_wall(picker, document, camera):
    view = view_of(document)
    view.setCameraType(camera)
    view.fitAll()
    window.settle(60)
    assert _hovered(picker, view, V(60, 12, 40))["thickness"] == pytest.approx(40.0, abs=1e-3)
    ends = V(50, 27, 52), V(50, 33, 52)
    WallFlight().fly(document, PlacedWall(6.0, [ends]), document.Thickness.Diagonal, MILLIMETRE)
    window.settle(600)
    height = widget_of(view).height()
    seen = [place_of(view, each) for each in ends]
    assert all(0.2 * height < each.y() < 0.8 * height for each in seen)
    assert (seen[0] - seen[1]).manhattanLength() > 0.1 * height
    direction = view.getViewDirection()
    assert 0.3 < abs(direction.y) < 0.9  # from outside, at an angle


def test_a_view_that_is_closed_under_the_mouse_is_left_alone(picker, document):
    view = view_of(document)
    _hovered(picker, view, V(50, 27, 52))
    move_to(view, place_of(view, V(60, 12, 40)))
    App.closeDocument(document.Name)
    window.settle(100)
    picker.stop()  # by whoever started it

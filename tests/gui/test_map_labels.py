# SPDX-License-Identifier: LGPL-2.1-or-later
"""Labels of a thickness map in the 3D view: which walls have one, where it stands, and what hides it."""

import itertools
from dataclasses import replace

import FreeCAD as App
import numpy as np
import Part
import pytest
import window_actions as window
from thickness_window import look_at, picture, show_map, view_of
from window_actions import V

from thinpart_workbench.api.document_maps import parts_of
from thinpart_workbench.core.maps.map_section import SectionPlane
from thinpart_workbench.freecad_adapter.objects.thickness_object import thickness_objects
from thinpart_workbench.freecad_adapter.preferences import set_preference
from thinpart_workbench.gui.application import lifelong
from thinpart_workbench.gui.colour_bar.bar_handle import is_on_bar
from thinpart_workbench.gui.view3d.label_node import shown_labels
from thinpart_workbench.gui.view3d.map_labels import WallsFoundLater
from thinpart_workbench.gui.view3d.picking import add_probe


@pytest.fixture(autouse=True)
def at_first():
    """What is shown in views is as at first, before and after."""
    names = ("MapLabels", "ColourBarShown", "ColourBarAcross", "ColourBarDown", "ColourBarSize")
    for name in names:
        set_preference(name, None)
    yield
    for name in names:
        set_preference(name, None)


@pytest.fixture
def thickness(document):
    """The map of a block with a rib along its middle, seen from a corner."""
    document.UndoMode = 1
    return show_map(document, window.add_ribbed_block(document))


def texts(thickness):
    """What the labels in the window say."""
    return {text for text, _, _ in shown_labels(view_of(thickness.Document))}


def wait_for(thickness, expected):
    """Wait until the labels say something."""
    window.wait_until(lambda: texts(thickness) == expected, lambda: f"labels {expected}; there are {texts(thickness)}")


def look(thickness, direction, up=(0, 0, 1)):
    """Turn the camera, all of the part being in the view."""
    view = view_of(thickness.Document)
    right = V(*direction).cross(V(*up))
    view.setCameraOrientation(App.Rotation(right, right.cross(V(*direction)), V(*direction) * -1, "ZXY"))
    view.fitAll()
    return view


def test_the_thinnest_and_the_thickest_wall_have_labels_beside_their_places(thickness):
    wait_for(thickness, {"min 6\u00a0mm", "thickest wall 100\u00a0mm"})
    view = view_of(thickness.Document)
    for text, rect, place in shown_labels(view):
        assert not rect.adjusted(-2, -2, 2, 2).contains(place), text
        assert rect.intersected(view.graphicsView().viewport().rect()) == rect, text


def test_pinned_walls_have_numbers_and_labels_do_not_overlap(thickness):
    for x in (20.0, 25.0, 30.0, 35.0, 40.0):
        add_probe(thickness, (x, 0.0, 20.0), (x, 60.0, 20.0), 60.0)
    wait_for(thickness, {"min 6\u00a0mm", "thickest wall 100\u00a0mm", *(f"{number}: 60\u00a0mm" for number in range(1, 6))})
    found = shown_labels(view_of(thickness.Document))
    for (_, one, _), (_, other, _) in itertools.combinations(found, 2):
        assert not one.intersects(other)
    widget = view_of(thickness.Document).graphicsView().viewport()
    for _, rect, _ in found:
        for corner in (rect.topLeft(), rect.bottomRight(), rect.topRight(), rect.bottomLeft()):
            assert not is_on_bar(widget, corner)
    thickness.Document.undo()
    window.wait_until(lambda: "5: 60\u00a0mm" not in texts(thickness))


def test_a_label_hides_behind_the_part(thickness):
    add_probe(thickness, (20.0, 0.0, 20.0), (20.0, 0.1, 20.0), 0.1)
    wait_for(thickness, {"min 6\u00a0mm", "thickest wall 100\u00a0mm", "1: 0.1\u00a0mm"})
    look(thickness, (0, -1, 0))
    # From behind, the place in front is hidden; the sides of the rib are seen, and so is a rear end of the block.
    window.wait_until(lambda: texts(thickness) and "1: 0.1\u00a0mm" not in texts(thickness))
    assert "min 6\u00a0mm" in texts(thickness)
    look(thickness, (0, 0, 1), (0, 1, 0))  # from below, the rib is hidden
    window.wait_until(lambda: "min 6\u00a0mm" not in texts(thickness))
    look(thickness, (0, 1, 0))
    window.wait_until(lambda: {"1: 0.1\u00a0mm", "min 6\u00a0mm"} <= texts(thickness))


@pytest.mark.parametrize("camera", ["Perspective", "Orthographic"])
def test_another_object_hides_a_label_and_uncovers_it(thickness, camera):
    view = look(thickness, (0, 1, 0))
    view.setCameraType(camera)
    window.wait_until(lambda: "min 6\u00a0mm" in texts(thickness))
    wall = window.add(thickness.Document, "Wall", Part.makeBox(300, 5, 300, V(-100, -50, -100)))
    window.wait_until(lambda: texts(thickness) == set())
    wall.ViewObject.Visibility = False
    window.wait_until(lambda: "min 6\u00a0mm" in texts(thickness))


@pytest.mark.parametrize("close", [lambda document: App.closeDocument(document.Name), lambda document: document.removeObject(
    thickness_objects(document)[0].Name)], ids=["document", "map"])
def test_what_is_closed_right_after_its_view_moved(thickness, close):
    """Labels look again, a moment later, whether other objects hide their places: there are no labels any more."""
    window.add(thickness.Document, "Other", Part.makeBox(5, 5, 5, V(200, 0, 0)))
    look_at(thickness.Document)
    wait_for(thickness, {"min 6\u00a0mm", "thickest wall 100\u00a0mm"})
    for direction in ((0, 0, -1), (-1, 0, 0), (0, 1, 0)):
        look(thickness, direction, (0, 1, 0) if direction[2] else (0, 0, 1))
        window.settle(30)
    close(thickness.Document)
    window.settle(500)  # FreeCAD crashed here


def test_what_is_cut_off_has_no_label_and_hides_none(thickness):
    view = look(thickness, (0, 1, 0))
    window.wait_until(lambda: "min 6\u00a0mm" in texts(thickness))
    proxy = thickness.ViewObject.Proxy
    proxy.section = SectionPlane((0.0, 0.0, 1.0), 30.0)
    window.wait_until(lambda: "min 6\u00a0mm" not in texts(thickness))
    proxy.section = None
    window.wait_until(lambda: "min 6\u00a0mm" in texts(thickness))
    # FreeCAD's own clipping plane, which cuts off the rib the one way, and the block the other way.
    found = []
    for way in (1, -1):
        view.toggleClippingPlane(1, pla=App.Placement(V(0, 0, 42), App.Rotation(V(0, 0, 1), V(0, 0, way))))
        window.settle(300)
        found.append("min 6\u00a0mm" in texts(thickness))
        view.toggleClippingPlane(0)
        window.wait_until(lambda: "min 6\u00a0mm" in texts(thickness))
    assert sorted(found) == [False, True]


def test_labels_are_hidden_and_come_back_with_the_box_in_the_panel(document, tmp_path):
    window.add_ribbed_block(document)
    window.show_thickness()
    thickness, = thickness_objects(document)
    view = look_at(document)
    window.wait_until(lambda: "min 6\u00a0mm" in texts(thickness))
    before = picture(view, tmp_path)
    box = window.widget("ThinPart_MapLabels")
    assert box.isChecked()
    box.setChecked(False)
    window.wait_until(lambda: texts(thickness) == set())
    assert picture(view, tmp_path) != before
    # The next map has none either.
    window.show_thickness()
    window.settle(200)
    assert texts(thickness) == set() and not window.widget("ThinPart_MapLabels").isChecked()
    window.widget("ThinPart_MapLabels").setChecked(True)
    window.wait_until(lambda: "min 6\u00a0mm" in texts(thickness))


def test_a_saved_picture_of_another_size_has_labels_too(thickness, tmp_path):
    wait_for(thickness, {"min 6\u00a0mm", "thickest wall 100\u00a0mm"})
    view = view_of(thickness.Document)
    shown = shown_labels(view)
    with_labels = picture(view, tmp_path, 900, 500)
    set_preference("MapLabels", False)
    lifelong.map_events.refresh_soon()
    window.wait_until(lambda: texts(thickness) == set())
    without = picture(view, tmp_path, 900, 500)
    different = sum(with_labels.pixel(x, y) != without.pixel(x, y) for x in range(0, 900, 3) for y in range(0, 500, 3))
    assert 50 < different < 3000
    set_preference("MapLabels", True)
    lifelong.map_events.refresh_soon()
    window.wait_until(lambda: shown_labels(view) == shown)


def test_balls_have_the_thickest_place_and_the_ball_of_the_thinnest_wall(document):
    window.add_ribbed_block(document)
    window.show_thickness()
    thickness, = thickness_objects(document)
    look_at(document)
    window.widget("ThinPart_Measure").setCurrentIndex(1)
    window.wait_until(lambda: thickness.Measure != "ray" and window.is_thickness_told())
    window.wait_until(lambda: any(text.startswith("thickest wall 4") for text in texts(thickness)))
    least = next(float(text.split()[1]) for text in texts(thickness) if text.startswith("min"))
    assert least == pytest.approx(6.0, rel=0.05)


def test_a_large_map_gets_its_labels_later_from_a_thread(document):
    window.add_ribbed_block(document)
    thickness = show_map(document, *document.Objects)
    part, = parts_of(thickness)
    copies = np.tile(np.eye(4), (2, 1, 1))
    calls = []
    later = WallsFoundLater([replace(part, matrices=copies)] * (120_000 // part.map.count + 1), lambda: calls.append(1))
    assert later.found is None
    window.wait_until(lambda: calls == [1])
    assert later.found.thinnest.value == pytest.approx(6.0, rel=1e-3)
    # Few facets are looked through at once.
    assert WallsFoundLater([part], None).found.thickest.value == pytest.approx(100.0, rel=1e-3)


def test_the_flight_to_a_wall_replaces_its_label(document):
    window.add_ribbed_block(document)
    window.show_thickness()
    thickness, = thickness_objects(document)
    look_at(document)
    window.wait_until(lambda: "min 6\u00a0mm" in texts(thickness))
    window.click("ThinPart_FlyButton")
    view = view_of(document)
    window.wait_until(lambda: [text for text, _, _ in shown_labels(view, "ThinPart_MarkLabels")] == ["6\u00a0mm"])
    window.wait_until(lambda: "min 6\u00a0mm" not in texts(thickness))
    (_, mark, place), = shown_labels(view, "ThinPart_MarkLabels")
    assert not mark.contains(place)
    assert not any(rect.intersects(mark) for _, rect, _ in shown_labels(view))

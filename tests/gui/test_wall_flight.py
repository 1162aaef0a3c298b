# SPDX-License-Identifier: LGPL-2.1-or-later
"""Flights to a wall: it is in the middle of the view, nothing stands before it, and it is marked with its thickness."""

import FreeCAD as App
import FreeCADGui as Gui
import numpy as np
import Part
import pytest
import window_actions as window
from thickness_window import look_at, view_of, widget_of
from window_actions import V

from thinpart_workbench.api.document_maps import parts_of
from thinpart_workbench.core.record.region_groups import region_groups
from thinpart_workbench.freecad_adapter.objects.thickness_object import thickness_objects
from thinpart_workbench.gui.application.length_unit import MILLIMETRE
from thinpart_workbench.gui.application.qt import QtCore
from thinpart_workbench.gui.document.free_area import free_area
from thinpart_workbench.gui.scene.drawn_triangles import drawn_triangles
from thinpart_workbench.gui.scene.view_ray import first_object
from thinpart_workbench.gui.view3d.label_node import MARK, shown_labels
from thinpart_workbench.gui.view3d.wall_flight import PlacedWall, WallFlight


def deep_pocket():
    """A block with a deep pocket whose floor is 0.5 thick, on a foot that hides the floor's lower side."""
    block = Part.makeBox(60, 60, 40).cut(Part.makeBox(16, 16, 39.5, V(22, 22, 0.5)))
    return block.fuse(Part.makeBox(60, 60, 5, V(0, 0, -8))).fuse(
        Part.makeBox(60, 5, 3, V(0, 0, -3))).fuse(Part.makeBox(60, 5, 3, V(0, 55, -3))).fuse(
        Part.makeBox(5, 60, 3, V(0, 0, -3))).fuse(Part.makeBox(5, 60, 3, V(55, 0, -3)))


def u_with_rib():
    """A channel with a thin rib between its two high walls."""
    return Part.makeBox(80, 40, 4).fuse(Part.makeBox(80, 4, 40)).fuse(Part.makeBox(80, 4, 40, V(0, 36, 0))).fuse(
        Part.makeBox(70, 0.6, 20, V(5, 20, 3)))


def open_box_in_box():
    """A thin cup within a thick open box."""
    outer = Part.makeBox(80, 80, 60).cut(Part.makeBox(70, 70, 55, V(5, 5, 5)))
    inner = Part.makeBox(30, 30, 30, V(25, 25, 4)).cut(Part.makeBox(29, 29, 40, V(25.5, 25.5, 9)))
    return outer.fuse(inner)


def closed_box_with_rib():
    """A thin rib within a closed box."""
    return Part.makeBox(60, 60, 60).cut(Part.makeBox(50, 50, 50, V(5, 5, 5))).fuse(
        Part.makeBox(50, 0.8, 50.2, V(5, 30, 4.9)))


def all_texts(document):
    """The labels of the mark in the view, [] without one."""
    return [text for text, _, _ in shown_labels(view_of(document), MARK)]


def seen_in_the_middle(document):
    """What Coin picks in the middle of the view."""
    view = view_of(document)
    return first_object(view, free_area(widget_of(view)).center())[1]


def fly(document, press=None):
    """Fly by the button, or by what is given, and wait until the camera has arrived."""
    if press is None:
        window.widget("ThinPart_FlyButton").click()
    else:
        press()
    arrive(document)


def arrive(document):
    """Wait until the camera stands still, which takes longer than the flight where the machine is busy."""
    window.settle(400)
    last = [None, None]

    def stands_still():
        last[:] = last[1], view_of(document).getCamera()
        window.settle(150)
        return last[0] == last[1]

    window.wait_until(stands_still)


def mapped(document, camera="Orthographic"):
    """The map of a document, its panel open."""
    view = look_at(document)
    view.setCameraType(camera)
    view.fitAll()
    window.show_thickness()
    window.settle(400)
    thickness, = thickness_objects(document)
    return thickness


def thinnest_of(thickness):
    """Thickness of the thinnest wall that the record has, and ends of lines through it: each of its faces has one."""
    witnesses = [face["witness"] for part in parts_of(thickness) for face in part.record["faces"] if face["witness"]]
    least = min(witness["distance"] for witness in witnesses)
    return least, [end for witness in witnesses if witness["distance"] < least * (1.0 + 1e-6) for end in witness["points"]]


def is_near_wall(place, value, ends, tolerance):
    """Whether a place is at one end of a wall."""
    return place is not None and min(np.linalg.norm(np.array(place) - end) for end in np.array(ends)) <= tolerance


@pytest.mark.parametrize("camera", ["Orthographic", "Perspective"])
@pytest.mark.parametrize("make, value", [(deep_pocket, 0.5), (u_with_rib, 0.6), (open_box_in_box, 0.5)])
def test_the_thinnest_wall_is_what_one_sees(document, make, value, camera):
    window.add(document, "Part", make())
    thickness = mapped(document, camera)
    least, ends = thinnest_of(thickness)
    assert least == pytest.approx(value, rel=1e-3)
    fly(document)
    assert is_near_wall(seen_in_the_middle(document), least, ends, 0.05 * value + 1e-3 * thickness.Diagonal)
    assert all_texts(document) == [MILLIMETRE.text(least)]
    assert MILLIMETRE.text(least) in window.text("ThinPart_Walls")
    assert not window.is_shown("ThinPart_FlightText")


def test_a_wall_within_a_closed_box_is_marked_and_said_to_be_hidden(document):
    window.add(document, "Box", closed_box_with_rib())
    thickness = mapped(document)
    least, ends = thinnest_of(thickness)
    assert least == pytest.approx(0.8, rel=1e-3)
    fly(document)
    assert not is_near_wall(seen_in_the_middle(document), least, ends, 1.0)
    assert "clipping plane" in window.text("ThinPart_FlightText")
    assert all_texts(document) == [MILLIMETRE.text(least)]


def test_another_part_that_covers_the_wall_is_avoided_and_one_that_is_hidden_is_not(document):
    window.add(document, "Part", u_with_rib())
    lid = window.add(document, "Lid", Part.makeBox(100, 200, 2, V(-10, -80, 41)))
    thickness = mapped(document)
    wall = PlacedWall(0.6, [(V(40, 20, 15), V(40, 20.6, 15))])
    flight = WallFlight()
    fly(document, lambda: flight.fly(document, wall, thickness.Diagonal, MILLIMETRE))
    assert is_near_wall(seen_in_the_middle(document), 0.6, wall.places[0], 0.2)
    flight.clear()
    thickness.ViewObject.Visibility = lid.ViewObject.Visibility = False
    window.settle(100)
    drawn = drawn_triangles(view_of(document).getSceneGraph())
    assert drawn[:, :, 2].max() == pytest.approx(40.0)


def test_a_place_linked_part_is_seen_where_it_stands(document):
    feature = window.add(document, "Part", u_with_rib())
    feature.ViewObject.Visibility = False
    holder = document.addObject("App::Part", "Holder")
    link = document.addObject("App::Link", "Link")
    link.LinkedObject = feature
    link.Placement = App.Placement(V(10, 0, 5), App.Rotation(V(0, 0, 1), 90))
    holder.addObject(link)
    holder.Placement = App.Placement(V(200, 100, 0), App.Rotation(V(1, 0, 0), 30))
    wall = window.add(document, "Screen", Part.makeBox(300, 2, 200, V(50, 40, -50)))
    document.recompute()
    matrix = holder.Placement.multiply(link.Placement)
    ends = [tuple(matrix.multVec(end)) for end in (V(40, 20, 15), V(40, 20.6, 15))]
    view = look_at(document)
    flight = WallFlight()
    assert flight.fly(document, PlacedWall(0.6, [ends]), 100.0, MILLIMETRE)
    arrive(document)
    assert is_near_wall(seen_in_the_middle(document), 0.6, ends, 0.1)
    assert wall.ViewObject.Visibility and all_texts(document) == [MILLIMETRE.text(0.6)]
    flight.clear()
    assert all_texts(document) == [] and view is not None


def test_each_face_and_region_is_flown_to_and_the_next_and_previous_by_key(document):
    window.add(document, "Part", u_with_rib())
    thickness = mapped(document)
    part, = parts_of(thickness)
    tolerance = 2e-3 * thickness.Diagonal
    table = window.widget("ThinPart_FaceTable")
    for number, row in enumerate(table.rows):
        if row.summary.thinnest is None or row.summary.thinnest > 5.0:
            continue
        facet = row.summary.thinnest_facet
        middle = part.map.corners[facet].mean(axis=0) + part.map.origin
        opposite = part.map.wall_at(facet, middle)[1]
        fly(document, lambda at=number: table.activated.emit(table.model().index(at, 0)))
        if not window.is_shown("ThinPart_FlightText"):
            assert is_near_wall(seen_in_the_middle(document), row.summary.thinnest, (middle, opposite), tolerance)
        assert all_texts(document) == [MILLIMETRE.text(row.summary.thinnest)]
    regions = window.widget("ThinPart_RegionsTable")
    groups = region_groups(part.record)
    assert [group.kind for group in regions.rows] == [group.kind for group in groups] and len(groups) >= 2
    walls = sorted(wall for group in groups for wall in group.walls)
    assert walls[0][0] == pytest.approx(0.6, rel=1e-3)
    for value, ends in walls:
        fly(document, lambda: window.key(regions, QtCore.Qt.Key_N))
        assert all_texts(document) == [MILLIMETRE.text(value)]
        assert is_near_wall(seen_in_the_middle(document), value, ends, tolerance)
    fly(document, lambda: window.key(regions, QtCore.Qt.Key_P))
    assert all_texts(document) == [MILLIMETRE.text(walls[-2][0])]


def test_keys_of_the_head_go_from_the_thinnest_wall_on_and_back(document):
    window.add(document, "Part", u_with_rib())
    thickness = mapped(document)
    part, = parts_of(thickness)
    pairs = {}
    for face in part.record["faces"]:
        if face["witness"]:
            key = frozenset((face["face"], face["witness"]["opposite_face"]))
            pairs[key] = min(face["witness"]["distance"], pairs.get(key, np.inf))
    values = [MILLIMETRE.text(value) for value in sorted(pairs.values())]
    button = window.widget("ThinPart_FlyButton")
    fly(document)
    shown = [all_texts(document)[0]]
    for code in (QtCore.Qt.Key_N, QtCore.Qt.Key_N, QtCore.Qt.Key_P):
        fly(document, lambda code=code: window.key(button, code))
        shown += all_texts(document)
    assert shown == [values[0], values[1], values[2], values[1]]


def test_the_mark_goes_with_the_panel(document):
    window.add(document, "Part", u_with_rib())
    mapped(document)
    fly(document)
    assert len(all_texts(document)) == 1

    Gui.Control.closeDialog()
    window.settle(100)
    assert all_texts(document) == []


def test_regions_of_a_classified_part_are_flown_to(document):
    window.add(document, "Part", u_with_rib())
    look_at(document)
    window.classify()
    regions = window.widget("ThinPart_RegionsTable")
    fly(document, lambda: window.key(regions, QtCore.Qt.Key_N))
    value, ends = min(regions.rows[0].walls)
    assert all_texts(document) == [MILLIMETRE.text(value)]
    assert is_near_wall(seen_in_the_middle(document), value, ends, 0.2)


def test_the_mark_goes_when_its_part_is_moved_or_the_map_is_removed(document):
    feature = window.add(document, "Part", u_with_rib())
    thickness = mapped(document)
    fly(document)
    assert len(all_texts(document)) == 1
    feature.Placement.Base = V(0, 0, 50)
    document.recompute()
    window.wait_until(lambda: all_texts(document) == [])
    fly(document)
    least, ends = thinnest_of(thickness)
    moved = [np.array(end) + (0, 0, 50) for end in ends]
    assert is_near_wall(seen_in_the_middle(document), least, moved, 0.2)
    document.removeObject(thickness.Name)
    window.wait_until(lambda: all_texts(document) == [])

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Large maps are drawn with fewer facets while the user moves the view, and whole when it stands still."""

import FreeCADGui as Gui
import numpy as np
import Part
import pytest
import thickness_window
import window_actions as window

from thinpart_workbench.api.document_maps import new_thickness_object
from thinpart_workbench.core.maps.mapped_part import MappedPart
from thinpart_workbench.core.maps.thickness_map import ThicknessMap
from thinpart_workbench.freecad_adapter.preferences import set_preference
from thinpart_workbench.gui.application.qt import QtCore
from thinpart_workbench.gui.view3d.facet_nodes import MANY
from thinpart_workbench.gui.view3d.view_provider import ThicknessView

PATH = [QtCore.QPoint(300 + 20 * step, 300 + 10 * step) for step in range(6)]


def torus_map(around, along):
    """A ThicknessMap of a torus, with another thickness on each side."""
    u, v = np.meshgrid(np.linspace(0, 2 * np.pi, around, endpoint=False), np.linspace(0, 2 * np.pi, along, endpoint=False),
                       indexing="ij")
    points = np.stack([(30 + 8 * np.cos(v)) * np.cos(u), (30 + 8 * np.cos(v)) * np.sin(u), 8 * np.sin(v)], -1).reshape(-1, 3)
    i, j = (each.ravel() for each in np.meshgrid(np.arange(around), np.arange(along), indexing="ij"))

    def at(a, b):
        return (a % around) * along + b % along

    facets = np.concatenate([np.stack([at(i, j), at(i + 1, j), at(i + 1, j + 1)], 1),
                             np.stack([at(i, j), at(i + 1, j + 1), at(i, j + 1)], 1)])
    thickness = np.where(points[facets].mean(axis=1)[:, 0] > 0.0, 2.0, 9.0)
    none = np.full(len(facets), -1, dtype=np.int32)
    return ThicknessMap(points.astype(np.float32), facets.astype(np.int32), thickness.astype(np.float32), none,
                        np.zeros(len(facets), dtype=np.int32))


def add_map(document, around, along):
    """Thickness object of a torus, drawn."""
    source = window.add(document, "Ring", Part.makeTorus(30, 8))
    part = MappedPart({"name": "Ring", "label": "Ring"}, torus_map(around, along))
    thickness = new_thickness_object(document, [source], [part])
    ThicknessView(thickness.ViewObject)
    thickness_window.look_at(document)
    window.settle(200)
    return thickness, part.map


@pytest.fixture
def many(document):
    """A map with more than `MANY` facets, without labels, which come a moment after it."""
    set_preference("MapLabels", False)
    thickness, shown = add_map(document, 800, 80)
    assert shown.count > MANY
    yield thickness
    set_preference("MapLabels", None)


def turn(document, is_released=True):
    """Turn the view with the mouse."""
    Gui.getDocument(document.Name).ActiveView.setNavigationType("Gui::BlenderNavigationStyle")  # the middle button turns
    widget = thickness_window.widget_of(thickness_window.view_of(document))
    window.mouse_drag(widget, PATH, QtCore.Qt.MiddleButton, is_released)


@pytest.mark.parametrize("projection", ["Orthographic", "Perspective"])
def test_few_facets_are_drawn_while_the_view_turns_and_all_when_it_stands(document, many, projection):
    thickness_window.view_of(document).setCameraType(projection)
    window.settle(50)
    view = many.ViewObject.Proxy
    camera = thickness_window.view_of(document).getCameraNode()
    before = camera.orientation.getValue().getValue()
    assert not view.is_coarse
    turn(document, is_released=False)
    assert camera.orientation.getValue().getValue() != before, "the mouse has turned the view"
    assert view.is_coarse
    window.settle(400)
    assert view.is_coarse, "the button is still pressed"
    window.mouse_release(thickness_window.widget_of(thickness_window.view_of(document)), PATH[-1], QtCore.Qt.MiddleButton)
    window.wait_until(lambda: not view.is_coarse)


def test_few_facets_look_as_all_do(document, many, tmp_path):
    view = thickness_window.view_of(document)
    whole = thickness_window.picture(view, tmp_path, 400, 300)
    many.ViewObject.Proxy.coarsen(True)
    few = thickness_window.picture(view, tmp_path, 400, 300)
    far = [(x, y) for x in range(80, 400, 4) for y in range(0, 300, 4)
           if sum(abs(a - b) for a, b in zip(thickness_window.pixel(whole, QtCore.QPoint(x, y)),
                                             thickness_window.pixel(few, QtCore.QPoint(x, y)))) > 90]
    assert len(far) < 0.02 * 80 * 75, "but for the rim, where a pixel may be of the background"
    many.ViewObject.Proxy.coarsen(False)
    assert thickness_window.picture(view, tmp_path, 400, 300) == whole


def test_colours_change_on_the_few_facets_too(document, many, tmp_path):
    view = thickness_window.view_of(document)
    many.ViewObject.Proxy.coarsen(True)
    before = thickness_window.picture(view, tmp_path, 400, 300)
    many.ColourMap = "magma" if many.ColourMap != "magma" else "viridis"
    window.settle(50)
    many.ViewObject.Proxy.coarsen(True)
    assert thickness_window.picture(view, tmp_path, 400, 300) != before


def test_a_program_that_moves_the_camera_gets_pictures_of_all_facets(document, many):
    view = thickness_window.view_of(document)
    view.viewFront()
    window.settle(50)
    view.viewTop()
    assert not many.ViewObject.Proxy.is_coarse


def test_a_small_map_is_always_whole(document):
    thickness, shown = add_map(document, 200, 40)
    assert shown.count < MANY
    turn(document, is_released=False)
    assert not thickness.ViewObject.Proxy.is_coarse


def test_what_is_isolated_stays_isolated_while_the_view_turns(document, many):
    many.ViewObject.Proxy.isolate({0: {0}})
    turn(document, is_released=False)
    assert not many.ViewObject.Proxy.is_coarse


def test_closing_the_document_while_the_view_turns(document, many):
    import FreeCAD as App

    turn(document, is_released=False)
    App.closeDocument(document.Name)
    window.settle(400)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The section plane of a thickness map: what is cut off, the edge in the colours of the walls, the fields of the panel."""

import os

import FreeCAD as App
import FreeCADGui as Gui
import numpy as np
import pytest
import window_actions as window
from thickness_window import bar_rows, click_at, look_at, move_to, picture, pixel, place_of, view_of
from window_actions import V

from thinpart_workbench.core.maps.map_section import SectionPlane
from thinpart_workbench.freecad_adapter.objects.thickness_object import thickness_objects
from thinpart_workbench.freecad_adapter.objects.thickness_probes import probes_of
from thinpart_workbench.freecad_adapter.preferences import set_preference
from thinpart_workbench.gui.application.qt import QtCore, QtWidgets
from thinpart_workbench.gui.view3d.picking import ThicknessPicker


@pytest.fixture
def ribbed(document):
    set_preference("HeatMapShading", False)
    set_preference("MapLabels", False)  # they take other places after a section, and pictures are compared
    document.UndoMode = 1
    window.add_ribbed_block(document)
    window.show_thickness()
    window.settle(300)
    look_at(document)
    thickness, = thickness_objects(document)
    yield thickness
    set_preference("HeatMapShading", None)
    set_preference("MapLabels", None)


def switch():
    """Click the box before the text: a check box has no button in the middle of a wide row."""
    box = window.widget("ThinPart_SectionOn")
    window.mouse_click(box, QtCore.QPoint(8, box.height() // 2))
    window.settle(50)


def choose(direction):
    box = window.widget("ThinPart_SectionDirection")
    box.setCurrentIndex(box.findData(direction))
    box.activated.emit(box.currentIndex())
    window.settle(50)


def test_the_plane_cuts_map_and_part_and_fills_the_material(ribbed, tmp_path):
    undo = ribbed.Document.UndoCount
    view = view_of(ribbed.Document)
    whole = picture(view, tmp_path)
    switch()
    choose("x")
    image = picture(view, tmp_path)
    folder = os.environ.get("THINPART_PICTURES")
    if folder:
        for background in ("White", "Black"):
            picture(view, tmp_path, background=background).save(os.path.join(folder, f"section {background}.png"))
        window.settle(300)
        QtWidgets.QApplication.primaryScreen().grabWindow(0).save(os.path.join(folder, "section window.png"))
    plane = ribbed.ViewObject.Proxy.section
    assert plane == SectionPlane((1.0, 0.0, 0.0), 50.0) and ribbed.Document.UndoCount == undo
    cut, off = place_of(view, V(50, 30, 20)), place_of(view, V(100, 15, 20))
    # The material is grey, hatched; where the part was cut off, what lies behind is seen.
    colours = np.array([pixel(image, cut + QtCore.QPoint(x, 0)) for x in range(-20, 21)])
    assert np.ptp(colours, axis=1).max() < 12 and np.ptp(colours[:, 0]) > 40
    assert pixel(image, off) != pixel(whole, off)
    # The edge on the flank of the rib has the colour of its wall.
    colour = ribbed.ViewObject.Proxy.colours.of_values([6.0])[0]
    edge = place_of(view, V(50, 27, 50))
    found = [pixel(image, edge + QtCore.QPoint(x, y)) for x in range(-3, 4) for y in range(-3, 4)]
    assert min(np.abs(np.subtract(each, colour.astype(int))).max() for each in found) <= 3
    assert bar_rows(image) == bar_rows(whole)
    switch()
    assert ribbed.ViewObject.Proxy.section is None
    assert picture(view, tmp_path) == whole


def test_position_side_and_direction_are_set_in_the_panel(ribbed):
    switch()
    assert ribbed.ViewObject.Proxy.section is not None
    choose("z")
    place = window.widget("ThinPart_SectionPlace")
    proxy = ribbed.ViewObject.Proxy
    assert proxy.section.normal == (0.0, 0.0, 1.0) and place.value() == pytest.approx(30.0)
    place.setValue(45.0)
    assert proxy.section == SectionPlane((0.0, 0.0, 1.0), 45.0)
    window.click("ThinPart_SectionFlip")
    assert proxy.section == SectionPlane((0.0, 0.0, -1.0), -45.0) and place.value() == pytest.approx(45.0)
    window.widget("ThinPart_SectionSlider").setValue(250)
    assert proxy.section == SectionPlane((0.0, 0.0, -1.0), -15.0) and place.value() == pytest.approx(15.0)
    choose("view")
    view = view_of(ribbed.Document)
    look = np.array(tuple(view.getViewDirection()))
    assert np.allclose(proxy.section.normal, -look, atol=1e-5)


def test_the_section_stays_with_a_map_that_is_recoloured_moved_or_measured_again(ribbed, tmp_path):
    switch()
    choose("x")
    proxy, view = ribbed.ViewObject.Proxy, view_of(ribbed.Document)
    before = picture(view, tmp_path)
    ribbed.ColourMap = "viridis"
    assert picture(view, tmp_path) != before and proxy.section.offset == 50.0
    source = ribbed.Sources[0]
    source.Placement.Base = V(0, 0, 30)
    ribbed.Document.recompute()
    window.wait_until(lambda: not ribbed.Stale)
    moved = picture(view, tmp_path)
    place = place_of(view, V(50, 30, 50))
    assert np.ptp(pixel(moved, place)) < 12, "the material moved along"
    assert proxy.section == SectionPlane((1.0, 0.0, 0.0), 50.0)


def test_the_clipping_plane_of_freecad_leaves_the_colour_bar_whole(ribbed, tmp_path):
    view = view_of(ribbed.Document)
    whole = picture(view, tmp_path)
    rows = bar_rows(whole)
    for normal in (V(1, 0, 0), V(-1, 0, 0), V(0, 0, 1), V(0, 0, -1)):
        view.toggleClippingPlane(1, pla=App.Placement(V(50, 30, 30), App.Rotation(V(0, 0, 1), normal)))
        window.settle(200)
        clipped = picture(view, tmp_path)
        view.toggleClippingPlane(0)
        assert clipped != whole and rows and bar_rows(clipped) == rows
    window.settle(100)
    assert picture(view, tmp_path) == whole


def test_the_wall_under_the_mouse_is_told_while_the_panel_is_open_and_selection_still_works(ribbed, tmp_path):
    view, bar = view_of(ribbed.Document), Gui.getMainWindow().statusBar()
    before = picture(view, tmp_path)
    place = place_of(view, V(50, 27, 52))
    move_to(view, place)
    window.wait_until(lambda: window.text("ThinPart_Hover") == "6\u00a0mm")
    assert bar.currentMessage() == window.text("ThinPart_HoveredWall") == "Here: 6\u00a0mm"
    line = picture(view, tmp_path)
    far = place_of(view, V(50, 33, 52))
    middle = (place + far) / 2
    assert pixel(line, middle) != pixel(before, middle), "a line through the wall"
    folder = os.environ.get("THINPART_PICTURES")
    if folder:
        line.save(os.path.join(folder, "hover.png"))
    click_at(view, place)
    assert not probes_of(ribbed)
    move_to(view, QtCore.QPoint(3, 3))
    window.wait_until(lambda: not window.is_shown("ThinPart_Hover"))
    assert "Here" not in bar.currentMessage()


def test_what_is_cut_off_is_not_pointed_at_and_flying_there_ends_the_section(ribbed):
    view, proxy = view_of(ribbed.Document), ribbed.ViewObject.Proxy
    proxy.section = SectionPlane((1.0, 0.0, 0.0), 50.0)
    picker = ThicknessPicker(ribbed)
    assert picker.wall_at(view, place_of(view, V(50, 30, 20))) is None, "material"
    assert picker.wall_at(view, place_of(view, V(30, 27, 52)))["thickness"] == pytest.approx(6.0)
    proxy.section = SectionPlane((0.0, 0.0, 1.0), 10.0)  # without the rib, which is the thinnest wall
    window.click("ThinPart_NextWall")
    assert proxy.section is None


def test_the_section_in_inches_cuts_links_and_stays_when_measured_again(document, tmp_path):
    set_preference("HeatMapShading", False)
    set_preference("MapLabels", False)
    before = App.Units.getSchema()
    block = window.add_ribbed_block(document)
    link = document.addObject("App::Link", "Copy")
    link.LinkedObject = block
    link.Placement.Base = V(150, 0, 0)
    document.recompute()
    App.Units.setSchema(3)
    if "UnitSystem" in document.PropertiesList:
        document.UnitSystem = 3
    try:
        window.show_thickness()
        thickness, = thickness_objects(document)
        view = look_at(document)
        switch()
        choose("y")
        place, proxy = window.widget("ThinPart_SectionPlace"), thickness.ViewObject.Proxy
        assert place.suffix().strip() == "in" and place.value() == pytest.approx(30.0 / 25.4, abs=1e-3)
        place.setValue(0.5)
        assert proxy.section.offset == pytest.approx(-12.7) and proxy.section.normal == (0.0, -1.0, 0.0)
        for x in (50.0, 200.0):  # the material of the block and of its link
            spot = place_of(view, V(x, 12.7, 20))
            image = picture(view, tmp_path)
            colours = np.array([pixel(image, spot + QtCore.QPoint(each, 0)) for each in range(-20, 21)])
            assert np.ptp(colours, axis=1).max() < 12, x
        block.Shape = block.Shape.fuse(window.Part.makeBox(10, 60, 50, V(0, 0, 0))).removeSplitter()
        document.recompute()
        window.wait_until(lambda: thickness.Stale and window.is_shown("ThinPart_AgainButton"))
        window.click("ThinPart_AgainButton")
        window.wait_until(lambda: not thickness.Stale and window.is_thickness_told())
        assert proxy.section.offset == pytest.approx(-12.7)
        window.wait_until(lambda: place.value() == pytest.approx(0.5, abs=1e-3))
    finally:
        App.Units.setSchema(before)
        set_preference("HeatMapShading", None)
        set_preference("MapLabels", None)

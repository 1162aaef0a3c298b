# SPDX-License-Identifier: LGPL-2.1-or-later
"""Thickness maps in the 3D view: colours as the bar has them, kept, undone, out of date."""

import os
import re
from dataclasses import replace

import FreeCAD as App
import FreeCADGui as Gui
import numpy as np
import Part
import pytest
import window_actions as window
from pivy import coin
from thickness_window import bar_rows, look_at, picture, pixel, place_of, show_map, view_of
from window_actions import V

from thinpart_workbench.api.document_maps import parts_of
from thinpart_workbench.core.rendering.colour_scale import colour_table
from thinpart_workbench.freecad_adapter.objects.thickness_object import OWN_CHECK, SHARE, scale_of, thickness_objects
from thinpart_workbench.freecad_adapter.preferences import set_preference
from thinpart_workbench.gui.application import lifelong
from thinpart_workbench.gui.application.qt import QtCore, QtGui, QtWidgets
from thinpart_workbench.gui.colour_bar.colour_bar import bar_image, round_ratios, round_values
from thinpart_workbench.gui.colour_bar.colours import GREYED, NEUTRAL, ThicknessColours
from thinpart_workbench.gui.scene.drawn_triangles import drawn_triangles
from thinpart_workbench.gui.view3d.facet_nodes import corner_normals
from thinpart_workbench.gui.view3d.soft_light import CUBE_FROM, DARKEST

# Places on the ribbed block that are seen from the corner, and what the wall there is.
SEEN = {(50, 27, 52): 6.0, (60, 12, 40): 40.0, (50, 0, 20): 60.0, (100, 20, 20): 100.0}


@pytest.fixture(autouse=True)
def preferred():
    """Flat colours can be compared exactly, and those of viridis with the bar from its top to its bottom."""
    set_preference("HeatMapShading", False)
    set_preference("HeatMapColours", "viridis")
    yield
    set_preference("HeatMapShading", None)
    set_preference("HeatMapColours", None)


@pytest.fixture
def block(document):
    document.UndoMode = 1
    return window.add_ribbed_block(document)


@pytest.fixture
def thickness(block):
    return show_map(block.Document, block)


def _assert_colours(thickness, folder, moved=(0, 0, 0)):
    view = view_of(thickness.Document)
    image = picture(view, folder)
    for point, value in SEEN.items():
        expected = ThicknessColours.of(thickness).of_values([value])[0]
        found = pixel(image, place_of(view, V(*point) + V(*moved)))
        assert np.abs(np.subtract(found, expected.astype(int))).max() <= 2, (point, found, expected)
    return image


def test_colours_are_those_of_the_scale(thickness, tmp_path):
    _assert_colours(thickness, tmp_path)
    thickness.ColourMap = "plasma"
    _assert_colours(thickness, tmp_path)
    thickness.Reversed = True
    thickness.Bands = 4
    _assert_colours(thickness, tmp_path)
    thickness.AutomaticRange = False
    thickness.Low, thickness.High = 10.0, 50.0
    _assert_colours(thickness, tmp_path)
    thickness.RangeUnit = SHARE
    _assert_colours(thickness, tmp_path)
    assert scale_of(thickness).high == pytest.approx(50.0)
    thickness.ThinOnly, thickness.Threshold = True, 41.0
    image = _assert_colours(thickness, tmp_path)
    assert pixel(image, place_of(view_of(thickness.Document), V(100, 20, 20))) == NEUTRAL


def _channels(image, view, point):
    return np.array(pixel(image, place_of(view, V(*point))), dtype=float)


@pytest.fixture
def tapered(document):
    """A plate that gets thicker evenly, from 2 mm at x = 0 to 12 mm at x = 100."""
    outline = Part.makePolygon([V(0, 0, 0), V(100, 0, 0), V(100, 0, -12), V(0, 0, -2), V(0, 0, 0)])
    thickness = show_map(document, window.add(document, "Tapered", Part.Face(outline).extrude(V(0, 70, 0))))
    view = view_of(document)
    view.viewTop()
    view.fitAll()
    window.settle(100)
    return thickness


def _assert_steps(thickness, folder, levels):
    """Every row of the top of the plate changes its colour where it is as thick as a level, within a pixel."""
    view = view_of(thickness.Document)
    image = picture(view, folder)
    left, right = (place_of(view, V(x, 35, 0)).x() for x in (1, 99))
    for y in range(4, 67):
        row = place_of(view, V(50, y, 0)).y()
        colours = [pixel(image, QtCore.QPoint(x, row)) for x in range(left, right + 1)]
        # Smooth colours change by little from pixel to pixel.
        steps = [x for x, (one, two) in enumerate(zip(colours, colours[1:]))
                 if np.abs(np.subtract(one, two)).max() > 12]
        expected = [place_of(view, V(10 * (level - 2), y, 0)).x() - left for level in levels]
        assert len(steps) >= len(levels), (y, steps, expected)
        assert all(min(abs(step - each) for each in expected) <= 2 for step in steps), (y, steps, expected)


@pytest.mark.parametrize("is_logarithmic, levels", [
    (False, [4.5, 7.0, 9.5]), (True, [2 * 6 ** 0.25, 2 * 6 ** 0.5, 2 * 6 ** 0.75])], ids=["even", "logarithmic"])
def test_bands_end_in_clean_lines(tapered, is_logarithmic, levels, tmp_path):
    tapered.AutomaticRange, tapered.Low, tapered.High = False, 2.0, 12.0
    tapered.Bands, tapered.Logarithmic = 4, is_logarithmic
    _assert_steps(tapered, tmp_path, levels)
    tapered.Bands = 0
    _assert_steps(tapered, tmp_path, [])


def test_thin_walls_and_limits_end_in_clean_lines(tapered, tmp_path):
    tapered.AutomaticRange, tapered.Low, tapered.High = False, 2.0, 12.0
    tapered.Threshold, tapered.ThinOnly = 6.3, True
    _assert_steps(tapered, tmp_path, [6.3])
    tapered.ThinOnly, tapered.Check = False, OWN_CHECK
    _assert_steps(tapered, tmp_path, [6.3, 6.93])
    tapered.ViewObject.Proxy.highlight(4.0, 8.0)
    _assert_steps(tapered, tmp_path, [4.0, 6.3, 6.93, 8.0])
    tapered.ViewObject.Proxy.isolate({})
    assert not len(drawn_triangles(tapered.ViewObject.RootNode))
    tapered.ViewObject.Proxy.isolate()
    _assert_steps(tapered, tmp_path, [4.0, 6.3, 6.93, 8.0])


def test_light_changes_how_bright_a_colour_is_and_nothing_else(thickness, tmp_path):
    view = view_of(thickness.Document)
    thickness.ColourMap = "red is thin"
    flat = picture(view, tmp_path)
    thickness.Shaded = True
    lit = picture(view, tmp_path)
    brightness = {}
    for point in SEEN:
        expected = ThicknessColours.of(thickness).of_values([SEEN[point]])[0].astype(float)
        assert np.abs(_channels(flat, view, point) - expected).max() <= 2
        found = _channels(lit, view, point)
        brightness[point] = share = found.sum() / expected.sum()
        assert DARKEST - 0.02 <= share <= 1.01
        assert np.abs(found - share * expected).max() <= 3, "the same hue"
    # The three sides of a box that are seen from a corner differ, and each is evenly lit.
    assert np.ptp([brightness[point] for point in ((60, 12, 40), (50, 0, 20), (100, 20, 20))]) > 0.15
    near = _channels(lit, view, (20, 0, 10)), _channels(lit, view, (80, 0, 30))
    is_even = tuple(map(int, re.findall(r"\d+", coin.SoDB.getVersion())[:3])) >= CUBE_FROM
    assert np.abs(near[0] - near[1]).max() <= (2 if is_even else 26)
    thickness.Shaded = False
    _assert_colours(thickness, tmp_path)


def test_normals_are_smooth_within_a_face_and_sharp_between_faces(document):
    window.add(document, "Rod", Part.makeCylinder(10, 30))
    part, = parts_of(show_map(document, document.getObject("Rod")))
    shown = part.map
    normals = corner_normals(shown)
    assert np.linalg.norm(normals, axis=2) == pytest.approx(1.0)
    corners = shown.corners + shown.origin
    outward = corners * [1, 1, 0] / 10.0
    round_side = np.abs(shown.normals[:, 2]) < 0.5
    assert np.abs(normals - outward)[round_side].max() < 0.06
    assert np.abs(np.abs(normals[~round_side, :, 2]) - 1.0).max() < 1e-6


def test_only_isolated_faces_are_drawn(thickness):
    part, = parts_of(thickness)
    everything = len(drawn_triangles(thickness.ViewObject.RootNode))
    assert everything == part.map.count
    face = int(part.map.face[0])
    thickness.ViewObject.Proxy.isolate({0: {face}})
    triangles = drawn_triangles(thickness.ViewObject.RootNode)
    assert len(triangles) == np.count_nonzero(part.map.face == face) < everything
    expected = part.map.corners[part.map.face == face] + part.map.origin
    assert np.abs(np.sort(triangles.reshape(-1, 3), axis=0) - np.sort(expected.reshape(-1, 3), axis=0)).max() < 1e-3
    thickness.ViewObject.Proxy.isolate()
    assert len(drawn_triangles(thickness.ViewObject.RootNode)) == everything


def test_a_logarithmic_bar_has_its_middle_at_the_geometric_mean(thickness, tmp_path):
    thickness.AutomaticRange = False
    thickness.Low, thickness.High = 1.0, 100.0
    thickness.Logarithmic, thickness.Threshold = True, 0.0
    _assert_colours(thickness, tmp_path)
    rows = bar_rows(picture(view_of(thickness.Document), tmp_path, 800, 600, "White"))
    at_ten = ThicknessColours.of(thickness).of_values([10.0])[0].astype(int)
    assert np.abs(np.subtract(rows[len(rows) // 2], at_ten)).max() <= 40
    assert round_ratios(1.0, 100.0) == pytest.approx([1, 2, 5, 10, 20, 50, 100])


def test_the_bar_shows_the_same_scale_at_every_size(thickness, tmp_path):
    view = view_of(thickness.Document)
    table = colour_table("viridis")
    for size, background in (((800, 600), "White"), ((2000, 1500), "Black"), ((700, 900), "Current")):
        rows = bar_rows(picture(view, tmp_path, *size, background))
        # The darkest colours of the lower end are hardly coloured, so the bar is read from the top.
        assert len(rows) > 0.25 * size[1], size
        assert np.abs(np.subtract(rows[2], table[-1].astype(int))).max() <= 12
        assert np.abs(np.subtract(rows[len(rows) // 2], table[128].astype(int))).max() <= 40
    thickness.Bands = 3
    rows = bar_rows(picture(view, tmp_path, 800, 600, "White"))
    assert len(set(rows)) <= 3 + 3, "three bands, and the mark of the threshold"


def test_the_bar_tells_what_was_not_measured(thickness):
    content = thickness.ViewObject.Proxy.bar
    assert not content.has_unmeasured
    grey = QtGui.QColor(*ThicknessColours.of(thickness).of_values([np.nan])[0].tolist()).rgb()

    def count(shown):
        image = bar_image(shown, 900)
        return sum(image.pixel(x, y) == grey for x in range(image.width()) for y in range(image.height()))

    assert count(content) == 0
    assert count(replace(content, has_unmeasured=True)) > 150


def test_round_values_are_round():
    assert round_values(0.0, 100.0) == [0, 20, 40, 60, 80, 100]
    assert round_values(6.0, 7.3) == pytest.approx([6, 6.5, 7])
    assert round_values(0.013, 0.02) == pytest.approx([0.014, 0.016, 0.018, 0.02])
    assert round_values(2.0, 2.0) == [2.0]


def test_what_is_pointed_out_keeps_its_colour(thickness, tmp_path):
    view = view_of(thickness.Document)
    shown = thickness.ViewObject.Proxy
    shown.highlight(0.0, 10.0)
    image = picture(view, tmp_path)
    assert pixel(image, place_of(view, V(60, 12, 40))) == GREYED
    assert pixel(image, place_of(view, V(50, 27, 52))) != GREYED
    part = parts_of(thickness)[0]
    top = int(part.map.face[np.argmax(part.map.corners.mean(axis=1)[:, 2])])
    shown.highlight_faces({0: {top}})
    image = picture(view, tmp_path)
    assert pixel(image, place_of(view, V(50, 27, 52))) == GREYED
    assert pixel(image, place_of(view, V(50, 30, 60))) != GREYED
    shown.highlight(None)
    _assert_colours(thickness, tmp_path)


def test_selecting_it_does_not_recolour_it(thickness, tmp_path):
    Gui.Selection.addSelection(thickness)
    _assert_colours(thickness, tmp_path)


def test_saved_and_opened_again(thickness, tmp_path):
    document = thickness.Document
    thickness.ColourMap, thickness.Bands = "magma", 6
    view_of(document).saveImage(str(tmp_path / "before.png"), 400, 300, "Current")
    document.saveAs(str(tmp_path / "part.FCStd"))
    App.closeDocument(document.Name)
    window.settle()
    again = App.openDocument(str(tmp_path / "part.FCStd"))
    window.settle(100)
    thickness, = thickness_objects(again)
    look_at(again)
    assert not thickness.Stale and thickness.ColourMap == "magma"
    _assert_colours(thickness, tmp_path)
    assert bar_rows(picture(view_of(again), tmp_path, 800, 600))
    assert not Gui.getDocument(again.Name).Modified


def test_undo_redo_and_remove(block, tmp_path):
    document = block.Document
    thickness = show_map(document, block)
    view, switch = view_of(document), block.ViewObject.SwitchNode
    assert switch.whichChild.getValue() == -1 and block.ViewObject.Visibility
    document.undo()
    window.settle(60)
    assert thickness_objects(document) == [] and switch.whichChild.getValue() != -1
    assert not bar_rows(picture(view, tmp_path, 800, 600))
    document.redo()
    window.settle(60)
    thickness, = thickness_objects(document)
    assert switch.whichChild.getValue() == -1
    _assert_colours(thickness, tmp_path)
    thickness.ViewObject.Visibility = False
    window.settle(60)
    assert switch.whichChild.getValue() != -1 and not bar_rows(picture(view, tmp_path, 800, 600))
    thickness.ViewObject.Visibility = True
    window.settle(60)
    assert bar_rows(picture(view, tmp_path, 800, 600))
    document.openTransaction("Delete")
    document.removeObject(thickness.Name)
    document.commitTransaction()
    window.settle(60)
    assert switch.whichChild.getValue() != -1 and not bar_rows(picture(view, tmp_path, 800, 600))
    document.undo()
    window.settle(60)
    _assert_colours(thickness_objects(document)[0], tmp_path)


@pytest.fixture
def asked():
    """Document's and object's names of the maps that are asked to be measured again."""
    names = []

    def note(*each):
        names.append(each)

    lifelong.map_events.measure_requested.add(note)
    yield names
    lifelong.map_events.measure_requested.remove(note)


def test_out_of_date_until_the_edit_is_undone_or_it_is_recomputed(block, thickness, asked, tmp_path):
    document = block.Document
    fresh = picture(view_of(document), tmp_path)
    icon = thickness.ViewObject.Proxy.getIcon()
    document.openTransaction("Edit")
    block.Shape = Part.makeBox(100, 60, 41)
    document.commitTransaction()
    window.settle(60)
    assert thickness.Stale and thickness.ViewObject.Proxy.getIcon() != icon
    faded = picture(view_of(document), tmp_path)
    place = place_of(view_of(document), V(100, 20, 20))
    assert pixel(faded, place) != pixel(fresh, place)
    _assert_colours(thickness, tmp_path)
    document.undo()
    window.settle(60)
    assert not thickness.Stale and asked == []
    document.redo()
    document.recompute()
    window.settle(60)
    assert thickness.Stale
    asked.clear()
    thickness.touch()
    document.recompute()
    window.settle(60)
    assert asked == [(document.Name, thickness.Name)] and thickness.Stale


def test_it_goes_where_its_source_goes(block, thickness, tmp_path):
    block.Placement.Base = V(300, -40, 90)
    block.Document.recompute()
    window.settle(60)
    look_at(block.Document)
    assert not thickness.Stale
    _assert_colours(thickness, tmp_path, (300, -40, 90))
    box = thickness.ViewObject.getBoundingBox()
    assert (box.XMin, box.ZMax) == pytest.approx((300.0, 150.0), abs=0.1)


def test_two_documents_and_two_views_and_closing(thickness, tmp_path):
    one = thickness.Document
    other = App.newDocument("Other")
    plate = window.add(other, "Plate", Part.makeBox(40, 30, 2))
    second = show_map(other, plate)
    second.ColourMap = "inferno"
    tops = [bar_rows(picture(view_of(each), tmp_path, 800, 600))[2] for each in (one, other)]
    for top, name in zip(tops, ("viridis", "inferno")):
        assert np.abs(np.subtract(top, colour_table(name)[-1].astype(int))).max() <= 12
    App.closeDocument(other.Name)
    window.settle(60)
    assert bar_rows(picture(view_of(one), tmp_path, 800, 600))
    Gui.setActiveDocument(one.Name)
    Gui.runCommand("Std_ViewCreate")
    window.wait_until(lambda: len(Gui.getDocument(one.Name).mdiViewsOfType("Gui::View3DInventor")) == 2)
    window.settle(100)
    for view in Gui.getDocument(one.Name).mdiViewsOfType("Gui::View3DInventor"):
        view.viewIsometric()
        view.fitAll()
        assert bar_rows(picture(view, tmp_path, 800, 600))


@pytest.mark.complains("The thickness map ")
def test_a_damaged_map_is_one_sentence_and_can_be_removed(thickness, tmp_path):
    document = thickness.Document
    file = str(tmp_path / "part.FCStd")
    document.saveAs(file)
    App.closeDocument(document.Name)
    _damage(file)
    before = _report()
    again = App.openDocument(file)
    window.wait_until(lambda: "cannot be read" in _report()[len(before):])
    window.settle(100)
    told = _report()[len(before):]
    assert told.count("cannot be read: measure the part again") == 1, told
    assert "Traceback" not in told
    thickness, = thickness_objects(again)
    again.recompute()
    picture(view_of(again), tmp_path)
    again.removeObject(thickness.Name)
    window.settle(60)
    assert [each.Name for each in again.Objects] == ["Ribbed"]
    assert again.Ribbed.ViewObject.SwitchNode.whichChild.getValue() != -1


def test_nothing_of_the_source_is_changed_in_the_file(block, thickness, tmp_path):
    block.Document.saveAs(str(tmp_path / "part.FCStd"))
    assert block.ViewObject.Visibility
    name = thickness.Name
    App.closeDocument(block.Document.Name)
    again = App.openDocument(str(tmp_path / "part.FCStd"))
    window.settle(100)
    view = again.getObject("Ribbed").ViewObject
    assert view.Visibility and view.SwitchNode.whichChild.getValue() == -1
    again.removeObject(name)
    window.settle(60)
    assert view.SwitchNode.whichChild.getValue() != -1


def _damage(file):
    import zipfile

    with zipfile.ZipFile(file) as archive:
        content = {each: archive.read(each) for each in archive.namelist()}
    for name in content:
        if name.endswith(".npz"):
            content[name] = content[name][:1000]
    os.remove(file)
    with zipfile.ZipFile(file, "w") as archive:
        for name in sorted(content, key=lambda each: each != "Document.xml"):
            archive.writestr(name, content[name])


def _report():
    view = Gui.getMainWindow().findChild(QtWidgets.QTextEdit, "Report view")
    return "" if view is None else view.toPlainText()

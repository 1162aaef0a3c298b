# SPDX-License-Identifier: LGPL-2.1-or-later
"""Analysis colours: undone, cleared exactly, never saved."""

import FreeCAD as App
import FreeCADGui as Gui
import Part
import pytest
import window_actions as window
from window_actions import V

from thinpart_workbench.gui.document.face_colours import NEUTRAL

RED = (0.84, 0.15, 0.12)


def look(feature):
    """Everything that a face's colours consist of."""
    view = feature.ViewObject
    if "ShapeAppearance" in view.PropertiesList:
        return [(m.DiffuseColor, m.SpecularColor, m.Shininess, m.Transparency)
                for m in view.ShapeAppearance]
    return view.DiffuseColor


@pytest.fixture(params=["plain", "painted", "transparent", "one face painted"])
def block(request, document):
    """A ribbed block that looks like something before it is classified."""
    feature = window.add_ribbed_block(document)
    view = feature.ViewObject
    if request.param == "painted":
        view.ShapeColor = (0.1, 0.7, 0.3)
    if request.param == "transparent":
        view.Transparency = 40
    if request.param == "one face painted":
        colours = [(0.5, 0.5, 0.5, 0.0)] * len(feature.Shape.Faces)
        colours[3] = (0.0, 0.2, 1.0, 0.0)
        view.DiffuseColor = colours
    return feature


def test_clear_restores_exactly_also_after_classifying_twice(block):
    before = look(block)
    window.classify()
    assert look(block) != before
    window.classify()
    window.press("ThinPart_ClearColours")
    assert look(block) == before


def test_what_is_not_thin_keeps_its_look(block):
    before = look(block)
    window.classify()
    after = look(block)
    before = before * len(after) if len(before) == 1 else before
    same = [one == other for one, other in zip(before, after)]
    assert same.count(False) == 2 and len(after) == len(block.Shape.Faces)


@pytest.mark.parametrize("own, is_neutral", [((1.0, 0.5, 0.0), True), ((0.7, 0.0, 0.1), True), ((0.1, 0.3, 0.9), False)])
def test_own_colours_that_look_like_verdicts_are_neutral_meanwhile(document, own, is_neutral):
    ribbed = window.add_ribbed_block(document)
    features = [ribbed, window.add(document, "Own", Part.makeBox(60, 60, 60, V(200, 0, 0))),
                window.add(document, "Green", Part.makeBox(60, 50, 60, V(300, 0, 0)))]
    for feature, colour in zip(features[1:], (own, (0.1, 0.7, 0.3))):
        feature.ViewObject.ShapeColor = colour
    before = [look(each) for each in features]
    Gui.Selection.addSelection(ribbed)
    window.classify()
    assert window.rgb(ribbed).count(RED) == 2
    assert [set(window.rgb(each)) - {RED} == {NEUTRAL} for each in features] == 3 * [is_neutral]
    window.press("ThinPart_ClearColours")
    assert [look(each) for each in features] == before


def test_undo_takes_the_colours_away_and_redo_brings_them_back(block):
    document, before = block.Document, look(block)
    window.classify()
    coloured = look(block)
    Gui.runCommand("Std_Undo")
    assert look(block) == before
    assert not Gui.isCommandActive("ThinPart_ClearColours")
    Gui.runCommand("Std_Redo")
    assert look(block) == coloured
    window.press("ThinPart_ClearColours")
    assert look(block) == before
    document.undo()
    assert look(block) == coloured and Gui.isCommandActive("ThinPart_ClearColours")


def test_saving_never_keeps_the_colours(block, tmp_path):
    document, before = block.Document, look(block)
    document.saveAs(str(tmp_path / "part.FCStd"))
    window.classify()
    coloured = look(block)
    Gui.runCommand("Std_Save")
    assert look(block) == coloured, "the colours stay on the screen"
    assert not Gui.getDocument(document.Name).Modified
    App.closeDocument(document.Name)
    again = App.openDocument(str(tmp_path / "part.FCStd"))
    opened = look(again.getObject("Ribbed"))
    # A file keeps 8 bits of a colour.
    assert len(opened) == len(before)
    assert [tuple(round(c, 2) for c in window.rgb(again.getObject("Ribbed"))[0])] != [RED]
    assert RED not in window.rgb(again.getObject("Ribbed"))
    assert not Gui.isCommandActive("ThinPart_ClearColours")


def test_a_copy_does_not_keep_them_either(document, tmp_path):
    feature = window.add_ribbed_block(document)
    window.classify()
    coloured = look(feature)
    document.saveCopy(str(tmp_path / "copy.FCStd"))
    assert look(feature) == coloured
    App.closeDocument(document.Name)
    copy = App.openDocument(str(tmp_path / "copy.FCStd"))
    assert RED not in window.rgb(copy.getObject("Ribbed"))


def test_colours_of_undone_and_then_saved_documents(document, tmp_path):
    feature = window.add_ribbed_block(document)
    before = look(feature)
    document.saveAs(str(tmp_path / "part.FCStd"))
    window.classify()
    document.undo()
    Gui.runCommand("Std_Save")
    assert look(feature) == before


def test_colours_go_when_the_shape_changes(document):
    feature = window.add_ribbed_block(document)
    before = look(feature)
    window.classify()
    coloured = look(feature)
    document.openTransaction("Edit")
    feature.Shape = Part.makeBox(100, 60, 40)
    document.commitTransaction()
    assert look(feature) == before
    assert not Gui.isCommandActive("ThinPart_ClearColours")
    document.undo()
    assert look(feature) == coloured, "the shape that they belong to is back, too"
    document.undo()
    assert look(feature) == before


def test_one_solid_of_many(document):
    ribbed = window.ribbed_shape()
    plate = Part.makeBox(100, 100, 2)
    plate.translate(V(200, 0, 0))
    compound = window.add(document, "Both", Part.makeCompound([ribbed, plate]))
    Gui.Selection.addSelection(document.Name, "Both", f"Face{len(ribbed.Faces) + 1}")
    window.classify()
    assert window.text("ThinPart_PartLabel") == "Both (2)"
    colours = window.rgb(compound)
    assert colours[:len(ribbed.Faces)].count(RED) == 2, "the sides of the rib"
    assert colours[len(ribbed.Faces):].count(RED) == 2, "both sides of the plate"


def test_body(document):
    body = document.addObject("PartDesign::Body", "Body")
    box = document.addObject("PartDesign::AdditiveBox", "Slab")
    body.addObject(box)
    box.Length, box.Width, box.Height = 100, 100, 2
    document.recompute()
    before = look(body.Tip)
    window.classify()
    assert window.text("ThinPart_Headline") == "Thin part"
    assert RED in window.rgb(body.Tip)
    window.press("ThinPart_ClearColours")
    assert look(body.Tip) == before


def test_a_link_shows_the_colours_of_what_it_links_to(document):
    feature = window.add_ribbed_block(document)
    link = document.addObject("App::Link", "Copy")
    link.LinkedObject = feature
    link.Placement.Base = V(300, 0, 0)
    feature.ViewObject.Visibility = False
    document.recompute()
    before = look(feature)
    Gui.Selection.addSelection(document.Name, "Copy", "Face1")
    window.classify()
    assert window.text("ThinPart_Headline") == "Part with thin features"
    assert RED in window.rgb(feature)
    window.press("ThinPart_ClearColours")
    assert look(feature) == before


def test_child_of_a_part_container(document):
    container = document.addObject("App::Part", "Assembly")
    ribbed = window.add_ribbed_block(document)
    plate = window.add(document, "Plate", Part.makeBox(100, 100, 2))
    container.addObject(ribbed)
    container.addObject(plate)
    container.Placement.Base = V(10, 20, 30)
    document.recompute()
    Gui.Selection.addSelection(document.Name, "Assembly", "Plate.Face1")
    window.classify()
    assert window.text("ThinPart_PartLabel") == "Plate"
    assert window.rgb(plate).count(RED) == 2 and window.rgb(ribbed).count(RED) == 2

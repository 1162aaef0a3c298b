# SPDX-License-Identifier: LGPL-2.1-or-later
"""Below a verdict the Classify panel says what the libraries have already, and shows what differs."""

import FreeCAD as App
import FreeCADGui as Gui
import made_maps
import numpy as np
import Part
import pytest
import window_actions as window
from window_actions import V

from thinpart_workbench.api.classification import classify
from thinpart_workbench.freecad_adapter.preferences import set_preference, set_preference_list
from thinpart_workbench.gui.application.qt import QtGui
from thinpart_workbench.gui.view3d.difference_nodes import OTHERS, OWN


def bracket(length=60.0):
    base, flange, lug = Part.makeBox(length, 30, 4), Part.makeBox(4, 30, 25), Part.makeBox(14, 8, 12, V(20, 22, 4))
    return base.fuse([flange, lug]).cut(Part.makeCylinder(4, 20, V(45, 12, -5))).removeSplitter()


@pytest.fixture
def library(tmp_path, monkeypatch):
    monkeypatch.setenv("THINPART_CACHE", str(tmp_path / "cache"))
    folder = tmp_path / "library"
    folder.mkdir()
    bracket().exportStep(str(folder / "bracket.step"))
    Part.makeSphere(20).exportStep(str(folder / "ball.step"))
    for file in ("bracket.step", "ball.step"):
        classify(folder / file, write_info=True)
    set_preference_list("Libraries", [str(folder)])
    yield folder
    set_preference_list("Libraries", [])
    set_preference("KnownParts", True)


def known():
    return window.text("ThinPart_KnownText").replace("\u00a0", " ")


def test_what_the_libraries_have_is_said_below_the_verdict(document, library):
    feature = window.add(document, "Mine", bracket())
    feature.Placement = App.Placement(V(10, 300, 7), App.Rotation(V(1, 1, 0.3), 50))
    window.classify()
    window.wait_until(lambda: window.is_shown("ThinPart_KnownText"))
    assert known() == "Your libraries have this part: bracket.step."
    assert window.widget("ThinPart_KnownText").toolTip() == str(library / "bracket.step")
    feature.Shape = bracket(64.0)
    document.recompute()
    window.classify()
    window.wait_until(lambda: window.is_shown("ThinPart_KnownText"))
    assert known().startswith("Your libraries have one like it: bracket.step. Alike: ") and "It is 4 mm longer." in known()
    feature.Shape = bracket().mirror(V(), V(1, 0, 0))
    document.recompute()
    window.classify()
    window.wait_until(lambda: window.is_shown("ThinPart_KnownText"))
    assert known() == "Your libraries have its mirror image: bracket.step."


def test_nothing_is_said_of_a_part_that_they_lack_and_where_it_is_not_wanted(document, library):
    feature = window.add(document, "Mine", Part.makeBox(90, 20, 3))
    window.classify()
    window.settle(300)
    assert not window.is_shown("ThinPart_KnownText")
    set_preference("KnownParts", False)
    feature.Shape = bracket()
    document.recompute()
    window.classify()
    window.settle(1500)
    assert not window.is_shown("ThinPart_KnownText")


BUTTON, LEGEND, STATE = "ThinPart_ShowDifference", "ThinPart_DifferenceLegend", "ThinPart_DifferenceText"


def classified_longer(document):
    """A bracket that is 4 mm longer, and has neither hole nor lug, classified."""
    feature = window.add(document, "Mine", Part.makeBox(64, 30, 4).fuse(Part.makeBox(4, 30, 25)).removeSplitter())
    feature.Placement = App.Placement(V(10, 300, 7), App.Rotation(V(1, 1, 0.3), 50))
    window.classify()
    window.wait_until(lambda: window.is_shown(BUTTON))
    return feature


def show_difference():
    window.click(BUTTON)
    window.wait_until(lambda: window.is_shown(LEGEND))


def drawn_colours(document, tmp_path):
    """How many pixels of the view are in the colour of what only the part has, and of what only the other one has."""
    view = Gui.getDocument(document.Name).ActiveView
    view.viewIsometric()
    view.fitAll()
    window.settle(300)
    view.saveImage(str(tmp_path / "view.png"), 400, 300, "White")
    image = QtGui.QImage(str(tmp_path / "view.png"))
    counts = [0, 0]
    for x in range(0, image.width(), 2):
        for y in range(0, image.height(), 2):
            shown = np.array(image.pixelColor(x, y).getRgbF()[:3])
            # In any light, but not the red of thin faces; and translucent, on white or grey.
            counts[0] += np.abs(shown / max(shown.max(), 0.1) - np.array(OWN) / max(OWN)).max() < 0.1
            counts[1] += shown[2] - shown[0] > 0.3 * (OTHERS[2] - OTHERS[0])
    return counts


def state_of(document):
    return [(each.Name, each.ViewObject.Visibility, each.ViewObject.Transparency) for each in document.Objects], (
        document.UndoCount)


compares = pytest.mark.timeout(180)  # processes start, read two documents and compare them, up to twice


@compares
def test_the_difference_is_coloured_until_it_is_not_wanted(document, library, tmp_path):
    feature = classified_longer(document)
    before = state_of(document)
    own, others = drawn_colours(document, tmp_path)
    assert own < 20 and others < 20
    show_difference()
    assert window.text("ThinPart_DifferenceMeaning0") == "not in bracket.step"
    assert window.text("ThinPart_DifferenceMeaning1") == "only in bracket.step"
    said = window.text(STATE).replace("\u00a0", " ")
    assert said.startswith("Coloured where the two are more than 0.0") and said.endswith("at most it is 12 mm.")
    own, others = drawn_colours(document, tmp_path)
    assert own > 100 and others > 20
    assert feature.ViewObject.SwitchNode.whichChild.getValue() == -1  # it would hide the wall of the other's hole
    assert state_of(document) == before
    window.click(BUTTON)
    window.wait_until(lambda: not window.is_shown(LEGEND))
    assert drawn_colours(document, tmp_path)[0] < 20
    assert feature.ViewObject.SwitchNode.whichChild.getValue() != -1 and state_of(document) == before
    show_difference()
    feature.Shape = bracket(70.0)
    document.recompute()
    window.wait_until(lambda: not window.is_shown(LEGEND))
    assert drawn_colours(document, tmp_path)[0] < 20
    window.click(BUTTON)
    assert window.text(STATE) == "The document has changed since it was measured: classify it again."


@compares
def test_the_difference_gives_way_to_a_map_and_ends_with_the_panel(document, library, tmp_path):
    feature = classified_longer(document)
    thickness = made_maps.add_map(document, feature)
    thickness.ViewObject.Visibility = False
    window.settle(100)
    show_difference()
    thickness.ViewObject.Visibility = True
    window.wait_until(lambda: not window.is_shown(LEGEND))
    assert not window.widget(BUTTON).isChecked()
    thickness.ViewObject.Visibility = False
    window.settle(100)
    show_difference()
    Gui.Control.closeDialog()
    window.settle(300)
    assert drawn_colours(document, tmp_path)[1] < 20
    assert feature.ViewObject.SwitchNode.whichChild.getValue() != -1


@compares
def test_a_document_that_is_gone_is_named(document, library):
    classified_longer(document)
    (library / "bracket.step").unlink()
    window.click(BUTTON)
    window.wait_until(lambda: "bracket.step" in window.text(STATE))
    assert not window.is_shown(LEGEND) and not window.widget(BUTTON).isChecked()
    window.click("ThinPart_OpenKnown")
    window.wait_until(lambda: window.text(STATE) == f"The file {library / 'bracket.step'} no longer exists.")


@compares
def test_the_other_part_is_opened_and_one_that_is_the_same_has_no_difference(document, library):
    window.add(document, "Mine", bracket())
    window.classify()
    window.wait_until(lambda: window.is_shown("ThinPart_OpenKnown"))
    assert not window.is_shown(BUTTON)
    window.click("ThinPart_OpenKnown")
    window.wait_until(lambda: App.ActiveDocument is not None and App.ActiveDocument.Name != document.Name)
    assert App.ActiveDocument.Objects[-1].Shape.Volume == pytest.approx(bracket().Volume)

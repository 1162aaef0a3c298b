# SPDX-License-Identifier: LGPL-2.1-or-later
"""Below a verdict the Classify panel says what the libraries have already."""

import FreeCAD as App
import Part
import pytest
import window_actions as window
from window_actions import V

from thinpart_workbench.api.classification import classify
from thinpart_workbench.freecad_adapter.preferences import set_preference, set_preference_list


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

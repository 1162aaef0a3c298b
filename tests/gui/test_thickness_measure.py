# SPDX-License-Identifier: LGPL-2.1-or-later
"""The choice of the measure in the panel of a thickness map: across the wall, or the largest ball inside."""

import FreeCAD as App
import Part
import pytest
import window_actions as window

from thinpart_workbench.api.document_maps import parts_of
from thinpart_workbench.core.analysis_settings import RAY, SHOWN_MEASURES, SPHERE
from thinpart_workbench.freecad_adapter.objects.thickness_object import OWN_CHECK, thickness_objects
from thinpart_workbench.gui.application.qt import QtCore
from thinpart_workbench.gui.colour_bar.colours import ThicknessColours

pytestmark = pytest.mark.timeout(120)  # each measures several times


@pytest.fixture
def wedged(document):
    """The map of a wedge of 30 degrees, 60 mm long, its panel open: balls are smaller than its walls are thick."""
    tip, up, down = App.Vector(0, 0, 0), App.Vector(40, 10.718, 0), App.Vector(40, -10.718, 0)
    window.add(document, "Wedge", Part.Face(Part.makePolygon([tip, down, up, tip])).extrude(App.Vector(0, 0, 60)))
    window.show_thickness()
    window.settle(300)
    thickness, = thickness_objects(document)
    return thickness


def combo():
    return window.widget("ThinPart_Measure")


def choose(measure):
    combo().setCurrentIndex(combo().findData(measure))
    window.wait_until(lambda: not window.is_shown("ThinPart_Progress") and window.is_thickness_told())
    window.settle(300)


def said():
    chart = window.widget("ThinPart_ThicknessChart")
    return window.text("ThinPart_ThinShare"), chart.measure


def test_balls_are_measured_shown_and_kept(wedged):
    assert (wedged.Measure, combo().currentData()) == (RAY, RAY)
    across = parts_of(wedged)[0].map
    verdict = window.text("ThinPart_Headline"), window.text("ThinPart_Walls")
    choose(SPHERE)
    assert (wedged.Measure, combo().currentData()) == (SPHERE, SPHERE)
    balls, = parts_of(wedged)
    assert balls.map.measure == SPHERE
    # The largest ball inside touches both flanks and the back: the circle inscribed in the triangle.
    side = (40.0 ** 2 + 10.718 ** 2) ** 0.5
    inscribed = 2.0 * 40.0 * 2.0 * 10.718 / (2.0 * side + 2.0 * 10.718)
    assert balls.map.ends[1] == pytest.approx(inscribed, rel=0.02)
    assert across.ends[1] > 20.0 > balls.map.ends[1]
    assert (window.text("ThinPart_Headline"), window.text("ThinPart_Walls")) == verdict  # by rays all the same
    assert said()[0].startswith("On ") and "largest ball" in said()[0] and said()[1] == SPHERE
    assert wedged.ViewObject.Proxy.bar.measure == SPHERE
    assert wedged.High <= wedged.Thickest == pytest.approx(inscribed, rel=0.02)  # the colours' range is that of balls
    headers = window.widget("ThinPart_ProbeTable").model()
    assert headers.headerData(1, QtCore.Qt.Horizontal) == "Largest ball"

    # The part changes and is measured again: by balls.
    wedged.Document.getObject("Wedge").Shape = wedged.Document.getObject("Wedge").Shape.copy().scale(2.0)
    wedged.Document.recompute()
    window.wait_until(lambda: wedged.Stale and window.is_shown("ThinPart_AgainButton"))
    window.click("ThinPart_AgainButton")
    window.wait_until(lambda: not wedged.Stale and window.is_thickness_told())
    window.settle(300)
    assert wedged.Measure == SPHERE
    assert parts_of(wedged)[0].map.ends[1] == pytest.approx(2.0 * inscribed, rel=0.02)

    choose(RAY)
    assert wedged.Measure == RAY and said()[1] == RAY and "thinner than" in said()[0]
    assert headers.headerData(1, QtCore.Qt.Horizontal) == "Wall"


def test_limits_of_a_process_are_not_held_against_balls_but_own_ones_are(wedged):
    wedged.Check, wedged.Threshold = OWN_CHECK, 5.0
    window.settle(300)
    assert ThicknessColours.of(wedged).checked == (5.0, 0.0)
    result = window.text("ThinPart_CheckResult")
    assert "Own limit" in result and "\n" not in result
    window.click("ThinPart_ProbeButton")
    probes = window.widget("ThinPart_ProbeBox")
    probes.show_hovered({"thickness": 2.0})
    assert "at least" in window.text("ThinPart_HoveredWall")

    choose(SPHERE)
    assert wedged.Check == OWN_CHECK and ThicknessColours.of(wedged).checked == (wedged.Threshold, 0.0)
    assert window.text("ThinPart_CheckResult").startswith(f"{result}\n")  # the same result, by rays
    assert "largest balls" in window.text("ThinPart_CheckResult") and window.is_shown("ThinPart_CheckShares")
    wedged.Check = "FDM"
    window.settle(300)
    assert ThicknessColours.of(wedged).checked is None and not window.is_shown("ThinPart_CheckShares")
    assert "Colours show" in window.text("ThinPart_CheckResult")
    wedged.Check = OWN_CHECK
    window.settle(300)
    probes.show_hovered({"thickness": 2.0})
    assert window.text("ThinPart_HoveredWall").startswith("Largest ball here")

    choose(RAY)
    assert ThicknessColours.of(wedged).checked == (wedged.Threshold, 0.0)
    assert window.text("ThinPart_CheckResult") == result


def test_undo_brings_the_earlier_measure_back(wedged):
    choose(SPHERE)
    wedged.Document.undo()
    window.wait_until(lambda: combo().currentData() == RAY)
    assert wedged.Measure == RAY and parts_of(wedged)[0].map.measure == RAY


def test_a_cancelled_choice_changes_nothing(wedged):
    combo().setCurrentIndex(combo().findData(SPHERE))
    window.widget("ThinPart_ThicknessHead").cancelled.emit()
    window.settle(200)
    assert (wedged.Measure, combo().currentData()) == (RAY, RAY)
    assert "Nothing was changed" in window.text("ThinPart_Message")


def test_a_map_of_an_earlier_version_is_by_rays(wedged, tmp_path):
    wedged.removeProperty("Measure")
    file = str(tmp_path / "earlier.FCStd")
    document = wedged.Document
    document.saveCopy(file)
    opened = App.openDocument(file)
    try:
        restored, = thickness_objects(opened)
        assert restored.Measure == RAY
    finally:
        App.closeDocument(opened.Name)


def test_both_choices_say_what_they_are():
    from thinpart_workbench.gui.record.measure_text import measure_choices

    assert [measure for measure, _, _ in measure_choices()] == list(SHOWN_MEASURES)
    assert all(len(meaning) > 80 for _, _, meaning in measure_choices())

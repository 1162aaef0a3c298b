# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where FreeCAD writes numbers with a comma, ThinPart does too, also in pictures; either mark can be typed."""

import re

import pytest
import window_actions as window
from profile_editor import type_into
from thickness_window import show_map

from thinpart_workbench.core.figures import Length
from thinpart_workbench.core.judging.criteria import load_profile
from thinpart_workbench.core.message import message
from thinpart_workbench.gui.application.qt import QtCore, QtWidgets
from thinpart_workbench.gui.application.sentences import translated
from thinpart_workbench.gui.colour_bar.colour_bar import tick_text
from thinpart_workbench.gui.profile.condition_editor import ConditionEditor
from thinpart_workbench.gui.widgets.range_filter import RangeFilter


@pytest.fixture
def comma():
    before = QtCore.QLocale()
    QtCore.QLocale.setDefault(QtCore.QLocale("de_DE"))
    yield
    QtCore.QLocale.setDefault(before)


@pytest.mark.parametrize("text", ["2,5", "2.5"])
def test_a_range_is_typed_with_either_mark_and_shown_with_the_comma(text, comma):
    ranges = RangeFilter("Probe", "Wall, {}")
    ranges.show_histogram((1.25, 40.0), [1, 2, 3])
    ranges.show()
    least, most = (ranges.findChild(QtWidgets.QLineEdit, f"ThinPart_Probe{end}") for end in ("Least", "Most"))
    assert (least.placeholderText(), most.placeholderText()) == ("1,25", "40")
    type_into(least, text)
    window.wait_until(lambda: ranges.bounds[0] == 2.5)
    ranges.slider.set_bounds(None, None)
    type_into(most, f"7{text[1:]}x")
    window.wait_until(lambda: ranges.bounds[1] == 7.5)
    ranges.hide()
    ranges.deleteLater()


def test_the_colour_bar_has_the_comma(document, comma):
    thickness = show_map(document, window.add_ribbed_block(document))
    thickness.AutomaticRange, thickness.Low, thickness.High = False, 0.25, 8.0
    assert tick_text(0.25) == "0,25" and tick_text(8.0) == "8"


def test_conditions_have_the_comma(comma):
    content = load_profile("calibrated").content["categories"][0]["criteria"][0]["conditions"][0]
    row = parent = QtWidgets.QDialog()
    row = ConditionEditor(content, parent)
    parent.show()
    said = row.findChild(QtWidgets.QLabel, "ThinPart_ConditionText").text()
    assert re.search(r"\b0,\d", said) and not re.search(r"\b0\.\d", said)
    parent.hide()
    parent.deleteLater()


def test_names_and_versions_keep_their_points(comma):
    said = message("{file}, {program}: {share:g} of {wall}", file="lid 3.5 mm.step", program="FreeCAD 1.1.3", share=0.15,
                   wall=Length(2.5))
    assert translated(said) == "lid 3.5 mm.step, FreeCAD 1.1.3: 0,15 of 2,5\u00a0mm"
    assert translated("lid 3.5 mm.step has 2.5 mm") == "lid 3.5 mm.step has 2.5 mm"

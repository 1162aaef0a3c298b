# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the window says by the profile that is the default."""

import Part
import pytest
import window_actions as window

from thinpart_workbench.freecad_adapter.preferences import preference

RED = (0.84, 0.15, 0.12)

pytestmark = pytest.mark.default_profile


def test_it_is_the_calibrated_one():
    assert preference("Profile") == "calibrated"


def test_a_plate_is_thin_with_figures_and_the_advice_to_use_shells(document):
    window.add(document, "Plate", Part.makeBox(100, 60, 3))
    window.classify()
    assert window.text("ThinPart_Headline") == "Thin part"
    assert window.text("ThinPart_Why") == (
        "3\u00a0mm plate, 93\u00a0% of the surface: consider shells (Prepare mesh says whether they can be made).")
    assert window.text("ThinPart_HowSure").startswith("Probability: 87\u00a0%, next 'Part with thin features' with ")
    assert window.text("ThinPart_PaperVerdict") == ""  # the paper says the same


def test_a_bar_is_normal_where_the_paper_calls_it_thin(document):
    window.add(document, "Bar", Part.makeBox(20, 20, 200))
    window.classify()
    assert window.text("ThinPart_Headline") == "Normal part"
    assert window.text("ThinPart_Why") == (
        "Solid: no wall is thinner than 20\u00a0mm, 100\u00a0% of the width of 20\u00a0mm: mesh it with solids.")
    assert window.text("ThinPart_PaperVerdict") == (
        "By the paper's criteria: thin (criterion 4: 95\u00a0% of the surface over walls thinner than 50.5\u00a0mm).")


def test_a_block_with_a_thin_rib_has_thin_features_and_the_rib_is_red(document):
    rib = Part.makeBox(100, 2, 20)
    rib.Placement.Base.y, rib.Placement.Base.z = 29, 40
    feature = window.add(document, "Ribbed", Part.makeBox(100, 60, 40).fuse(rib))
    window.classify()
    assert window.text("ThinPart_Headline") == "Part with thin features"
    assert window.text("ThinPart_Why") == (
        "Solid core, 14\u00a0% of the surface is thin: a wall of 2\u00a0mm (3.3\u00a0% of the width). Refine the mesh "
        "there.")
    assert 2 <= window.rgb(feature).count(RED) < len(feature.Shape.Faces)


def test_between_two_categories_it_is_unsure_and_names_both(document):
    # A rib that is low, and somewhat thicker than 5 % of the width.
    rib = Part.makeBox(100, 4, 8)
    rib.Placement.Base.y, rib.Placement.Base.z = 29, 40
    block = Part.makeBox(100, 60, 40).fuse(rib)
    window.add(document, "Between", block)
    window.classify()
    assert window.text("ThinPart_Headline") in (
        "Unsure: thin features or normal", "Unsure: normal or thin features")
    text = window.text("ThinPart_HowSure")
    assert text.startswith("Unsure: '") and text.count("%") == 2 and " or '" in text


def test_the_risk_of_the_automatic_mesh_stands_beside_the_verdict_with_its_reasons(document):
    window.add(document, "Plate", Part.makeBox(100, 60, 3))
    window.classify()
    text = window.text("ThinPart_MeshRisk")
    assert text.startswith("Risk of the automatic mesh: ") and "%: " in text
    assert "a twentieth of the surface is thinner than 3\u00a0mm, 1/3.9 of an element" in text

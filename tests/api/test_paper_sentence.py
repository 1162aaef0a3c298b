# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the paper would say of a part that was judged by another profile."""

import copy

import made_library
import made_meshes
import pytest
from made_descriptors import part

from thinpart_workbench.api.window.verdicts import paper_sentence
from thinpart_workbench.core.descriptors.recorded_descriptors import recorded_descriptors
from thinpart_workbench.core.judging.classification import classify
from thinpart_workbench.core.judging.criteria import load_profile
from thinpart_workbench.core.length_unit import INCH
from thinpart_workbench.core.message import in_other_words
from thinpart_workbench.core.record.part_record import judge_again

CALIBRATED, PAPER = load_profile("calibrated"), load_profile("paper")
BOX = (100.0, 60.0, 40.0)
DIAGONAL = sum(side ** 2 for side in BOX) ** 0.5


def record_with(descriptors, category):
    """A record with such descriptors, of which the profile says `category`."""
    record = made_library.record_of("cube", category=category)
    axes = record["descriptors"]["box_axes"]
    record["descriptors"] = {**recorded_descriptors(descriptors, (1.0, 2.0, 3.0), 0.0, False, True), "box_axes": axes}
    paper = classify(descriptors, PAPER)
    record["paper"] = {"category": paper.category, "criteria": list(paper.criteria)}
    return record


@pytest.mark.parametrize("descriptors, category, said", [
    (part((150.0, 120.0, 8.0), 0.9, [(0.3, 1.0)]), "normal",
     "thin (criterion 1: its box is flat, 150 mm by 120 mm by 8 mm)."),
    (part((120.0, 100.0, 10.0), 0.4, [(0.3, 1.0)]), "normal",
     "thin (criterion 2: its box is flat, 120 mm by 100 mm by 10 mm)."),
    (part(BOX, 0.15, [(0.3, 1.0)]), "normal", "thin (criterion 3: it fills 15\u00a0% of its box)."),
    (part(BOX, 0.15, [(0.1, 0.9)]), "normal", "thin (criterion 3: it fills 15\u00a0% of its box; also 4)."),
    (part(BOX, 0.5, [(0.1, 0.7)]), "thin_features",
     "thin (criterion 4: 70\u00a0% of the surface over walls thinner than 30.8 mm)."),
    (part(BOX, 0.5, [(0.03, 0.1)]), "normal",
     "thin features (criterion 5: 10\u00a0% of the surface over walls thinner than 6.16 mm)."),
    (part(BOX, 0.5, [(0.2, 0.1), (0.5, 0.5)]), "normal",
     "thin features (criterion 6: 10\u00a0% of the surface over walls of 6.16 mm to 35.8 mm, beside a thick body)."),
    (part(BOX, 0.5, [], [(0.01, 30, 0.1)]), "thin",
     "thin features (criterion 7: walls at 10 to 55 degrees as near as 1.23 mm)."),
    (part(BOX, 0.5, [(0.5, 0.5)]), "thin_features", "normal (no criterion holds)."),
    (part(BOX, None, [(0.5, 0.5)]), "normal",
     "unknown. V/VBB could not be measured, so criterion 3 cannot be decided."),
])
def test_it_names_the_category_and_the_figure_that_decides(descriptors, category, said):
    record = record_with(descriptors, category)
    assert paper_sentence(record, CALIBRATED) == f"By the paper's criteria: {said}"


def test_it_is_judged_from_the_descriptors_and_changes_nothing():
    record = record_with(part(BOX, 0.5, [], [(0.01, 30, 0.1)]), "normal")
    record["paper"]["criteria"] = [5]
    before = copy.deepcopy(record)
    assert "criterion 7" in paper_sentence(record, CALIBRATED)
    assert record == before


def test_nothing_is_said_where_they_agree_or_by_the_paper_itself():
    record = record_with(part(BOX, 0.5, [(0.03, 0.1)]), "thin_features")
    assert paper_sentence(record, CALIBRATED) == ""
    record["category"] = "normal"  # by a profile of that name that was edited
    assert paper_sentence(record, PAPER) == ""


def test_lengths_follow_the_unit():
    record = record_with(part(BOX, 0.5, [], [(0.01, 30, 0.1)]), "normal")
    said = in_other_words(paper_sentence(record, CALIBRATED), lambda text: text, INCH)
    assert said.endswith("as near as 0.0485\u00a0in).")


def test_a_bar_that_was_measured_is_thin_by_the_paper_alone():
    record = made_library.measured_record("bar", made_meshes.box(20, 20, 200))
    assert record["category"] == "thin" and paper_sentence(record, PAPER) == ""
    from thinpart_workbench.core.record.part_record import descriptors_of

    judge_again(record, classify(descriptors_of(record), CALIBRATED))
    assert record["category"] == "normal"
    assert paper_sentence(record, CALIBRATED).startswith("By the paper's criteria: thin (criterion 4: 9")

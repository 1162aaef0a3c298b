# SPDX-License-Identifier: LGPL-2.1-or-later
"""What counts as trouble with an automatic mesh, and the tables of how often labels and verdicts foretell it."""

import math

import pytest
from made_descriptors import part

from benchmarks.solver_plot import write_plot
from benchmarks.solver_tables import solved_part, tables
from thinpart_workbench.core.judging.criteria import load_profile
from thinpart_workbench.workflow.learning.labels import LabelledPart
from thinpart_workbench.workflow.solving.automatic_mesh import NO_MESH, NOT_SOLVED, SOLVED, UNKNOWN, AutomaticMesh
from thinpart_workbench.workflow.solving.calculix_program import TIMEOUT
from thinpart_workbench.workflow.solving.mesh_trouble import has_trouble, is_refused

JACOBIAN = "in e_c3d: nonpositive jacobian determinant in element 52"
SIX = (1.0,) * 6


@pytest.mark.parametrize("found, trouble, refused", [
    (AutomaticMesh(SOLVED, 0.03, change=0.005, frequencies=SIX), False, False),
    (AutomaticMesh(SOLVED, 0.05, change=0.005, frequencies=SIX), True, False),
    (AutomaticMesh(SOLVED, 0.03, change=0.005, frequencies=SIX, is_tangled=True), False, True),
    (AutomaticMesh(SOLVED, 0.05, change=0.03, frequencies=SIX), None, False),  # it may be within the limit
    (AutomaticMesh(SOLVED, 0.08, change=0.03, frequencies=SIX), True, False),
    (AutomaticMesh(SOLVED, 0.01, change=0.03, frequencies=SIX), None, False),
    (AutomaticMesh(SOLVED, 0.08, frequencies=SIX), None, False),  # one reference mesh says nothing of itself
    (AutomaticMesh(NO_MESH, reason="Gmsh crashed"), True, False),
    (AutomaticMesh(NOT_SOLVED, reason=JACOBIAN, is_tangled=True), True, True),
    (AutomaticMesh(NOT_SOLVED, reason=TIMEOUT), None, True),
    (AutomaticMesh(UNKNOWN, reason=JACOBIAN), None, True),
    (AutomaticMesh(UNKNOWN, reason="the part took too long"), None, False),
    (AutomaticMesh(UNKNOWN, reason=JACOBIAN, frequencies=SIX), None, False),  # of a reference mesh
])
def test_what_is_known_decides(found, trouble, refused):
    assert (has_trouble(found), is_refused(found)) == (trouble, refused)


def test_another_error_may_be_stated():
    found = AutomaticMesh(SOLVED, 0.05, change=0.005, frequencies=SIX)
    assert has_trouble(found, 0.04) and not has_trouble(found, 0.06)


@pytest.fixture(scope="module")
def judged():
    """Six plates, five of them in trouble, and four blocks, one of them."""
    profiles = [load_profile("calibrated"), load_profile("paper")]
    plate = part((10.0, 10.0, 0.2), 0.9, [(0.02, 0.9)], plates=0.9)
    block = part((10.0, 9.0, 8.0), 0.9, [(0.5, 0.9)], plates=0.0)
    parts = []
    for number, (descriptors, label, error) in enumerate([
            *((plate, "thin", error) for error in (0.02, 0.1, 0.2, 0.3, 0.5)), (plate, "thin", None),
            *((block, "normal", error) for error in (0.01, 0.02, 0.03, 0.08))]):
        truth = AutomaticMesh(NO_MESH) if error is None else AutomaticMesh(SOLVED, error, change=0.001, frequencies=SIX)
        parts.append(solved_part(LabelledPart(f"{number}.step", "Body", "group", label, None, True, {}, descriptors, ()),
                                 truth, profiles))
    return parts, profiles


def test_tables_count_trouble_by_label_and_verdict(judged):
    outcomes, trouble, by_error, foretold = tables(*judged)
    assert outcomes.rows == [["no mesh", 1], ["off by more than 4 %", 5], ["within 4 %", 4]]
    assert trouble.rows[0] == ["label, sure", "thin", 6, "5, 83 %", "44 % to 97 %", "20.0 %", "83 %"]
    assert trouble.rows[2] == ["", "normal", 4, "1, 25 %", "5 % to 70 %", "2.5 %", "25 %"]
    verdicts = trouble.rows[6:9]
    assert [row[2:] for row in verdicts] == [row[2:] for row in trouble.rows[:3]], "each verdict is the label"
    assert [row[:4] for row in by_error.rows[1:]] == [
        ["4 %", "5 of 6, 83 %", "-", "1 of 4, 25 %"], ["6 %", "5 of 6, 83 %", "-", "1 of 4, 25 %"],
        ["10 %", "4 of 6, 67 %", "-", "0 of 4, 0 %"]]
    # Of 6 in trouble and 4 that are not, 5 and 1 are called thin: 5/6 * 3/4 + (5/6 * 1/4 + 1/6 * 3/4) / 2.
    areas = {row[0]: row[1] for row in foretold.rows}
    assert areas["label"].startswith("0.79 (") and areas["verdict, calibrated"] == areas["label"]
    assert areas["K[0;0.12], high"] == areas["label"]


def test_rows_hold_everything_and_the_plot_is_the_same_in_every_run(judged, tmp_path):
    parts, profiles = judged
    row = parts[5].row(profiles)
    assert (row["label"], row["trouble"], row["verdicts"]["paper"]["category"]) == ("thin", True, "thin")
    assert row["truth"]["outcome"] == NO_MESH and math.isclose(row["quantities"]["V/VBB"], 0.9)
    for name in ("one.svg", "two.svg"):
        write_plot(parts, profiles, tmp_path / name)
    assert (tmp_path / "one.svg").read_bytes() == (tmp_path / "two.svg").read_bytes()

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mesh settings that worked for one part, carried over to another."""

import pytest

from thinpart_workbench.core.record.mesh_settings import settings_for, wall_sizes_for, worked_settings
from thinpart_workbench.core.record.record_types import PART

FIGURES = {"elements": 5000, "poor_share": 0.001, "gamma_least": 0.2, "layers_share": 0.97, "tries": [
    {"what": "as proposed", "reason": "PLC Error", "seconds": 1.0}, {"what": "finer", "reason": "", "seconds": 2.0}]}


@pytest.fixture
def meshed():
    rows = [{"kind": "plate", "thickness": 2.0, "size": 0.5, "is_changed": True},
            {"kind": "plate", "thickness": 4.0, "size": 1.7, "is_changed": False},
            {"kind": "tube", "thickness": 2.0, "size": None, "is_changed": True}]
    settings = {"order": 1, "error": None, "layers": 3.0, "growth": 1.3, "size": 8.0, "budget": 9000}
    return worked_settings(settings, 8.0, 100.0, rows, FIGURES, "2026-01-02T03:04:05+00:00", "0.1.0")


def test_what_is_kept_is_as_the_definition_and_says_which_try_worked(meshed):
    assert PART.kinds["meshed"].holds(meshed) and meshed["how"] == "finer" and meshed["elements"] == 5000


def test_the_greatest_size_grows_with_the_part_and_a_budget_does_not_move(meshed):
    assert settings_for(meshed, 50.0) == {"order": 1, "error": None, "layers": 3.0, "growth": 1.3, "size": 4.0,
                                          "budget": None}
    assert settings_for({**meshed, "size_mm": None}, 50.0)["size"] is None


def test_sizes_that_people_chose_go_to_walls_of_the_same_kind_and_relative_thickness(meshed):
    walls = [("plate", 1.05), ("plate", 2.0), ("tube", 1.0), ("tube", 3.0), ("taper", 1.0)]
    # Half as large a part: a quarter of its first wall, none for the tube that was left out; what nobody chose stays.
    assert wall_sizes_for(meshed, walls, 50.0) == {0: pytest.approx(0.2625), 2: None}


@pytest.mark.parametrize("order, layers, kept", [(2, None, 0.05), (2, 1.0, None), (1, None, None)])
def test_the_error_aimed_at_is_kept_where_it_decided_the_sizes(order, layers, kept):
    settings = {"order": order, "error": 0.05, "layers": layers, "growth": 1.5, "size": None, "budget": None}
    found = worked_settings(settings, 8.0, 100.0, [], FIGURES, "2026-01-02T03:04:05+00:00", "0.1.0")
    assert PART.kinds["meshed"].holds(found) and found["error"] == kept
    assert settings_for(found, 50.0)["error"] == kept


def test_an_info_file_from_before_errors_were_aimed_at_had_layers(meshed):
    del meshed["error"]
    assert PART.kinds["meshed"].holds(meshed) and settings_for(meshed, 50.0)["error"] is None

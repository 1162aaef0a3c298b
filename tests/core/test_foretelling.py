# SPDX-License-Identifier: LGPL-2.1-or-later
"""How well quantities foretell trouble."""

import numpy as np
import pytest
from made_descriptors import part

from thinpart_workbench.core.descriptors.descriptor_table import quantity_named
from thinpart_workbench.core.judging.foretelling import area_interval, area_under_curve, foretellings


def test_the_area_is_the_share_of_pairs_in_order():
    chance = np.random.default_rng(5)
    yes, no = chance.integers(0, 20, 30) + 3.0, chance.integers(0, 20, 40) * 1.0
    pairs = np.mean((yes[:, None] > no) + 0.5 * (yes[:, None] == no))
    assert area_under_curve(yes, no) == pytest.approx(pairs)
    assert area_under_curve(np.array([np.inf, 2.0]), np.array([1.0])) == 1.0


def test_the_interval_solves_its_equation_and_does_not_vanish():
    low, high = area_interval(0.8, 30, 40)
    assert 0.5 < low < 0.8 < high < 1.0
    for end in (low, high):
        half = 0.5 * 70 - 1.0
        variance = end * (1 - end) * (1 + half * (1 - end) / (2 - end) + half * end / (1 + end)) / 1200
        assert abs(0.8 - end) == pytest.approx(1.959964 * np.sqrt(variance), rel=1e-5)
    low, high = area_interval(1.0, 10, 10)
    assert 0.6 < low < 0.9 and high == 1.0
    wide = area_interval(1.0, 3, 3)
    assert wide[0] < low, "few parts say less"


def test_the_interval_covers_the_truth_as_often_as_it_says():
    chance = np.random.default_rng(7)
    covered = []
    for _ in range(400):
        yes, no = chance.normal(1.0, 1.0, 25), chance.normal(0.0, 1.0, 25)
        low, high = area_interval(area_under_curve(yes, no), 25, 25)
        covered.append(low <= 0.7602 <= high)  # Phi(1 / sqrt 2)
    assert 0.91 < np.mean(covered) < 0.99


def test_quantities_are_sorted_by_what_they_foretell():
    fills = np.linspace(0.1, 0.9, 20)
    parts = [part(box=(1.0, 0.8, 0.5), fill=fill, walls=[(0.01, 0.5 * fill)]) for fill in fills]
    shares = quantity_named("F[0;0.05]"), quantity_named("F[0.3;0.7]")
    found = foretellings(parts, fills < 0.5, shares)
    best = {each.symbol: each for each in found if each.area == 1.0}
    assert best["V/VBB"].is_low and best["F[0;0.05]"].is_low and (best["V/VBB"].troubled, best["V/VBB"].others) == (10, 10)
    assert [each.area for each in found] == sorted((each.area for each in found), reverse=True)
    same = {each.symbol: each for each in found}["D2/D3"]
    assert same.area == 0.5 and same.low < 0.5 < same.high
    assert foretellings(parts, np.ones(20, bool)) == []


def test_parts_whose_value_is_unknown_are_left_out():
    parts = [part(fill=None if number % 2 else 0.1 * number + 0.05) for number in range(8)]
    found = {each.symbol: each for each in foretellings(parts, [number < 4 for number in range(8)])}
    assert (found["V/VBB"].troubled, found["V/VBB"].others) == (2, 2)

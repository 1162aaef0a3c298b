# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rotations with translations do what matrices written out do."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from thinpart_workbench.core.rigid_transform import (
    inverse,
    nearest_motion,
    rigid_transform,
    rotation,
    transform_directions,
    transform_points,
    translation,
)

QUARTER = rigid_transform([[0, -1, 0], [1, 0, 0], [0, 0, 1]], (10, 20, 30))
"""A quarter turn about z, then a move."""

seeds = st.integers(0, 2 ** 32 - 1)


def any_transform(random):
    return rigid_transform(Rotation.random(random_state=random.integers(2 ** 31)).as_matrix(),
                           random.normal(size=3) * 10.0 ** random.uniform(-3, 5))


def test_a_quarter_turn_and_a_move():
    assert np.array_equal(transform_points(QUARTER, (1, 0, 0)), [10, 21, 30])
    assert np.array_equal(transform_directions(QUARTER, (1, 0, 0)), [0, 1, 0])
    assert np.array_equal(translation(QUARTER), transform_points(QUARTER, (0, 0, 0)))
    assert np.array_equal(inverse(QUARTER), [[0, 1, 0, -20], [-1, 0, 0, 10], [0, 0, 1, -30], [0, 0, 0, 1]])
    assert np.array_equal(transform_points(QUARTER @ QUARTER, (1, 0, 0)), transform_points(QUARTER, (10, 21, 30)))


def test_points_may_be_scaled_too():
    doubled = np.diag((2.0, 2.0, 2.0, 1.0))
    assert np.array_equal(transform_points(doubled, [(1, 2, 3), (0, 0, 1)]), [(2, 4, 6), (0, 0, 2)])


def test_one_point_is_carried_as_each_of_many_is():
    points = np.arange(12.0).reshape(4, 3)
    assert np.array_equal(transform_points(QUARTER, points), [transform_points(QUARTER, each) for each in points])
    assert np.array_equal(transform_directions(QUARTER, points), [transform_directions(QUARTER, each) for each in points])
    assert transform_points(QUARTER, np.empty((0, 3))).shape == (0, 3)


@settings(max_examples=50, deadline=None)
@given(seeds)
def test_there_and_back(seed):
    random = np.random.default_rng(seed)
    first, second, points = any_transform(random), any_transform(random), random.normal(size=(5, 3))
    reach = 1.0 + np.abs(translation(first)).max() + np.abs(translation(second)).max()
    assert transform_points(inverse(first), transform_points(first, points)) == pytest.approx(points, abs=1e-14 * reach)
    assert inverse(first) == pytest.approx(np.linalg.inv(first), abs=1e-13 * reach)
    assert transform_points(second @ first, points) == pytest.approx(
        transform_points(second, transform_points(first, points)), abs=1e-13 * reach)
    assert inverse(second @ first) == pytest.approx(inverse(first) @ inverse(second), abs=1e-13 * reach)
    assert np.linalg.norm(transform_directions(first, points), axis=1) == pytest.approx(np.linalg.norm(points, axis=1))


@settings(max_examples=50, deadline=None)
@given(seeds)
def test_the_motion_between_points_is_found(seed):
    random = np.random.default_rng(seed)
    motion, points = any_transform(random), random.normal(size=(6, 3))
    found = nearest_motion(points, transform_points(motion, points))
    reach = 1.0 + np.abs(translation(motion)).max()
    assert found == pytest.approx(motion, abs=1e-10 * reach)


def test_a_mirror_image_is_reached_by_no_motion():
    points = np.random.default_rng(1).normal(size=(6, 3))
    motion = nearest_motion(points, points * (-1, 1, 1))
    assert np.linalg.det(rotation(motion)) == pytest.approx(1.0)
    assert np.abs(transform_points(motion, points) - points * (-1, 1, 1)).max() > 0.1

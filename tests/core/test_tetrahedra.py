# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tetrahedra of volume meshes: values that are known, and those of Gmsh."""

import numpy as np
import pytest

from thinpart_workbench.core.mesh.tetrahedra import radius_ratios, surface_share

REGULAR = np.array([[1.0, 1.0, 1.0], [1.0, -1.0, -1.0], [-1.0, 1.0, -1.0], [-1.0, -1.0, 1.0]])
CORNER = np.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]])
ALL = np.array([[0, 1, 2, 3]])


def test_a_regular_one_has_one_and_a_flat_one_nothing():
    assert radius_ratios(REGULAR, ALL) == pytest.approx([1.0])
    flat = REGULAR * [1.0, 1.0, 0.0]
    assert radius_ratios(flat, ALL).tolist() == [0.0]
    assert radius_ratios(np.zeros((4, 3)), ALL).tolist() == [0.0]


def test_the_corner_of_a_cube_has_the_known_ratio():
    # Inscribed radius 1 / (3 + sqrt 3), circumscribed sqrt 3 / 2.
    expected = 3.0 / (3.0 + np.sqrt(3.0)) / (np.sqrt(3.0) / 2.0)
    assert radius_ratios(CORNER, ALL) == pytest.approx([expected])


def test_the_ratio_depends_on_shape_alone():
    chance = np.random.default_rng(3)
    points = chance.normal(size=(4, 3))
    turn, _ = np.linalg.qr(chance.normal(size=(3, 3)))
    orders = np.array([chance.permutation(4) for _ in range(5)])
    ratio, = radius_ratios(points, ALL)
    assert radius_ratios(7.0 * points @ turn + [1e3, 0.0, -5.0], orders) == pytest.approx([ratio] * 5, rel=1e-9)


def test_the_share_of_the_surface_counts_outer_sides_only():
    points = np.vstack([CORNER, [1.0, 1.0, 1.0]])
    two = np.array([[0, 1, 2, 3], [1, 2, 3, 4]])
    own, other = 3 * 0.5, 3 * 0.5 * np.linalg.norm(np.cross(points[2] - points[1], points[4] - points[1]))
    assert surface_share(points, two, np.array([True, False])) == pytest.approx(own / (own + other))
    assert surface_share(points, two, np.array([True, True])) == pytest.approx(1.0)
    assert surface_share(points, two, np.array([False, False])) == 0.0

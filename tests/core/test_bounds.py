# SPDX-License-Identifier: LGPL-2.1-or-later
import brute_force
import made_meshes
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from thinpart_workbench.core.mesh.bounds import minimal_box, principal_box

angles = st.tuples(*[st.floats(-3.1, 3.1)] * 3)
sides = st.tuples(*[st.floats(0.01, 1000.0)] * 3)


@settings(max_examples=60, deadline=None)
@given(sides, angles)
def test_box_of_a_box_is_exact_under_any_rotation(size, turn):
    points = made_meshes.box(*size)[0] @ Rotation.from_rotvec(turn).as_matrix().T
    assert minimal_box(points).dimensions == pytest.approx(sorted(size, reverse=True), rel=1e-6)


def test_square_plate_is_not_turned_by_45_degrees(rng):
    plate = made_meshes.box(100, 100, 2)[0]
    for rotation in Rotation.random(20, random_state=1).as_matrix():
        box = minimal_box(plate @ rotation.T)
        assert box.dimensions == pytest.approx([100, 100, 2], rel=1e-6)
        assert box.axes @ box.axes.T == pytest.approx(np.eye(3), abs=1e-9)


def test_the_papers_principal_box_is_kept_as_it_is():
    points = made_meshes.box(30, 20, 10)[0]
    assert principal_box(points).dimensions == pytest.approx([30, 20, 10], rel=1e-9)


@pytest.mark.parametrize("shape", [
    made_meshes.ribbed_block(), made_meshes.wedge(), made_meshes.tube(),
    made_meshes.prism([(0, 0), (4, 0), (1, 3)], 5), made_meshes.sphere(),
    made_meshes.prism([(0, 0), (10, 0), (14, 6), (9, 12), (2, 9)], 4),
])
def test_same_dimensions_under_any_rotation(shape):
    reference = minimal_box(shape[0]).dimensions
    for rotation in Rotation.random(12, random_state=2).as_matrix():
        assert minimal_box(shape[0] @ rotation.T).dimensions == pytest.approx(reference, rel=1e-3)


def _random_points(seed):
    random = np.random.default_rng(seed)
    return random.normal(size=(random.integers(4, 200), 3)) * random.uniform(0.3, 3.0, 3)


def _ellipsoid(a, b, c, steps):
    return made_meshes.sphere(1.0, steps)[0] * [a, b, c]


def _skewed(a, b, c, by):
    corners = made_meshes.box(a, b, c)[0]
    return corners + np.outer(corners[:, 2], by)


TETRAHEDRON = np.array([[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]], dtype=float)
ROUND = np.linspace(0, 2 * np.pi, 120, endpoint=False)

SHAPES = {
    **{f"random {seed}": _random_points(seed) for seed in range(10)},
    "regular tetrahedron": TETRAHEDRON,
    "long tetrahedron": TETRAHEDRON * [1, 2, 5],
    "corner cut off": made_meshes.box(1, 1, 1)[0][:7],
    "skewed bar": _skewed(1, 1, 10, [0.3, 0.1, 0]),
    "skewed plate": _skewed(30, 20, 2, [0.8, 0.5, 0]),
    "cone": np.vstack([np.column_stack([np.cos(ROUND), np.sin(ROUND), 0 * ROUND]), [[0, 0, 2]]]),
    "tube": made_meshes.tube()[0],
    "ribbed block": made_meshes.ribbed_block()[0],
    "triangular prism": made_meshes.prism([(0, 0), (4, 0), (1, 3)], 5)[0],
    "ellipsoid": _ellipsoid(3, 2, 1, 60),
    "fine ellipsoid": _ellipsoid(50, 20, 17, 220),
    "fine ring": made_meshes.revolved([(20, -5), (50, 0), (20, 5)], 2400)[0],
    "two balls": made_meshes.joined(
        made_meshes.sphere(5, 90), made_meshes.moved(made_meshes.sphere(3, 90), shift=(20, 8, 3)))[0],
    "bent plate": made_meshes.prism([(0, 0), (50, 0), (80, 30), (78, 32), (49, 2), (0, 2)], 40)[0],
}


@pytest.mark.parametrize("name", SHAPES)
def test_within_a_fifth_of_a_percent_of_a_dense_search(name):
    turn = Rotation.random(random_state=sum(name.encode())).as_matrix()
    points = SHAPES[name] @ turn
    assert minimal_box(points).volume <= 1.002 * brute_force.box_volume(points)


def test_all_points_lie_inside(rng):
    points = rng.normal(size=(5000, 3)) * [1, 2, 5]
    box = minimal_box(points)
    assert np.ptp(points @ box.axes.T, axis=0) == pytest.approx(box.dimensions, rel=1e-12)


def test_points_in_a_plane_have_a_flat_box():
    points = made_meshes.box(100, 50, 0)[0] @ Rotation.from_rotvec([1, 2, 3]).as_matrix()
    assert minimal_box(points).dimensions == pytest.approx([100, 50, 0], abs=1e-9)

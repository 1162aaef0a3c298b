# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curved tetrahedra that are inside out are found, and their sides made straight."""

import numpy as np
import pytest

from thinpart_workbench.core.mesh.second_order import LEAST, SIDES, least_jacobians, straightened

RNG = np.random.default_rng(5)

CORNERS = np.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]])


def curved(corners, tetrahedra):
    """Points and elements of second order with straight sides: neighbours share the middles of their sides."""
    points, number, rows = list(corners), {}, []
    for row in tetrahedra:
        middles = []
        for one, other in SIDES:
            side = tuple(sorted((row[one], row[other])))
            if side not in number:
                number[side] = len(points)
                points.append(0.5 * (corners[side[0]] + corners[side[1]]))
            middles.append(number[side])
        rows.append([*row, *middles])
    return np.array(points), np.array(rows)


def mapped(points, nodes, place):
    """Where a place within an element lies, by the shape functions of textbooks."""
    corner = np.append(1.0 - place.sum(), place)
    weights = [*(corner * (2.0 * corner - 1.0)), *(4.0 * corner[one] * corner[other] for one, other in SIDES)]
    return np.array(weights) @ points[nodes]


def jacobian(points, nodes, place, step=1e-5):
    """The determinant at a place, by differences."""
    slopes = [(mapped(points, nodes, place + step * axis) - mapped(points, nodes, place - step * axis)) / (2.0 * step)
              for axis in np.eye(3)]
    return np.linalg.det(np.array(slopes))


def middle(tetrahedra, row, one, other):
    """The point half-way along a side of an element."""
    return tetrahedra[row, 4 + SIDES.index((one, other))]


@pytest.fixture
def single():
    return curved(CORNERS, [(0, 1, 2, 3)])


@pytest.fixture
def pair():
    """Two on either side of a triangle."""
    return curved(np.vstack([CORNERS, [1.0, 1.0, 1.0]]), [(0, 1, 2, 3), (1, 2, 3, 4)])


def test_straight_sides_have_the_jacobian_of_straight_sides(pair):
    assert least_jacobians(*pair) == pytest.approx([1.0, 1.0])


def test_the_least_jacobian_is_that_of_differences_at_the_places_that_are_checked():
    inner = (5.0 - 5.0 ** 0.5) / 20.0
    corner = np.eye(4)
    places = np.concatenate([corner, [0.5 * (corner[one] + corner[other]) for one, other in SIDES],
                             inner + (1.0 - 4.0 * inner) * corner])[:, 1:]
    for _ in range(20):
        points, tetrahedra = curved(RNG.normal(size=(4, 3)), [(0, 1, 2, 3)])
        straight = jacobian(points, tetrahedra[0], places[0])
        points[4:] += 0.15 * RNG.normal(size=(6, 3))
        expected = min(jacobian(points, tetrahedra[0], place) / straight for place in places)
        assert least_jacobians(points, tetrahedra)[0] == pytest.approx(expected, rel=1e-4, abs=1e-4)


def test_an_element_inside_out_is_straightened(single):
    points, tetrahedra = single
    straight = points.copy()
    points[middle(tetrahedra, 0, 0, 1)] += [0.0, 0.9, 0.9]  # through the opposite side
    assert least_jacobians(points, tetrahedra)[0] < 0.0
    found, moved = straightened(points, tetrahedra)
    assert found == pytest.approx(straight) and middle(tetrahedra, 0, 0, 1) in moved
    assert least_jacobians(found, tetrahedra)[0] == pytest.approx(1.0)


def test_a_curved_one_that_is_not_is_not_touched(pair):
    points, tetrahedra = pair
    points[5:] += 0.02 * RNG.normal(size=(len(points) - 5, 3))
    assert LEAST < least_jacobians(points, tetrahedra).min() < 0.99
    found, moved = straightened(points, tetrahedra)
    assert (found == points).all() and len(moved) == 0 and moved.dtype == np.int64


def test_the_other_one_at_a_side_keeps_its_own_sides(pair):
    points, tetrahedra = pair
    own, outer = middle(tetrahedra, 1, 0, 3), middle(tetrahedra, 0, 0, 1)
    points[own] += [0.03, -0.02, 0.04]  # a gentle curve of the second one alone
    points[outer] += [0.0, 0.9, 0.9]
    least = least_jacobians(points, tetrahedra)
    assert least[0] < 0.0 < LEAST < least[1]
    found, moved = straightened(points, tetrahedra)
    assert own not in moved and (found[own] == points[own]).all()
    assert set(moved) <= set(tetrahedra[0, 4:]) and least_jacobians(found, tetrahedra).min() > LEAST


def test_one_that_is_inside_out_only_since_a_neighbour_was_straightened_is_straightened_too():
    """A bend by a square of x changes no volume, nor corners whose x is 0 or 1; a flat element needs all its sides bent."""
    corners = np.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.3, -1.0], [1.0, 0.3, 0.02]])
    points, tetrahedra = curved(corners, [(0, 2, 1, 3), (0, 1, 2, 4)])
    points[:, 2] -= 1.5 * points[:, 0] * (1.0 - points[:, 0])
    assert least_jacobians(points, tetrahedra) == pytest.approx([1.0, 1.0])
    bad = middle(tetrahedra, 0, 0, 3)
    points[bad] += [1.5, 0.0, 0.0]
    least = least_jacobians(points, tetrahedra)
    assert least[0] < 0.0 and least[1] == pytest.approx(1.0), "the second one is sound until the first is straight"
    found, moved = straightened(points, tetrahedra)
    assert set(moved) == set(tetrahedra[:, 4:].ravel()) and least_jacobians(found, tetrahedra) == pytest.approx([1.0, 1.0])


@pytest.mark.parametrize("turn", [1.0, -1.0])
def test_neither_depends_on_an_affine_map(pair, turn):
    points, tetrahedra = pair
    points[5:] += 0.3 * RNG.normal(size=(len(points) - 5, 3))
    matrix, shift = RNG.normal(size=(3, 3)), np.array([4.0, -3.0, 8.0])
    matrix *= np.sign(np.linalg.det(matrix)) * turn
    other = points @ matrix + shift
    assert least_jacobians(other, tetrahedra) == pytest.approx(least_jacobians(points, tetrahedra))
    (found, moved), (found_of_other, moved_of_other) = straightened(points, tetrahedra), straightened(other, tetrahedra)
    assert len(moved) and (moved == moved_of_other).all() and found_of_other == pytest.approx(found @ matrix + shift)


def test_an_element_without_volume_counts_as_bad_and_is_no_endless_loop(single):
    points, tetrahedra = single
    points[:, 2] = 0.0
    points[4:] += 0.1
    assert least_jacobians(points, tetrahedra)[0] == 0.0
    found, moved = straightened(points, tetrahedra)
    assert len(moved) == 6 and np.isfinite(found).all() and (found[:4] == points[:4]).all()


def test_without_elements_nothing_moves():
    found, moved = straightened(CORNERS, np.zeros((0, 10), np.int64))
    assert (found == CORNERS).all() and len(moved) == 0

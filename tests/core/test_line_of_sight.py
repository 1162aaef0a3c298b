# SPDX-License-Identifier: LGPL-2.1-or-later
"""From where walls are seen: lines of sight past what stands before them."""

import made_meshes
import numpy as np
import pytest

from thinpart_workbench.core.rays.line_of_sight import Scene, best_sight

DOWN = np.array([0.0, 0.0, -1.0])


def _corners(*meshes):
    points, triangles = made_meshes.joined(*meshes)
    return points[triangles]


def _plate():
    return made_meshes.box(100.0, 100.0, 1.0)


WALL = np.array([40.0, 60.0, 1.0]), np.array([40.0, 60.0, 0.0])


def _blocked(scene, sight):
    start = sight.target - 1e-3 * sight.direction
    return np.isfinite(scene.distances(start, -sight.direction[None])[0])


@pytest.mark.parametrize("shift", [(0.0, 0.0, 0.0), (1e4, -2e4, 5e3)])
def test_an_open_wall_is_seen_from_the_side_that_the_view_is_on(shift):
    scene = Scene(_corners(_plate()) + shift)
    for current, end in ((DOWN, 0), (-DOWN, 1)):
        sight = best_sight(scene, [tuple(WALL + np.array(shift))], current)
        assert sight.is_free and sight.target == pytest.approx(WALL[end] + shift, abs=1e-6)
        assert sight.direction @ current == pytest.approx(np.cos(np.radians(50.0)))
        assert not _blocked(scene, sight)


def test_a_wall_under_a_roof_is_seen_from_below_or_past_the_roof():
    roof = made_meshes.moved(made_meshes.box(300.0, 300.0, 1.0), shift=(-100.0, -100.0, 5.0))
    scene = Scene(_corners(_plate(), roof))
    sight = best_sight(scene, [WALL], DOWN)
    assert sight.is_free and sight.target == pytest.approx(WALL[1]) and not _blocked(scene, sight)
    narrow = made_meshes.moved(made_meshes.box(10.0, 10.0, 1.0), shift=(35.0, 55.0, 5.0))
    floor = made_meshes.moved(made_meshes.box(300.0, 300.0, 1.0), shift=(-100.0, -100.0, -5.0))
    scene = Scene(_corners(_plate(), narrow, floor))
    sight = best_sight(scene, [WALL], DOWN)
    assert sight.is_free and sight.target == pytest.approx(WALL[0]) and not _blocked(scene, sight)


def test_a_floor_deep_in_a_shaft_is_seen_from_above():
    block = made_meshes.box(100.0, 100.0, 100.0)
    shaft = made_meshes.inverted(made_meshes.moved(made_meshes.box(10.0, 10.0, 99.0), shift=(45.0, 45.0, 1.0)))
    points, triangles = made_meshes.joined(block, shaft)
    corners = points[triangles]
    is_lid = (corners[:, :, 2] == 100.0).all(axis=1)  # the shaft is open
    base = made_meshes.moved(made_meshes.box(300.0, 300.0, 1.0), shift=(-100.0, -100.0, -2.0))
    scene = Scene(np.concatenate([corners[~is_lid], _corners(base)]))
    wall = np.array([50.0, 50.0, 1.0]), np.array([50.0, 50.0, 0.0])
    sight = best_sight(scene, [wall], np.array([1.0, 0.0, 0.0]))
    assert sight.is_free and sight.target == pytest.approx(wall[0]) and sight.direction[2] < -0.98


def test_what_is_enclosed_is_seen_from_nowhere_but_at_another_place_it_may_be():
    case = made_meshes.inverted(made_meshes.moved(made_meshes.box(300.0, 300.0, 300.0), shift=(-100.0, -100.0, -100.0)))
    scene = Scene(_corners(_plate(), case))
    sight = best_sight(scene, [WALL], DOWN)
    assert not sight.is_free and np.isinf(sight.cost) and np.linalg.norm(sight.direction) == pytest.approx(1.0)
    outside = made_meshes.moved(_plate(), shift=(1000.0, 0.0, 0.0))
    other = tuple(end + (1000.0, 0.0, 0.0) for end in WALL)
    sight = best_sight(Scene(_corners(_plate(), case, outside)), [WALL, other], DOWN)
    assert sight.is_free and sight.target == pytest.approx(other[0])


def test_the_target_lies_on_the_facets_that_are_drawn():
    """The facets of a round wall lie under it, or the other way round in a bore."""
    tube = made_meshes.tube(20.0, 18.0, 60.0, steps=24)
    middle = np.pi / 24
    across = np.array([np.cos(middle), np.sin(middle), 0.0])
    scene = Scene(_corners(tube))
    ends = 20.0 * across + (0.0, 0.0, 30.0), 18.0 * across + (0.0, 0.0, 30.0)
    sight = best_sight(scene, [ends], -across)
    assert sight.is_free
    assert np.linalg.norm(sight.target[:2]) == pytest.approx(20.0 * np.cos(middle), rel=1e-6)


def test_nothing_drawn_hides_nothing():
    sight = best_sight(Scene(np.empty((0, 3, 3))), [WALL], DOWN)
    assert sight.is_free and sight.target == pytest.approx(WALL[0])

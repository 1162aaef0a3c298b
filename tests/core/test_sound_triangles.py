# SPDX-License-Identifier: LGPL-2.1-or-later
"""Triangles of shells that a solver takes: slivers, inside-out ones, sharp bends, what hangs on by a node."""

import numpy as np
import pytest

from thinpart_workbench.core.shells.sound_triangles import least_jacobians, sound_triangles


def with_middles(points, corners):
    """The same triangles with straight sides of second order, which neighbours share."""
    points, ends = list(map(np.asarray, points)), {}
    rows = []
    for triangle in corners:
        middles = []
        for first, second in ((0, 1), (1, 2), (2, 0)):
            side = tuple(sorted((triangle[first], triangle[second])))
            if side not in ends:
                ends[side] = len(points)
                points.append(0.5 * (points[side[0]] + points[side[1]]))
            middles.append(ends[side])
        rows.append([*triangle, *middles])
    return np.array(points, dtype=float), np.array(rows, dtype=np.int64)


SQUARE = [(0, 0, 0), (10, 0, 0), (10, 10, 0), (0, 10, 0)]


def test_sound_triangles_stay_as_they_are():
    points, triangles = with_middles(SQUARE, [(0, 1, 2), (0, 2, 3)])
    found = sound_triangles(points, triangles, np.full(2, 1.0))
    assert all((a == b).all() for a, b in zip(found, (points, triangles, [0, 1])))


@pytest.mark.parametrize("order", [1, 2])
def test_a_bevel_at_the_rim_becomes_a_part_of_it(order):
    bevel = [(10.05, 0, 0.05), (10.05, 10, 0.05)]
    corners = [(0, 1, 2), (0, 2, 3), (1, 4, 5), (1, 5, 2)]
    points, triangles = with_middles([*SQUARE, *bevel], corners)
    triangles = triangles[:, :3 * order]
    points, triangles, kept = sound_triangles(points, triangles, np.full(4, 1.0))
    assert kept.tolist() == [0, 1]
    assert points[triangles[:, :3]].reshape(-1, 3).max(axis=0) == pytest.approx([10.025, 10.0, 0.025])
    assert least_jacobians(points, triangles, np.full(2, 1.0)).min() > 0.5


def test_a_triangle_that_a_small_hole_turned_inside_out_gets_straight_sides():
    points, triangles = with_middles(SQUARE, [(0, 1, 2), (0, 2, 3)])
    across = triangles[0, 5]  # the middle of the diagonal that both share
    points[across] = (11.0, -1.0, 0.0)
    assert least_jacobians(points, triangles, np.full(2, 1.0)).min() < 0.0
    points, triangles, kept = sound_triangles(points, triangles, np.full(2, 1.0))
    assert kept.tolist() == [0, 1] and points[across] == pytest.approx([5.0, 5.0, 0.0])


def strip(radius, steps, length=10.0):
    """A plate that is bent by 90 degrees in some steps, with straight ends."""
    angles = np.linspace(0.0, 0.5 * np.pi, steps + 1)
    outline = [(-20.0, radius), *zip(radius * np.sin(angles), radius * np.cos(angles)), (radius, -20.0)]
    points = [(x, y, z) for x, z in outline for y in (0.0, length)]
    corners = [(2 * k, 2 * k + 1, 2 * k + 3) for k in range(len(outline) - 1)]
    corners += [(2 * k, 2 * k + 3, 2 * k + 2) for k in range(len(outline) - 1)]
    return with_middles(points, corners)


@pytest.mark.parametrize("radius, has_bend", [(4.0, True), (0.4, False)])
def test_a_bend_of_less_than_half_of_the_thickness_becomes_sharp(radius, has_bend):
    points, triangles = strip(radius, 6)
    thickness = np.full(len(triangles), 2.0)
    points, triangles, kept = sound_triangles(points, triangles, thickness)
    assert least_jacobians(points, triangles, thickness[kept]).min() > 0.0
    assert (len(kept) == len(thickness)) == has_bend
    a, b, c = points[triangles[:, :3].T]
    area = 0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1).sum()
    assert area == pytest.approx(10.0 * (40.0 + 0.5 * np.pi * radius), rel=0.02)


def test_what_hangs_on_by_a_node_is_left_out_where_it_is_small():
    points, triangles = with_middles([*SQUARE, (11, 11, 0), (11, 10.5, 0)], [(0, 1, 2), (0, 2, 3), (2, 4, 5)])
    assert sound_triangles(points, triangles, np.full(3, 1.0))[2].tolist() == [0, 1]
    points, triangles = with_middles([*SQUARE, (20, 10, 0), (20, 20, 0)], [(0, 1, 2), (0, 2, 3), (2, 4, 5)])
    assert sound_triangles(points, triangles, np.full(3, 1.0))[2].tolist() == [0, 1, 2]

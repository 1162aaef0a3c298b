# SPDX-License-Identifier: LGPL-2.1-or-later
"""Faces that are near each other through the material: against all pairs of facets, and with known answers."""

import numpy as np
import pytest
from scipy.optimize import minimize

from thinpart_workbench.core.mesh.surface_mesh import surface_mesh
from thinpart_workbench.core.rays.close_triangles import closest_points_of_triangles, facing_triangles
from thinpart_workbench.core.walls.near_faces import near_faces

BOX = np.array([[0, 2, 1], [0, 3, 2], [4, 5, 6], [4, 6, 7], [0, 1, 5], [0, 5, 4], [1, 2, 6], [1, 6, 5], [2, 3, 7], [2, 7, 6],
                [3, 0, 4], [3, 4, 7]])
FACES = np.repeat(np.arange(6), 2)


def box(lengths, moved=(0.0, 0.0, 0.0)):
    corners = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]], dtype=float)
    return corners * lengths + moved


def mesh_of(*boxes):
    """One mesh of boxes, each with its own faces."""
    points = np.concatenate(boxes)
    triangles = np.concatenate([BOX + 8 * number for number in range(len(boxes))])
    return surface_mesh(points, triangles, np.concatenate([FACES + 6 * number for number in range(len(boxes))]))


def found(mesh, below, least=0.0):
    return [(tuple(sorted((wall.face, wall.opposite_face))), wall.distance)
            for wall in near_faces(mesh, lambda: below, least)]


def test_the_sides_of_a_plate_are_found_and_no_others():
    assert found(mesh_of(box((50.0, 30.0, 2.0))), 2.1) == [((0, 1), pytest.approx(2.0))]
    assert found(mesh_of(box((50.0, 30.0, 2.0))), 1.9) == []
    assert [distance for _, distance in found(mesh_of(box((50.0, 30.0, 2.0))), 60.0)] == pytest.approx([2.0, 30.0, 50.0])


def test_what_faces_each_other_through_the_air_is_not_found():
    apart = mesh_of(box((50.0, 30.0, 2.0)), box((50.0, 30.0, 2.0), (0.0, 0.0, 3.0)))
    assert found(apart, 1.9) == []
    assert {faces for faces, distance in found(apart, 2.5)} == {(0, 1), (6, 7)}


def test_what_is_nearer_than_the_least_is_left_out():
    plate = mesh_of(box((50.0, 30.0, 2.0)))
    assert found(plate, 60.0, 25.0) == [((2, 4), pytest.approx(30.0)), ((3, 5), pytest.approx(50.0))]


def test_the_search_ends_as_soon_as_a_thin_one_is_known():
    """The distance gets less meanwhile: faces beyond it are not looked for."""
    limit = [60.0]
    mesh, seen = mesh_of(box((50.0, 30.0, 2.0))), []
    for wall in near_faces(mesh, lambda: limit[0], 0.0):
        seen.append(wall.distance)
        limit[0] = wall.distance
    assert seen == [pytest.approx(2.0)]


def test_triangles_are_those_of_all_pairs():
    """On small triangles in any place, against every two of them."""
    random = np.random.default_rng(3)
    corners = random.uniform(0.0, 10.0, (400, 1, 3)) + random.uniform(-0.6, 0.6, (400, 3, 3))
    mesh = surface_mesh(corners.reshape(-1, 3), np.arange(1200).reshape(-1, 3), np.arange(400) // 4)
    below, cosine = 1.5, -0.3
    left_out = np.array([[3, 7, 20], [5, 90, 21]])
    pairs = set(map(tuple, np.sort(np.stack(facing_triangles(mesh, below, cosine, left_out)), axis=0).T.tolist()))
    first, second = np.triu_indices(mesh.count, 1)
    here, there = closest_points_of_triangles(mesh.corners[first], mesh.corners[second])
    faces = np.sort(mesh.face_of_triangle[np.stack([first, second])], axis=0)
    is_left_out = (faces[:, :, None] == left_out[:, None, :]).all(axis=0).any(axis=1)

    def is_beneath(one, other):
        return (np.einsum("mkj,mj->mk", mesh.corners[other] - mesh.corners[one][:, :1], mesh.normals[one]) < 0.0).any(axis=1)

    expected = (np.linalg.norm(here - there, axis=1) < below) & (faces[0] != faces[1]) & ~is_left_out \
        & (np.einsum("ij,ij->i", mesh.normals[first], mesh.normals[second]) < cosine) \
        & is_beneath(first, second) & is_beneath(second, first)
    assert expected.sum() > 100
    assert set(zip(first[expected].tolist(), second[expected].tolist())) <= pairs
    assert not {(0, 1), (4, 5)} & pairs and all(
        mesh.face_of_triangle[one] != mesh.face_of_triangle[other] for one, other in pairs)


def test_closest_points_of_triangles_are_those_of_a_search():
    random = np.random.default_rng(5)
    first, second = random.normal(size=(2, 40, 3, 3)) + np.array([[[[0.0]]], [[[2.0]]]])
    here, there = closest_points_of_triangles(first, second)
    for one, other, start, end in zip(first, second, here, there):
        def square(weights, one=one, other=other):
            return ((_at(weights[:2]) @ one - _at(weights[2:]) @ other) ** 2).sum()

        limits = [{"type": "ineq", "fun": lambda w: 1.0 - w[0] - w[1]}, {"type": "ineq", "fun": lambda w: 1.0 - w[2] - w[3]}]
        least = min(minimize(square, begin, bounds=[(0.0, 1.0)] * 4, constraints=limits).fun
                    for begin in ([0.3, 0.3, 0.3, 0.3], [0.9, 0.05, 0.05, 0.9], [0.05, 0.9, 0.9, 0.05]))
        assert ((start - end) ** 2).sum() == pytest.approx(least, rel=1e-3, abs=1e-5)


def _at(weights):
    return np.array([weights[0], weights[1], 1.0 - weights.sum()])

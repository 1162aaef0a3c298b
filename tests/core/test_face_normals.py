# SPDX-License-Identifier: LGPL-2.1-or-later
"""Normals of round and free-form faces at points of them."""

import numpy as np
import pytest

from thinpart_workbench.core.mesh.face_normals import FaceNormals, NodeNormals, RoundFaces
from thinpart_workbench.core.mesh.surface_mesh import surface_mesh

CENTRE = np.array([3.0, -2.0, 7.0])
AXIS = np.array([2.0, 3.0, 6.0]) / 7.0
ONE = np.array([3.0, -2.0, 0.0]) / np.sqrt(13.0)
OTHER = np.cross(AXIS, ONE)


def known(has_centre, major, slope):
    return FaceNormals(
        3,
        RoundFaces(np.array([2]), CENTRE[None], AXIS[None], np.array([has_centre]), np.array([major]), np.array([slope])),
        NodeNormals(np.empty(0, dtype=np.int64), np.empty((0, 3)), np.empty((0, 3)), 0.1),
    )


def directions(rng, count):
    """Angles around the axis, and unit vectors to there."""
    angle = rng.uniform(0.0, 2.0 * np.pi, count)
    return np.cos(angle)[:, None] * ONE + np.sin(angle)[:, None] * OTHER


def cylinder(rng):
    out = directions(rng, 50)
    return known(False, 0.0, 0.0), CENTRE + 4.0 * out + rng.uniform(-9.0, 9.0, 50)[:, None] * AXIS, out


def cone(rng):
    out, height = directions(rng, 50), rng.uniform(-9.0, 9.0, 50)[:, None]
    slope = np.tan(0.4)
    normals = np.cos(0.4) * out - np.sin(0.4) * np.sign(height) * AXIS
    return known(False, 0.0, slope), CENTRE + np.abs(height) * slope * out + height * AXIS, normals


def sphere(rng):
    out = rng.normal(size=(50, 3))
    out[0] = AXIS
    out /= np.linalg.norm(out, axis=1)[:, None]
    return known(True, 0.0, 0.0), CENTRE + 4.0 * out, out


def torus(rng):
    out, around = directions(rng, 50), rng.uniform(0.0, 2.0 * np.pi, 50)[:, None]
    normals = np.cos(around) * out + np.sin(around) * AXIS
    return known(True, 5.0, 0.0), CENTRE + 5.0 * out + 1.5 * normals, normals


@pytest.mark.parametrize("shape", [cylinder, cone, sphere, torus])
def test_a_round_face_has_the_normals_of_its_surface(shape):
    of_faces, points, normals = shape(np.random.default_rng(1))
    found = of_faces.at(np.full(len(points), 2), points.T).T
    side = np.sign(np.einsum("ij,ij->i", found, normals))
    assert found * side[:, None] == pytest.approx(normals, abs=1e-12)
    assert of_faces.is_known.tolist() == [False, False, True]


def test_there_is_no_normal_on_the_axis_of_a_cone():
    of_faces, _, _ = cone(np.random.default_rng(1))
    assert (of_faces.at(np.array([2]), CENTRE[:, None]) == 0.0).all()


def test_nodes_have_the_normal_of_their_own_face_and_points_beside_them_none():
    empty = np.empty(0)
    nodes = NodeNormals(np.array([0, 1, 1]), np.array([[0.0, 0, 0], [0, 0, 0], [1, 0, 0]]),
                        np.array([[0.0, 0, 2], [0, 3, 0], [1, 0, 0]]), 0.01)
    no_round_faces = RoundFaces(empty.astype(int), np.empty((0, 3)), np.empty((0, 3)), empty > 0, empty, empty)
    of_faces = FaceNormals(2, no_round_faces, nodes)
    points = np.array([[0.001, 0, 0], [0.001, 0, 0], [1, 0.005, 0], [0.5, 0, 0], [1.0, 0, 0]]).T
    found = of_faces.at(np.array([0, 1, 1, 1, 0]), points).T
    assert found.tolist() == [[0, 0, 1], [0, 1, 0], [1, 0, 0], [0, 0, 0], [0, 0, 0]]


def quarter_of_a_cylinder(normals=None):
    """The mesh of a curved face with facets of 15 degrees, radius 1, that faces away from its axis."""
    angle = np.radians(np.arange(0.0, 91.0, 15.0))
    rim = np.column_stack([np.cos(angle), np.sin(angle)])
    points = np.concatenate([np.column_stack([rim, np.full(7, height)]) for height in (0.0, 2.0)])
    first = np.arange(6)
    triangles = np.concatenate(
        [np.column_stack([first, first + 1, first + 8]), np.column_stack([first, first + 8, first + 7])])
    return surface_mesh(points, triangles, np.zeros(12, dtype=int), face_normals=normals)


def test_the_normals_at_the_border_of_a_face_are_those_of_the_geometry():
    cylinder = FaceNormals(
        1, RoundFaces(np.array([0]), np.zeros((1, 3)), np.array([[0.0, 0, 1]]), np.array([False]), np.zeros(1), np.zeros(1)),
        NodeNormals(np.empty(0, dtype=np.int64), np.empty((0, 3)), np.empty((0, 3)), 0.1))

    def off(mesh):
        points = (mesh.corners + mesh.origin)[..., :2].transpose(1, 2, 0)
        cosine = np.einsum("ijk,ijk->ik", mesh.corner_normals[:, :2], points)
        return np.degrees(np.arccos(np.clip(np.abs(cosine), 0.0, 1.0)))

    assert off(quarter_of_a_cylinder()).max() == pytest.approx(7.5, abs=0.1)
    mesh = quarter_of_a_cylinder(cylinder)
    assert off(mesh).max() < 1e-4
    assert (np.einsum("ijk,kj->ik", mesh.corner_normals, mesh.normals) > 0.9).all()  # to the side of the facets


def test_normals_that_are_far_from_the_facets_are_not_taken():
    turned = FaceNormals(
        1, RoundFaces(np.array([0]), np.zeros((1, 3)), np.array([[1.0, 0, 0]]), np.array([False]), np.zeros(1), np.zeros(1)),
        NodeNormals(np.empty(0, dtype=np.int64), np.empty((0, 3)), np.empty((0, 3)), 0.1))
    own, other = quarter_of_a_cylinder(), quarter_of_a_cylinder(turned)
    far = np.abs(np.einsum("ijk,ijk->ik", own.corner_normals, other.corner_normals)) < np.cos(np.radians(30.0))
    assert not far.any()

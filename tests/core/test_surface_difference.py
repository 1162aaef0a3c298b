# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where a surface lies apart from another one."""

import made_meshes
import numpy as np
import pytest

from thinpart_workbench.core.forms.nearest_on_mesh import NearestOnMesh
from thinpart_workbench.core.maps.surface_difference import surface_difference
from thinpart_workbench.core.mesh.surface_mesh import surface_mesh
from thinpart_workbench.core.rays.closest_points import closest_weights

SIDES = np.array([60.0, 40.0, 4.0])
AREA = 2.0 * (60.0 * 40.0 + 60.0 * 4.0 + 40.0 * 4.0)


def plate():
    return surface_mesh(*made_meshes.box(*SIDES))


def areas(corners):
    sides = corners[:, 1:] - corners[:, :1]
    return 0.5 * np.linalg.norm(np.cross(sides[:, 0], sides[:, 1]), axis=1)


def test_it_is_cut_where_the_distance_is_the_tolerance():
    # Half-lengths are from the middle: everything beyond x = 10 is apart.
    found = surface_difference(plate(), lambda points: np.maximum(points[:, 0] - 9.0, 0.0), 1.0)
    assert found.greatest == pytest.approx(21.0)
    assert found.corners[found.is_apart][..., 0].min() == pytest.approx(10.0, abs=1e-3)
    assert found.corners[~found.is_apart][..., 0].max() == pytest.approx(10.0, abs=1e-3)
    assert found.share == pytest.approx((2.0 * 20.0 * 44.0 + 160.0) / AREA, rel=1e-4)
    assert areas(found.corners.astype(float)).sum() == pytest.approx(AREA, rel=1e-5)


def test_the_pieces_have_the_normals_of_the_surface_and_all_edges_are_lines():
    found = surface_difference(plate(), lambda points: np.maximum(points[:, 0] - 9.0, 0.0), 1.0)
    sides = found.corners[:, 1:] - found.corners[:, :1]
    across = np.cross(sides[:, 0], sides[:, 1]).astype(float)
    assert (np.einsum("kj,kcj->kc", across, found.normals) > 0.0).all()
    assert np.linalg.norm(found.lines[:, 1] - found.lines[:, 0], axis=1).sum() == pytest.approx(4.0 * SIDES.sum(), rel=1e-5)
    assert found.line_is_apart.any() and not found.line_is_apart.all()


@pytest.mark.parametrize("radius", [0.8, 2.0, 6.0])
def test_a_spot_in_a_large_face_is_found(radius):
    """As where the other part has a hole: the surface lies as far apart as the border of the hole is away."""
    def distances(points):
        from_middle = np.linalg.norm(points[:, :2] - [7.3, -4.1], axis=1)
        return np.where(points[:, 2] > 1.9, np.maximum(radius - from_middle, 0.0), 0.0)

    tolerance = 0.02
    found = surface_difference(plate(), distances, tolerance)
    assert found.share * AREA == pytest.approx(np.pi * (radius - tolerance) ** 2, rel=0.1)
    middles = found.corners[found.is_apart].mean(axis=1)
    assert np.linalg.norm(middles[:, :2] - [7.3, -4.1], axis=1).max() < radius + 0.3


def test_what_lies_apart_can_be_taken_alone():
    found = surface_difference(plate(), lambda points: np.maximum(points[:, 0] - 9.0, 0.0), 1.0)
    alone = found.only_apart()
    assert len(alone.corners) == found.is_apart.sum() == len(alone.normals) and alone.is_apart.all() and alone.share == 1.0
    assert alone.lines.reshape(-1, 3)[:, 0].max() == pytest.approx(30.0) and len(alone.lines) < len(found.lines)


def test_nothing_is_apart_from_itself():
    mesh = plate()
    nearest = NearestOnMesh(mesh)
    found = surface_difference(mesh, lambda points: np.linalg.norm(points - nearest.nearest(points), axis=1), 1e-3)
    assert found.share == 0.0 and found.greatest < 1e-6 and not found.line_is_apart.any()


def fan():
    """A disc with a rim of 3,000 corners, all of whose triangles meet in one corner of the rim: most are long and narrow."""
    angle = np.linspace(0.0, 2.0 * np.pi, 3000, endpoint=False)
    ring = np.column_stack([10.0 * np.cos(angle), 10.0 * np.sin(angle), np.zeros(3000)])
    points = np.concatenate([ring, [[0.0, 0.0, -5.0]]])
    follows = np.arange(3000)
    top = np.column_stack([np.zeros(2998, dtype=int), follows[1:-1], follows[2:]])
    cone = np.column_stack([np.roll(follows, -1), follows, np.full(3000, 3000)])
    return surface_mesh(points, np.concatenate([top, cone]))


def test_the_nearest_point_of_long_narrow_triangles_is_that_of_all_triangles():
    mesh = fan()
    rng = np.random.default_rng(3)
    points = np.column_stack([rng.uniform(-7.0, 7.0, (300, 2)), np.zeros(300)]) - mesh.origin
    points[200:, 2] += rng.uniform(-0.3, 0.3, 100)
    columns = np.ascontiguousarray(mesh.corners.transpose(2, 1, 0))
    for point, foot in zip(points, NearestOnMesh(mesh).nearest(points)):
        weights = closest_weights(np.repeat(point[:, None], mesh.count, axis=1), columns)
        feet = np.einsum("kcn,cn->nk", columns, weights)
        assert np.linalg.norm(point - foot) == pytest.approx(np.linalg.norm(point - feet, axis=1).min(), abs=1e-4)

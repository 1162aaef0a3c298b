# SPDX-License-Identifier: LGPL-2.1-or-later
"""The largest balls inside, of solids of which they are known."""

import made_meshes
import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from thinpart_workbench.core.mesh.sampling import surface_samples
from thinpart_workbench.core.mesh.surface_mesh import surface_mesh
from thinpart_workbench.core.thickness.inscribed_balls import inscribed_balls
from thinpart_workbench.core.walls.thickness_field import measure_rays

TURN = Rotation.from_rotvec([0.4, -1.1, 0.7]).as_matrix()
PLACES = pytest.mark.parametrize("rotation, scale", [(np.eye(3), 1.0), (TURN, 0.01), (TURN, 1000.0)])


def _balls(shape, rotation, scale):
    """Points and normals as the solid was before it was turned and scaled, and the diameters, mm."""
    mesh = surface_mesh(*made_meshes.moved(shape, rotation, (30.0, -20.0, 10.0), scale))
    samples = surface_samples(mesh, 2000)
    points = (samples.points + mesh.origin - (30.0, -20.0, 10.0)) @ rotation / scale
    return points, mesh.normals[samples.triangle] @ rotation, inscribed_balls(mesh, samples) / scale


@PLACES
@pytest.mark.parametrize("size, cells", [((100.0, 80.0, 2.0), 1), ((10.0, 10.0, 10.0), 1), ((10.0, 10.0, 10.0), 12),
                                         ((200.0, 20.0, 5.0), 3)])
def test_a_box_bounds_balls_by_its_opposite_side_or_the_nearest_edge(size, cells, rotation, scale):
    points, normals, found = _balls(made_meshes.box(*size, cells), rotation, scale)
    own = np.abs(normals).argmax(axis=1)
    to_sides = np.minimum(points, np.array(size) - points)
    to_sides[np.arange(len(points)), own] = 0.5 * np.array(size)[own]
    np.testing.assert_allclose(found, 2.0 * to_sides.min(axis=1), rtol=1e-4, atol=1e-5)


@PLACES
@pytest.mark.parametrize("steps", [60, 180])
def test_a_tube_bounds_them_by_its_wall_and_its_ends(steps, rotation, scale):
    points, normals, found = _balls(made_meshes.tube(20.0, 18.0, 60.0, steps), rotation, scale)
    radius, along = np.linalg.norm(points[:, :2], axis=1), np.minimum(points[:, 2], 60.0 - points[:, 2])
    at_end = np.abs(normals[:, 2]) > 0.5
    known = 2.0 * np.where(at_end, np.abs(np.minimum(20.0 - radius, radius - 18.0)), np.minimum(1.0, along))
    sagitta = 20.0 * (1.0 - np.cos(np.pi / steps))
    np.testing.assert_allclose(found, known, atol=0.2 * sagitta)


@PLACES
@pytest.mark.parametrize("steps", [36, 72])
def test_a_ball_is_its_own(steps, rotation, scale):
    _, _, found = _balls(made_meshes.sphere(20.0, steps), rotation, scale)
    np.testing.assert_allclose(found, 40.0, rtol=0.5 / steps)


@PLACES
def test_a_hollow_ball_has_its_wall(rotation, scale):
    _, _, found = _balls(made_meshes.spherical_shell(20.0, 1.0, 60), rotation, scale)
    np.testing.assert_allclose(found, 1.0, rtol=0.005)


@PLACES
@pytest.mark.parametrize("angle", [5.0, 30.0, 100.0])
def test_a_wedge_bounds_them_by_its_other_flank(angle, rotation, scale):
    side, length = 100.0, 60.0
    points, normals, found = _balls(made_meshes.wedge(angle, side, length), rotation, scale)
    flank = (np.abs(normals[:, 2]) < 0.5) & (normals[:, 0] < 0.5 * np.cos(np.radians(angle / 2)))
    from_tip, along = np.linalg.norm(points[flank, :2], axis=1), points[flank, 2]
    known = 2.0 * np.minimum.reduce([
        from_tip * np.tan(np.radians(angle) / 2), (side - from_tip) * np.tan(np.radians(90.0 - angle / 2) / 2),
        along, length - along])
    assert flank.sum() > 500
    np.testing.assert_allclose(found[flank], known, rtol=1e-4, atol=1e-4)


@PLACES
def test_a_hexagonal_prism_bounds_them_by_its_flats(rotation, scale):
    corners = [(10.0 * np.cos(turn), 10.0 * np.sin(turn)) for turn in np.radians(np.arange(0.0, 360.0, 60.0))]
    points, normals, found = _balls(made_meshes.prism(corners, 50.0), rotation, scale)
    flats = np.radians(np.arange(30.0, 360.0, 60.0))
    outward = np.column_stack([np.cos(flats), np.sin(flats)])
    apothem, along = 10.0 * np.cos(np.radians(30.0)), np.minimum(points[:, 2], 50.0 - points[:, 2])
    at_end = np.abs(normals[:, 2]) > 0.5
    to_flats = apothem - (points[:, :2] @ outward.T).max(axis=1)
    across = np.abs(points[:, 0] * -normals[:, 1] + points[:, 1] * normals[:, 0])
    on_flat = np.minimum.reduce([np.full(len(points), apothem), (5.0 - across) * np.tan(np.radians(60.0)), along])
    known = 2.0 * np.where(at_end, np.minimum(to_flats, 25.0), on_flat)
    np.testing.assert_allclose(found, known, rtol=1e-4, atol=1e-5)


def test_none_is_bounded_less_than_by_any_point_of_the_surface():
    # With concave edges: the ball under the rib is bounded by the rib's own edges.
    mesh = surface_mesh(*made_meshes.moved(made_meshes.ribbed_block(), TURN))
    samples = surface_samples(mesh, 300)
    found = inscribed_balls(mesh, samples)
    cloud = surface_samples(mesh, 400_000).points
    for point, triangle, diameter in zip(samples.points, samples.triangle, found):
        away, inward = cloud - point, -mesh.normals[triangle]
        depth = away @ inward
        inside = depth > 1e-6
        least = ((away[inside] ** 2).sum(axis=1) / depth[inside]).min()
        assert diameter <= least * (1.0 + 1e-9)
        assert diameter > least - 1.0


def test_no_ball_is_wider_than_the_wall_is_thick_along_the_normal():
    mesh = surface_mesh(*made_meshes.ribbed_block())
    samples = surface_samples(mesh, 3000)
    distance = measure_rays(mesh, samples).distance[:samples.count]
    assert (inscribed_balls(mesh, samples) <= distance * (1.0 + 1e-9)).all()


def test_an_open_sheet_bounds_nothing():
    sheet = np.array([[0.0, 0, 0], [10, 0, 0], [10, 10, 0], [0, 10, 0]]), np.array([[0, 1, 2], [0, 2, 3]])
    mesh = surface_mesh(*sheet)
    found = inscribed_balls(mesh, surface_samples(mesh, 100))
    assert np.isinf(found).all()

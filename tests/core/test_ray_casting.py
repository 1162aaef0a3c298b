# SPDX-License-Identifier: LGPL-2.1-or-later
import brute_force
import made_meshes
import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from thinpart_workbench.core.columns import corners_of
from thinpart_workbench.core.mesh.dominant_directions import dominant_axes
from thinpart_workbench.core.mesh.sampling import centroid_samples, surface_samples
from thinpart_workbench.core.mesh.surface_mesh import surface_mesh
from thinpart_workbench.core.rays.box_tree import box_tree
from thinpart_workbench.core.rays.inward_rays import InwardRays
from thinpart_workbench.core.rays.ray_casting import OUTER, first_hits, first_hits_about, first_hits_within
from thinpart_workbench.core.rays.ray_packets import PACKET
from thinpart_workbench.core.rays.tree_descent import Work
from thinpart_workbench.core.tolerances import TOLERANCES

TURNED = Rotation.from_rotvec([0.5, 0.7, -0.3]).as_matrix()


def heat_sink(fins=60, length=60.0, cells=12):
    """A comb extruded along z, its sides cut into slender strips."""
    outline = [(0, 0), (4.0 * fins, 0)]
    for k in reversed(range(fins)):
        outline += [(4 * k + 3.0, 5), (4 * k + 2.75, 30), (4 * k + 1.25, 30), (4 * k + 1.0, 5)]
    outline = np.array(outline + [(0, 5)], dtype=float)
    rows, triangles = [], []
    count = len(outline)
    for level in np.linspace(0.0, length, cells + 1):
        rows.append(np.column_stack([outline, np.full(count, level)]))
    for level in range(cells):
        for i in range(count):
            a, b = level * count + i, level * count + (i + 1) % count
            triangles += [(a, b, b + count), (a, b + count, a + count)]
    caps = np.array(made_meshes.prism(outline, 1.0)[1])
    caps = caps[(caps < count).all(axis=1)]
    last = cells * count
    return np.concatenate(rows), np.concatenate([triangles, caps, caps[:, ::-1] + last])


MADE = {
    "heat sink": heat_sink(),
    "shell": made_meshes.spherical_shell(steps=110),
    "plate": made_meshes.box(100, 100, 2, cells=45),
    "tube": made_meshes.tube(steps=400),
}


def _counted(mesh, samples):
    work = Work()
    rays = InwardRays(mesh)
    # The tree is over the mesh as it is turned to its directions and moved to its middle.
    axes = dominant_axes(mesh.normals, mesh.areas)
    turned = axes @ mesh.vertices.T
    origins = axes @ samples.points.T - 0.5 * (turned.min(axis=1) + turned.max(axis=1))[:, None]
    first_hits(rays.tree, origins, -rays.normals[:, samples.triangle], work=work)
    return work


# Boxes are tested eight to a node. The bounds are 1.4 times what was counted.
@pytest.mark.parametrize("name,nodes,pairs", [
    ("heat sink", 55, 95), ("shell", 45, 40), ("plate", 95, 45), ("tube", 48, 66),
])
@pytest.mark.parametrize("turn", [np.eye(3), TURNED])
def test_few_boxes_and_triangles_are_tested_per_packet(name, nodes, pairs, turn):
    mesh = surface_mesh(*made_meshes.moved(MADE[name], turn))
    for samples in (centroid_samples(mesh), surface_samples(mesh, 4 * mesh.count)):
        work = _counted(mesh, samples)
        packets = samples.count / PACKET
        assert work.nodes / packets < nodes
        assert work.pairs / packets < pairs
        assert work.exact / samples.count < 4.5


def test_work_per_ray_hardly_grows_with_the_mesh():
    visited = []
    for steps in (40, 160):
        mesh = surface_mesh(*made_meshes.spherical_shell(steps=steps))
        samples = centroid_samples(mesh)
        visited.append(_counted(mesh, samples).nodes / samples.count)
    assert visited[1] < 1.5 * visited[0]


def test_a_turned_mesh_costs_no_more():
    for name in MADE:
        work = [
            _counted(mesh, centroid_samples(mesh)) for mesh in
            (surface_mesh(*made_meshes.moved(MADE[name], turn)) for turn in (np.eye(3), TURNED))
        ]
        assert work[1].nodes < 1.2 * work[0].nodes
        assert work[1].pairs < 1.2 * work[0].pairs


@pytest.mark.parametrize("name", MADE)
def test_fine_meshes_are_identical_to_brute_force(name):
    mesh = surface_mesh(*made_meshes.moved(MADE[name], TURNED, shift=(1e5, 0, -3e5)))
    rays = InwardRays(mesh)
    samples = surface_samples(mesh)
    distance, triangle = rays.first_hits(samples, 1.0)
    chosen = np.linspace(0, samples.count - 1, 300).astype(int)
    truth, other = brute_force.first_hits(
        mesh, samples.points[chosen], -samples.normals[chosen])
    assert np.abs(distance[chosen] - truth).max() <= 1e-9 * mesh.extent
    assert (triangle[chosen] == other).mean() > 0.9


@pytest.mark.parametrize("side", [1.0, OUTER])
def test_any_rays_from_any_place_are_identical_to_brute_force(side):
    rng = np.random.default_rng(11)
    mesh = surface_mesh(*made_meshes.joined(
        made_meshes.sphere(10, 30), made_meshes.moved(made_meshes.tube(8, 7, 30, 40), shift=(5, 5, 5))))
    tree = box_tree(*_columns(mesh))
    origins = rng.uniform(-12, 12, (500, 3))
    directions = rng.normal(size=(500, 3))
    directions[:80] = np.eye(3)[rng.integers(0, 3, 80)] * rng.choice([-1, 1], (80, 1))
    directions /= np.linalg.norm(directions, axis=1)[:, None]
    distance, triangle = first_hits(tree, origins.T, directions.T, side)
    looked_at = mesh if side > 0 else _inside_out(mesh)
    truth, _ = brute_force.first_hits(looked_at, origins, directions)
    assert (np.isinf(distance) == np.isinf(truth)).all()
    met = np.isfinite(truth)
    assert 100 < met.sum() < 500
    assert np.abs(distance[met] - truth[met]).max() <= 1e-9 * mesh.extent
    assert ((triangle >= 0) == met).all()
    limited, _ = first_hits_within(tree, origins.T, directions.T, np.where(met, truth * 0.999, 1.0), side)
    assert np.isinf(limited[met]).all()
    reached, _ = first_hits_within(tree, origins.T, directions.T, np.full(500, np.inf), side)
    assert (reached == distance).all()
    guess = np.where(met, truth * rng.uniform(0.01, 3.0, 500), rng.choice([1e-6, 1.0, np.inf], 500))
    guessed, which = first_hits_about(tree, origins.T, directions.T, guess, side)
    assert (guessed == distance).all() and (which == triangle).all()


def _columns(mesh):
    return corners_of(mesh.vertex_columns, mesh.triangles), mesh.normals.T, mesh.areas


def _inside_out(mesh):
    class Inverted:
        corners = mesh.corners[:, ::-1]
        normals, areas, extent, cracked = -mesh.normals, mesh.areas, mesh.extent, mesh.cracked

    return Inverted


def test_no_rays_are_no_error():
    mesh = surface_mesh(*made_meshes.box(1, 1, 1))
    tree = box_tree(*_columns(mesh))
    for distance, triangle in (
        first_hits(tree, np.empty((3, 0)), np.empty((3, 0))),
        first_hits_within(tree, np.empty((3, 0)), np.empty((3, 0)), np.empty(0)),
        first_hits_about(tree, np.empty((3, 0)), np.empty((3, 0)), np.empty(0)),
    ):
        assert len(distance) == len(triangle) == 0


@pytest.mark.parametrize("width,closed", [(0.6, True), (3.0, False)])
def test_a_ray_does_not_slip_through_a_crack_as_wide_as_rounding(width, closed):
    # The far side of a plate in two halves that do not touch: shares of the gap tolerance.
    points, triangles = made_meshes.box(100, 100, 2)
    extent = np.linalg.norm([100, 100, 2])
    crack = width * TOLERANCES.gap * extent
    far = [[0, 0, 2], [50 - crack / 2, 0, 2], [50 - crack / 2, 100, 2], [0, 100, 2],
           [50 + crack / 2, 0, 2], [100, 0, 2], [100, 100, 2], [50 + crack / 2, 100, 2]]
    top = (points[triangles][:, :, 2] == 2).all(axis=1)
    start = len(points)
    halves = start + np.array([[0, 1, 2], [0, 2, 3], [4, 5, 6], [4, 6, 7]])
    mesh = surface_mesh(np.concatenate([points, far]), np.concatenate([triangles[~top], halves]))
    assert mesh.cracked
    gap = TOLERANCES.gap * mesh.extent
    tree = box_tree(*_columns(mesh), gap)
    origins = np.column_stack([np.full(50, 50.0), np.linspace(3, 97, 50), np.zeros(50)])
    distance, _ = first_hits(tree, (origins - mesh.origin).T, np.tile([[0.0], [0.0], [1.0]], (1, 50)))
    assert (np.abs(distance - 2) < 1e-9).all() == closed

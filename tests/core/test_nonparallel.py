# SPDX-License-Identifier: LGPL-2.1-or-later
import math

import made_meshes
import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from thinpart_workbench.core.analysis_settings import AnalysisSettings
from thinpart_workbench.core.descriptors.descriptor_table import STATED_FLOOR
from thinpart_workbench.core.mesh.sampling import SurfaceSamples, surface_samples
from thinpart_workbench.core.mesh.surface_mesh import surface_mesh
from thinpart_workbench.core.rays.inward_rays import InwardRays
from thinpart_workbench.core.rays.ray_packets import PACKET
from thinpart_workbench.core.rays.tree_descent import Work
from thinpart_workbench.core.thickness.convex_clipping import areas, clip
from thinpart_workbench.core.thickness.measurement import measure
from thinpart_workbench.core.thickness.nonparallel import nonparallel_minimum, sampled_minimum
from thinpart_workbench.core.thickness.slanted_pairs import slanted_pairs
from thinpart_workbench.core.walls.thickness_field import measure_rays

TURNED = Rotation.from_rotvec([0.5, 0.7, -0.3]).as_matrix()


def _finer(shape, times):
    """Every triangle cut in four, several times."""
    points, triangles = shape
    for _ in range(times):
        a, b, c = (points[triangles[:, k]] for k in range(3))
        ab, bc, ca = (a + b) / 2, (b + c) / 2, (c + a) / 2
        points = np.concatenate([
            np.stack(each, axis=1) for each in ((a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca))
        ]).reshape(-1, 3)
        triangles = np.arange(len(points)).reshape(-1, 3)
    return points, triangles


def _least(shape, minimum=AnalysisSettings.minimum_samples):
    """Least non-parallel distance, mm, by a search that is never ended, and the mesh; what is stated is within its error."""
    mesh = surface_mesh(*shape)
    rays = InwardRays(mesh)
    field = measure_rays(mesh, surface_samples(mesh, minimum), rays=rays)
    exact = nonparallel_minimum(mesh, rays, field, mesh.extent, share_of_rays=math.inf)
    assert exact.error == 0.0
    stated = nonparallel_minimum(mesh, rays, field, mesh.extent)
    if exact.distance is None:
        assert stated == exact
        return None, mesh
    for found in (stated, sampled_minimum(field, mesh.extent)):
        assert found.distance == pytest.approx(exact.distance, rel=1e-9, abs=found.error)
    return exact.distance * mesh.extent, mesh


@pytest.mark.parametrize("angle", [12, 30, 54])
@pytest.mark.parametrize("times", [0, 2, 4])
def test_a_wedge_is_as_thin_as_the_strip_along_its_edge(angle, times):
    side, length = 100.0, 60.0
    shape = _finer(made_meshes.wedge(angle, side, length), times)
    least, mesh = _least(made_meshes.moved(shape, TURNED, shift=(300, 0, 0)))
    # On both faces a strip of that width, which rises by the tangent of the angle.
    strip = STATED_FLOOR * mesh.areas.sum() / (2 * length)
    assert least == pytest.approx(strip * np.tan(np.radians(angle)), rel=1e-3)


@pytest.mark.parametrize("times", [0, 2, 4])
def test_a_blunt_wedge_is_as_thin_as_its_end(times):
    shape = made_meshes.prism([(0, 0), (100, 0), (100, 10), (0, 60)], 50)
    least, mesh = _least(made_meshes.moved(_finer(shape, times), TURNED))
    # Rays from the lower face are the shorter ones; those from the upper one miss the end.
    width = STATED_FLOOR * mesh.areas.sum() / 50
    assert least == pytest.approx(10 + width * 0.5, rel=1e-6)


@pytest.mark.parametrize("angle", [9.0, 56.0])
def test_other_angles_do_not_count(angle):
    assert _least(made_meshes.wedge(angle))[0] is None


@pytest.mark.parametrize("shape", [
    made_meshes.box(100, 60, 40), made_meshes.tube(), made_meshes.spherical_shell(steps=60),
    made_meshes.sphere(steps=60),
])
def test_parallel_walls_have_none(shape):
    assert _least(made_meshes.moved(shape, TURNED))[0] is None


@pytest.mark.parametrize("shape, most", [(made_meshes.tube(), 0.0), (made_meshes.spherical_shell(), 1.5)])
def test_round_walls_are_sorted_out_before_they_are_cut(shape, most):
    # Their facets may stand at ten degrees to those opposite, the surfaces that they stand for do not.
    mesh = surface_mesh(*shape)
    pairs = sum(len(first) for first, *_ in slanted_pairs(mesh, InwardRays(mesh), 2.2))
    assert pairs <= most * mesh.count


def _ring(steps):
    """A ring with a triangular section: 20 degrees at its outer edge."""
    half = 30 * np.tan(np.radians(10))
    return made_meshes.revolved([(20, -half), (50, 0), (20, half)], steps)


def test_a_round_wedge_does_not_follow_the_tessellation():
    least = [_least(made_meshes.moved(_ring(steps), TURNED))[0] for steps in (60, 120, 240)]
    assert least == pytest.approx([least[-1]] * 3, rel=0.05)
    # The strip at the edge, on both sides of the ring, seen along the slope.
    area = 2 * np.pi * 70 * 30 / np.cos(np.radians(10)) + 2 * np.pi * 20 * 60 * np.tan(np.radians(10))
    strip = STATED_FLOOR * area / (2 * 2 * np.pi * 50)
    assert least[-1] == pytest.approx(strip * np.tan(np.radians(20)), rel=0.02)


def _rack(teeth=40):
    """Teeth that all end in the same narrow, slanted tip."""
    outline = [(0, 0), (10.0 * teeth, 0)]
    for tooth in reversed(range(teeth)):
        outline += [(10 * tooth + 9.0, 5), (10 * tooth + 5.5, 30), (10 * tooth + 4.5, 30), (10 * tooth + 1.0, 5)]
    return made_meshes.prism(outline + [(0, 5)], 60)


# Nodes of the tree for each packet of triangles, and pairs of triangles that are cut. The bounds are 1.4 times what was
# counted; a second search would double the nodes.
@pytest.mark.parametrize("shape, nodes, cut", [
    (_finer(made_meshes.wedge(30), 5), 15, 360),
    (_finer(made_meshes.prism([(0, 0), (100, 0), (100, 10), (0, 60)], 50), 4), 20, 125),
    (_ring(240), 29, 3360),
    (_ring(30), 35, 420),
    (_rack(), 43, 340),
])
@pytest.mark.parametrize("turn", [np.eye(3), TURNED])
def test_one_search_is_enough(shape, nodes, cut, turn):
    mesh = surface_mesh(*made_meshes.moved(shape, turn))
    rays, work = InwardRays(mesh), Work()
    field = measure_rays(mesh, surface_samples(mesh), rays=rays)
    assert nonparallel_minimum(mesh, rays, field, 1.0, work=work, share_of_rays=math.inf).distance is not None
    assert 0 < work.nodes / (mesh.count / PACKET) < nodes
    assert 0 < work.exact < cut


@pytest.mark.parametrize("turn", [np.eye(3), TURNED])
def test_what_lies_beyond_the_result_is_not_cut(turn):
    mesh = surface_mesh(*made_meshes.moved(_finer(made_meshes.wedge(30), 5), turn))
    rays, work = InwardRays(mesh), Work()
    field = measure_rays(mesh, surface_samples(mesh, 1000), rays=rays)
    # Without samples near the edge, the limit is far beyond the result.
    far = np.flatnonzero(field.distance > 10.0)
    samples = SurfaceSamples(field.samples.points[far], field.samples.triangle[far], field.samples.area[far])
    least = nonparallel_minimum(
        mesh, rays, measure_rays(mesh, samples, rays=rays), 1.0, work=work, share_of_rays=math.inf).distance
    pairs = sum(len(first) for first, *_ in slanted_pairs(mesh, rays, 10.0))
    seen = samples.area.sum() / mesh.areas.sum()
    assert least == pytest.approx(seen * _least(made_meshes.wedge(30))[0], rel=1e-3)
    assert pairs > 5_000
    assert 0 < work.exact < 450


@pytest.mark.parametrize("outline", [
    [(0, 0), (80, 0), (90, 30), (50, 12), (10, 45)],
    [(0, 0), (60, 0), (60, 30), (45, 9), (30, 30), (15, 6), (0, 30)],
])
def test_agrees_with_very_many_samples(outline):
    shape = made_meshes.moved(made_meshes.prism(outline, 25), TURNED)
    least, mesh = _least(shape)
    samples = surface_samples(mesh, 580_000)
    field = measure_rays(mesh, samples)
    degrees = np.degrees(field.wedge_angle)
    slanted = np.flatnonzero((degrees >= 10) & (degrees < 55))
    slanted = slanted[np.argsort(field.distance[slanted])]
    reached = np.cumsum(field.area[slanted]) >= STATED_FLOOR * mesh.areas.sum()
    assert least == pytest.approx(field.distance[slanted[reached]][0], rel=0.05)


def test_what_another_wall_hides_does_not_count():
    # A block with a wedge-shaped cavity under its upper side.
    block = made_meshes.prism([(0, 0), (100, 0), (100, 60), (0, 60)], 50)
    cavity = made_meshes.inverted(made_meshes.moved(
        made_meshes.prism([(20, 20), (80, 20), (80, 40)], 40), shift=(0, 0, 5)))
    free, _ = _least(made_meshes.joined(block, cavity))
    assert free == pytest.approx(20, rel=0.01)
    # A level slot between them: now the least is that of the cavity and the slot.
    level = made_meshes.inverted(made_meshes.moved(made_meshes.box(76, 2, 46), shift=(12, 50, 2)))
    nearer, _ = _least(made_meshes.joined(block, cavity, level))
    assert nearer == pytest.approx(10, rel=0.01)
    # One whose lower side is parallel to the cavity and whose upper side is to the block leaves no walls that stand at
    # an angle and see each other; those of a larger block without a slot are then the nearest.
    slanted = made_meshes.inverted(made_meshes.moved(
        made_meshes.prism([(20, 30), (80, 50), (80, 56), (20, 56)], 46), shift=(0, 0, 2)))
    larger = made_meshes.moved(made_meshes.joined(block, cavity), scale=1.5, shift=(1000, 0, 0))
    hidden, _ = _least(made_meshes.joined(block, cavity, slanted, larger))
    assert hidden == pytest.approx(30, rel=0.01)


def test_the_record_states_the_exact_value():
    mesh = surface_mesh(*made_meshes.wedge(30))
    descriptors = measure(mesh, AnalysisSettings()).descriptors
    assert descriptors.value("min_nonparallel[10;55]") == descriptors.min_nonparallel
    assert 0 < descriptors.min_nonparallel < 1e-3
    # Other bounds are read off the distribution.
    assert descriptors.value("min_nonparallel[10;20]") is None
    assert descriptors.value("min_nonparallel[25;35]") == pytest.approx(0.0, abs=0.001)


def _cost(work):
    """About what a search did, in nodes of the tree that were tested."""
    return work.nodes + work.pairs + 15.0 * work.overlaps + 90.0 * work.exact


@pytest.mark.parametrize("shape", [_ring(30), _ring(480), _finer(made_meshes.wedge(30), 6), _rack(200)])
def test_it_costs_a_share_of_the_rays_and_says_what_is_left_open(shape):
    mesh = surface_mesh(*made_meshes.moved(shape, TURNED))
    rays = InwardRays(mesh)
    field = measure_rays(mesh, surface_samples(mesh), rays=rays)
    exact = nonparallel_minimum(mesh, rays, field, mesh.extent, share_of_rays=math.inf).distance
    errors = []
    for share in (0.0, 0.16, 2.0, math.inf):
        work = Work()
        found = nonparallel_minimum(mesh, rays, field, mesh.extent, work=work, share_of_rays=share)
        assert found == nonparallel_minimum(mesh, rays, field, mesh.extent, share_of_rays=share)
        # One portion of pairs, of which the number is not known before.
        portion = 30_000
        assert _cost(work) <= share * (5.0 * field.samples.count + rays.work.nodes + rays.work.pairs) + portion
        assert abs(found.distance - exact) <= found.error + 1e-9
        assert share > 0.0 or work == Work() and found == sampled_minimum(field, mesh.extent)
        errors.append(found.error)
    assert errors == sorted(errors, reverse=True) and errors[0] > 0.0 and errors[-1] == 0.0


def test_it_is_searched_for_only_where_samples_are_not_near_enough():
    blunt = made_meshes.prism([(0, 0), (100, 0), (100, 10), (0, 60)], 50)
    mesh = surface_mesh(*made_meshes.moved(_finer(blunt, 2), TURNED))
    asked = []

    def is_near_enough(known):
        asked.append((known.min_nonparallel, known.precision.slanted))
        return len(asked) == 1

    sampled, searched = (measure(mesh, AnalysisSettings(), is_near_enough=is_near_enough) for _ in range(2))
    assert asked == [(sampled.descriptors.min_nonparallel, sampled.slanted_error)] * 2
    assert searched.slanted_error < 0.1 * sampled.slanted_error
    assert abs(sampled.descriptors.min_nonparallel - searched.descriptors.min_nonparallel) <= sampled.slanted_error


def test_parts_without_slanted_walls_ask_nobody():
    def is_near_enough(known):
        raise AssertionError

    mesh = surface_mesh(*made_meshes.box(100, 60, 40))
    assert measure(mesh, AnalysisSettings(), is_near_enough=is_near_enough).descriptors.min_nonparallel is None


def test_progress_is_reported_and_can_stop_it():
    mesh = surface_mesh(*_finer(made_meshes.wedge(30), 5))
    rays = InwardRays(mesh)
    field = measure_rays(mesh, surface_samples(mesh), rays=rays)
    seen = []
    nonparallel_minimum(mesh, rays, field, 1.0, seen.append, share_of_rays=math.inf)
    assert len(seen) >= 2 and all(0 <= each <= 1 for each in seen)

    def stop(fraction):
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        nonparallel_minimum(mesh, rays, field, 1.0, stop, share_of_rays=math.inf)


def test_polygons_are_cut_by_half_planes():
    rng = np.random.default_rng(3)
    square = np.array([[0.0, 0], [1, 0], [1, 1], [0, 1]])
    normal = rng.normal(size=(200, 2))
    level = rng.uniform(-1, 1, 200)
    squares = np.broadcast_to(square, (200, 4, 2))
    value = np.einsum("mkj,mj->mk", squares, normal) + level[:, None]
    kept, left = areas(clip(squares, value)), areas(clip(squares, -value))
    assert kept + left == pytest.approx(np.ones(200))
    points = rng.uniform(size=(4000, 2))
    shares = (points @ normal.T + level >= 0).mean(axis=0)
    assert kept == pytest.approx(shares, abs=0.05)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Forms: moments, outlines, how one is laid upon another, and how records keep them."""

import made_meshes
import numpy as np
import pytest

from thinpart_workbench.core.analysis_settings import AnalysisSettings
from thinpart_workbench.core.errors import ThinPartError
from thinpart_workbench.core.forms.form import form_of
from thinpart_workbench.core.forms.laying import is_exact, laid_partly, laid_whole
from thinpart_workbench.core.forms.moments import surface_moments
from thinpart_workbench.core.forms.motion import Motion, turn_by
from thinpart_workbench.core.forms.nearest_on_mesh import NearestOnMesh
from thinpart_workbench.core.forms.recorded_form import (
    form_of_record,
    packed_form,
    recorded_form,
    unpacked_form,
    unpacked_numbers,
)
from thinpart_workbench.core.forms.topology import topology
from thinpart_workbench.core.mesh.surface_mesh import surface_mesh
from thinpart_workbench.core.rays.closest_points import closest_weights
from thinpart_workbench.core.reuse.likeness import ALIKE, LIKE, known_scale
from thinpart_workbench.core.reuse.likeness import kind_of as likeness
from thinpart_workbench.core.thickness.measurement import measure

TURN = turn_by(np.array([0.3, -1.1, 0.7]))
LETTER = [(0, 0), (40, 0), (40, 6), (12, 6), (12, 30), (0, 30)]
"""An L, which is not its own mirror image once it has a foot."""


def letter(length=20.0, foot=8.0):
    """An L of a length, with a foot at one end that makes it chiral."""
    points, triangles = made_meshes.prism(LETTER, length)
    points = points.copy()
    end = points[:, 2] > 0.0
    points[end, 1] += foot * points[end, 0] / 40.0
    return points, triangles


def form(shape, move=lambda points: points, is_mirrored=False):
    points, triangles = shape
    mesh = surface_mesh(move(points), triangles[:, ::-1] if is_mirrored else triangles)
    return form_of(measure(mesh, AnalysisSettings(minimum_samples=3000)).field)


def moved(points):
    return points @ TURN.T + [120.0, -40.0, 7.0]


def test_moments_of_a_box_are_those_of_the_textbook():
    moments = surface_moments(surface_mesh(*made_meshes.box(10, 20, 30)))
    assert moments.area == pytest.approx(2200.0) and moments.centroid == pytest.approx([5.0, 10.0, 15.0])
    # Of x: two faces at distance 5, four faces over which x runs from -5 to 5.
    across = (1200.0 * 25.0 + (400.0 + 600.0) * 25.0 / 3.0) / 2200.0
    assert moments.second[0, 0] == pytest.approx(across)
    assert np.abs(moments.second - np.diag(np.diag(moments.second))).max() < 1e-9 and np.abs(moments.third).max() < 1e-9


def test_third_moments_are_exact():
    # A box from which a corner is cut: by quadrature over many small triangles.
    coarse, fine = letter(), made_meshes.prism(LETTER, 20.0)
    mesh = surface_mesh(*coarse)
    rng = np.random.default_rng(1)
    triangle = rng.choice(mesh.count, 400_000, p=mesh.areas / mesh.areas.sum())
    weights = rng.dirichlet((1.0, 1.0, 1.0), len(triangle))
    points = np.einsum("kc,kcj->kj", weights, mesh.corners[triangle])
    points -= surface_moments(mesh).centroid - mesh.origin
    sampled = np.einsum("ki,kj,kl->ijl", points, points, points) / len(points)
    assert np.abs(surface_moments(mesh).third - sampled).max() < 0.01 * np.abs(sampled).max()
    assert surface_moments(surface_mesh(*fine)).area > 0.0


@pytest.mark.parametrize("shape", [letter, made_meshes.wedge, made_meshes.tube, made_meshes.ribbed_block])
def test_a_moved_part_lies_upon_itself(shape):
    one, other = form(shape()), form(shape(), moved)
    laid = laid_whole(one, other, 1.0, False)[0]
    assert laid.least_share > 0.99 and not laid.motion.is_mirrored
    points = laid.motion.points(one.outline.points) + other.moments.centroid
    assert np.abs(laid.motion.turn @ laid.motion.turn.T - np.eye(3)).max() < 1e-9
    mesh = surface_mesh(moved(shape()[0]), shape()[1])
    away = points - mesh.origin - NearestOnMesh(mesh).nearest(points - mesh.origin)
    assert np.linalg.norm(away, axis=1).max() < 2e-3 * other.extent


@pytest.mark.parametrize("shape", [letter, made_meshes.tube, made_meshes.sphere])
def test_a_turned_copy_is_laid_on_its_own_points_however_it_could_be_turned_within_itself(shape):
    one, other = form(shape()), form(shape(), moved)
    way, = laid_whole(one, other, 1.0, False)
    assert is_exact(way, 1e-3 * other.extent) and not way.motion.is_mirrored
    assert np.abs(way.motion.turn - TURN).max() < 1e-4


def test_ways_in_which_two_forms_are_surely_not_the_same_are_left_out():
    one, longer = form(letter(foot=0.0)), form(letter(20.6, foot=0.0), moved)
    assert laid_whole(one, longer, 1.0, False) == []


def test_a_mirror_image_is_told_from_the_part():
    one, mirrored = form(letter()), form(letter(), lambda points: moved(points * [-1.0, 1.0, 1.0]), is_mirrored=True)
    assert laid_whole(one, mirrored, 1.0, True)[0].least_share > 0.99
    assert all(each.least_share < 0.95 for each in laid_whole(one, mirrored, 1.0, False))


def test_a_scaled_part_lies_upon_itself():
    one, large = form(letter()), form(letter(), lambda points: 25.4 * moved(points))
    scale = known_scale(float(np.sqrt(large.moments.area / one.moments.area)))
    assert scale == 25.4
    assert laid_whole(one, large, scale, False)[0].least_share > 0.99


@pytest.mark.parametrize("scale, known", [(1.0005, 1.0), (25.41, 25.4), (0.0393, 1 / 25.4), (999.0, 1000.0), (3.7, 3.7)])
def test_scales_are_those_that_people_know(scale, known):
    assert known_scale(scale) == pytest.approx(known)


def test_a_longer_part_is_alike_in_all_but_its_end():
    one, longer = form(letter(foot=0.0)), form(letter(24.0, foot=0.0), moved)
    laid = laid_partly(one, longer, LIKE)
    assert 0.6 < laid.least_share < 0.99 and likeness(laid, False) == ALIKE
    assert all(each.least_share < 0.95 for each in laid_whole(one, longer, 1.0, False))


def test_parts_that_have_nothing_in_common_are_not_alike():
    assert laid_partly(form(made_meshes.tube()), form(made_meshes.wedge()), LIKE) is None


def test_a_motion_and_its_inverse_are_nothing():
    motion = Motion(TURN * [1.0, 1.0, -1.0], 2.5, np.array([3.0, 4.0, -5.0]))
    points = np.random.default_rng(3).normal(size=(20, 3))
    assert motion.inverse().points(motion.points(points)) == pytest.approx(points) and motion.is_mirrored


def record_of(found):
    return {"form": recorded_form(found), "descriptors": {"area_mm2": found.moments.area}}


def test_a_record_keeps_the_form():
    found = form(letter(), moved)
    kept = form_of_record(record_of(found))
    assert kept.moments.third == pytest.approx(found.moments.third)
    assert kept.moments.second == pytest.approx(found.moments.second)
    assert np.abs(kept.outline.points - found.outline.points).max() < 2e-5 * found.extent
    assert np.abs(kept.outline.normals - found.outline.normals).max() < 2e-5
    assert np.array_equal(kept.outline.face, found.outline.face)
    numbers, outline = packed_form(record_of(found))
    again = unpacked_form(unpacked_numbers([numbers])[0], outline)
    assert again.radii == pytest.approx(found.radii) and packed_form({}) == (None, None)


@pytest.mark.parametrize("outline", ["AAAA", "no base64!", "eJxjYGBgAAAABAAB"])
def test_a_damaged_outline_is_refused_in_a_sentence(outline):
    record = record_of(form(letter()))
    record["form"]["outline"] = outline
    with pytest.raises(ThinPartError, match="is damaged: classify its document again"):
        form_of_record(record)


def topology_of(shape):
    mesh = surface_mesh(*shape)
    return topology(mesh, ["plane"] * (mesh.face_of_triangle.max() + 1))


def test_parts_of_a_family_have_one_topology_whatever_their_sizes():
    assert topology_of(made_meshes.box(10, 20, 30)) == topology_of(made_meshes.box(3, 90, 5))
    straight = letter(foot=0.0)
    assert topology_of(straight) == topology_of((moved(letter(90.0, foot=0.0)[0]), straight[1]))
    assert topology_of(straight) != topology_of(made_meshes.box(10, 20, 30))
    # An L and a step outside in: as many faces, other corners.
    assert topology_of(made_meshes.prism(LETTER, 5)) != topology_of(made_meshes.prism(
        [(0, 0), (40, 0), (44, 12), (40, 30), (0, 30), (-4, 12)], 5))


def test_nearest_points_of_long_facets_are_exact():
    # A cylinder of facets 60 long and 1.4 wide, with another 2 mm inside it, whose points are nearer than most of its own.
    mesh = surface_mesh(*made_meshes.tube())
    rng = np.random.default_rng(3)
    points = np.column_stack([rng.uniform(-25.0, 25.0, (2000, 2)), rng.uniform(-5.0, 65.0, 2000)]) - mesh.origin
    feet = NearestOnMesh(mesh).nearest(points)
    every = np.ascontiguousarray(mesh.corners.transpose(2, 1, 0))
    for point, foot in zip(points[:300], feet):
        weights = closest_weights(np.repeat(point[:, None], mesh.count, axis=1), every)
        least = np.linalg.norm(np.einsum("kcn,cn->nk", every, weights) - point, axis=1).min()
        assert np.linalg.norm(foot - point) == pytest.approx(least, abs=1e-9)

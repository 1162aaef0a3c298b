# SPDX-License-Identifier: LGPL-2.1-or-later
import made_meshes
import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from scipy.spatial import ConvexHull
from scipy.spatial.transform import Rotation

from thinpart_workbench.core.mesh.mass_properties import area, volume
from thinpart_workbench.core.mesh.surface_mesh import surface_mesh

angles = st.tuples(*[st.floats(-3.1, 3.1)] * 3)
shifts = st.tuples(*[st.floats(-1e6, 1e6)] * 3)
scales = st.sampled_from([0.001, 0.1, 1.0, 1000.0])


@settings(max_examples=80, deadline=None)
@given(st.tuples(*[st.floats(0.1, 100.0)] * 3), angles, shifts, scales)
def test_box_anywhere(size, turn, shift, scale):
    rotation = Rotation.from_rotvec(turn).as_matrix()
    mesh = surface_mesh(*made_meshes.moved(
        made_meshes.box(*size), rotation, np.array(shift) * scale, scale))
    a, b, c = size
    assert mesh.watertight
    assert volume(mesh) == pytest.approx(a * b * c * scale ** 3, rel=1e-5)
    assert area(mesh) == pytest.approx(2 * (a * b + b * c + c * a) * scale ** 2, rel=1e-5)


@settings(max_examples=60, deadline=None)
@given(st.integers(0, 10 ** 6), st.integers(5, 60), angles)
@example(187, 49, (0.0, 0.0, 0.0))  # two facets of it are nearly coplanar
def test_convex_hull_of_random_points(seed, count, turn):
    points = np.random.default_rng(seed).normal(size=(count, 3))
    hull = ConvexHull(points)
    outward = np.einsum(
        "ij,ij->i", np.cross(points[hull.simplices[:, 1]] - points[hull.simplices[:, 0]],
                             points[hull.simplices[:, 2]] - points[hull.simplices[:, 0]]),
        hull.equations[:, :3])
    triangles = np.where(outward[:, None] > 0, hull.simplices, hull.simplices[:, ::-1])
    mesh = surface_mesh(*made_meshes.moved((points, triangles),
                                           Rotation.from_rotvec(turn).as_matrix()))
    # Facets that lie in one plane up to the rounding of float32 are put into it: no point moves by more than a few steps.
    assert volume(mesh) == pytest.approx(hull.volume, rel=1e-6)
    assert area(mesh) == pytest.approx(hull.area, rel=1e-6)


@settings(max_examples=40, deadline=None)
@given(st.floats(10.0, 50.0), st.floats(0.1, 0.9), st.integers(12, 60))
def test_a_void_inside_is_subtracted(radius, share, steps):
    whole = surface_mesh(*made_meshes.sphere(radius, steps))
    inner = surface_mesh(*made_meshes.sphere(radius * share, steps))
    shell = surface_mesh(*made_meshes.spherical_shell(radius, radius * (1 - share), steps))
    assert volume(shell) == pytest.approx(volume(whole) - volume(inner), rel=1e-9)
    assert area(shell) == pytest.approx(area(whole) + area(inner), rel=1e-9)

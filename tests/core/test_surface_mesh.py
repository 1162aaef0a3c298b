# SPDX-License-Identifier: LGPL-2.1-or-later
import made_meshes
import numpy as np
import pytest

from thinpart_workbench.core.errors import MeshError
from thinpart_workbench.core.mesh.mass_properties import area, volume
from thinpart_workbench.core.mesh.surface_mesh import surface_mesh


def soup(mesh):
    """The same triangles without shared points, as an STL file gives them."""
    points, triangles = mesh
    return points[triangles].reshape(-1, 3), np.arange(3 * len(triangles)).reshape(-1, 3)


def test_box_is_watertight_and_exact():
    mesh = surface_mesh(*soup(made_meshes.box(3, 4, 5)))
    assert mesh.watertight and len(mesh.vertices) == 8
    assert volume(mesh) == pytest.approx(60, rel=1e-14)
    assert area(mesh) == pytest.approx(94, rel=1e-14)
    assert mesh.warnings == ()


def test_inverted_soup_is_turned_round():
    mesh = surface_mesh(*made_meshes.inverted(made_meshes.box(3, 4, 5)))
    assert volume(mesh) == pytest.approx(60, rel=1e-14)
    assert "inside out" in mesh.warnings[0]


def test_duplicates_and_flat_triangles_are_dropped_and_counted():
    points, triangles = made_meshes.box(3, 4, 5)
    extra = np.concatenate([triangles, triangles[:4][:, [1, 2, 0]], [[0, 0, 1]]])
    mesh = surface_mesh(points, extra)
    assert mesh.warnings == ("4 duplicate triangles were left out.", "1 triangle of zero area was left out.")
    assert mesh.watertight and volume(mesh) == pytest.approx(60, rel=1e-14)


def test_needle_keeps_the_surface_closed():
    # A zero-area triangle that fills a T-junction: without it the edges would not cancel.
    points, triangles = made_meshes.box(10, 10, 10)
    a, b, c = triangles[0]
    middle = len(points)
    points = np.vstack([points, (points[a] + points[b]) / 2])
    triangles = np.vstack([triangles[1:], [a, middle, c], [middle, b, c], [a, b, middle]])
    mesh = surface_mesh(points, triangles)
    assert mesh.watertight and mesh.warnings == ("1 triangle of zero area was left out.",)
    assert volume(mesh) == pytest.approx(1000, rel=1e-12)


def test_open_surface_is_said_to_be_open_and_has_no_volume():
    points, triangles = made_meshes.box(3, 4, 5)
    mesh = surface_mesh(points, triangles[2:])
    assert not mesh.watertight and volume(mesh) is None
    assert "open (4 free edges)" in mesh.warnings[0]


def test_inconsistent_orientation_is_told_apart_from_open():
    points, triangles = made_meshes.box(3, 4, 5)
    triangles = triangles.copy()
    triangles[3] = triangles[3][::-1]
    mesh = surface_mesh(points, triangles)
    assert not mesh.watertight and "not consistently oriented" in mesh.warnings[0]


def test_corners_apart_by_float32_rounding_are_welded(rng):
    points, triangles = soup(made_meshes.sphere(20, 30))
    noisy = points + rng.uniform(-4e-7, 4e-7, points.shape)
    assert surface_mesh(noisy, triangles).watertight


def test_far_from_the_origin_no_digit_is_lost():
    mesh = surface_mesh(*made_meshes.moved(made_meshes.box(3, 4, 5), shift=(1e6, -1e6, 1e6)))
    assert volume(mesh) == pytest.approx(60, rel=1e-9)


@pytest.mark.parametrize("points, triangles, kind", [
    (np.zeros((0, 3)), np.zeros((0, 3), int), "empty"),
    ([[0, 0, 0], [1, 0, 0], [0, np.nan, 0]], [[0, 1, 2]], "not_finite"),
    ([[0, 0, 0], [1, 0, 0], [np.inf, 1, 0]], [[0, 1, 2]], "not_finite"),
    ([[5, 5, 5]] * 3, [[0, 1, 2]], "zero_volume"),
    ([[0, 0, 0], [1, 0, 0], [2, 0, 0]], [[0, 1, 2]], "zero_volume"),
    ([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 7]], "unreadable"),
])
def test_hopeless_input_has_a_kind(points, triangles, kind):
    with pytest.raises(MeshError) as failure:
        surface_mesh(points, triangles)
    assert failure.value.kind == kind


def test_flat_closed_surface_encloses_nothing():
    points, triangles = made_meshes.box(10, 10, 0.0)
    keep = [k for k, t in enumerate(triangles)
            if np.linalg.norm(np.cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]))]
    mesh = surface_mesh(points, triangles[keep])
    with pytest.raises(MeshError) as failure:
        volume(mesh)
    assert failure.value.kind == "zero_volume"


@pytest.mark.parametrize("mesh", [
    made_meshes.box(3, 4, 5), made_meshes.tube(), made_meshes.inverted(made_meshes.sphere()),
    (made_meshes.box(3, 4, 5)[0], made_meshes.box(3, 4, 5)[1][1:])], ids=["box", "tube", "inverted sphere", "open box"])
def test_sides_that_share_an_edge_are_found_once_and_stay_right(mesh):
    mesh = surface_mesh(*mesh)
    first, second = mesh.shared_sides
    ends = np.stack([mesh.triangles, np.roll(mesh.triangles, -1, axis=1)], axis=2).reshape(-1, 2)
    assert (ends[first] == ends[second][:, ::-1]).all()
    assert len(first) == (3 * mesh.count - (0 if mesh.watertight else 3)) // 2

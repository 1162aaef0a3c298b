# SPDX-License-Identifier: LGPL-2.1-or-later
import made_meshes
import numpy as np
import pytest

from thinpart_workbench.core.analysis_settings import AnalysisSettings
from thinpart_workbench.core.maps.map_outline import outline
from thinpart_workbench.core.maps.map_search import MapSearch
from thinpart_workbench.core.maps.thickness_map import thickness_map
from thinpart_workbench.core.mesh.surface_mesh import surface_mesh
from thinpart_workbench.core.thickness.measurement import measure


@pytest.fixture(scope="module")
def ribbed():
    """Map of a block with a rib, far from the origin."""
    points, triangles = made_meshes.ribbed_block()
    return thickness_map(measure(surface_mesh(points + (1000.0, 0.0, 0.0), triangles), AnalysisSettings()))


def _distances(shown, eye, direction):
    """Of every facet along a ray, inf where it is missed: the plain way."""
    corners = shown.corners + shown.origin
    a, b, c = corners[:, 0], corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    matrices = np.stack([b, c, np.broadcast_to(-direction, b.shape)], axis=2)
    across = np.abs(np.linalg.det(matrices)) > 1e-9
    u, v, t = np.full((3, shown.count), np.inf)
    solved = np.linalg.solve(matrices[across], (eye - a[across])[..., None])[..., 0]
    u[across], v[across], t[across] = solved.T
    return np.where((u >= 0) & (v >= 0) & (u + v <= 1) & (t > 0), t, np.inf)


def test_the_first_facet_is_that_of_a_test_of_every_facet(ribbed, rng):
    search = MapSearch(ribbed)
    middle = ribbed.origin + 0.5 * (ribbed.points.min(axis=0) + ribbed.points.max(axis=0))
    for _ in range(4):
        eye = middle + 300.0 * rng.normal(size=3)
        direction = middle + rng.uniform(-40, 40, 3) - eye
        distances = _distances(ribbed, eye, direction)
        facet, distance = search.first_hit(eye, direction)
        assert distance == pytest.approx(distances.min())
        assert (facet >= 0) == np.isfinite(distances.min())
        if facet >= 0:
            assert distances[facet] == pytest.approx(distance)


def test_a_ray_along_the_sides_of_facets_meets_them(ribbed):
    """It runs in the planes of boxes, and through points that facets share."""
    search = MapSearch(ribbed)
    low = ribbed.origin + ribbed.points.min(axis=0)
    below = ribbed.corners[:, :, 1].max(axis=1) < ribbed.points[:, 1].min() + 1e-5
    for corner in ribbed.corners[below][:200]:
        eye = corner.mean(axis=0) + ribbed.origin
        for x, z in ((eye[0], eye[2]), (corner[0, 0] + ribbed.origin[0], eye[2])):
            facet, distance = search.first_hit((x, low[1] - 50.0, z), np.array([0.0, 2.0, 0.0]))
            assert facet >= 0 and distance == pytest.approx(25.0, abs=1e-4)


def test_what_is_missed_or_lies_behind(ribbed):
    search = MapSearch(ribbed)
    assert search.first_hit((0.0, 0.0, 0.0), np.array([-1.0, 0.0, 0.0])) == (-1, np.inf)
    assert search.first_hit((0.0, 500.0, 0.0), np.array([1.0, 0.0, 0.0])) == (-1, np.inf)


def test_the_facet_at_a_point():
    shown = thickness_map(measure(surface_mesh(*made_meshes.box(100, 60, 40)), AnalysisSettings()))
    search = MapSearch(shown)
    for facet in range(0, shown.count, 997):
        point = shown.corners[facet].mean(axis=0) + shown.origin
        assert search.nearest_facet(point, 1e-4) == facet
        outside = point + 0.5 * shown.normal(facet)
        assert search.nearest_facet(outside, 0.49) == -1
        assert shown.face[search.nearest_facet(outside, 0.51)] == shown.face[facet]
    corner = shown.origin + shown.points.max(axis=0)
    assert search.nearest_facet(corner + 1.0, 1.7) == -1 and search.nearest_facet(corner + 1.0, 1.8) >= 0


def test_the_outline_of_a_box_is_its_twelve_edges():
    shown = thickness_map(measure(surface_mesh(*made_meshes.box(100, 60, 40)), AnalysisSettings()))
    sides = shown.points[outline(shown)].astype(float)
    assert np.linalg.norm(sides[:, 0] - sides[:, 1], axis=1).sum() == pytest.approx(4 * 200.0, rel=1e-6)


def test_a_smooth_surface_has_no_lines_and_an_open_one_its_border():
    points, triangles = made_meshes.sphere()
    settings = AnalysisSettings()
    shown = thickness_map(measure(surface_mesh(points, triangles), settings))
    if len(np.unique(shown.face)) == 1:
        assert len(outline(shown)) == 0
    points, triangles = made_meshes.box(10, 10, 10)
    shown = thickness_map(measure(surface_mesh(points, triangles[:-2]), settings))
    assert np.linalg.norm(np.diff(shown.points[outline(shown)].astype(float), axis=1), axis=2).sum() == (
        pytest.approx(120.0))

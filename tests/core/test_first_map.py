# SPDX-License-Identifier: LGPL-2.1-or-later
"""The first, coarse map of a part: right where it is shown, soon, and from few triangles."""

import made_meshes
import numpy as np
import pytest

from thinpart_workbench.core.errors import MeshError
from thinpart_workbench.core.maps import first_map as module
from thinpart_workbench.core.maps.first_map import BALLS, MOST_FACETS, first_map
from thinpart_workbench.core.mesh.surface_mesh import surface_mesh, unchecked_mesh
from thinpart_workbench.core.mesh.thinned_facets import thinned_facets
from thinpart_workbench.core.rays.inward_rays import InwardRays


def torus(around, along, radius=8.0):
    """Points and triangles of a torus 2 `radius` thick, 2 x around x along of them."""
    u, v = np.meshgrid(np.linspace(0, 2 * np.pi, around, endpoint=False), np.linspace(0, 2 * np.pi, along, endpoint=False),
                       indexing="ij")
    points = np.stack([(30 + radius * np.cos(v)) * np.cos(u), (30 + radius * np.cos(v)) * np.sin(u), radius * np.sin(v)], -1)
    i, j = (each.ravel() for each in np.meshgrid(np.arange(around), np.arange(along), indexing="ij"))

    def at(a, b):
        return (a % around) * along + b % along

    return points.reshape(-1, 3), np.concatenate([np.stack([at(i, j), at(i + 1, j), at(i + 1, j + 1)], 1),
                                                  np.stack([at(i, j), at(i + 1, j + 1), at(i, j + 1)], 1)])


def sheet(thickness, cells):
    """Points and triangles of a square sheet of 100 mm, its two sides divided into squares and closed round."""
    grid = np.stack(np.meshgrid(np.linspace(0, 100, cells + 1), np.linspace(0, 100, cells + 1), indexing="ij"), -1)
    top = np.concatenate([grid.reshape(-1, 2), np.full((grid.shape[0] ** 2, 1), thickness)], axis=1)
    row = cells + 1
    i, j = (each.ravel() for each in np.meshgrid(np.arange(cells), np.arange(cells), indexing="ij"))
    a, b, c, d = i * row + j, (i + 1) * row + j, (i + 1) * row + j + 1, i * row + j + 1
    upper = np.concatenate([np.stack([a, b, c], 1), np.stack([a, c, d], 1)])
    rim = np.concatenate([np.arange(cells) * row, cells * row + np.arange(cells), np.arange(cells, 0, -1) * row + cells,
                          np.arange(cells, 0, -1)])
    ahead, below = np.roll(rim, -1), len(top)
    sides = np.concatenate([np.stack([rim, rim + below, ahead + below], 1), np.stack([rim, ahead + below, ahead], 1)])
    return (np.concatenate([top, top * [1, 1, 0]]), np.concatenate([upper, upper[:, ::-1] + below, sides]))


def test_a_plate_is_coloured_with_its_thickness_all_over():
    mesh = surface_mesh(*made_meshes.box(40, 30, 4))
    found = first_map(mesh)
    flat = np.abs(found.normals[:, 2]) > 0.9
    assert found.thickness[flat] == pytest.approx(4.0, abs=1e-3)
    assert found.corner_thickness[flat] == pytest.approx(4.0, abs=1e-3)
    assert found.areas.sum() == pytest.approx(mesh.areas.sum(), rel=1e-4) and found.count <= MOST_FACETS


def test_few_rays_leave_no_face_without_colours(monkeypatch):
    """Most facets take the thickness of the nearest one on their face."""
    cast = []
    monkeypatch.setattr(module, "RAYS", 50)
    first_hits = InwardRays.first_hits
    monkeypatch.setattr(InwardRays, "first_hits", lambda self, samples, *rest: (
        cast.append(samples.count), first_hits(self, samples, *rest))[1])
    found = first_map(surface_mesh(*made_meshes.box(40, 30, 4)))
    assert cast[0] <= 56 < found.count and found.measured.all()
    for axis, length in enumerate((40, 30, 4)):
        assert found.thickness[np.abs(found.normals[:, axis]) > 0.9] == pytest.approx(length, abs=1e-3)


def test_balls_are_shown_where_they_are_asked_for_and_can_be_had_in_time():
    found = first_map(surface_mesh(*made_meshes.box(40, 30, 4)), "sphere")
    assert found.measure == "sphere" and np.nanmax(found.thickness) == pytest.approx(4.0, abs=1e-3)
    points, triangles = torus(400, 60)
    assert len(triangles) > MOST_FACETS and first_map(surface_mesh(points, triangles), "sphere") is None
    assert BALLS < MOST_FACETS


def test_thinned_facets_look_like_all_of_them():
    points, triangles = torus(800, 200)
    thinned, facets, kept = thinned_facets(points, triangles, 20_000)
    assert 10_000 < len(facets) < 40_000 and len(kept) == len(facets)
    found = unchecked_mesh(thinned, facets)
    assert found.areas.sum() == pytest.approx(4 * np.pi ** 2 * 30 * 8, rel=0.02)
    away = np.linalg.norm(thinned[facets].mean(axis=1) - points[triangles[kept]].mean(axis=1), axis=1)
    assert away.max() < 2.5, "each facet lies about where the one lay that it stands for"
    colours = first_map(found)
    assert np.nanmedian(colours.thickness) == pytest.approx(16.0, rel=0.01) and colours.measured.mean() > 0.999


@pytest.mark.parametrize("thickness", [0.02, 0.3, 5.0])
def test_a_sheet_thinner_than_a_cell_does_not_collapse(thickness):
    points, triangles = sheet(thickness, 300)
    thinned, facets, _ = thinned_facets(points, triangles, 5_000)
    found = first_map(unchecked_mesh(thinned, facets))
    inside = (np.abs(found.normals[:, 2]) > 0.9) & (np.abs(found.corners.mean(axis=1)[:, :2]) < 40).all(axis=1)
    assert found.thickness[inside] == pytest.approx(thickness, rel=1e-3)


def test_triangles_without_area_and_inside_out_do_no_harm():
    points, triangles = torus(60, 30)
    spoilt = np.concatenate([triangles[:, ::-1], [[0, 0, 1], [0, 1, 0]]])
    found = unchecked_mesh(points, spoilt)
    assert found.count == len(triangles) and np.isfinite(found.normals).all()
    assert np.nanmedian(first_map(found).thickness) == pytest.approx(16.0, rel=0.02)
    with pytest.raises(MeshError) as raised:
        unchecked_mesh(points, np.zeros((3, 3), dtype=np.int64))
    assert raised.value.kind == "zero_volume"

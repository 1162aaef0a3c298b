# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sections of thickness maps: the edge of the cut, and the material in it."""

import made_meshes
import numpy as np
import pytest

from thinpart_workbench.core.analysis_settings import AnalysisSettings
from thinpart_workbench.core.maps.map_section import SectionPlane, map_section, section_extent
from thinpart_workbench.core.maps.mapped_part import MappedPart
from thinpart_workbench.core.maps.thickness_map import thickness_map
from thinpart_workbench.core.mesh.surface_mesh import surface_mesh
from thinpart_workbench.core.thickness.measurement import measure

AXES = [(1, 0, 0), (0, 1, 0), (0, 0, 1), (0.6, 0.0, 0.8), tuple(np.ones(3) / np.sqrt(3.0))]


def _map(shape):
    return thickness_map(measure(surface_mesh(*shape), AnalysisSettings()))


def _area(pieces):
    """Area of four-sided pieces, mm2."""
    halves = np.concatenate([pieces[:, [0, 1, 2]], pieces[:, [0, 2, 3]]])
    return 0.5 * np.linalg.norm(np.cross(halves[:, 1] - halves[:, 0], halves[:, 2] - halves[:, 0]), axis=1).sum()


@pytest.mark.parametrize("shape, plane, area, length", [
    (made_meshes.box(100, 60, 40), SectionPlane((1, 0, 0), 30.0), 60 * 40, 200.0),
    (made_meshes.box(100, 60, 40), SectionPlane((0, 0, -1), -11.0), 100 * 60, 320.0),
    (made_meshes.tube(20.0, 18.0, 60.0), SectionPlane((0, 1, 0), 0.001), 2 * 2 * 60, 4 * 62.0),
], ids=["box", "box from below", "tube along its axis"])
def test_the_material_has_the_area_of_the_cut_and_its_edge_the_length(shape, plane, area, length):
    shown = _map(shape)
    cut = map_section(shown, plane)
    assert _area(cut.material) == pytest.approx(area, rel=1e-3)
    assert np.linalg.norm(np.ptp(cut.ends, axis=1), axis=1).sum() == pytest.approx(length, rel=1e-3)
    for points in (cut.ends, cut.material):
        assert np.abs(plane.heights(points.reshape(-1, 3))).max() < 1e-4


@pytest.mark.parametrize("normal", AXES)
@pytest.mark.parametrize("shape", [made_meshes.ribbed_block(), made_meshes.spherical_shell(), made_meshes.tube()],
                         ids=["ribbed", "shell", "tube"])
def test_sections_at_all_heights_add_up_to_the_volume(shape, normal):
    mesh = surface_mesh(*made_meshes.moved(shape, shift=(300.0, -20.0, 5.0)))
    measured = measure(mesh, AnalysisSettings())
    shown = thickness_map(measured)
    low, high = section_extent([MappedPart({}, shown)], np.eye(4), normal)
    count = 200
    heights = low + (np.arange(count) + 0.5) * (high - low) / count
    areas = [_area(map_section(shown, SectionPlane(normal, height)).material) for height in heights]
    assert sum(areas) * (high - low) / count == pytest.approx(measured.descriptors.volume, rel=0.01)


def test_the_edge_has_the_thickness_of_the_wall_there():
    cut = map_section(_map(made_meshes.tube(20.0, 18.0, 60.0)), SectionPlane((0, 0, 1), 30.0))
    assert cut.thickness == pytest.approx(2.0, rel=0.02)


def test_only_drawn_facets_have_an_edge_but_all_bound_the_material():
    shown = _map(made_meshes.box(100, 60, 40))
    plane = SectionPlane((1, 0, 0), 30.0)
    cut = map_section(shown, plane, shown.normals[:, 2] > 0.9)
    assert np.linalg.norm(np.ptp(cut.ends, axis=1), axis=1).sum() == pytest.approx(60.0)
    assert _area(cut.material) == pytest.approx(2400.0)
    outside = map_section(shown, SectionPlane((1, 0, 0), 300.0))
    assert not len(outside.ends) and not len(outside.material)


def test_very_many_edges_are_filled_more_coarsely():
    plates = [made_meshes.moved(made_meshes.box(1, 200, 60, cells=12), shift=(2.0 * number, 0.001 * number, 0.0))
              for number in range(60)]
    cut = map_section(_map(made_meshes.joined(*plates)), SectionPlane((0, 0, 1), 30.0))
    assert len(cut.material) <= 200_000 and _area(cut.material) == pytest.approx(60 * 200, rel=0.02)


def test_a_plane_moves_with_what_it_cuts_and_tells_where_a_ray_enters():
    matrix = np.array([[0.0, -1, 0, 7], [1, 0, 0, 2], [0, 0, 1, 3], [0, 0, 0, 1]])
    plane = SectionPlane((1.0, 0.0, 0.0), 5.0)
    assert plane.moved(matrix) == SectionPlane((0.0, 1.0, 0.0), 7.0)
    assert plane.entry((10.0, 0, 0), (-2.0, 0, 0)) == 2.5 and plane.entry((0, 0, 0), (1.0, 0, 0)) == 0.0
    assert plane.entry((10.0, 0, 0), (1.0, 0, 0)) == np.inf == plane.entry((10.0, 0, 0), (0, 1.0, 0))

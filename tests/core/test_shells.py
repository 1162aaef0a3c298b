# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shells: pairs of faces, thickness through the wall, sections, pieces, ends within the material, shell or solid."""

import made_meshes
import numpy as np
import pytest

from thinpart_workbench.core.analysis_settings import AnalysisSettings
from thinpart_workbench.core.errors import ThinPartError
from thinpart_workbench.core.mesh.surface_mesh import surface_mesh
from thinpart_workbench.core.shells.facing_faces import facing_faces
from thinpart_workbench.core.shells.open_ends import open_ends
from thinpart_workbench.core.shells.shell_mesh import ShellMesh, shell_mesh
from thinpart_workbench.core.shells.shell_or_solid import idealisation
from thinpart_workbench.core.shells.shell_settings import ShellSettings
from thinpart_workbench.core.shells.wall_sides import wall_sides
from thinpart_workbench.core.thickness.measurement import measure


def measured(vertices, triangles):
    return measure(surface_mesh(vertices, triangles), AnalysisSettings())


@pytest.fixture(scope="module")
def plate():
    return measured(*made_meshes.box(100, 80, 2))


def sheet(measurement, low, high, cells=10):
    """A grid of triangles half-way through a plate, between two corners."""
    middle = measurement.field.mesh.origin
    x, y = (np.linspace(a, b, cells + 1) for a, b in zip(low, high))
    points = np.array([(a, b, 0.0) for a in x for b in y]) + middle
    first = (np.arange(cells)[:, None] * (cells + 1) + np.arange(cells)).ravel()
    triangles = np.concatenate([np.column_stack([first, first + 1, first + cells + 1]),
                                np.column_stack([first + 1, first + cells + 2, first + cells + 1])])
    return points, triangles, np.zeros(len(triangles), dtype=np.int64)


class _Wall:
    def __init__(self, pairs):
        self.face_pairs, self.thickness = [pair.faces for pair in pairs], pairs[0].thickness


def test_the_two_sides_of_a_plate_are_a_pair_and_its_rims_are_none(plate):
    pairs = facing_faces(plate.field)
    assert len(pairs) == 1
    assert pairs[0].thickness == pytest.approx(2.0, rel=1e-6) and pairs[0].area == pytest.approx(8000.0, rel=0.02)
    assert pairs[0].middles[:, 2] == pytest.approx(plate.field.mesh.origin[2])


def test_a_plate_has_two_sides_and_rims_belong_to_none(plate):
    count = int(plate.field.mesh.face_of_triangle.max()) + 1
    rims_and_sides = {(first, second): 1.0 for first in range(count) for second in range(first + 1, count)}
    sides = wall_sides(plate.field, rims_and_sides, count)
    assert [side.area for side in sides] == [pytest.approx(8000.0, rel=0.02)] * 2
    assert [len(side.faces) for side in sides] == [1, 1] and sides[0].faces != sides[1].faces
    assert sides[0].pairs == sides[1].pairs == [tuple(sorted((*sides[0].faces, *sides[1].faces)))]
    assert sides[0].thickness == pytest.approx(2.0)


def test_a_block_has_no_sides():
    block = measured(*made_meshes.box(50, 40, 30))
    assert wall_sides(block.field, {}, int(block.field.mesh.face_of_triangle.max()) + 1) == []


def test_walls_whose_thickness_varies_have_it_at_their_nodes():
    points = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0], [2, 0, 0]], dtype=float)
    shell = ShellMesh(points, np.array([[0, 1, 2], [1, 3, 2], [1, 4, 3]]), np.array([0, 0, 1]), np.array([1.0, 2.0, 5.0]))
    assert shell.is_tapered.tolist() == [True, True, False]
    node, thickness = shell.node_thickness(np.array([0, 1]))
    assert node.tolist() == [0, 1, 2, 3] and thickness.tolist() == [1.0, 1.5, 1.5, 2.0]


def test_a_shell_half_way_through_a_plate_has_its_thickness_and_volume(plate):
    shell = shell_mesh(*sheet(plate, (-50, -40), (50, 40)), [_Wall(facing_faces(plate.field))], plate.field.mesh, plate.rays)
    assert shell.thickness == pytest.approx(2.0) and shell.volume == pytest.approx(16000.0)
    assert shell.pieces == 1 and shell.sections()[1] == pytest.approx([2.0])
    inside, free = open_ends(shell, plate.field.mesh, plate.rays)
    assert (inside, free) == (0.0, pytest.approx(360.0))


def test_an_edge_that_ends_within_the_material_is_found(plate):
    shell = shell_mesh(*sheet(plate, (-50, -40), (20, 40)), [_Wall(facing_faces(plate.field))], plate.field.mesh, plate.rays)
    inside, free = open_ends(shell, plate.field.mesh, plate.rays)
    assert (inside, free) == (pytest.approx(80.0), pytest.approx(300.0))


def test_sections_gather_like_thicknesses_and_pieces_are_counted():
    points = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [5, 0, 0], [6, 0, 0], [5, 2, 0]], dtype=float)
    shell = ShellMesh(points, np.array([[0, 1, 2], [3, 4, 5]]), np.array([0, 1]), np.array([3.0, 1.0]))
    section, thickness = shell.sections()
    assert list(section) == [1, 0] and list(thickness) == [1.0, 3.0]
    assert shell.pieces == 2 and shell.volume == pytest.approx(0.5 * 3.0 + 1.0)


def test_a_plate_is_a_shell_and_a_block_is_a_solid(plate):
    found = idealisation(plate, 50_000, 10.0)
    assert found.advice == "shell" and found.plate_volume_share == pytest.approx(1.0, abs=0.02)
    assert found.width_to_thickness == pytest.approx(40.0, rel=0.05)
    assert 100 < found.shell_elements < found.solid_elements == 50_000
    assert idealisation(measured(*made_meshes.box(50, 40, 30)), 1000, 10.0).advice == "solid"


def test_no_shell_is_advised_where_none_can_be_made_and_the_reason_is_given_where_it_matters(plate):
    found = idealisation(plate, 50_000, 10.0, "It has no mid-surface.")
    assert found.advice == "solid" and found.no_shell == "It has no mid-surface."
    block = idealisation(measured(*made_meshes.box(50, 40, 30)), 1000, 10.0, "It has no mid-surface.")
    assert block.advice == "solid" and block.no_shell == ""


@pytest.mark.parametrize("values", [{"size": 0.0}, {"size": float("inf")}, {"order": 3}])
def test_settings_out_of_range_are_refused(values):
    with pytest.raises(ThinPartError) as refused:
        ShellSettings(**values)
    assert refused.value.kind == "usage"

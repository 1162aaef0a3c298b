# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sides of a shell that solids are tied to."""

import numpy as np
import pytest

from thinpart_workbench.core.shells.mixed_mesh import SolidMesh, area_of_sides, reached_by, sides_on
from thinpart_workbench.core.shells.shell_mesh import ShellMesh
from thinpart_workbench.storage.exchange.shell_files import inp_text, mixed_text


@pytest.fixture
def shell():
    """One triangle of second order, 2 mm thick, whose side along x is 4 mm long."""
    points = np.array([[0, 0, 0], [4, 0, 0], [0, 4, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0]], dtype=float)
    return ShellMesh(points, np.arange(6)[None], np.zeros(1, int), np.full(1, 2.0))


def test_a_side_is_on_a_cut_with_all_its_nodes(shell):
    assert sides_on(shell.triangles, np.array([1, 1, 0, 1, 0, 0], bool)).tolist() == [[0, 0]]
    assert sides_on(shell.triangles, np.array([1, 1, 1, 1, 0, 1], bool)).tolist() == [[0, 0], [0, 2]]
    assert sides_on(shell.triangles, np.array([1, 1, 1, 0, 0, 0], bool)).shape == (0, 2)


def test_the_cross_section_is_length_by_thickness_along_an_arc_too(shell):
    assert area_of_sides(shell, np.array([[0, 0]])) == pytest.approx(8.0)
    shell.points[:2], shell.points[3] = [[10, 0, 0], [0, 10, 0]], 10.0 * np.sqrt(0.5) * np.array([1.0, 1.0, 0.0])
    assert area_of_sides(shell, np.array([[0, 0]])) == pytest.approx(2.0 * 5.0 * np.pi, rel=0.01)


def test_a_node_is_tied_within_the_thickness(shell):
    points = np.array([[1, 0, 0.99], [3, 0, -1.0], [2, 0, 1.2], [5.5, 0, 0]])
    assert reached_by(shell, np.array([[0, 0]]), points).tolist() == [True, True, False, False]


def test_the_file_of_both_has_the_shell_first_and_numbers_on(shell):
    points = np.random.default_rng(1).random((10, 3))
    solid = SolidMesh(points, np.arange(10)[None], np.array([0, 3]), np.array([[0, 2]]), 0.5)
    text = mixed_text(shell, solid, "part")
    assert text.startswith(inp_text(shell, "part"))
    rest = text[len(inp_text(shell, "part")):]
    # CalculiX has the last two nodes of a tetrahedron the other way round than Gmsh.
    assert "TYPE=C3D10, ELSET=SOLID\n2,7,8,9,10,11,12,13,14,16,15\n" in rest
    assert "NSET=CUT\n7,\n10,\n" in rest and "NAME=SHELLEND\n1,S5\n" in rest and "TOLERANCE=2, ADJUST=NO" in rest

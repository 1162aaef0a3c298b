# SPDX-License-Identifier: LGPL-2.1-or-later
"""Netgen where Gmsh fails: its elements in Gmsh's order, files that are read back, and the real program where it is."""

import shutil

import numpy as np
import pytest

from thinpart_workbench.core.mesh.second_order import SIDES, least_jacobians
from thinpart_workbench.storage.exchange.msh_file import read_tetrahedra, read_triangles, write_mesh
from thinpart_workbench.workflow.meshing.netgen_program import has_netgen
from thinpart_workbench.workflow.meshing.netgen_script import NETGEN, in_order

CORNERS = np.array([[0.0, 0.0, 0.0], [0.0, 3.0, 0.0], [2.0, 0.0, 0.0], [0.0, 0.0, 5.0]])
"""Of a tetrahedron as Netgen has it: the other way round than Gmsh."""


def points_of(corners):
    """Corners and the middles of the sides, in Netgen's order."""
    return np.concatenate([corners, [0.5 * (corners[one] + corners[other]) for one, other in NETGEN[len(corners)]]])


def test_a_tetrahedron_is_the_right_way_round_and_has_its_middles_where_gmsh_has_them():
    points = points_of(CORNERS)
    nodes = in_order(np.arange(1, 11)[None], 4, True)
    own = points[nodes[0]]
    assert sorted(nodes[0]) == list(range(10)) and np.linalg.det(own[1:4] - own[0]) == pytest.approx(30.0)
    for number, (one, other) in enumerate(SIDES, start=4):
        assert own[number] == pytest.approx(0.5 * (own[one] + own[other]))
    assert least_jacobians(points, nodes) == pytest.approx(1.0)
    assert in_order(np.arange(1, 11)[None], 4, False).tolist() == [nodes[0, :4].tolist()]


def test_a_triangle_has_its_middles_where_gmsh_has_them():
    points, nodes = points_of(CORNERS[:3]), in_order(np.arange(1, 7)[None], 3, True)
    for number, (one, other) in enumerate(SIDES[:3], start=3):
        assert points[nodes[0, number]] == pytest.approx(0.5 * (points[nodes[0, one]] + points[nodes[0, other]]))


@pytest.mark.parametrize("order, sizes", [(1, (4, 3)), (2, (10, 6))])
def test_a_mesh_that_is_written_is_read_back(order, sizes, tmp_path):
    random = np.random.default_rng(5)
    points = random.normal(size=(20, 3))
    tetrahedra, triangles = (random.permuted(np.tile(np.arange(20), (rows, 1)), axis=1)[:, :width]
                             for rows, width in zip((7, 5), sizes))
    surface = np.array([3, 1, 1, 2, 3])
    file = tmp_path / "mesh.msh"
    write_mesh(file, points, tetrahedra, triangles, surface)
    for found, given in zip((*read_tetrahedra(file, order), *read_triangles(file, order)),
                            (points, tetrahedra, points, triangles, surface)):
        assert (found == given).all()


@pytest.mark.skipif(shutil.which("gmsh") is None, reason="gmsh is not installed")
def test_gmsh_converts_a_mesh_that_is_written(tmp_path):
    from thinpart_workbench.workflow.meshing.gmsh_program import convert_mesh

    points, nodes = points_of(CORNERS), in_order(np.arange(1, 11)[None], 4, True)
    triangle = nodes[:, [0, 1, 2, 4, 5, 6]]
    write_mesh(tmp_path / "mesh.msh", points, nodes, triangle, np.array([1]))
    output = tmp_path / "mesh.unv"
    assert convert_mesh(shutil.which("gmsh"), str(tmp_path / "mesh.msh"), str(output), 30.0, str(tmp_path)) == ""
    assert output.read_text().count("    -1") >= 4


@pytest.mark.skipif(not has_netgen(), reason="this Python has no Netgen with netgen.occ")
def test_netgen_meshes_with_the_sizes_of_a_proposal(tmp_path):
    from thinpart_workbench.freecad_adapter.bootstrap import load_meshing

    load_meshing()
    import Part

    from thinpart_workbench.core.analysis_settings import AnalysisSettings
    from thinpart_workbench.core.judging.criteria import load_profile
    from thinpart_workbench.core.sizing.size_proposal import propose_sizes
    from thinpart_workbench.core.sizing.sizing_settings import SizingSettings
    from thinpart_workbench.freecad_adapter.shapes.part import SolidPart
    from thinpart_workbench.workflow.analysis.analyse_part import analyse_part
    from thinpart_workbench.workflow.meshing.netgen_program import mesh_with_netgen

    part = SolidPart("Plate", "Plate", shape=Part.makeBox(100, 60, 3))
    part.write_brep(str(tmp_path / "part.brep"))
    proposal = propose_sizes(analyse_part(part, AnalysisSettings(), load_profile())[0], 10.0, SizingSettings())
    output = tmp_path / "mesh.msh"
    assert mesh_with_netgen(str(tmp_path / "part.brep"), proposal, str(output), 60.0, str(tmp_path)) == ""
    points, tetrahedra = read_tetrahedra(output, 2)
    assert 0.3 * proposal.nodes < len(points) < 3.0 * proposal.nodes and least_jacobians(points, tetrahedra).min() > 0.0

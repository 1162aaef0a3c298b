# SPDX-License-Identifier: LGPL-2.1-or-later
"""Volume meshes as Gmsh writes them, and what is none."""

import shutil
import struct
import subprocess

import numpy as np
import pytest

from thinpart_workbench.core.errors import ThinPartError
from thinpart_workbench.core.mesh.second_order import SIDES, least_jacobians
from thinpart_workbench.storage.exchange.msh_file import move_points, read_tetrahedra, read_triangles

POINTS = [(5, 0.0, 0.0, 0.0), (2, 1.0, 0.0, 0.0), (9, 0.0, 1.0, 0.0), (3, 0.0, 0.0, 1.0)]


def mesh(elements, count=None):
    nodes = b"".join(struct.pack("<i3d", *point) for point in POINTS)
    return (b"$MeshFormat\n2.2 1 8\n\x01\0\0\0\n$EndMeshFormat\n$Nodes\n4\n" + nodes + b"\n$EndNodes\n$Elements\n"
            + str(len(elements) if count is None else count).encode() + b"\n" + b"".join(elements) + b"\n$EndElements\n")


TETRAHEDRON = struct.pack("<3i7i", 4, 1, 2, 2, 1, 1, 5, 2, 9, 3)
TRIANGLE = struct.pack("<3i6i", 2, 1, 2, 1, 1, 1, 5, 2, 9)


def test_tetrahedra_are_rows_of_the_points(tmp_path):
    (tmp_path / "a.msh").write_bytes(mesh([TRIANGLE, TETRAHEDRON]))
    points, tetrahedra = read_tetrahedra(tmp_path / "a.msh")
    assert points.tolist() == [list(point[1:]) for point in POINTS] and tetrahedra.tolist() == [[0, 1, 2, 3]]
    (tmp_path / "b.msh").write_bytes(mesh([TRIANGLE]))
    assert read_tetrahedra(tmp_path / "b.msh")[1].shape == (0, 4)


@pytest.mark.parametrize("content", [b"", b"$MeshFormat\n4.1 0 8\n", mesh([TETRAHEDRON], 3), mesh([TETRAHEDRON])[:180],
                                     mesh([struct.pack("<3i", 77, 1, 2)]), mesh([struct.pack("<3i", 4, 0, 2)])])
def test_what_is_no_mesh_is_one_sentence(content, tmp_path):
    (tmp_path / "bad.msh").write_bytes(content)
    with pytest.raises(ThinPartError, match="The mesh .*bad.msh cannot be read"):
        read_tetrahedra(tmp_path / "bad.msh")


def test_points_are_a_copy_that_may_be_changed(tmp_path):
    (tmp_path / "a.msh").write_bytes(mesh([TETRAHEDRON]))
    points, _ = read_tetrahedra(tmp_path / "a.msh")
    points += 1.0
    assert np.isfinite(points).all()


@pytest.fixture(scope="module")
def of_gmsh(tmp_path_factory):
    """A box with a hole, by the real Gmsh, in elements of second order."""
    if shutil.which("gmsh") is None:
        pytest.skip("gmsh is not installed")
    folder = tmp_path_factory.mktemp("gmsh")
    (folder / "part.geo").write_text(
        'SetFactory("OpenCASCADE");\nBox(1) = {0, 0, 0, 20, 12, 6};\nCylinder(2) = {7, 6, -1, 0, 0, 8, 2};\n'
        "BooleanDifference(3) = { Volume{1}; Delete; }{ Volume{2}; Delete; };\n")
    gmsh("part.geo", "-3", "-order", "2", "-clmax", "5", "-o", "part.msh", folder=folder)
    return folder / "part.msh"


def gmsh(*arguments, folder):
    subprocess.run(["gmsh", *arguments, "-format", "msh2", "-bin", "-nt", "1", "-v", "2"], cwd=folder, check=True,
                   timeout=60)


def test_the_middles_of_sides_are_in_the_order_that_is_stated(of_gmsh):
    points, tetrahedra = read_tetrahedra(of_gmsh, 2)
    _, triangles, _ = read_triangles(of_gmsh, 2)
    on_surface = np.isin(tetrahedra[:, 4:], triangles)
    middles = points[tetrahedra[:, np.array(SIDES)]].mean(axis=2)
    away = np.linalg.norm(points[tetrahedra[:, 4:]] - middles, axis=2)
    assert len(tetrahedra) > 100 and (~on_surface).sum() > 100
    assert away[~on_surface].max() < 1.0 and np.median(away) < 1e-9, "all but those at the hole are half-way"
    assert np.median(least_jacobians(points, tetrahedra)) == pytest.approx(1.0)


def test_points_are_moved_and_all_else_stays_as_gmsh_wrote_it(of_gmsh, tmp_path):
    shutil.copy(of_gmsh, tmp_path / "moved.msh")
    points, tetrahedra = read_tetrahedra(of_gmsh, 2)
    _, triangles, surface = read_triangles(of_gmsh, 2)
    wanted = points + np.random.default_rng(3).normal(size=points.shape)
    move_points(tmp_path / "moved.msh", wanted)
    found, same = read_tetrahedra(tmp_path / "moved.msh", 2)
    assert (found == wanted).all() and (same == tetrahedra).all()
    _, other_triangles, other_surface = read_triangles(tmp_path / "moved.msh", 2)
    assert (other_triangles == triangles).all() and (other_surface == surface).all()
    # Only the places differ, and Gmsh still reads it.
    before, after = of_gmsh.read_bytes(), (tmp_path / "moved.msh").read_bytes()
    assert len(before) == len(after) and before.partition(b"$EndNodes")[2] == after.partition(b"$EndNodes")[2]
    gmsh("moved.msh", "-save", "-o", "again.msh", folder=tmp_path)
    assert read_tetrahedra(tmp_path / "again.msh", 2)[0] == pytest.approx(wanted, rel=1e-12)


def test_points_where_they_are_leave_the_file_as_it_is(of_gmsh, tmp_path):
    shutil.copy(of_gmsh, tmp_path / "same.msh")
    move_points(tmp_path / "same.msh", read_tetrahedra(of_gmsh, 2)[0])
    assert (tmp_path / "same.msh").read_bytes() == of_gmsh.read_bytes()

"""Volume meshes as Gmsh writes them, and what is none."""

import struct

import numpy as np
import pytest

from thinpart_workbench.core.errors import ThinPartError
from thinpart_workbench.storage.exchange.msh_file import read_tetrahedra

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

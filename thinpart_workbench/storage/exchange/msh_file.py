# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reads the meshes that Gmsh writes."""

import numpy as np

from ...core.errors import ThinPartError
from ...core.message import message
from ...core.problem import problem_of
from ...core.regular_file import read_regular

LARGEST = 2 << 30
"""Bytes of a file above which it is not read."""

_TETRAHEDRA = (4, 11)
"""Gmsh's numbers for tetrahedra of four nodes and of ten."""

_TRIANGLES = {2: 3, 9: 6}
"""Nodes of triangles of first and of second order, by Gmsh's number."""

_NODES_OF = {1: 2, 2: 3, 3: 4, 4: 4, 5: 8, 6: 6, 7: 5, 8: 3, 9: 6, 11: 10, 15: 1}
"""Nodes of an element, by Gmsh's number for its type."""

_NODE = np.dtype([("number", "<i4"), ("point", "<f8", 3)])


def read_tetrahedra(path, order=1):
    """The tetrahedra of a file in the binary MSH format 2.2 (Gmsh reference manual, 10.2).

    Returns `points` (ndarray of shape (v, 3)) and `tetrahedra` (ndarray of int64, shape (n, 4) or (n, 10); rows of the
    points; n is 0 where Gmsh could not fill the volume). Raises ThinPartError, kind ``unreadable``.

    Parameters
    ----------
    path : str or Path
    order : int
        2 for all nodes of tetrahedra of second order; else the corners only.
    """
    points, blocks = _read(path)
    width = {1: 4, 2: 10}[order]
    return points, np.concatenate([np.zeros((0, width), np.int64)] + [
        nodes[:, :width] for kind, _, nodes in blocks if kind in _TETRAHEDRA and nodes.shape[1] >= width])


def read_triangles(path, order=1):
    """The triangles of a file in the binary MSH format 2.2; raises ThinPartError of kind ``unreadable``.

    Parameters
    ----------
    path : str or Path
    order : int
        1 or 2.

    Returns
    -------
    points : ndarray of shape (v, 3)
    triangles : ndarray of int64, shape (n, 3) or (n, 6)
        Rows of the points: corners, then the middles of the sides.
    surface : ndarray of shape (n,), int64
        Number of the surface that each lies on, from 1.
    """
    points, blocks = _read(path)
    width = {1: 3, 2: 6}[order]
    found = [(nodes, tags[:, 1]) for kind, tags, nodes in blocks if _TRIANGLES.get(kind) == width]
    if not found:
        return points, np.zeros((0, width), np.int64), np.zeros(0, np.int64)
    triangles, surface = zip(*found)
    return points, np.concatenate(triangles), np.concatenate(surface).astype(np.int64)


def move_points(path, points):
    """Give all points of a mesh other places, in its own file, one that Gmsh has made in a temporary folder.

    Parameters
    ----------
    path : str or Path
        In the binary MSH format 2.2.
    points : ndarray of shape (v, 3)
        In the order of `read_tetrahedra`.
    """
    content = bytearray(read_regular(path, LARGEST))
    count, start = _count_after(content, b"$Nodes\n")
    np.frombuffer(content, _NODE, count, start)["point"][:] = points
    with open(path, "wb") as file:
        file.write(content)


def write_mesh(path, points, tetrahedra, triangles, surface):
    """Write a mesh in the binary MSH format 2.2.

    Parameters
    ----------
    path : str or Path
    points : ndarray of shape (v, 3)
    tetrahedra : ndarray of int, shape (n, 4) or (n, 10)
    triangles : ndarray of int, shape (k, 3) or (k, 6)
    surface : ndarray of int, shape (k,)
        Number of the surface that each triangle lies on, from 1.
    """
    nodes = np.zeros(len(points), _NODE)
    nodes["number"], nodes["point"] = np.arange(1, len(points) + 1), points
    kinds = {4: 4, 10: 11, 3: 2, 6: 9}
    with open(path, "wb") as file:
        file.write(b"$MeshFormat\n2.2 1 8\n" + np.array([1], "<i4").tobytes() + b"\n$EndMeshFormat\n")
        file.write(b"$Nodes\n%d\n" % len(nodes) + nodes.tobytes() + b"\n$EndNodes\n")
        file.write(b"$Elements\n%d\n" % (len(triangles) + len(tetrahedra)))
        first = 1
        for elements, entity in ((triangles, surface), (tetrahedra, np.ones(len(tetrahedra), int))):
            if not len(elements):
                continue
            numbers = np.arange(first, first + len(elements))
            file.write(np.array([kinds[elements.shape[1]], len(elements), 2], "<i4").tobytes())
            file.write(np.column_stack([numbers, entity, entity, elements + 1]).astype("<i4").tobytes())
            first += len(elements)
        file.write(b"\n$EndElements\n")


def _read(path):
    try:
        return _elements(read_regular(path, LARGEST))
    except (OSError, ValueError, IndexError, KeyError) as error:
        raise ThinPartError(message(
            "The mesh {file} cannot be read ({problem}).", file=path,
            problem=problem_of(error, message("it is damaged or incomplete"))), "unreadable") from None


def _elements(content):
    """Points, and blocks of elements: (kind, tags, rows of the points)."""
    if not content.startswith(b"$MeshFormat\n2.2 1 8\n"):
        raise ValueError(message("it is not in the binary MSH format 2.2"))
    count, start = _count_after(content, b"$Nodes\n")
    nodes = np.frombuffer(content, _NODE, count, start)
    rows = np.zeros(int(nodes["number"].max(initial=0)) + 1, np.int64)
    rows[nodes["number"]] = np.arange(count)
    expected, start = _count_after(content, b"$Elements\n")
    found = []
    while expected > 0:
        kind, length, tags = np.frombuffer(content, "<i4", 3, start).tolist()
        width = 1 + tags + _NODES_OF[kind]
        block = np.frombuffer(content, "<i4", length * width, start + 12).reshape(length, width)
        found.append((kind, block[:, 1:1 + tags], rows[block[:, 1 + tags:]]))
        start, expected = start + 12 + block.nbytes, expected - length
        if length <= 0:
            raise ValueError(message("a block of its elements is empty"))
    return nodes["point"].copy(), found


def _count_after(content, title):
    start = content.index(title) + len(title)
    end = content.index(b"\n", start)
    return int(content[start:end]), end + 1

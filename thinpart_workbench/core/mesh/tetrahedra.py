# SPDX-License-Identifier: LGPL-2.1-or-later
"""Volume meshes of tetrahedra: how good each is, how much of the surface lies on chosen ones, and layers in a wall."""

import numpy as np
from scipy.sparse import coo_matrix
from scipy.spatial import cKDTree

POOR = 0.3
"""Ratio of radii below which a tetrahedron is poor: where Gmsh's own optimisation begins to act."""

_SIDES = np.array([[1, 2, 3], [0, 3, 2], [0, 1, 3], [0, 2, 1]])
"""Corners of the side opposite to each corner."""


def radius_ratios(points, tetrahedra):
    """Three times the radius of the inscribed sphere by that of the circumscribed one: Gmsh's measure ``gamma``.

    Returns an ndarray of shape (n,): 1 for regular tetrahedra, 0 for flat ones.

    Liu, Joe (1994), Relationship between tetrahedron shape measures, BIT 34:268-287, doi:10.1007/BF01955874.

    Parameters
    ----------
    points : ndarray of shape (v, 3), mm
    tetrahedra : ndarray of int, shape (n, 4)
    """
    corner = points[tetrahedra[:, 0]]
    a, b, c = (points[tetrahedra[:, number]] - corner for number in (1, 2, 3))
    crossed = np.cross(b, c), np.cross(c, a), np.cross(a, b)
    six_volumes = np.abs(np.einsum("ij,ij->i", a, crossed[0]))
    around = sum(np.einsum("ij,ij->i", edge, edge)[:, None] * normal for edge, normal in zip((a, b, c), crossed))
    # The inscribed radius is 3 V / area, the circumscribed one |around| / 12 V.
    below = _side_areas(points, tetrahedra).sum(axis=1) * np.linalg.norm(around, axis=1)
    return np.divide(3.0 * six_volumes ** 2, below, out=np.zeros(len(tetrahedra)), where=below > 0.0)


def surface_share(points, tetrahedra, chosen):
    """Share of the surface of a mesh that lies on chosen tetrahedra: float, 0 for a mesh without a surface.

    Parameters
    ----------
    points : ndarray of shape (v, 3), mm
    tetrahedra : ndarray of int, shape (n, 4)
    chosen : ndarray of bool, shape (n,)
    """
    outer = _outer_sides(tetrahedra)[1]
    areas = _side_areas(points, tetrahedra).reshape(-1)[outer]
    total = areas.sum()
    return float(areas[np.repeat(chosen, 4)[outer]].sum() / total) if total > 0.0 else 0.0


def _side_areas(points, tetrahedra):
    """Area of the side opposite to each corner, ndarray of shape (n, 4)."""
    corners = points[tetrahedra[:, _SIDES]]
    normals = np.cross(corners[:, :, 1] - corners[:, :, 0], corners[:, :, 2] - corners[:, :, 0])
    return 0.5 * np.linalg.norm(normals, axis=2)


def inverse_condition_numbers(points, tetrahedra):
    """Signed inverse condition number of the map from the regular tetrahedron: Gmsh's measure ``minSICN``.

    Returns an ndarray of shape (n,): 1 for regular tetrahedra, 0 for flat ones, negative for inverted ones.

    3 / (|S| |S^-1|) with the norms of Frobenius. Knupp (2001), Algebraic mesh quality metrics, SIAM J. Sci. Comput.
    23(1):193-218, doi:10.1137/S1064827500371499.

    Parameters
    ----------
    points : ndarray of shape (v, 3), mm
    tetrahedra : ndarray of int, shape (n, 4)
    """
    corner = points[tetrahedra]
    sides = (corner[:, 1:] - corner[:, :1]).transpose(0, 2, 1) @ _FROM_REGULAR
    determinant = np.linalg.det(sides)
    # |S^-1| det = |adj(S)|: the cofactors are the cross products of the columns.
    a, b, c = sides[:, :, 0], sides[:, :, 1], sides[:, :, 2]
    cofactors = np.stack([np.cross(b, c), np.cross(c, a), np.cross(a, b)], axis=1)
    below = np.sqrt(np.einsum("nij,nij->n", sides, sides) * np.einsum("nij,nij->n", cofactors, cofactors))
    return np.divide(3.0 * determinant, below, out=np.zeros(len(tetrahedra)), where=below > 0.0)


def outer_nodes(tetrahedra):
    """Nodes on the surface of a mesh: ndarray of int, ascending."""
    return np.unique(_outer_sides(tetrahedra)[0])


def layers_through(points, tetrahedra, here, there, most):
    """How many elements lie one behind the other between two places on opposite sides of a wall.

    Returns an ndarray of int, shape (k,): the number of edges from the node next to the one place to the nearest surface
    node beyond the middle of the wall. 1 where one element reaches through, `most` where that many or more are needed.

    Parameters
    ----------
    points : ndarray of shape (v, 3), mm
    tetrahedra : ndarray of int, shape (n, 4)
    here, there : ndarray of shape (k, 3), mm
        On the surface, and on the opposite side of the wall.
    most : int
        Counting ends there.
    """
    outer = outer_nodes(tetrahedra)
    edges = np.concatenate([tetrahedra[:, pair] for pair in ([0, 1], [0, 2], [0, 3], [1, 2], [1, 3], [2, 3])])
    graph = coo_matrix((np.ones(len(edges), dtype=np.int8), edges.T), shape=(len(points), len(points))).tocsr()
    graph = ((graph + graph.T) > 0).tocsr()
    start = outer[cKDTree(points[outer]).query(here)[1]]
    is_outer = np.zeros(len(points), dtype=bool)
    is_outer[outer] = True
    through = there - here
    middle = np.einsum("ij,ij->i", 0.5 * (here + there), through)
    found = np.full(len(here), most)
    rows = np.arange(len(here))
    reached = [np.array([node]) for node in start]
    for layer in range(1, most):
        for row in rows[found == most]:
            near = graph.indices[_spans(graph.indptr, reached[row])]
            near = np.unique(near)
            beyond = is_outer[near] & (points[near] @ through[row] > middle[row])
            if beyond.any():
                found[row] = layer
            reached[row] = near
    return found


def _spans(pointers, rows):
    """Indices of the entries of some rows of a csr_matrix."""
    start, count = pointers[rows], pointers[rows + 1] - pointers[rows]
    return np.repeat(start - np.cumsum(count) + count, count) + np.arange(count.sum())


def _outer_sides(tetrahedra):
    sides = np.sort(tetrahedra[:, _SIDES].reshape(-1, 3), axis=1)
    unique, first, count = np.unique(sides, axis=0, return_index=True, return_counts=True)
    return unique[count == 1], first[count == 1]


_FROM_REGULAR = np.linalg.inv(np.array([[1.0, 0.5, 0.5], [0.0, np.sqrt(3.0) / 2.0, np.sqrt(3.0) / 6.0],
                                        [0.0, 0.0, np.sqrt(2.0 / 3.0)]]))
"""From the edges of the regular tetrahedron of length 1 to those of an element."""

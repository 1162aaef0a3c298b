# SPDX-License-Identifier: LGPL-2.1-or-later
"""Edges of triangles: which sides share one, and whether each is used equally often in both directions."""

import numpy as np
from scipy.spatial import cKDTree

_RADIX = 1 << 16


def edge_balance(triangles):
    """Count the uses of each undirected edge of triangles, ndarray of shape (n, 3), int64.

    Returns
    -------
    edges : ndarray of shape (e, 2), int64
        Lower vertex first.
    balance : ndarray of shape (e,), int64
        Uses from the lower to the higher vertex minus uses in the other direction.
    uses : ndarray of shape (e,), int64
    """
    return _balance(
        np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    )


def shared_sides(triangles):
    """Find pairs of sides of triangles, ndarray of shape (n, 3), int64, that share an edge.

    Returns `first` and `second` (ndarray of shape (e,), int64): Side ``3 t + k`` runs from corner k of triangle t to the
    next.
    """
    order, low, high = _by_edge(triangles)
    twice = np.flatnonzero((low[1:] == low[:-1]) & (high[1:] == high[:-1]))
    return order[twice], order[twice + 1]


def paired_sides(triangles):
    """The `shared_sides` if each side has exactly one counterpart, which runs the other way; otherwise None.

    Such a surface is closed, no triangle is repeated, and none has twice the same corner.
    """
    order, low, high = _by_edge(triangles)
    if len(order) % 2:
        return None
    one, other = order[::2], order[1::2]
    in_pairs = np.array_equal(low[::2], low[1::2]) and np.array_equal(high[::2], high[1::2])
    again = (low[2::2] == low[1:-1:2]) & (high[2::2] == high[1:-1:2])
    start = triangles.ravel()
    if not in_pairs or again.any() or (start[one] == start[other]).any():
        return None
    return one, other


def _by_edge(triangles):
    """Sides in the order of their edges, and the lower and the higher vertex of each."""
    start = triangles.ravel()
    end = triangles[:, [1, 2, 0]].ravel()
    low, high = np.minimum(start, end), np.maximum(start, end)
    count = int(high.max()) + 1
    if count <= _RADIX:
        # Numpy sorts 16-bit integers by counting them, in a fifth of the time.
        order = np.argsort(high.astype(np.uint16), kind="stable")
        order = order[np.argsort(low[order].astype(np.uint16), kind="stable")]
    else:
        order = np.argsort(low * count + high, kind="stable")
    return order, low[order], high[order]


def _balance(directed, weight=1):
    low, high = directed.min(axis=1), directed.max(axis=1)
    sign = np.where(low == high, 0, np.where(directed[:, 0] < directed[:, 1], weight, -weight))
    base = int(directed.max()) + 1 if len(directed) else 1
    keys, which = np.unique(low * base + high, return_inverse=True)
    which = which.ravel()
    balance = np.bincount(which, sign, minlength=len(keys)).astype(np.int64)
    uses = np.bincount(which, np.abs(sign), minlength=len(keys)).astype(np.int64)
    return np.stack(np.divmod(keys, base), axis=1), balance, uses


def closes_at_t_junctions(vertices, triangles, tolerance):
    """Whether the only open edges are long ones that several shorter ones cover.

    Meshes assembled from patches have such T-junctions. Each open edge is split at the open vertices that lie on
    it. If the pieces then cancel, the surface encloses a volume, up to cracks no wider than the tolerance.

    Parameters
    ----------
    vertices : ndarray of shape (v, 3), mm
    triangles : ndarray of shape (n, 3), int64
    tolerance : float, mm
        Distance from an edge within which a vertex counts as on it.
    """
    edges, balance, _ = edge_balance(triangles)
    open_edges = np.flatnonzero(balance)
    if not len(open_edges):
        return True
    edges, balance = edges[open_edges], balance[open_edges]
    edge, vertex = _vertices_on(vertices, edges, tolerance)
    start, end = vertices[edges[edge, 0]], vertices[edges[edge, 1]]
    along = np.einsum("ij,ij->i", vertices[vertex] - start, end - start)
    order = np.lexsort([along, edge])
    edge, vertex = edge[order], vertex[order]
    # Each edge has a vertex at its start and at its end, so the pieces lie between neighbouring vertices.
    within = edge[1:] == edge[:-1]
    pieces = np.stack([vertex[:-1][within], vertex[1:][within]], axis=1)
    return not _balance(pieces, balance[edge[1:][within]])[1].any()


def slit_area(vertices, triangles):
    """Area between the open edges of a mesh, mm2: float; infinity where they are not simple loops.

    A mesher that divides the two sides of one edge of a B-Rep differently, or leaves out the smallest triangles of a face,
    leaves slits.

    Parameters
    ----------
    vertices : ndarray of shape (v, 3), mm
    triangles : ndarray of shape (n, 3), int64
    """
    edges, balance, _ = edge_balance(triangles)
    is_open = balance != 0
    if (np.abs(balance[is_open]) != 1).any():
        return np.inf
    directed = np.where(balance[is_open, None] > 0, edges[is_open], edges[is_open][:, ::-1])
    follower = dict(directed.tolist())
    if len(follower) < len(directed) or set(follower) != set(follower.values()):
        return np.inf
    total = 0.0
    while follower:
        loop, vertex = [], next(iter(follower))
        while vertex in follower:
            loop.append(vertex)
            vertex = follower.pop(vertex)
        away = vertices[loop[1:]] - vertices[loop[0]]
        total += 0.5 * float(np.linalg.norm(np.cross(away[:-1], away[1:]), axis=1).sum())
    return total


def _vertices_on(vertices, edges, tolerance):
    """Pairs (edge, vertex) of open vertices on open edges, the ends included."""
    candidates = np.unique(edges)
    tree = cKDTree(vertices[candidates])
    start, end = vertices[edges[:, 0]], vertices[edges[:, 1]]
    length = np.linalg.norm(end - start, axis=1)
    near = tree.query_ball_point(0.5 * (start + end), 0.5 * length + tolerance)
    edge = np.repeat(np.arange(len(edges)), [len(indices) for indices in near])
    vertex = candidates[np.concatenate([np.asarray(indices, dtype=np.int64) for indices in near])]
    direction = (end - start) / np.maximum(length, np.finfo(float).tiny)[:, None]
    away = vertices[vertex] - start[edge]
    along = np.einsum("ij,ij->i", away, direction[edge])
    across = np.linalg.norm(away - along[:, None] * direction[edge], axis=1)
    inside = (across <= tolerance) & (along > tolerance) & (along < length[edge] - tolerance)
    is_end = (vertex == edges[edge, 0]) | (vertex == edges[edge, 1])
    is_on = inside | is_end
    return edge[is_on], vertex[is_on]

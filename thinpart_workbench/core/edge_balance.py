"""Edges of triangles: which sides share one, and whether all are used as often one way as the other."""

import numpy as np
from scipy.spatial import cKDTree


def edge_balance(triangles):
    """Use of each undirected edge.

    Parameters
    ----------
    triangles : ndarray of shape (n, 3), int64

    Returns
    -------
    edges : ndarray of shape (e, 2), int64
        Lower vertex first.
    balance : ndarray of shape (e,), int64
        Uses from the lower to the higher vertex minus uses the other way.
    uses : ndarray of shape (e,), int64
    """
    return _balance(
        np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    )


def shared_sides(triangles):
    """Sides of triangles that stand for one edge, in pairs.

    Parameters
    ----------
    triangles : ndarray of shape (n, 3), int64

    Returns
    -------
    first, second : ndarray of shape (e,), int64
        Side ``3 t + k`` runs from corner k of triangle t to the next.
    """
    edges = np.sort(triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
    key = edges[:, 0] * (int(triangles.max()) + 1) + edges[:, 1]
    order = np.argsort(key, kind="stable")
    twice = np.flatnonzero(key[order][1:] == key[order][:-1])
    return order[twice], order[twice + 1]


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
    """Whether what is open is only edges that meet several shorter ones along their length.

    Parameters
    ----------
    vertices : ndarray of shape (v, 3), mm
    triangles : ndarray of shape (n, 3), int64
    tolerance : float, mm
        How far a vertex may lie off an edge and still be on it.

    Notes
    -----
    Meshes put together from patches have such T-junctions. Each open edge is cut at the open
    vertices that lie on it; if the pieces then cancel, the surface encloses a volume, up to cracks
    no wider than the tolerance.
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
    # A vertex of each edge stands at its start and its end, so pieces lie between neighbours.
    within = edge[1:] == edge[:-1]
    pieces = np.stack([vertex[:-1][within], vertex[1:][within]], axis=1)
    return not _balance(pieces, balance[edge[1:][within]])[1].any()


def _vertices_on(vertices, edges, tolerance):
    """Pairs (edge, vertex) of open vertices on open edges, the ends included."""
    candidates = np.unique(edges)
    tree = cKDTree(vertices[candidates])
    start, end = vertices[edges[:, 0]], vertices[edges[:, 1]]
    length = np.linalg.norm(end - start, axis=1)
    near = tree.query_ball_point(0.5 * (start + end), 0.5 * length + tolerance)
    edge = np.repeat(np.arange(len(edges)), [len(each) for each in near])
    vertex = candidates[np.concatenate([np.asarray(each, dtype=np.int64) for each in near])]
    direction = (end - start) / np.maximum(length, np.finfo(float).tiny)[:, None]
    away = vertices[vertex] - start[edge]
    along = np.einsum("ij,ij->i", away, direction[edge])
    across = np.linalg.norm(away - along[:, None] * direction[edge], axis=1)
    inside = (across <= tolerance) & (along > tolerance) & (along < length[edge] - tolerance)
    is_end = (vertex == edges[edge, 0]) | (vertex == edges[edge, 1])
    kept = inside | is_end
    return edge[kept], vertex[kept]

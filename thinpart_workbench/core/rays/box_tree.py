# SPDX-License-Identifier: LGPL-2.1-or-later
"""A tree of axis-aligned boxes over triangles, with eight children per node, in flat arrays."""

from dataclasses import dataclass

import numpy as np

from ..columns import cross, dot
from .space_filling_curve import hilbert_order

WIDTH = 8
"""Children per node."""

_AT_ONCE = 16384

_PADDING = 4e-7
"""Boxes are float32, so they are enlarged by this share of the extent, lest rounding exclude a triangle."""

_COARSE_SLACK = 8e-6
"""Error, as a share of the extent, of the point where a ray hits a plane in float32, unless the ray grazes the plane."""


@dataclass(frozen=True)
class BoxTree:
    """Boxes over triangles sorted along a Hilbert curve.

    Attributes
    ----------
    order : ndarray of shape (n,), int64
        Index of the triangle at each position along the curve.
    levels : list of ndarray of shape (6 * 8, p), float32
        From the root down. Column q holds the lower and then the upper corners of the boxes of the children of
        node q: rows ``axis * 8 + child``, upper corners from row 24 on. Child c of node q is node ``8 q + c`` of the
        next level; below the last level, position ``8 q + c`` along the curve. The long axis is contiguous because
        that makes numpy several times faster.
    leaf_normals : ndarray of shape (3 * 8, p), float32
        Normals of the triangles of the last level, zero for missing ones.
    triangle_rows : ndarray of shape (12, n), float64
        Per position along the curve: unit normal n, n.a, then for each of two barycentric coordinates its gradient
        g and g.a, where a is the first corner: the coordinate of a point p of the plane is u = g.p - g.a.
    coarse_rows : ndarray of shape (13, n), float32
        The same with slack for rounding: u and v are raised by it, and the last row is the bound of their sum.
    extent : float, mm
        Diagonal of the axis-aligned box of all triangles.
    gap : float, mm
        A ray this near to a triangle hits it.
    """

    order: np.ndarray
    levels: list
    leaf_normals: np.ndarray
    triangle_rows: np.ndarray
    coarse_rows: np.ndarray
    extent: float
    gap: float


def box_tree(corners, normals, areas, gap=0.0):
    """Build the tree bottom-up: BoxTree.

    Parameters
    ----------
    corners : ndarray of shape (3, 3, n), mm, middle near zero
        Coordinate, corner, triangle.
    normals : ndarray of shape (3, n)
    areas : ndarray of shape (n,), mm2
    gap : float, mm
        See `BoxTree`; small against `extent`.
    """
    low, high = corners.min(axis=1), corners.max(axis=1)
    extent = float(np.linalg.norm(high.max(axis=1) - low.min(axis=1)))
    order = hilbert_order(low + high)
    grown = _PADDING * extent + gap
    low = np.take((low - grown).astype(np.float32), order, axis=1)
    high = np.take((high + grown).astype(np.float32), order, axis=1)
    levels = []
    while True:
        present = low.shape[1]
        low, high = _fill_up(low, np.inf), _fill_up(high, np.inf)
        nodes = low.shape[1] // WIDTH
        levels.append(np.concatenate([_children_of(low), _children_of(high)]))
        if nodes == 1:
            break
        high[:, present:] = -np.inf
        low = low.reshape(3, nodes, WIDTH).min(axis=2)
        high = high.reshape(3, nodes, WIDTH).max(axis=2)
    leaf_normals = _children_of(_fill_up(np.take(normals.astype(np.float32), order, axis=1), 0.0))
    rows = _triangle_rows(corners, normals, areas, order)
    coarse = _coarse_rows(rows, _COARSE_SLACK * extent + gap)
    return BoxTree(order, levels[::-1], leaf_normals, rows, coarse, extent, gap)


def children_of_nodes(values):
    """Arrange values, ndarray of shape (n,), in curve order like the last level: row is child, column is node.

    Returns an ndarray of shape (8, p), float32: zero where there is no child.
    """
    return _children_of(_fill_up(values[None].astype(np.float32), 0.0))


def _fill_up(columns, filler):
    """Pad to a multiple of eight columns. No ray hits a box at infinity."""
    missing = -columns.shape[1] % WIDTH
    if not missing:
        return columns
    return np.concatenate(
        [columns, np.full((columns.shape[0], missing), filler, dtype=np.float32)], axis=1
    )


def _children_of(columns):
    """Reshape (3, 8 p) in curve order to (3 * 8, p): row ``axis * 8 + child``."""
    nodes = columns.shape[1] // WIDTH
    grouped = columns.reshape(-1, nodes, WIDTH).transpose(0, 2, 1)
    return np.ascontiguousarray(grouped).reshape(-1, nodes)


def _coarse_rows(rows, slack):
    coarse = np.empty((13, rows.shape[1]), dtype=np.float32)
    coarse[:12] = rows
    slack_u, slack_v = (
        np.sqrt(sum(rows[row + axis] ** 2 for axis in range(3))) * slack for row in (4, 8)
    )
    coarse[7] = rows[7] - slack_u
    coarse[11] = rows[11] - slack_v
    coarse[12] = 1.0 + 2.0 * (slack_u + slack_v)
    return coarse


def _triangle_rows(corners, normals, areas, order):
    rows = np.empty((12, len(order)))
    for start in range(0, len(order), _AT_ONCE):
        part = order[start:start + _AT_ONCE]
        own = np.take(corners, part, axis=2)
        first, normal = np.ascontiguousarray(own[:, 0]), np.take(normals, part, axis=1)
        inverse = 0.5 / areas[part]
        gradient_u = cross(own[:, 2] - first, normal) * inverse
        gradient_v = cross(normal, own[:, 1] - first) * inverse
        columns = slice(start, start + len(part))
        for row, vector in zip((0, 4, 8), (normal, gradient_u, gradient_v)):
            rows[row:row + 3, columns] = vector
            rows[row + 3, columns] = dot(vector, first)
    return rows

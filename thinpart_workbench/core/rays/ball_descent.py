# SPDX-License-Identifier: LGPL-2.1-or-later
"""Descent of balls through a tree of boxes."""

import numpy as np

from .box_tree import WIDTH, children_of_nodes


def least_of_nodes(tree, values):
    """The least value below every child of every node: list of ndarray of shape (8, p), float32.

    By level, from the root down, as `BoxTree.levels`; 0 where a node of the last level lacks a child.

    Parameters
    ----------
    tree : BoxTree
    values : ndarray of shape (n,)
        By triangle.
    """
    least = children_of_nodes(values[tree.order])
    levels = [least]
    for level in tree.levels[-2::-1]:
        upper = np.zeros(WIDTH * level.shape[1], dtype=np.float32)
        upper[:least.shape[1]] = least.min(axis=0)
        least = np.ascontiguousarray(upper.reshape(-1, WIDTH).T)
        levels.append(least)
    return levels[::-1]


def boxes_met(tree, centres, radii, values, most):
    """Find pairs of a ball and a triangle whose box the ball meets.

    Returns `ball` and `leaf` (ndarray of shape (q,), int64): `leaf` is the position of the triangle along the curve;
    `BoxTree.order[leaf]` is its index.

    Parameters
    ----------
    tree : BoxTree
    centres : ndarray of shape (3, m), mm
        In the coordinates of the tree.
    radii : ndarray of shape (m,), mm
    values : list of ndarray
        See `least_of_nodes`.
    most : ndarray of shape (m,)
        Of each ball, triangles whose value is greater are left out.
    """
    rows = np.concatenate([centres, (radii * radii)[None], most[None]]).astype(np.float32)
    ball, node = np.arange(len(radii)), np.zeros(len(radii), dtype=np.int64)
    for boxes, value in zip(tree.levels, values):
        count = len(ball)
        low, high = np.take(boxes, node, axis=1, mode="clip").reshape(2, 3, WIDTH, count)
        own = np.take(rows, ball, axis=1, mode="clip")
        low -= own[0:3, None]
        np.subtract(own[0:3, None], high, out=high)
        away = np.maximum(low, high, out=low)
        np.maximum(away, np.float32(0.0), out=away)
        away *= away
        square = np.add(away[0], away[1], out=away[0])
        square += away[2]
        met = square < own[3]
        met &= np.take(value, node, axis=1, mode="clip") <= own[4]
        met = np.flatnonzero(met)
        child = met // count
        parent = met - child * count
        ball, node = ball[parent], node[parent] * WIDTH + child
    return ball, node

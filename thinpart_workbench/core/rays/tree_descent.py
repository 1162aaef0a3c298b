# SPDX-License-Identifier: LGPL-2.1-or-later
"""Descent of thick rays through a tree of boxes."""

from dataclasses import dataclass

import numpy as np

from .box_tree import WIDTH


@dataclass
class Work:
    """Counters of the work done: the same on every machine, so that work can be limited by them.

    Attributes
    ----------
    nodes, pairs, exact, overlaps : int
        Nodes of the tree whose eight boxes were tested; pairs of a packet and a triangle; pairs of a ray and a
        triangle that were decided in float64, or of two triangles that were cut; pairs of triangles that were looked at
        for an overlap.
    """

    nodes: int = 0
    pairs: int = 0
    exact: int = 0
    overlaps: int = 0


def descend(tree, thick, triangle_filter, work=None, node_filter=None):
    """Find pairs of a packet and a triangle whose box the thick ray hits within its limit.

    Returns `packet` and `leaf` (ndarray of shape (q,), int64): `leaf` is the position of the triangle along the curve;
    `BoxTree.order[leaf]` is its index.

    Parameters
    ----------
    tree : BoxTree
    thick : ThickRays
    triangle_filter : callable
        Takes the packet and the node of the last level for each of k pairs; returns ndarray of shape (8, k), bool:
        which triangles of the node to keep.
    work : Work, optional
        Counters to increase.
    node_filter : callable, optional
        The same for nodes of the levels above: takes the packet, the node and the depth, and says which of its children
        to descend to.
    """
    packets = thick.rows.shape[1]
    packet, node = np.arange(packets), np.zeros(packets, dtype=np.int64)
    visited = 0
    for depth, boxes in enumerate(tree.levels):
        count = len(packet)
        visited += count
        box = np.take(boxes, node, axis=1, mode="clip").reshape(2, 3, WIDTH, count)
        own = np.take(thick.rows, packet, axis=1, mode="clip")
        near, far = box
        near -= own[0:3, None]
        near *= own[6:9, None]
        far -= own[3:6, None]
        far *= own[6:9, None]
        enter = np.minimum(near, far)
        leave = np.maximum(near, far, out=far)
        first = np.maximum(enter[0], enter[1], out=enter[0])
        np.maximum(first, enter[2], out=first)
        np.maximum(first, np.float32(0.0), out=first)
        last = np.minimum(leave[0], leave[1], out=leave[0])
        np.minimum(last, leave[2], out=last)
        np.minimum(last, own[9], out=last)
        met = first <= last
        if depth == len(tree.levels) - 1:
            met &= triangle_filter(packet, node)
        elif node_filter is not None:
            met &= node_filter(packet, node, depth)
        met = np.flatnonzero(met)
        child = met // count
        parent = met - child * count
        packet, node = packet[parent], node[parent] * WIDTH + child
    if work is not None:
        work.nodes += visited
        work.pairs += len(packet)
    return packet, node


def cosines(tree, thick, packet, node):
    """Compute the cosines between the axis of each packet and the normals of the eight triangles of its node.

    Returns an ndarray of shape (8, k), float32.
    """
    normals = np.take(tree.leaf_normals, node, axis=1, mode="clip").reshape(3, WIDTH, len(node))
    normals *= np.take(thick.axis, packet, axis=1, mode="clip")[:, None]
    cosine = np.add(normals[0], normals[1], out=normals[0])
    cosine += normals[2]
    return cosine

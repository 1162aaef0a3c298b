"""The way of thick rays down a tree of boxes."""

from dataclasses import dataclass

import numpy as np

from .box_tree import WIDTH


@dataclass
class Work:
    """How much was tested; a test holds it against what it should be.

    Attributes
    ----------
    nodes, pairs, exact : int
        Nodes of the tree whose eight boxes were tested; pairs of a packet and a triangle; pairs of
        a ray and a triangle that were decided in float64.
    """

    nodes: int = 0
    pairs: int = 0
    exact: int = 0


def descend(tree, thick, is_wanted, work=None):
    """Pairs of a packet and a triangle whose box the thick ray meets within its limit.

    Parameters
    ----------
    tree : BoxTree
    thick : ThickRays
    is_wanted : callable
        Is given the packet and the node of the last level for each of k pairs; returns ndarray of
        shape (8, k), bool: which of the node's triangles to keep.
    work : Work, optional
        Is added to.

    Returns
    -------
    packet, place : ndarray of shape (q,), int64
        Place along the curve; `BoxTree.order` has the triangle.
    """
    packets = thick.rows.shape[1]
    roots = tree.levels[0].shape[1]
    packet = np.repeat(np.arange(packets), roots)
    node = np.tile(np.arange(roots), packets)
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
            met &= is_wanted(packet, node)
        met = np.flatnonzero(met)
        child = met // count
        parent = met - child * count
        packet, node = packet[parent], node[parent] * WIDTH + child
    if work is not None:
        work.nodes += visited
        work.pairs += len(packet)
    return packet, node


def cosines(tree, thick, packet, node):
    """Cosine between the axis of each packet and the normals of the node's eight triangles.

    Returns
    -------
    ndarray of shape (8, k), float32
    """
    normals = np.take(tree.leaf_normals, node, axis=1, mode="clip").reshape(3, WIDTH, len(node))
    normals *= np.take(thick.axis, packet, axis=1, mode="clip")[:, None]
    cosine = np.add(normals[0], normals[1], out=normals[0])
    cosine += normals[2]
    return cosine

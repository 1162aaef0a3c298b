"""First triangle met by many rays together, in numpy.

Rays come in packets: eight origins close together that share one direction, so that a packet is
one thick ray for the boxes. All packets descend the tree together, level by level.
"""

import numpy as np

from .box_tree import WIDTH
from .tolerances import TOLERANCES

PACKET = 8
"""Rays per packet."""

PACKETS_AT_ONCE = 512
"""Packets that descend together: their boxes and candidates stay in the processor's cache."""

_CANDIDATES_AT_ONCE = 4096
_GUESS_MARGIN = 1.05
_GUESS_GROWTH = 4.0


INNER, OUTER = 1.0, -1.0
"""Sides from which a triangle can be met: leaving the material, or entering it."""


def first_hits(tree, origins, directions, report=None, side=INNER):
    """Distance to, and index of, the first triangle that each ray meets from one side.

    Parameters
    ----------
    tree : BoxTree
    origins : ndarray of shape (8, p, 3), float64, mm
        Eight origins per packet; packets in an order that keeps neighbours together.
    directions : ndarray of shape (p, 3), float64
        Unit direction of each packet.
    report : callable, optional
        Called with the fraction done; may raise to stop.
    side : float
        `INNER` or `OUTER`.

    Returns
    -------
    distance : ndarray of shape (8, p), float64, mm
        inf where nothing is met.
    triangle : ndarray of shape (8, p), int64
        -1 where nothing is met.

    Notes
    -----
    A triangle is met from its inner side when the ray runs along its outward normal. Each eighth
    packet is solved first without a limit, its neighbours then start from the distance it found and
    widen only where they meet nothing: a hit inside the limit is final.
    """
    packets = origins.shape[1]
    distance = np.full((PACKET, packets), np.inf)
    triangle = np.full((PACKET, packets), -1, dtype=np.int64)
    done = 0
    stride = 1
    while packets // (stride * 8) > 8:
        stride *= 8
    limit = np.full(packets, tree.extent * 1.01)
    solved_stride = None
    while stride >= 1:
        wanted = np.arange(0, packets, stride)
        if solved_stride is not None:
            wanted = wanted[wanted % solved_stride != 0]
            neighbour = (wanted // solved_stride) * solved_stride
            farthest = distance[:, neighbour].max(axis=0)
            guess = np.where(np.isfinite(farthest), farthest * _GUESS_MARGIN, 0.1 * tree.extent)
            limit[wanted] = np.minimum(guess, limit[wanted])
        for start in range(0, len(wanted), PACKETS_AT_ONCE):
            chunk = wanted[start:start + PACKETS_AT_ONCE]
            _solve(tree, origins, directions, side, chunk, limit[chunk], distance, triangle)
            done += len(chunk)
            if report is not None:
                report(done / packets)
        solved_stride, stride = stride, stride // 8
    found = triangle >= 0
    triangle[found] = tree.order[triangle[found]]
    return distance, triangle


def _solve(tree, origins, directions, side, packets, limit, distance, triangle):
    """Fill in the results of some packets, widening the limit where a ray met nothing."""
    whole = tree.extent * 1.01
    while len(packets):
        found_distance, found_triangle = _descend(
            tree, np.ascontiguousarray(origins[:, packets].transpose(2, 0, 1)),
            np.ascontiguousarray(directions[packets].T), side, limit,
        )
        distance[:, packets], triangle[:, packets] = found_distance, found_triangle
        unmet = np.isinf(found_distance).any(axis=0) & (limit < whole)
        packets, limit = packets[unmet], np.minimum(limit[unmet] * _GUESS_GROWTH, whole)


def _descend(tree, origins, directions, side, limit):
    """Hits within `limit`. origins (3, 8, p), directions (3, p), limit (p,)."""
    rays, nodes = _candidates(tree, origins, directions, side, limit)
    count = origins.shape[2]
    best_distance = np.full((PACKET, count), np.inf)
    best_triangle = np.full((PACKET, count), -1, dtype=np.int64)
    keys, hits, triangles = [], [], []
    for start in range(0, len(rays), _CANDIDATES_AT_ONCE):
        part = slice(start, start + _CANDIDATES_AT_ONCE)
        key, hit, place = _intersect(
            tree, origins, directions, side, limit, rays[part], nodes[part]
        )
        keys.append(key)
        hits.append(hit)
        triangles.append(place)
    if keys:
        key, hit, place = np.concatenate(keys), np.concatenate(hits), np.concatenate(triangles)
        # Farthest first, so that the nearest is written last and stays.
        order = np.argsort(-hit, kind="stable")
        best_distance.ravel()[key[order]] = hit[order]
        best_triangle.ravel()[key[order]] = place[order]
    return best_distance, best_triangle


def _candidates(tree, origins, directions, side, limit):
    """Pairs (packet, place of the curve) whose boxes the thick ray meets within the limit."""
    low, high = origins.min(axis=1), origins.max(axis=1)
    # A box grown by the packet's spread is met by the middle ray when any ray meets the box.
    reach = np.float32(1e-6) * np.float32(tree.extent)
    direction = directions.astype(np.float32)
    tiny = np.float32(1e-12)
    inverse = np.float32(1.0) / np.where(np.abs(direction) < tiny, tiny, direction)
    thick = np.concatenate([
        high.astype(np.float32) + reach, low.astype(np.float32) - reach, inverse,
        (limit[None] * (1.0 + 1e-6)).astype(np.float32),
    ])
    facing = direction * np.float32(side)
    packets = origins.shape[2]
    roots = tree.levels[0].shape[1]
    ray = np.repeat(np.arange(packets), roots)
    node = np.tile(np.arange(roots), packets)
    for depth, boxes in enumerate(tree.levels):
        count = len(ray)
        box = np.take(boxes, node, axis=1, mode="clip").reshape(2, 3, WIDTH, count)
        own = np.take(thick, ray, axis=1, mode="clip")
        near, far = box
        near -= own[0:3, None]
        near *= own[6:9, None]
        far -= own[3:6, None]
        far *= own[6:9, None]
        enter = np.minimum(near, far)
        leave = np.maximum(near, far, out=far)
        first = np.maximum(np.maximum(enter[0], enter[1]), enter[2])
        last = np.minimum(np.minimum(leave[0], leave[1]), leave[2])
        met = np.maximum(first, 0.0, out=first) <= np.minimum(last, own[9], out=last)
        if depth == len(tree.levels) - 1:
            met &= _faces_along(tree, node, np.take(facing, ray, axis=1, mode="clip"))
        met = np.flatnonzero(met)
        child = met // count
        parent = met - child * count
        ray, node = ray[parent], node[parent] * WIDTH + child
    return ray, node


def _faces_along(tree, node, direction):
    """Whether each child triangle can be met from inside; generous, float64 decides later."""
    normals = np.take(tree.leaf_normals, node, axis=1, mode="clip").reshape(3, WIDTH, len(node))
    normals *= direction[:, None]
    return normals[0] + normals[1] + normals[2] > np.float32(-1e-6)


def _intersect(tree, origins, directions, side, limit, ray, place):
    """Exact hits of the eight rays of each candidate pair with its triangle."""
    count = len(ray)
    packets = origins.shape[2]
    rows = np.take(tree.triangle_rows, place, axis=1)
    origin = np.take(origins.reshape(3 * PACKET, packets), ray, axis=1).reshape(3, PACKET, count)
    direction = np.take(directions, ray, axis=1)
    facing = rows[0] * direction[0] + rows[1] * direction[1] + rows[2] * direction[2]
    facing *= side
    hit = rows[3] - (rows[0] * origin[0] + rows[1] * origin[1] + rows[2] * origin[2])
    hit /= np.maximum(facing, TOLERANCES.grazing) * side
    point = origin + direction[:, None] * hit
    u = rows[4] * point[0] + rows[5] * point[1] + rows[6] * point[2] - rows[7]
    v = rows[8] * point[0] + rows[9] * point[1] + rows[10] * point[2] - rows[11]
    slack = TOLERANCES.edge
    inside = (u >= -slack) & (v >= -slack) & (u + v <= 1.0 + slack)
    inside &= (facing > TOLERANCES.grazing) & (hit > TOLERANCES.self_hit * tree.extent)
    inside &= hit <= np.take(limit, ray)
    found = np.flatnonzero(inside)
    row = found // count
    column = found - row * count
    return row * packets + ray[column], hit.ravel()[found], place[column]

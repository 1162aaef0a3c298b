# SPDX-License-Identifier: LGPL-2.1-or-later
"""Find the first triangles that many rays hit, in numpy.

All packets of rays descend the tree together, level by level. The remaining triangles of each packet are tested in
float32 with some slack, and those that pass are decided in float64.
"""

from functools import partial

import numpy as np

from ..columns import dot
from ..tolerances import TOLERANCES
from .ray_packets import PACKET, coherent_order, thick_rays
from .tree_descent import Work, cosines, descend

PACKETS_AT_ONCE = 384
"""Packets that descend together: few enough for their boxes and candidates to fit into the processor's cache."""

_PAIRS_AT_ONCE = 65536
_STRIDE = 8
_GUESS_MARGIN = 1.2
_GUESS_GROWTH = 16.0

_GRAZING_FLOAT32 = np.float32(0.05)
"""Cosine under which float32 cannot locate the hit on a plane, so that float64 must decide."""

INNER, OUTER = 1.0, -1.0
"""Sides from which a triangle can be hit: by a ray that leaves the material, or one that enters it."""


def first_hits(tree, origins, directions, side=INNER, work=None):
    """Find the first triangle that each ray hits from one side, and its distance.

    Returns `distance` (ndarray of shape (m,), float64, mm; inf where nothing is hit) and `triangle` (ndarray of shape (m,),
    int64; -1 where nothing is hit).

    A ray hits a triangle from its inner side if it runs along the outward normal. Every eighth packet is solved
    first without a limit. Its neighbours then start with the distance that it found as their limit, which is only
    increased for rays that hit nothing: a hit within the limit is final.

    Parameters
    ----------
    tree : BoxTree
    origins : ndarray of shape (3, m), float64, mm
    directions : ndarray of shape (3, m), float64
        Unit vectors.
    side : float
        `INNER` or `OUTER`.
    work : Work, optional
        Counters to increase.
    """
    order = coherent_order(origins, directions) if origins.size else np.empty(0, dtype=np.int64)
    distance, triangle = np.empty(len(order)), np.empty(len(order), dtype=np.int64)
    distance[order], triangle[order] = first_hits_in_order(
        tree, np.take(origins, order, axis=1), np.take(directions, order, axis=1), side, work=work
    )
    return distance, triangle


def first_hits_in_order(tree, origins, directions, side=INNER, report=None, work=None):
    """Same as `first_hits` for rays that are already in coherent order (`ray_packets.coherent_order`)."""
    rays = _Rays(tree, origins, directions, side, report, work or Work())
    _solve_in_stages(rays)
    return rays.found()


def first_hits_within(tree, origins, directions, limit, side=INNER):
    """Same as `first_hits` for a few rays far from each other, each with its own limit.

    Returns `distance` and `triangle`: as of `first_hits`.

    Parameters
    ----------
    tree, origins, directions, side
        As for `first_hits`.
    limit : ndarray of shape (m,), mm
        inf for no limit.
    """
    rays = _Rays(tree, origins, directions, side, None, Work())
    if rays.count:
        _cast(rays, np.arange(rays.count), np.minimum(limit, tree.extent * 1.01), 1)
    return rays.found()


def first_hits_about(tree, origins, directions, expected, side=INNER):
    """Same as `first_hits` for a few rays far from each other of which it is known about how far their hits are.

    Returns `distance` and `triangle`: as of `first_hits`.

    Parameters
    ----------
    tree, origins, directions, side
        As for `first_hits`.
    expected : ndarray of shape (m,), mm
        More than 0; inf where it is not known. Rays that hit nothing up to there are cast farther.
    """
    rays = _Rays(tree, origins, directions, side, None, Work())
    full_length = tree.extent * 1.01
    _solve(rays, np.arange(rays.count), np.minimum(expected * _GUESS_MARGIN, full_length), full_length, 1)
    return rays.found()


class _Rays:
    """Rays in coherent order, and their hits so far."""

    def __init__(self, tree, origins, directions, side, report, work):
        self.tree, self.side, self.report, self.work = tree, side, report, work
        self.origins, self.directions = origins, directions
        self.count = origins.shape[1]
        self.coarse_origins, self.coarse_directions = origins.astype(np.float32), directions.astype(np.float32)
        self.distance = np.full(self.count, np.inf)
        self.leaf = np.full(self.count, -1, dtype=np.int64)
        self._settled = 0

    def found(self):
        """Distance of the hit and index of the triangle, for each ray."""
        return self.distance, np.where(self.leaf >= 0, self.tree.order[self.leaf], -1)

    def settle(self, ray, limit):
        """Report progress for the rays that hit something or have reached the end of the mesh."""
        done = (self.leaf[ray] >= 0) | (limit >= self.tree.extent)
        self._settled += np.count_nonzero(done)
        if self.report is not None:
            self.report(min(1.0, self._settled / self.count))


def _solve_in_stages(rays):
    full_length = rays.tree.extent * 1.01
    packets = -(-rays.count // PACKET)
    stride, solved = 1, None
    while packets // (stride * _STRIDE) > _STRIDE:
        stride *= _STRIDE
    while stride >= 1 and rays.count:
        chosen = np.arange(0, packets, stride)
        limit = np.full(len(chosen), full_length)
        if solved is not None:
            chosen = chosen[chosen % solved != 0]
            near = (chosen // solved) * solved * PACKET + np.arange(PACKET)[:, None]
            found = rays.distance[np.minimum(near, rays.count - 1)].max(axis=0)
            limit = np.where(np.isfinite(found), found * _GUESS_MARGIN, 0.1 * rays.tree.extent)
        ray = (chosen[:, None] * PACKET + np.arange(PACKET)).ravel()
        limit = np.repeat(np.minimum(limit, full_length), PACKET)
        present = ray < rays.count
        _solve(rays, ray[present], limit[present], full_length)
        solved, stride = stride, stride // _STRIDE


def _solve(rays, ray, limit, full_length, size=PACKET):
    """Find the first hits of some rays, increasing the limit of those that hit nothing; at first `size` in a packet."""
    while len(ray):
        _cast(rays, ray, limit, size)
        open_end = (rays.leaf[ray] < 0) & (limit < full_length)
        ray, limit = ray[open_end], np.minimum(limit[open_end] * _GUESS_GROWTH, full_length)
        size = 1  # the remaining rays are far apart: a packet of them would be wide


def _cast(rays, ray, limit, size):
    """Store the first hits within the limit, with `size` rays per packet."""
    packets = -(-len(ray) // size)
    at_once = PACKETS_AT_ONCE * (1 if size > 1 else 4)
    alone = []
    for start in range(0, packets, at_once):
        rows = np.arange(start, min(start + at_once, packets)) * size + np.arange(size)[:, None]
        rows = np.minimum(rows, len(ray) - 1)
        members = ray[rows]
        limits = limit[rows].max(axis=0).astype(np.float32) * np.float32(1.0 + 1e-6)
        shape = (3,) + members.shape
        origins = np.take(rays.coarse_origins, members.ravel(), axis=1, mode="clip").reshape(shape)
        directions = np.take(rays.coarse_directions, members.ravel(), axis=1, mode="clip").reshape(shape)
        thick = thick_rays(origins, directions, limits, rays.tree.extent)
        if size > 1 and thick.divergent.any():
            alone.append(rows[:, thick.divergent].T.ravel())
            coherent = np.flatnonzero(~thick.divergent)
            if not len(coherent):
                continue
            members, limits = members[:, coherent], limits[coherent]
            origins, directions = origins[:, :, coherent], directions[:, :, coherent]
            thick = thick_rays(origins, directions, limits, rays.tree.extent)
        packet, leaf = descend(rays.tree, thick, partial(_may_be_hit, rays, thick), rays.work)
        lane, leaf = _candidates(rays, origins, directions, limits, packet, leaf)
        _decide(rays, members.ravel()[lane], leaf, np.tile(limits, size)[lane])
        rays.settle(members, limits)
    if alone:
        left = np.unique(np.concatenate(alone))
        _cast(rays, ray[left], limit[left], 1)


def _may_be_hit(rays, thick, packet, node):
    """Whether each triangle may be hit from the side of the rays; true in case of doubt."""
    facing = cosines(rays.tree, thick, packet, node)
    facing *= np.float32(rays.side)
    return facing > -np.take(thick.spread, packet, mode="clip")


def _candidates(rays, origins, directions, limit, packet, leaf):
    """Pairs (lane, leaf) that float32 cannot exclude; a lane is ``row * packets + packet``."""
    size, packets = origins.shape[1:]
    origins, directions = origins.reshape(-1, packets), directions.reshape(-1, packets)
    coarse, side = rays.tree.coarse_rows, np.float32(rays.side)
    slack = np.float32(1e-5 * rays.tree.extent)
    lanes, leaves = [], []
    step = max(1, _PAIRS_AT_ONCE // size)
    for start in range(0, len(packet), step):
        part, target = packet[start:start + step], leaf[start:start + step]
        count = len(part)
        row = np.take(coarse, target, axis=1, mode="clip")
        origin = np.take(origins, part, axis=1, mode="clip").reshape(3, size, count)
        point = np.take(directions, part, axis=1, mode="clip").reshape(3, size, count)
        facing = dot(row[0:3], point)
        facing *= side
        hit = dot(row[0:3], origin)
        np.subtract(row[3], hit, out=hit)
        hit *= side
        grazing = facing < _GRAZING_FLOAT32
        hit /= np.maximum(facing, np.float32(1e-6))
        point *= hit
        point += origin
        u = dot(row[4:7], point)
        u -= row[7]
        v = dot(row[8:11], point)
        v -= row[11]
        met = u >= 0.0
        met &= v >= 0.0
        u += v
        met &= u <= row[12]
        met &= hit <= np.take(limit, part, mode="clip") + slack
        met &= hit > -slack
        met |= grazing
        met &= facing > np.float32(0.5 * TOLERANCES.grazing)
        met = np.flatnonzero(met)
        lane = met // count
        column = met - lane * count
        lanes.append(lane * packets + part[column])
        leaves.append(target[column])
    if not lanes:
        return np.empty(0, dtype=np.int64), np.empty(0, dtype=np.int64)
    return np.concatenate(lanes), np.concatenate(leaves)


def _decide(rays, ray, leaf, limit):
    """Test pairs of ray and triangle in float64 and keep the nearest hit of each ray."""
    rays.work.exact += len(ray)
    tree, side = rays.tree, rays.side
    row = np.take(tree.triangle_rows, leaf, axis=1, mode="clip")
    origin = np.take(rays.origins, ray, axis=1, mode="clip")
    direction = np.take(rays.directions, ray, axis=1, mode="clip")
    facing = dot(row[0:3], direction) * side
    hit = (row[3] - dot(row[0:3], origin)) * side / np.maximum(facing, TOLERANCES.grazing)
    point = origin + direction * hit
    u = dot(row[4:7], point) - row[7]
    v = dot(row[8:11], point) - row[11]
    met = (u >= -_slack(tree, row[4:7])) & (v >= -_slack(tree, row[8:11]))
    met &= u + v <= 1.0 + _slack(tree, row[4:7] + row[8:11])
    met &= (facing > TOLERANCES.grazing) & (hit > TOLERANCES.self_hit * tree.extent)
    met &= hit <= limit
    met = np.flatnonzero(met)
    # Farthest first, so that the nearest is written last and remains.
    met = met[np.argsort(-hit[met], kind="stable")]
    rays.distance[ray[met]] = hit[met]
    rays.leaf[ray[met]] = leaf[met]


def _slack(tree, gradient):
    """Distance beyond its edge, as a barycentric coordinate, at which a triangle is still hit."""
    if tree.gap == 0.0:
        return TOLERANCES.edge
    return TOLERANCES.edge + tree.gap * np.sqrt(dot(gradient, gradient))

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pairs of triangles that may enclose a wall of uneven thickness."""

from dataclasses import dataclass

import numpy as np

from ..columns import dot
from ..descriptors.descriptor_table import STATED_ANGLES
from ..rays.box_tree import WIDTH, children_of_nodes
from ..rays.ray_packets import PACKET, coherent_order, thick_rays
from ..rays.tree_descent import cosines, descend

_PACKETS_AT_ONCE = 96
_PAIRS_AT_ONCE = 8192

_ROUNDING = 1e-5
"""Error of float32 here, as a share of the extent, and in radians."""


def slanted_pairs(mesh, rays, limit, report=None, work=None):
    """Find pairs of triangles of which the second may be below the first, slanted, and within a limit.

    Parameters
    ----------
    mesh : SurfaceMesh
    rays : InwardRays
        Rays over that mesh.
    limit : float, mm
    report : callable, optional
        Called with the fraction done; may raise to stop.
    work : Work, optional
        Counters to increase.

    Yields
    ------
    first, second : ndarray of shape (k,), int64
        A superset: no pair is missing, some may not qualify. No pair is repeated.
    depth : ndarray of shape (k,), float32, mm
        Lower bound of the distance.
    """
    outlines = _outlines(mesh, rays)
    order = coherent_order(outlines.corners.mean(axis=1), outlines.normals)
    packets = -(-len(order) // PACKET)
    for start in range(0, packets, _PACKETS_AT_ONCE):
        rows = np.arange(start, min(start + _PACKETS_AT_ONCE, packets)) * PACKET
        members = order[np.minimum(rows + np.arange(PACKET)[:, None], len(order) - 1)]
        thick = _thick(rays.tree, outlines, members, limit)
        yield from _pairs_of(rays.tree, outlines, members, thick, ~thick.divergent, limit, work)
        if thick.divergent.any():
            members = np.unique(members[:, thick.divergent])[None]
            alone = _thick(rays.tree, outlines, members, limit)
            every = np.ones(members.size, dtype=bool)
            yield from _pairs_of(rays.tree, outlines, members, alone, every, limit, work)
        if report is not None:
            report((start + rows.size) / packets)


@dataclass(frozen=True)
class _Outlines:
    """The triangles in the order and the coordinates of the tree.

    Attributes
    ----------
    corners : ndarray of shape (3, 3, n), float32, mm
        Coordinate, corner, leaf.
    normals : ndarray of shape (3, n), float32
    bend : ndarray of shape (n,), float32
        See `SurfaceMesh.bend`.
    corner_normals : ndarray of shape (3, 3, n), float32
        Corner, coordinate, leaf; in the coordinates of the mesh.
    bend_of_children : ndarray of shape (8, p), float32
        `bend`, arranged like the last level of the tree.
    normals_of_children : list of tuple
        For each level above, from the root down: the middles of the normals below each child, ndarray of shape (3, 8, p),
        how far they reach from there, summed over the coordinates, and the greatest `bend`, each ndarray of shape (8, p).
    """

    corners: np.ndarray
    normals: np.ndarray
    bend: np.ndarray
    corner_normals: np.ndarray
    bend_of_children: np.ndarray
    normals_of_children: list


def _outlines(mesh, rays):
    order = rays.tree.order
    corners = rays.corners(order).astype(np.float32).transpose(2, 1, 0)
    bend = mesh.bend[order].astype(np.float32)
    corner_normals = np.take(mesh.corner_normals, order, axis=2).astype(np.float32)
    normals = np.take(rays.normals, order, axis=1).astype(np.float32)
    return _Outlines(np.ascontiguousarray(corners), normals, bend, corner_normals, children_of_nodes(bend),
                     _normals_of_children(normals, bend, len(rays.tree.levels)))


def _normals_of_children(normals, bend, levels):
    """`_Outlines.normals_of_children`."""
    low, high, most = normals, normals, bend[None]
    found = []
    for _ in range(levels - 1):
        low, high, most = (_by_node(rows, how) for rows, how in ((low, np.min), (high, np.max), (most, np.max)))
        found.append((np.stack([children_of_nodes(row) for row in 0.5 * (low + high)]),
                      children_of_nodes(0.5 * (high - low).sum(axis=0)), children_of_nodes(most[0])))
    return found[::-1]


def _by_node(columns, how):
    """Least or greatest of each eight columns, the last of which may be fewer."""
    missing = -columns.shape[1] % WIDTH
    columns = np.concatenate([columns, np.repeat(columns[:, -1:], missing, axis=1)], axis=1)
    return how(columns.reshape(len(columns), -1, WIDTH), axis=2)


def _thick(tree, outlines, members, limit):
    """Make thick rays from triangles: every ray from a triangle lies between the rays from its corners."""
    size, count = members.shape
    origins = outlines.corners[:, :, members].reshape(3, 3 * size, count)
    directions = np.tile(-outlines.normals[:, members], (1, 3, 1))
    limits = np.full(count, limit * (1.0 + 1e-6), dtype=np.float32)
    return thick_rays(origins, directions, limits, tree.extent)


def _pairs_of(tree, outlines, members, thick, chosen, limit, work):
    own_bend = outlines.bend[members].max(axis=0)

    def may_count(packet, node):
        bend = np.take(own_bend, packet) + np.take(outlines.bend_of_children, node, axis=1)
        return _may_be_slanted(cosines(tree, thick, packet, node), bend, np.take(thick.spread, packet)) \
            & np.take(chosen, packet)

    def may_hold(packet, node, depth):
        middle, spread, bend = (np.take(rows, node, axis=-1) for rows in outlines.normals_of_children[depth])
        facing = dot(middle, np.take(thick.axis, packet, axis=1)[:, None])
        return _may_be_slanted(facing, bend + np.take(own_bend, packet), spread + np.take(thick.spread, packet))

    packet, leaf = descend(tree, thick, may_count, work, may_hold)
    repeated = np.zeros(members.shape, dtype=bool)
    repeated[1:] = members[1:] == members[:-1]  # The last packet is padded by repetition.
    for start in range(0, len(packet), _PAIRS_AT_ONCE):
        part = slice(start, start + _PAIRS_AT_ONCE)
        yield _pairs_of_triangles(tree, outlines, members, repeated, packet[part], leaf[part], limit)


def _may_be_slanted(facing, bend, spread=0.0):
    """Whether triangles may be at `STATED_ANGLES` to each other.

    Parameters
    ----------
    facing : ndarray, float32
        Cosine of the angle between one normal and the reverse of the other.
    bend : ndarray, float32
        Greatest angle between the smooth normals and those of the triangles, radians, both together.
    spread : ndarray, float32
        Greatest distance of those normals from the ones that `facing` is of.
    """
    from_angle, to_angle = np.radians(STATED_ANGLES)
    most = np.cos(np.maximum(np.float32(from_angle) - bend, np.float32(0.0)))
    most = most + (spread + np.float32(_ROUNDING))
    # The cosine changes by no more than the angle.
    return (facing < most) & (facing > np.float32(np.cos(to_angle) - _ROUNDING) - bend - spread)


def _pairs_of_triangles(tree, outlines, members, repeated, packet, leaf, limit):
    """Expand pairs of a packet and a triangle into the pairs of triangles that may count."""
    size, count = members.shape
    normals = outlines.normals[:, members].reshape(3 * size, count)
    normals = np.take(normals, packet, axis=1, mode="clip").reshape(3, size, len(packet))
    normals *= np.take(outlines.normals, leaf, axis=1, mode="clip")[:, None]
    bend = np.take(outlines.bend[members], packet, axis=1) + np.take(outlines.bend, leaf)
    may_count = _may_be_slanted(-normals.sum(axis=0), bend)
    may_count &= ~np.take(repeated, packet, axis=1)
    row, column = np.nonzero(may_count)
    first, second = members[row, packet[column]], leaf[column]
    over, depth = _over(tree, outlines, first, second, limit)
    first, second = first[over], second[over]
    slanted = _reaches_slant(outlines, first, second)
    return tree.order[first[slanted]], tree.order[second[slanted]], depth[slanted]


def _reaches_slant(outlines, first, second):
    """Whether the smooth surfaces over two triangles may reach the least of `STATED_ANGLES` anywhere.

    Interpolated normals lie between those of the corners, and the directions within less than a right angle of
    another one are a convex set. Therefore the angle between two points of the surfaces is at most that between two
    of the corners. By the angle of the facets, walls of a tessellated fillet pass the test; by this one, hardly any.
    """
    here = np.take(outlines.corner_normals, first, axis=2, mode="clip")
    there = np.take(outlines.corner_normals, second, axis=2, mode="clip")
    least = np.ones(len(first), dtype=np.float32)
    for one in here:
        for other in there:
            np.minimum(least, -dot(one, other), out=least)
    return least < np.float32(np.cos(np.radians(STATED_ANGLES[0]) - _ROUNDING))


def _over(tree, outlines, first, second, limit):
    """Of pairs, those whose second triangle may reach into the prism below the first, with a lower bound of its depth there.

    Returns `which` (ndarray of shape (q,), int64) and `depth` (ndarray of shape (q,), float32, mm).
    """
    rows = np.take(tree.coarse_rows, first, axis=1, mode="clip")
    corners = np.take(outlines.corners.reshape(9, -1), second, axis=1, mode="clip").reshape(3, 3, -1)
    slack = np.float32(_ROUNDING * tree.extent + tree.gap)
    below = rows[3] - dot(rows[0:3, None], corners)
    depth = below.min(axis=0)
    over = (depth < np.float32(limit) + slack) & (below.max(axis=0) > -slack)
    u = dot(rows[4:7, None], corners) - rows[7]
    over &= u.max(axis=0) >= 0.0
    v = dot(rows[8:11, None], corners) - rows[11]
    over &= v.max(axis=0) >= 0.0
    over = np.flatnonzero(over & ((u + v).min(axis=0) <= rows[12]))
    return over, depth[over] - slack

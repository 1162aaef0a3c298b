"""Pairs of triangles that may enclose a wall of uneven thickness."""

from dataclasses import dataclass

import numpy as np

from .box_tree import children_of_nodes
from .columns import dot
from .descriptors import STATED_ANGLES
from .ray_packets import PACKET, coherent_order, thick_rays
from .tree_descent import cosines, descend

_PACKETS_AT_ONCE = 96
_PAIRS_AT_ONCE = 8192

_ROUNDING = 1e-5
"""Share of the extent, and radians, by which float32 may be wrong here."""


def slanted_pairs(mesh, rays, limit, report=None):
    """Pairs of triangles of which the second may lie under the first, within a limit, and slanted.

    Parameters
    ----------
    mesh : SurfaceMesh
    rays : InwardRays
        Over that mesh.
    limit : float, mm
    report : callable, optional
        Called with the fraction done; may raise to stop.

    Yields
    ------
    first, second : ndarray of shape (k,), int64
        Generous: no pair is missing, some need not be there. None comes twice.
    """
    outlines = _outlines(mesh, rays)
    order = coherent_order(outlines.corners.mean(axis=1), outlines.normals)
    packets = -(-len(order) // PACKET)
    for start in range(0, packets, _PACKETS_AT_ONCE):
        rows = np.arange(start, min(start + _PACKETS_AT_ONCE, packets)) * PACKET
        members = order[np.minimum(rows + np.arange(PACKET)[:, None], len(order) - 1)]
        thick = _thick(rays.tree, outlines, members, limit)
        yield from _pairs_of(rays.tree, outlines, members, thick, ~thick.divergent, limit)
        if thick.divergent.any():
            members = np.unique(members[:, thick.divergent])[None]
            alone = _thick(rays.tree, outlines, members, limit)
            every = np.ones(members.size, dtype=bool)
            yield from _pairs_of(rays.tree, outlines, members, alone, every, limit)
        if report is not None:
            report((start + rows.size) / packets)


@dataclass(frozen=True)
class _Outlines:
    """The triangles at each place of the tree's curve, and as it has them.

    Attributes
    ----------
    corners : ndarray of shape (3, 3, n), float32, mm
        Coordinate, corner, place.
    normals : ndarray of shape (3, n), float32
    bend : ndarray of shape (n,), float32
        See `SurfaceMesh.bend`.
    corner_normals : ndarray of shape (3, 3, n), float32
        Corner, coordinate, place; as the mesh has them.
    bend_of_children : ndarray of shape (8, p), float32
        The same as the last level of the tree has it.
    """

    corners: np.ndarray
    normals: np.ndarray
    bend: np.ndarray
    corner_normals: np.ndarray
    bend_of_children: np.ndarray


def _outlines(mesh, rays):
    order = rays.tree.order
    corners = rays.corners(order).astype(np.float32).transpose(2, 1, 0)
    bend = mesh.bend[order].astype(np.float32)
    corner_normals = np.take(mesh.corner_normals, order, axis=2).astype(np.float32)
    return _Outlines(np.ascontiguousarray(corners), np.take(rays.normals, order, axis=1).astype(np.float32),
                     bend, corner_normals, children_of_nodes(bend))


def _thick(tree, outlines, members, limit):
    """Thick rays from whole triangles: every ray from a triangle runs between those of its corners."""
    size, count = members.shape
    origins = outlines.corners[:, :, members].reshape(3, 3 * size, count)
    directions = np.tile(-outlines.normals[:, members], (1, 3, 1))
    limits = np.full(count, limit * (1.0 + 1e-6), dtype=np.float32)
    return thick_rays(origins, directions, limits, tree.extent)


def _pairs_of(tree, outlines, members, thick, chosen, limit):
    own_bend = outlines.bend[members].max(axis=0)

    def is_wanted(packet, node):
        allowance = np.take(thick.spread + own_bend, packet)
        allowance = allowance + np.take(outlines.bend_of_children, node, axis=1)
        return _may_be_slanted(cosines(tree, thick, packet, node), allowance) & np.take(chosen, packet)

    packet, place = descend(tree, thick, is_wanted)
    repeated = np.zeros(members.shape, dtype=bool)
    repeated[1:] = members[1:] == members[:-1]  # The last packet is filled up so.
    for start in range(0, len(packet), _PAIRS_AT_ONCE):
        part = slice(start, start + _PAIRS_AT_ONCE)
        yield _pairs_of_triangles(tree, outlines, members, repeated, packet[part], place[part], limit)


def _may_be_slanted(facing, allowance):
    """Whether triangles may stand at the angles asked for.

    Parameters
    ----------
    facing : ndarray, float32
        Cosine of the angle between one normal and the other one reversed.
    allowance : ndarray, float32
        By how much the normals of the surface may differ from these, radians.
    """
    from_angle, to_angle = np.radians(STATED_ANGLES)
    allowance = allowance + _ROUNDING
    return (facing > np.float32(np.cos(to_angle)) - allowance) \
        & (facing < np.float32(np.cos(from_angle)) + allowance)


def _pairs_of_triangles(tree, outlines, members, repeated, packet, place, limit):
    """Of pairs of a packet and a triangle, the pairs of triangles that may count."""
    size, count = members.shape
    normals = outlines.normals[:, members].reshape(3 * size, count)
    normals = np.take(normals, packet, axis=1, mode="clip").reshape(3, size, len(packet))
    normals *= np.take(outlines.normals, place, axis=1, mode="clip")[:, None]
    allowance = np.take(outlines.bend[members], packet, axis=1) + np.take(outlines.bend, place)
    wanted = _may_be_slanted(-normals.sum(axis=0), allowance)
    wanted &= ~np.take(repeated, packet, axis=1)
    row, column = np.nonzero(wanted)
    first, second = members[row, packet[column]], place[column]
    over = _is_over(tree, outlines, first, second, limit)
    first, second = first[over], second[over]
    slanted = _reaches_slant(outlines, first, second)
    return tree.order[first[slanted]], tree.order[second[slanted]]


def _reaches_slant(outlines, first, second):
    """Whether smooth surfaces over two triangles stand at the least angle asked for anywhere; generous.

    Interpolated normals lie between those of the corners, and directions within less than a right angle of
    another are a convex set: no place of one is farther turned from a place of the other than two corners
    are. Walls of a tessellated fillet pass by the facets' angle, and hardly one by this.
    """
    here = np.take(outlines.corner_normals, first, axis=2, mode="clip")
    there = np.take(outlines.corner_normals, second, axis=2, mode="clip")
    least = np.ones(len(first), dtype=np.float32)
    for one in here:
        for other in there:
            np.minimum(least, -dot(one, other), out=least)
    return least < np.float32(np.cos(np.radians(STATED_ANGLES[0]) - _ROUNDING))


def _is_over(tree, outlines, first, second, limit):
    """Whether the second triangle may reach into the prism under the first; generous."""
    rows = np.take(tree.coarse_rows, first, axis=1, mode="clip")
    corners = np.take(outlines.corners.reshape(9, -1), second, axis=1, mode="clip").reshape(3, 3, -1)
    slack = np.float32(_ROUNDING * tree.extent + tree.gap)
    depth = rows[3] - dot(rows[0:3, None], corners)
    over = (depth.min(axis=0) < np.float32(limit) + slack) & (depth.max(axis=0) > -slack)
    u = dot(rows[4:7, None], corners) - rows[7]
    over &= u.max(axis=0) >= 0.0
    v = dot(rows[8:11, None], corners) - rows[11]
    over &= v.max(axis=0) >= 0.0
    return over & ((u + v).min(axis=0) <= rows[12])

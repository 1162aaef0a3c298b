# SPDX-License-Identifier: LGPL-2.1-or-later
"""Correct the box of a part with round sides, since facets lie slightly inside of them."""

import numpy as np

from ..tolerances import TOLERANCES
from .bounds import OrientedBox
from .rims import Rims

_NEAR = 0.02
"""Depth below the outermost vertex, as a share of the diagonal, down to which facets are checked for a higher arc."""

_STEEPEST = np.radians(20.0)
"""Normals that lean sideways from an edge by more than this do not belong to the arc over it."""

_SAME_RISE = 0.01
"""Share of its rise by which the arc over a rim may seem higher by normals."""

_CYLINDRICAL = 1e-4
"""Facets whose three leans, as points of a plane, enclose less than half of this have no one point at the top."""


def box_of_round_sides(mesh, box):
    """Compute the box of the smooth surface that the facets approximate: OrientedBox.

    A box with the same directions that is no smaller.

    Where the normals of the smooth surface at the ends of a facet's side lean to either side of a direction of the
    box, the surface rises to an arc between them. Over a side of length l with normals that lean by a and b, the arc
    has the radius l / (sin a + sin b), where the normals are projected into the plane of that side and the direction. This
    is exact on cylinders and cones. Over the inside of a facet, the surface has its top where the interpolated normal points
    along the direction; from a corner at the distance l, with a normal that leans by a, it rises by l tan(a / 2). This is
    exact on a sphere. Curves between faces may rise to a side where no face is parallel to it (`Rims`).

    Parameters
    ----------
    mesh : SurfaceMesh
        A mesh with B-Rep faces.
    box : OrientedBox
        The box of its vertices.
    """
    directions = np.concatenate([box.axes, -box.axes])
    heights = directions @ mesh.vertex_columns
    outermost = heights.max(axis=1)
    near = [_touched(mesh, height > top - _NEAR * mesh.extent) for height, top in zip(heights, outermost)]
    rims = Rims(mesh, np.flatnonzero(np.any(near, axis=0)))
    bent = mesh.bend > TOLERANCES.angle
    tops = [_top(top, rims.top(direction), *_tops(mesh, np.flatnonzero(bent & chosen), direction))
            for direction, chosen, top in zip(directions, near, outermost)]
    grown = np.add(tops[:3], tops[3:])
    order = np.argsort(-grown, kind="stable")
    return OrientedBox(grown[order], box.axes[order])


def _touched(mesh, vertices):
    """Triangles, ndarray of shape (n,), bool, that have one of some vertices."""
    return np.logical_or.reduce([vertices[corner] for corner in mesh.triangles.T])


def _top(of_vertices, of_rims, of_arcs=-np.inf, of_domes=-np.inf):
    """The height of a side of the box. Where an arc is that of a rim, the rim is more precise than normals are."""
    same_arc = of_arcs < of_rims + _SAME_RISE * (of_rims - of_vertices)
    return max(of_vertices, of_rims, of_domes, -np.inf if same_arc else of_arcs)


def _tops(mesh, chosen, direction):
    """Heights, mm, along a direction of the highest arc over a side of some triangles and of the highest dome inside one."""
    corners = mesh.corners[chosen]
    normals = np.ascontiguousarray(mesh.corner_normals[:, :, chosen].transpose(2, 0, 1))
    facing = (normals @ direction > np.cos(_STEEPEST)).all(axis=1)
    corners, normals = corners[facing], normals[facing]
    if not len(corners):
        return ()
    return _top_of_arcs(mesh, corners, normals, direction), _top_of_domes(corners, normals, direction)


def _top_of_arcs(mesh, corners, normals, direction):
    highest = -np.inf
    for start in range(3):
        ends = [start, (start + 1) % 3]
        height = corners[:, ends] @ direction
        side = corners[:, ends[1]] - corners[:, ends[0]]
        side = side - np.outer(side @ direction, direction)
        length = np.sqrt(np.einsum("ij,ij->i", side, side))
        flat = np.flatnonzero(length > TOLERANCES.weld * mesh.extent)
        height, side, length = height[flat], side[flat] / length[flat, None], length[flat]
        normal = normals[flat][:, ends]
        lean = np.einsum("ikj,ij->ik", normal, side)
        aside = np.einsum("ikj,ij->ik", normal, np.cross(side, direction))
        arc = (lean[:, 0] < 0.0) & (lean[:, 1] > 0.0)
        arc &= np.abs(aside).max(axis=1) < np.sin(_STEEPEST)
        if arc.any():
            # In the plane of the side and the direction, the surface is a curve whose normals are these, projected.
            lean = lean[arc] / np.hypot(lean[arc], normal[arc] @ direction)
            height, length = height[arc], length[arc]
            radius = length / (lean[:, 1] - lean[:, 0])
            over = height + radius[:, None] * (1.0 - np.sqrt(1.0 - lean ** 2))
            highest = max(highest, float(over.min(axis=1).max()))
    return highest


def _top_of_domes(corners, normals, direction):
    up = normals @ direction
    lean = normals - up[..., None] * direction
    # Weights of the corners, so that their leans cancel.
    weights = np.einsum("ikj,j->ik", np.cross(np.roll(lean, -1, axis=1), np.roll(lean, -2, axis=1)), direction)
    total = weights.sum(axis=1)
    inside = np.flatnonzero((np.abs(total) > _CYLINDRICAL) & (weights * np.sign(total)[:, None] >= 0.0).all(axis=1))
    if not len(inside):
        return -np.inf
    weights, lean, up, corners = weights[inside] / total[inside, None], lean[inside], up[inside], corners[inside]
    away = corners - np.einsum("ik,ikj->ij", weights, corners)[:, None]
    rise = np.einsum("ikj,ikj->ik", away, lean) / (1.0 + up)
    return float(np.einsum("ik,ik->i", weights, corners @ direction + rise).max())

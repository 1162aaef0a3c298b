# SPDX-License-Identifier: LGPL-2.1-or-later
"""Samples at a stated depth beside sharp edges, where the thickness of what ends in an edge is told."""

import numpy as np

from ..mesh.sampling import smooth_samples

MOST_EDGES = 200
"""Edges of a mesh beside which samples are put: those with the smallest angles, where the wall is thinnest, and as many of
other pairs of faces."""

_MOST_STEPS = 64
"""Triangles that a way across the surface may cross."""


def depth_samples(mesh, edges, depth):
    """Make samples at a depth beside sharp edges, on both sides: SurfaceSamples that represent no area.

    The way goes from the middle of an edge of the mesh at a right angle to it, straight on across the facets.

    Parameters
    ----------
    mesh : SurfaceMesh
    edges : SharpEdges
    depth : float, mm
    """
    chosen = _edges_of_smallest_angles(mesh, edges)
    if not len(chosen):
        return smooth_samples(mesh, np.zeros((0, 3)), np.zeros(0, dtype=np.int64), np.zeros(0))
    partner = np.full(3 * mesh.count, -1)
    first, second = mesh.shared_sides
    partner[first], partner[second] = second, first
    found = [place for side in np.concatenate([edges.first[chosen], edges.second[chosen]])
             for place in [_at_depth(mesh, partner, int(side), depth)] if place is not None]
    points = np.array([point for point, _ in found]).reshape(-1, 3)
    triangle = np.array([triangle for _, triangle in found], dtype=np.int64)
    return smooth_samples(mesh, points, triangle, np.zeros(len(found)))


def _edges_of_smallest_angles(mesh, edges):
    """Numbers of the edges beside which samples are put: ndarray."""
    order = np.argsort(edges.angle, kind="stable")
    faces = edges.faces(mesh)
    _, first_of_pair = np.unique(faces[:, order], axis=1, return_index=True)
    return np.union1d(order[:MOST_EDGES], order[np.sort(first_of_pair)[:MOST_EDGES]])


def _at_depth(mesh, partner, side, depth):
    """The point at a depth from the middle of a side, and its triangle; None where the surface ends before."""
    triangle, here = divmod(side, 3)
    corners = mesh.corners[triangle]
    point = 0.5 * (corners[here] + corners[(here + 1) % 3])
    way, left = _inward(corners, here), depth
    for _ in range(_MOST_STEPS):
        exit_side, length = _exit(mesh.corners[triangle], mesh.normals[triangle], here, point, way)
        if left <= length:
            return point + left * way, triangle
        beyond = partner[3 * triangle + exit_side]
        if beyond < 0:
            return None
        point, left = point + length * way, left - length
        corners = mesh.corners[triangle]
        along = corners[(exit_side + 1) % 3] - corners[exit_side]
        along = along / np.linalg.norm(along)
        triangle, here = divmod(int(beyond), 3)
        straight = float(way @ along)
        way = straight * along + np.sqrt(max(0.0, 1.0 - straight * straight)) * _inward(mesh.corners[triangle], here)
    return None


def _exit(corners, normal, here, point, way):
    """The side by which a way leaves a triangle that it entered by another, and how far that is."""
    best, least = (here + 1) % 3, np.inf
    for side in ((here + 1) % 3, (here + 2) % 3):
        outward = np.cross(corners[(side + 1) % 3] - corners[side], normal)
        towards = float(way @ outward)
        if towards > 0.0:
            length = max(0.0, float((corners[side] - point) @ outward) / towards)
            if length < least:
                best, least = side, length
    return best, (least if np.isfinite(least) else 0.0)


def _inward(corners, side):
    """Unit vector in the plane of a triangle, at a right angle to a side, into the triangle."""
    start, end, apex = corners[side], corners[(side + 1) % 3], corners[(side + 2) % 3]
    along = (end - start) / np.linalg.norm(end - start)
    across = (apex - start) - ((apex - start) @ along) * along
    return across / max(float(np.linalg.norm(across)), np.finfo(float).tiny)

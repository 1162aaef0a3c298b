# SPDX-License-Identifier: LGPL-2.1-or-later
"""The first colours of a part: a thickness map from few rays, which is there long before the fine one."""

import numpy as np
from scipy.spatial import cKDTree

from ..analysis_settings import LOCAL, RAY, SPHERE
from ..mesh.sampling import even_samples, smooth_samples
from ..rays.inward_rays import InwardRays
from ..thickness.inscribed_balls import inscribed_balls
from .facet_refinement import LONGEST, cut_sides, side_lengths
from .seen_walls import JUMP, seen_walls
from .thickness_map import ThicknessMap

FACETS = 6_000
"""The surface is cut about as finely as this many equal facets would be."""

MOST_FACETS = 30_000
"""Nothing more is cut from this number on."""

RAYS = 10_000
"""Walls that are measured; what lies between them is taken from the nearest one on the same face."""

BALLS = 1_500
"""The same for balls, each of which takes as long as several rays."""


def first_map(mesh, by=RAY):
    """Estimate the thickness of a part within a fraction of a second.

    Returns a ThicknessMap or None: None for the local thickness, and for balls in a mesh that is not coarse, which would
    take as long as the fine map of others. To be looked at until `thickness_map` is there, and for nothing else: where the
    thickness jumps it has no lines, and narrow places may go unseen.

    Parameters
    ----------
    mesh : SurfaceMesh
        A coarse one.
    by : str
        One of `SHOWN_MEASURES`.
    """
    if by == LOCAL or by == SPHERE and mesh.count > MOST_FACETS:
        return None
    points, facets, parent = _facets(mesh)
    middles, face = points[facets].mean(axis=1), mesh.face_of_triangle[parent]
    chosen = _chosen(points, facets, face, BALLS if by == SPHERE else RAYS)
    thickness = np.full(len(facets), np.nan)
    thickness[chosen] = _measured(mesh, middles[chosen], parent[chosen], by)
    _fill_gaps(thickness, chosen, middles, face, mesh.extent)
    return ThicknessMap(points.astype(np.float32), facets.astype(np.int32), thickness.astype(np.float32),
                        np.full(len(facets), -1, dtype=np.int32), face.astype(np.int32), mesh.origin, by,
                        _at_corners(facets, face, thickness, len(points)).astype(np.float32))


def _facets(mesh):
    """Facets to be shown: points, facets, and the triangle of the mesh that each lies on."""
    points, facets, parent = mesh.vertices, mesh.triangles, np.arange(mesh.count)
    size = LONGEST * np.sqrt(4.0 / np.sqrt(3.0) * mesh.areas.sum() / FACETS)
    while True:
        lengths = side_lengths(points, facets)
        room = MOST_FACETS - len(facets)
        longest = np.sort(lengths[lengths > size])[::-1][:max(room, 0)]
        if not len(longest):
            return points, facets, parent
        long = lengths >= longest[-1]
        points, facets, pieces = cut_sides(points, facets, long)
        parent = parent[pieces]


def _chosen(points, facets, face, count):
    """Facets whose walls are measured: all, or a share by area and one of every face."""
    if len(facets) <= count:
        return np.arange(len(facets))
    corners = points[facets]
    areas = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
    order = np.argsort(face, kind="stable")
    _, first = np.unique(face[order], return_index=True)
    return np.union1d(order[even_samples(areas[order], count)], order[first])


def _measured(mesh, points, triangle, by):
    rays = InwardRays(mesh)
    if by == SPHERE:
        samples = smooth_samples(mesh, points, triangle, np.zeros(len(points)))
        thickness = inscribed_balls(mesh, samples, rays)
    else:
        thickness, _ = seen_walls(mesh, rays, points, triangle)
    return np.where(np.isfinite(thickness), thickness, np.nan)


def _fill_gaps(thickness, chosen, middles, face, extent):
    """Give facets that were not measured the thickness of the nearest one on their face."""
    others = np.setdiff1d(np.arange(len(thickness)), chosen, assume_unique=True)
    if len(others):
        # Faces lie so far apart along the fourth axis that the nearest is never on another one.
        places = np.column_stack([middles, 2.0 * extent * face])
        thickness[others] = thickness[chosen[cKDTree(places[chosen]).query(places[others])[1]]]


def _at_corners(facets, face, thickness, points):
    """Thickness at the corners of facets, shape (m, 3): the mean around a corner, except where it jumps there."""
    key = (face.astype(np.int64)[:, None] * points + facets).ravel()
    _, corner = np.unique(key, return_inverse=True)
    corner = corner.ravel()
    own = np.repeat(thickness, 3)
    known = np.isfinite(own)
    count = np.bincount(corner[known], minlength=corner.max() + 1)
    mean = np.bincount(corner[known], own[known], minlength=len(count)) / np.maximum(count, 1)
    low, high = np.full(len(count), np.inf), np.zeros(len(count))
    np.minimum.at(low, corner[known], own[known])
    np.maximum.at(high, corner[known], own[known])
    is_smooth = known & (high <= JUMP * low)[corner]
    return np.where(is_smooth, mean[corner], own).reshape(-1, 3)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where a surface lies apart from another one, as it is drawn: pieces of facets, cut where the distance is the tolerance."""

from typing import NamedTuple

import numpy as np

from ..mesh.smooth_normals import normals_at
from .facet_refinement import cut_sides, side_lengths, small_facets, too_many
from .level_cuts import cut_at_levels
from .thickness_map import ThicknessMap

ROUNDS = 3
"""How many times facets are halved on which the two surfaces part."""


class SurfaceDifference(NamedTuple):
    """A surface in pieces that lie on another one, or apart from it.

    Attributes
    ----------
    corners : ndarray of shape (k, 3, 3), float32, mm
        In the coordinates of the mesh.
    normals : ndarray of shape (k, 3, 3), float32
        Outward unit normals of the smooth surface at the corners.
    is_apart : ndarray of shape (k,), bool
    lines : ndarray of shape (l, 2, 3), float32, mm
        The edges of the surface.
    line_is_apart : ndarray of shape (l,), bool
    greatest : float, mm
        Distance of the farthest corner or middle of a facet.
    """

    corners: np.ndarray
    normals: np.ndarray
    is_apart: np.ndarray
    lines: np.ndarray
    line_is_apart: np.ndarray
    greatest: float

    def only_apart(self):
        """The pieces and edges that lie apart, as a SurfaceDifference of the same `greatest`."""
        apart, lines = self.is_apart, self.line_is_apart
        return SurfaceDifference(self.corners[apart], self.normals[apart], apart[apart], self.lines[lines], lines[lines],
                                 self.greatest)

    @property
    def share(self):
        """float: share of the surface that lies apart."""
        sides = self.corners[:, 1:] - self.corners[:, :1]
        areas = np.linalg.norm(np.cross(sides[:, 0], sides[:, 1]).astype(np.float64), axis=1)
        return float(areas[self.is_apart].sum() / areas.sum())


def surface_difference(mesh, distances, tolerance):
    """Find where a surface lies farther from another one than a tolerance: `SurfaceDifference`.

    Facets on which the two part are halved, so that the line between what is the same and what is not is sharp; a difference
    that is smaller than a facet is found where it covers the middle of one.

    Parameters
    ----------
    mesh : SurfaceMesh
    distances : callable
        From ndarray of shape (n, 3), mm, in the coordinates of the mesh, to the distances of these points from the other
        surface: ndarray of shape (n,), mm.
    tolerance : float, mm
    """
    points, facets, parent, size, most = small_facets(mesh)
    at_points, at_middles = distances(points), distances(points[facets].mean(axis=1))
    for step in range(ROUNDS):
        is_apart = at_points[facets] > tolerance
        parts = (is_apart.any(axis=1) & ~is_apart.all(axis=1)) | (at_middles > tolerance) & ~is_apart.any(axis=1)
        cut = parts[:, None] & (side_lengths(points, facets) > 0.5 * size / 2 ** step)
        if not cut.any() or too_many(facets, cut, most):
            break
        points, facets, pieces = cut_sides(points, facets, cut)
        parent, is_new = parent[pieces], np.bincount(pieces)[pieces] > 1
        at_points = np.concatenate([at_points, distances(points[len(at_points):])])
        at_middles = at_middles[pieces]
        at_middles[is_new] = distances(points[facets[is_new]].mean(axis=1))
    greatest = float(max(at_points.max(), at_middles.max()))
    return _in_pieces(mesh, points, facets, parent, at_points, tolerance, greatest)


def _in_pieces(mesh, points, facets, parent, at_points, tolerance, greatest):
    at_corners = at_points[facets]
    shown = ThicknessMap(points.astype(np.float32), facets.astype(np.int32), at_corners.mean(axis=1),
                         np.full(len(facets), -1), mesh.face_of_triangle[parent], mesh.origin, corner_thickness=at_corners)
    cuts = cut_at_levels(shown, (tolerance,))
    whole = np.setdiff1d(np.arange(len(facets)), cuts.facet)
    corners = np.concatenate([shown.corners[whole], cuts.at_corners(shown.corners)])
    triangle = np.repeat(np.concatenate([parent[whole], parent[cuts.facet]]), 3)
    normals = normals_at(mesh, triangle, corners.reshape(-1, 3)).reshape(-1, 3, 3)
    is_apart = np.concatenate([at_corners[whole].mean(axis=1), cuts.thickness.mean(axis=1)]) > tolerance
    return SurfaceDifference(corners.astype(np.float32), normals.astype(np.float32), is_apart,
                             shown.points[shown.outline], (at_points[shown.outline] > tolerance).any(axis=1),
                             greatest)

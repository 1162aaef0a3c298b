# SPDX-License-Identifier: LGPL-2.1-or-later
"""The largest ball inside the material that touches the surface at each sample."""

from functools import cached_property

import numpy as np

from ..columns import dot
from ..mesh.sampling import even_samples, surface_samples
from ..mesh.smooth_normals import CREASE, normals_at
from ..progress import portion, report_progress
from ..rays.ball_descent import boxes_met, least_of_nodes
from ..rays.closest_points import closest_weights
from ..rays.inward_rays import InwardRays
from ..rays.ray_casting import INNER

CLOUD = 3000
"""Points of the surface, each for the same area, from which balls are guessed before triangles bound them exactly."""

DENSE = 8.0
"""A ball whose radius is this many distances between points of the cloud is bounded well by the cloud where the surface is
curved like the ball: there it would nearly touch thousands of triangles."""

NEAR = 1.0
"""A ball whose radius is known to be less than this many of these distances has few triangles near it: the cloud says
nothing that they do not say as fast."""

AS_CURVED = 0.5
"""From this curvature on, in radii of the ball, the surface is curved like the ball."""

KEPT = 1.0 - 1e-6
"""A ball is known to be empty when it is smaller by this share than what was found."""

LEAST_RISE = np.sin(0.5 * CREASE)
"""Sine of the angle over the tangent plane from which on a point of the surface bounds the ball. Two facets under less than
`CREASE` are one smooth surface, and near the edge between them each sees the other under half of that."""

_STEPS = 40
_LIFTS = 4
_MOST_DEPTH = 0.1
_SAME = 1e-12
_CLOUD_AT_ONCE = 128
_BALLS_AT_ONCE = 2048


def inscribed_balls(mesh, samples, rays=None, report=None):
    """Find the largest balls inside the material that touch the surface at samples: ndarray of shape (m,), mm.

    Their diameters; inf where nothing bounds the ball.

    A ball that touches the surface at p, with the inward normal m, and passes through q has the radius
    ``|q - p|^2 / (2 m.(q - p))``. The largest empty one is the least of those over all q. Ma, Bae and Choi (2012,
    doi:10.1007/s00371-011-0594-7) shrink the ball to the point of a cloud that is nearest to its centre until there is none
    inside, which is the method of Dinkelbach (1967, doi:10.1287/mnsc.13.7.492) for the least ratio. Here the ray along the
    normal and a small cloud give a first ball, and then that method is applied to every triangle that reaches into it, so
    that the ball is exact against triangles. Both points are taken from the curved surface that the facets approximate
    (`core.mesh.curved_surface`), with its normals: otherwise each facet of a cylinder would be an edge, to which balls
    shrink.

    Parameters
    ----------
    mesh : SurfaceMesh
    samples : SurfaceSamples
    rays : InwardRays, optional
        Rays over the mesh; built if not given.
    report : callable, optional
        Called with the fraction done; may raise to stop.
    """
    balls = LargestBalls(mesh, samples, rays or InwardRays(mesh))
    report_progress(report, 0.0)
    balls.bound_by_rays()
    report_progress(report, 0.2)
    balls.find(np.arange(samples.count), portion(report, 0.2, 1.0))
    return 2.0 * balls.radius


class LargestBalls:
    """The largest balls at samples, of which those that are asked for are found.

    All is in the coordinates of the tree of rays, whose scale is that of the mesh.

    Parameters
    ----------
    mesh : SurfaceMesh
    samples : SurfaceSamples
    rays : InwardRays
        Rays over the mesh.

    Attributes
    ----------
    points, inward : ndarray of shape (3, m)
        Of the samples, on the curved surface, and inward normals.
    radius : ndarray of shape (m,), mm
        Upper bounds of the radii, which those that were found have reached.
    """

    def __init__(self, mesh, samples, rays):
        self._mesh, self._rays, self._samples = mesh, rays, samples
        self._surface = mesh.curved_surface
        self._facets = rays.normals
        normals = normals_at(mesh, samples.triangle, samples.points)
        self.points = self._lifted(samples.triangle, samples.points)
        self.inward = -rays.turned_directions(normals)
        self.radius = np.full(samples.count, np.inf)

    def find(self, balls, report=None):
        """Find some of the balls: their radii are final then.

        Parameters
        ----------
        balls : ndarray of shape (k,), int64
        report : callable, optional
            Called with the fraction done; may raise to stop.
        """
        self._bound_by_cloud(balls[self.radius[balls] > NEAR * self._cloud[2]])
        report_progress(report, 0.3)
        for start in range(0, len(balls), _BALLS_AT_ONCE):
            self._bound_by_tree(balls[start:start + _BALLS_AT_ONCE])
            report_progress(report, 0.3 + 0.7 * start / len(balls))
        report_progress(report, 1.0)

    @property
    def centres(self):
        """ndarray of shape (m, 3), mm."""
        return (self.points + self.radius * self.inward).T

    def bound_by_rays(self):
        """Bound balls by what lies opposite along the normals of the facets."""
        distance, opposite = self._rays.first_hits(self._samples, INNER)
        met = np.flatnonzero(opposite >= 0)
        there = self._samples.points[met] - distance[met, None] * self._samples.normals_on(self._mesh)[met]
        self._bound_by_points(met, opposite[met], self._lifted(opposite[met], there))

    def bound_by_walls(self, distance, opposite):
        """Bound balls by walls that are known.

        Parameters
        ----------
        distance : ndarray of shape (m,), mm
            Along the normals.
        opposite : ndarray of shape (m,), int64
            Triangles there, -1 for none.
        """
        met = np.flatnonzero(opposite >= 0)
        # The triangle decides; its surface may lie farther away than where a ray meets it, by its depth.
        self.radius[met] = 0.5 * distance[met] + self._surface.depth
        self._bound(met, opposite[met])

    def _lifted(self, triangle, points):
        """Points of the curved surface over points of facets, ndarray of shape (m, 3), as columns."""
        heights = self._surface.heights(triangle, points.T)
        return self._rays.turned(points) + np.take(self._facets, triangle, axis=1) * heights

    def _bound_by_points(self, ball, triangle, points):
        """Bound balls by a point each, and then by the triangle that it lies on."""
        away = points - np.take(self.points, ball, axis=1)
        np.minimum.at(self.radius, ball, _radius(away, np.take(self.inward, ball, axis=1)))
        self._bound(ball, triangle)

    @cached_property
    def _cloud(self):
        """Points of the surface, as columns, the triangles that they lie on, and their mean distance, mm."""
        surface = surface_samples(self._mesh)
        chosen = np.unique(even_samples(surface.area, CLOUD))
        triangle = surface.triangle[chosen]
        return self._lifted(triangle, surface.points[chosen]), triangle, float(np.sqrt(surface.area.sum() / CLOUD))

    @cached_property
    def _curvature(self):
        return least_of_nodes(self._rays.tree, self._surface.least_curvature)

    def _bound_by_cloud(self, balls):
        """Bound balls by the points of a cloud that bound them most."""
        exact, triangle, _ = self._cloud
        cloud = exact.astype(np.float32)
        points, inward = self.points[:, balls].astype(np.float32), self.inward[:, balls].astype(np.float32)
        squares = dot(cloud, cloud)
        best = np.empty(points.shape[1], dtype=np.int64)
        for start in range(0, len(best), _CLOUD_AT_ONCE):
            part = slice(start, start + _CLOUD_AT_ONCE)
            point, direction = points[:, part], inward[:, part]
            square = np.float32(-2.0) * point.T @ cloud
            square += squares
            square += dot(point, point)[:, None]
            depth = direction.T @ cloud
            depth -= dot(direction, point)[:, None]
            flat = depth < np.float32(LEAST_RISE) * np.sqrt(np.maximum(square, np.float32(0.0)))
            np.maximum(square, np.float32(np.finfo(np.float32).tiny), out=square)
            depth /= square
            depth[flat] = 0.0
            best[part] = depth.argmax(axis=1)
        self._bound_by_points(balls, triangle[best], exact[:, best])

    def _bound_by_tree(self, balls):
        """Bound balls by all triangles that reach into them."""
        curvature, spacing = self._curvature, self._cloud[2]
        radius = np.minimum(self.radius[balls], self._rays.tree.extent)
        shrunk = KEPT * radius
        centres = np.take(self.points, balls, axis=1) + shrunk * np.take(self.inward, balls, axis=1)
        shrunk += np.minimum(self._surface.depth, _MOST_DEPTH * radius)  # hollow sides reach farther in than facets
        most = np.where(radius > DENSE * spacing, AS_CURVED / radius, np.inf)
        ball, leaf = boxes_met(self._rays.tree, centres, shrunk, curvature, most)
        row = np.take(self._rays.tree.triangle_rows[:4], leaf, axis=1, mode="clip")
        height = dot(row[:3], np.take(centres, ball, axis=1, mode="clip")) - row[3]
        near = np.flatnonzero(np.abs(height) < shrunk[ball])
        ball = balls[ball[near]]
        self._bound(ball, self._rays.tree.order[leaf[near]])

    def _bound(self, ball, triangle):
        """Shrink balls to triangles: pairs, ndarrays of shape (k,), int64, of which a ball may have many."""
        other = np.flatnonzero(triangle != self._samples.triangle[ball])
        ball, triangle = ball[other], triangle[other]
        extent = self._rays.tree.extent
        radius, is_found = np.minimum(self.radius, extent), np.zeros(len(self.radius), dtype=bool)
        corners = np.ascontiguousarray(self._rays.corners(triangle).transpose(2, 1, 0))
        facet, lift = np.take(self._facets, triangle, axis=1), np.zeros(len(ball))
        point, inward = np.take(self.points, ball, axis=1), np.take(self.inward, ball, axis=1)
        for step in range(_STEPS):
            own = radius[ball]
            # Instead of the facet, the ball is moved by the height that the surface had in the step before.
            weights = closest_weights(point + own * inward - lift * facet, corners)
            height = self._surface.heights_at(triangle, weights)
            there = corners[:, 0] * weights[0] + corners[:, 1] * weights[1] + corners[:, 2] * weights[2] + height * facet
            through = _radius(there - point, inward)
            smaller = through < own * (1.0 - _SAME)
            np.minimum.at(radius, ball[smaller], through[smaller])
            is_found[ball[smaller]] = True
            # A triangle outside a ball is outside every smaller one that touches the surface at the same point.
            active = np.flatnonzero(smaller | (np.abs(height - lift) > _SAME * extent) & (step < _LIFTS))
            if not len(active):
                break
            ball, triangle, lift = ball[active], triangle[active], height[active]
            point, inward, facet, corners = point[:, active], inward[:, active], facet[:, active], corners[:, :, active]
        self.radius[is_found] = radius[is_found]


def _radius(away, inward):
    """Radius of the balls that touch the surface at a point and pass another.

    Returns an ndarray of shape (k,), mm: inf where the other point is not far enough above the tangent plane; see
    `LEAST_RISE`.

    Parameters
    ----------
    away : ndarray of shape (3, k), mm
        From the one to the other.
    inward : ndarray of shape (3, k)
    """
    square, depth = dot(away, away), dot(away, inward)
    above = (depth > 0.0) & (depth >= LEAST_RISE * np.sqrt(square))
    return np.where(above, square, np.inf) / np.where(above, 2.0 * depth, 1.0)

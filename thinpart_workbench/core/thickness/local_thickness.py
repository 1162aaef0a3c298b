"""The local thickness at every sample: the diameter of the largest ball inside that reaches it."""

import numpy as np
from scipy.spatial import cKDTree

from ..descriptors.precision import BALLS
from ..mesh.sampling import SurfaceSamples, even_samples
from ..progress import report_progress
from .inscribed_balls import LargestBalls

REACH = 1.5
"""Radii around its centre that a ball reaches: the surface that meets it at an edge of 90 degrees is at most 1.41 away."""

SPACING = 0.5
"""The share of the distance between neighbouring balls that is added: with it, the thickness does not depend on how many
balls there are."""

SAME = 0.9
"""A ball is not looked for where it could raise no thickness by more than from this share of it."""

_AT_ONCE = 64, 4096
"""Balls that are looked for before the next are looked over again: at first, and at most."""

MANY = 60.0
"""Balls that reach as much of the surface as so many places are compared with all samples: a tree is slower then."""

_DENSE = 64

_GOLDEN = 0.6180339887498949


def local_thickness(mesh, field, rays, most, at=None, report=None):
    """Find the local thickness at the samples of a field that represent area, or at other points: ndarray of shape (m,), mm.

    Hildebrand and Rüegsegger (1997, doi:10.1046/j.1365-2818.1997.1340694.x) define it in a volume, as the diameter of the
    largest inscribed ball that contains a point. A ball that touches a wall does not contain the edges of the wall, so on
    the surface it reaches points up to `REACH` radii from its centre. Edges of 90 degrees are then as thick as the walls
    that meet there, while ribs, teeth and run-outs have a thickness of their own.

    Balls are taken in the order of their size, and each marks the samples that it reaches and no larger one has. One whose
    upper bound reaches only marked samples is never found exactly. Where walls are thinner than balls are far apart, a
    sample has the wall that its ray meets, and one that sees none across, as on a rim, that of the nearest which does.

    Parameters
    ----------
    mesh : SurfaceMesh
    field : ThicknessField
        Of the mesh; what its samples see bounds their balls.
    rays : InwardRays
        Rays over the mesh.
    most : float, mm
        Greatest diameter of a ball, the shortest side of the box.
    at : SurfaceSamples, optional
        Others of the mesh.
    report : callable, optional
        Called with the fraction done; may raise to stop.
    """
    counted = np.flatnonzero(field.area > 0.0)
    centres = counted[np.unique(even_samples(field.area[counted], BALLS))]
    samples = field.samples
    balls = LargestBalls(mesh, SurfaceSamples(samples.points[centres], samples.triangle[centres], samples.area[centres]),
                         rays)
    balls.bound_by_walls(field.distance[centres], field.opposite[centres])
    np.minimum(balls.radius, 0.5 * most, out=balls.radius)
    added = SPACING * float(np.sqrt(field.area.sum() / len(centres)))
    if at is None:
        at = SurfaceSamples(samples.points[counted], samples.triangle[counted], samples.area[counted])
    radii = _Marks(balls, rays.turned(at.points).T, added).radii(report)
    close = np.flatnonzero(radii < added)
    if len(close):
        _raise_to_walls(radii, close, mesh, at, rays, added)
    return 2.0 * radii


def _raise_to_walls(radii, close, mesh, at, rays, spacing):
    """Raise the radii of samples between the balls of thin walls to those of the walls that their rays meet.

    Parameters
    ----------
    radii : ndarray of shape (m,), mm
    close : ndarray of shape (k,), int64
        Samples whose balls are smaller than what is added to their reach.
    mesh, at, rays
        Of `local_thickness`.
    spacing : float, mm
        Half of the distance between balls.
    """
    own = LargestBalls(mesh, SurfaceSamples(at.points[close], at.triangle[close], at.area[close]), rays)
    own.bound_by_rays()
    across = own.radius <= 2.0 * spacing
    radii[close[across]] = np.maximum(radii[close[across]], own.radius[across])
    along, walls = close[~across], np.setdiff1d(np.arange(len(radii)), close[~across], assume_unique=True)
    if len(along) and len(walls):
        _, nearest = cKDTree(at.points[walls]).query(at.points[along])
        radii[along] = np.maximum(radii[along], radii[walls[nearest]])


class _Marks:
    """Balls, and the samples that they reach.

    Parameters
    ----------
    balls : LargestBalls
    points : ndarray of shape (m, 3), mm
        Of the samples.
    added : float, mm
        To the reach of every ball.
    """

    def __init__(self, balls, points, added):
        self._balls, self._points, self._added = balls, points, added
        self._radii = np.zeros(len(points))
        self._squares, self._tree = (points ** 2).sum(axis=1), cKDTree(points)
        # Spread over the surface in any part of the order, so that few of them reach most of it.
        self._order = np.argsort(np.arange(len(balls.radius)) * _GOLDEN % 1.0)
        self._waits = np.ones(len(balls.radius), bool)
        self._is_found = np.zeros(len(balls.radius), bool)

    def radii(self, report):
        """Radius of the largest ball that reaches each sample: ndarray of shape (m,), mm; 0 where none does."""
        bound = self._balls.radius
        largest = float(bound.max(initial=0.0))
        while self._waits.any():
            most = float(bound[self._waits].max())
            self._mark_from(SAME * most)
            report_progress(report, 1.0 - most / largest)
        return self._radii

    def _mark_from(self, level):
        """Find the balls of a level and above, and mark what they reach."""
        bound = self._balls.radius
        balls = self._order[self._waits[self._order] & (bound[self._order] >= level)]
        count, most = _AT_ONCE
        tree, left = self._tree, len(self._points)
        while len(balls):
            unmarked = np.flatnonzero(self._radii < level)
            if not len(unmarked):
                self._waits[balls] = False
                return
            if len(unmarked) < 0.8 * left:
                left, tree = len(unmarked), cKDTree(self._points[unmarked])
            centres, reach = self._balls.centres(balls), REACH * bound[balls] + self._added
            is_wanted = tree.query(centres)[0] <= reach
            self._waits[balls[~is_wanted]] = False
            balls = balls[is_wanted]
            chosen, balls = balls[:count], balls[count:]
            count = min(2 * count, most)
            new = chosen[~self._is_found[chosen]]
            self._balls.find(new)
            self._is_found[new] = True
            ready = chosen[bound[chosen] >= level]
            self._waits[ready] = False
            self._mark(ready)

    def _mark(self, balls):
        radius, centres = self._balls.radius[balls], self._balls.centres(balls)
        reach = REACH * radius + self._added
        large = np.pi * reach ** 2 > MANY * (self._added / SPACING) ** 2
        for part in np.array_split(np.flatnonzero(large), max(1, np.count_nonzero(large) // _DENSE)):
            square = self._squares[:, None] - 2.0 * self._points @ centres[part].T + (centres[part] ** 2).sum(axis=1)
            own = np.where(square <= reach[part] ** 2, radius[part], 0.0).max(axis=1, initial=0.0)
            np.maximum(self._radii, own, out=self._radii)
        small = np.flatnonzero(~large)
        reached = self._tree.query_ball_point(centres[small], reach[small], return_sorted=False)
        for own, samples in zip(radius[small], reached):
            self._radii[samples] = np.maximum(self._radii[samples], own)

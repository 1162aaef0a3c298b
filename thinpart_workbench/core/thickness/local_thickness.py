# SPDX-License-Identifier: LGPL-2.1-or-later
"""The local thickness at every sample: the diameter of the largest ball inside that reaches it."""

from itertools import chain

import numpy as np
from scipy.spatial import cKDTree

from ..descriptors.precision import BALLS
from ..mesh.sampling import even_samples
from .inscribed_balls import LargestBalls

REACH = 1.5
"""Radii around its centre that a ball reaches: the surface that meets it at an edge of 90 degrees is at most 1.41 away."""

SPACING = 0.5
"""The share of the distance between neighbouring balls that is added: with it, the thickness does not depend on how many
balls there are."""

EMPTY = 0.8
"""Radii from its centre within which a ball across a wall has no point of the surface. One that a ray along a sheet bounds,
from its rim to the next hole, has both sides of the sheet in it."""

MANY = 60.0
"""Balls that reach as much of the surface as so many places are compared with all samples: a tree is slower then."""

_AT_ONCE = 16, 128
"""Large balls that are compared at once: at first, and at most."""


def local_thickness(mesh, field, rays, most, at=None, report=None):
    """Find the local thickness at the samples of a field that represent area, or at other points: ndarray of shape (m,), mm.

    Hildebrand and Rüegsegger (1997, doi:10.1046/j.1365-2818.1997.1340694.x) define it in a volume, as the diameter of the
    largest inscribed ball that contains a point. A ball that touches a wall does not contain the edges of the wall, so on
    the surface it reaches points up to `REACH` radii from its centre. Edges of 90 degrees are then as thick as the walls
    that meet there, while ribs, teeth and run-outs have a thickness of their own.

    The largest ball that reaches a sample decides. Where walls are thinner than balls are far apart, a sample has the wall
    that its ray meets, and one that sees none across, as on a rim, that of the nearest which does.

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
    chosen = counted[np.unique(even_samples(field.area[counted], BALLS))]
    balls = LargestBalls(mesh, field.samples.chosen(chosen), rays)
    balls.bound_by_walls(field.distance[chosen], field.opposite[chosen])
    np.minimum(balls.radius, 0.5 * most, out=balls.radius)
    balls.find(np.arange(len(chosen)), report)
    spacing = float(np.sqrt(field.area.sum() / len(chosen)))
    added = SPACING * spacing
    asked = field.samples.chosen(counted) if at is None else at
    radii = _largest_reaching(rays.turned(asked.points).T, balls.centres, balls.radius, REACH * balls.radius + added,
                              MANY * spacing ** 2)
    close = np.flatnonzero(radii < added)
    if len(close):
        walls = LargestBalls(mesh, asked.chosen(close), rays)
        if at is None:
            walls.bound_by_walls(field.distance[counted[close]], field.opposite[counted[close]])
        else:
            walls.bound_by_rays()
        surface = cKDTree(rays.turned(field.samples.points[counted]).T)
        _raise_to_walls(radii, close, walls.radius, _are_empty(walls, surface, 2.0 * added), asked.points, added)
    return 2.0 * radii


def _are_empty(balls, surface, most):
    """Whether no point of the surface lies inside of balls, of those with radii up to `most`, mm: ndarray of bool."""
    asked = np.flatnonzero(balls.radius <= most)
    empty = np.zeros(len(balls.radius), dtype=bool)
    centres = balls.points[:, asked] + balls.radius[asked] * balls.inward[:, asked]  # others may be infinite
    empty[asked] = surface.query(centres.T)[0] > EMPTY * balls.radius[asked]
    return empty


def _raise_to_walls(radii, close, walls, empty, points, spacing):
    """Raise the radii of samples between the balls of thin walls to those of the walls that their rays meet.

    Parameters
    ----------
    radii : ndarray of shape (m,), mm
    close : ndarray of shape (k,), int64
        Samples whose balls are smaller than what is added to their reach.
    walls : ndarray of shape (k,), mm
        Half of what is opposite those.
    empty : ndarray of shape (k,), bool
        Whether a ball of that radius is in the material.
    points : ndarray of shape (m, 3), mm
        Of all samples.
    spacing : float, mm
        Half of the distance between balls.
    """
    across = empty & (walls <= 2.0 * spacing)
    radii[close[across]] = np.maximum(radii[close[across]], walls[across])
    along, known = close[~across], np.setdiff1d(np.arange(len(radii)), close[~across], assume_unique=True)
    if len(along) and len(known):
        _, nearest = cKDTree(points[known]).query(points[along])
        radii[along] = np.maximum(radii[along], radii[known[nearest]])


def _largest_reaching(points, centres, radii, reach, many):
    """Radius of the largest ball that reaches each point: ndarray of shape (m,), mm; 0 where none does.

    Parameters
    ----------
    points : ndarray of shape (m, 3), mm
    centres : ndarray of shape (k, 3), mm
    radii, reach : ndarray of shape (k,), mm
    many : float, mm2
        A ball that reaches more of the surface is large.
    """
    found, left = np.zeros(len(points)), np.arange(len(points))
    order = np.argsort(-radii, kind="stable")
    is_large = np.pi * reach[order] ** 2 > many
    large, small = order[is_large], order[~is_large][::-1]
    squares, (count, most) = (points ** 2).sum(axis=1), _AT_ONCE
    while len(large) and len(left):
        part, large = large[:count], large[count:]
        count = min(2 * count, most)
        beyond = points[left] @ (-2.0 * centres[part].T)
        beyond += squares[left, None] + ((centres[part] ** 2).sum(axis=1) - reach[part] ** 2)
        is_reached = beyond <= 0.0
        largest = is_reached.argmax(axis=1)
        reached = is_reached[np.arange(len(left)), largest]
        found[left[reached]] = radii[part[largest[reached]]]
        left = left[~reached]
    if len(small) and len(left):
        # The order of nodes decides nothing here, and balancing takes longer than it saves.
        tree = cKDTree(points[left], balanced_tree=False, compact_nodes=False)
        lists = tree.query_ball_point(centres[small], reach[small], return_sorted=False)
        counts = np.fromiter(map(len, lists), np.int64, len(lists))
        reached = np.fromiter(chain.from_iterable(lists), np.int64, counts.sum())
        found[left[reached]] = np.repeat(radii[small], counts)  # from the smallest on, so that the largest stays
    return found

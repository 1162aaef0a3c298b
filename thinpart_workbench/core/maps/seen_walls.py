# SPDX-License-Identifier: LGPL-2.1-or-later
"""What places of the surface see through the material, and whether two of them see the same wall."""

import numpy as np

from ..mesh.sampling import smooth_samples
from ..tolerances import TOLERANCES
from ..walls.walls import NONPARALLEL_BELOW, walls_under

STEP = 1.03
"""Ratio of thicknesses from which two walls are different where they end on different faces."""

JUMP = 1.5
"""The same where they end on one face: that may stand in its own way, or rise steeply."""


ASIDE = 1e-3
"""Share of the extent by which a ray that met nothing is cast again beside: it may have slipped through an edge."""


def seen_walls(mesh, rays, points, triangle, report=None):
    """Measure the walls under places of the surface, as a map shows them.

    Returns `thickness` (ndarray of shape (n,), mm; inf where there is no wall, or one at more than 60 degrees) and
    `opposite` (ndarray of shape (n,), int64; triangle of the far side, -1 for none).

    Parameters
    ----------
    mesh : SurfaceMesh
    rays : InwardRays
    points : ndarray of shape (n, 3), mm
    triangle : ndarray of shape (n,), int64
        That each lies on.
    report : callable, optional
        Called with the fraction done; may raise to stop.
    """
    if not len(points):
        return np.empty(0), np.empty(0, dtype=np.int64)
    thickness, opposite = _walls(mesh, rays, points, triangle, report)
    lost = np.flatnonzero(opposite < 0)
    if len(lost):
        away = mesh.corners[triangle[lost]].mean(axis=1) - points[lost]
        far = np.linalg.norm(away, axis=1)
        step = np.minimum(1.0, ASIDE * mesh.extent / np.maximum(far, np.finfo(float).tiny))
        thickness[lost], opposite[lost] = _walls(mesh, rays, points[lost] + step[:, None] * away, triangle[lost])
    return thickness, opposite


def _walls(mesh, rays, points, triangle, report=None):
    walls, _ = walls_under(mesh, rays, smooth_samples(mesh, points, triangle, np.zeros(len(points))), report)
    is_wall = walls.wedge_angle < NONPARALLEL_BELOW - TOLERANCES.angle
    return np.where(is_wall, walls.distance, np.inf), np.where(is_wall, walls.opposite, -1)


def differ(mesh, first, second):
    """Whether places see different walls: ndarray of shape (n,), bool.

    Parameters
    ----------
    mesh : SurfaceMesh
    first, second : tuple of ndarray
        Thickness and opposite triangle, each of shape (n,).
    """
    low, high = np.minimum(first[0], second[0]), np.maximum(first[0], second[0])
    same_face = mesh.face_of_triangle[first[1]] == mesh.face_of_triangle[second[1]]
    with np.errstate(invalid="ignore"):
        apart = high > np.where(same_face, JUMP, STEP) * low
    return apart & np.isfinite(low)

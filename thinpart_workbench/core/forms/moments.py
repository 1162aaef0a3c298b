# SPDX-License-Identifier: LGPL-2.1-or-later
"""Moments of a surface, about its centroid."""

from typing import NamedTuple

import numpy as np

_RULE = (((1 / 3, 1 / 3, 1 / 3), -27 / 48),
         *((tuple(0.6 if corner == k else 0.2 for corner in range(3)), 25 / 48) for k in range(3)))
"""Points of a triangle and their weights, exact for polynomials up to the third degree (Strang and Fix 1973, An Analysis of
the Finite Element Method)."""


class SurfaceMoments(NamedTuple):
    """Moments of the area of a surface.

    They are those of the surface and not of the volume, so that an open one has them as well.

    Attributes
    ----------
    area : float, mm2
    centroid : ndarray of shape (3,), mm
    second : ndarray of shape (3, 3), mm2
        Mean of the products of two coordinates, from the centroid.
    third : ndarray of shape (3, 3, 3), mm3
        Mean of the products of three: not zero only where the surface is no mirror image of itself through a point.
    """

    area: float
    centroid: np.ndarray
    second: np.ndarray
    third: np.ndarray


def surface_moments(mesh):
    """The `SurfaceMoments` of the triangles of a `SurfaceMesh`, in the coordinates of its document."""
    area, corners = float(mesh.areas.sum()), mesh.corners
    share = mesh.areas / area
    centroid = share @ corners.mean(axis=1)
    corners = corners - centroid
    second, third = np.zeros((3, 3)), np.zeros((9, 3))
    for barycentric, weight in _RULE:
        point = np.einsum("c,ncj->nj", barycentric, corners)
        weighted = (weight * share)[:, None] * point
        second += point.T @ weighted
        third += (point[:, :, None] * point[:, None, :]).reshape(-1, 9).T @ weighted
    return SurfaceMoments(area, centroid + mesh.origin, second, third.reshape(3, 3, 3))

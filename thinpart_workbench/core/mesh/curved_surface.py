# SPDX-License-Identifier: LGPL-2.1-or-later
"""The curved surface that facets approximate: how far it lies above them, and how strongly it is curved."""

from functools import cached_property

import numpy as np

from ..columns import corners_of, dot
from .smooth_normals import barycentric


class CurvedSurface:
    """A mesh whose facets bulge so far that the surface has the smooth normals at their corners.

    Between two corners, the surface rises above the chord by a parabola: the chord times the turn of the normal along it, by
    eight, in the middle (Vlachos, Peters, Boyd and Mitchell 2001, doi:10.1145/364338.364387, keep the quadratic terms of
    the same patch). Facets of planes do not bulge; those of a hollow side sink.
    """

    def __init__(self, mesh):
        self._mesh = mesh
        self._bent = np.flatnonzero(mesh.is_bent)
        corners, normals = corners_of(mesh.vertex_columns, mesh.triangles), mesh.corner_normals
        self._rise, curvature = np.empty((3, mesh.count)), np.empty((3, mesh.count))
        for first in range(3):
            second = (first + 1) % 3
            side = corners[:, second] - corners[:, first]
            turn = dot(side, normals[second] - normals[first])
            self._rise[first] = 0.5 * turn
            curvature[first] = turn / dot(side, side)
        self._least_curvature = curvature.min(axis=0)

    @property
    def depth(self):
        """float, mm: how far the surface lies below a facet at most."""
        # A third of each barycentric coordinate gives the sum of the three sides by nine, the middle of a side a quarter.
        return float(max(0.0, -self._rise.min() / 4.0, -self._rise.sum(axis=0).min() / 9.0))

    @property
    def least_curvature(self):
        """ndarray of shape (n,), 1/mm: of each facet, along the side that is curved least; negative on a hollow side."""
        return self._least_curvature

    @cached_property
    def volume_gain(self):
        """float, mm3: the volume between the facets and the surface, negative where more of it sinks than bulges."""
        rise = self._rise[:, self._bent].sum(axis=0)
        # The mean of the product of two barycentric coordinates over a triangle is a twelfth.
        return float(self._mesh.areas[self._bent] @ rise) / 12.0

    def heights(self, triangle, points):
        """How far the surface lies above points of facets, ndarray of shape (m,), mm; less than 0 where it lies below.

        Parameters
        ----------
        triangle : ndarray of shape (m,), int64
        points : ndarray of shape (3, m), mm
            On those triangles, in the coordinates of the mesh.
        """
        corners = corners_of(self._mesh.vertex_columns, self._mesh.triangles[triangle])
        return self.heights_at(triangle, barycentric(corners, points))

    def heights_at(self, triangle, weights):
        """The same, of barycentric coordinates: three ndarrays of shape (m,)."""
        rise = np.take(self._rise, triangle, axis=1)
        return (weights[0] * weights[1] * rise[0] + weights[1] * weights[2] * rise[1]
                + weights[2] * weights[0] * rise[2])

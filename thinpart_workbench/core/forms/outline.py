# SPDX-License-Identifier: LGPL-2.1-or-later
"""Points of a surface with its normals, few enough to be kept with a part, and enough on each of its faces."""

from typing import NamedTuple

import numpy as np

POINTS = 512
"""Number of points of a surface with few faces."""

MOST_ON_SMALL = 4
"""Number of points on a face that has less than its share of `POINTS`, so that no small hole goes unseen."""

MOST_POINTS = 4096
"""Greatest number of points: small faces have fewer where there would be more, and the smallest ones none."""


class Outline(NamedTuple):
    """Points on a surface, those of one face together.

    Attributes
    ----------
    points : ndarray of shape (k, 3), mm
        From the centroid of the surface.
    normals : ndarray of shape (k, 3)
        Outward unit normals of the smooth surface.
    face : ndarray of shape (k,), int64
    area : ndarray of shape (k,), mm2
        Area that each point stands for; the sum is that of the surface.
    """

    points: np.ndarray
    normals: np.ndarray
    face: np.ndarray
    area: np.ndarray

    def chosen(self, which):
        """Some of its points, as an index of arrays says."""
        return Outline(*(each[which] for each in self))

    @property
    def count(self):
        """Number of points."""
        return len(self.points)

    @property
    def spacing(self):
        """ndarray of shape (k,), mm: side of the square that each point stands for."""
        return np.sqrt(self.area)


def outline_of(field, centroid):
    """Choose points among the samples of a measurement: `Outline`.

    Points of curved faces are lifted from their facets to the smooth surface.

    Parameters
    ----------
    field : ThicknessField
    centroid : ndarray of shape (3,), mm
        Of the surface, in the coordinates of its document.
    """
    mesh, samples = field.mesh, field.samples
    counted = np.flatnonzero(samples.area > 0.0)
    face = mesh.face_of_triangle[samples.triangle[counted]]
    counted = counted[np.argsort(face, kind="stable")]
    number, first, available = np.unique(
        mesh.face_of_triangle[samples.triangle[counted]], return_index=True, return_counts=True)
    area = np.bincount(mesh.face_of_triangle, mesh.areas)[number]
    wanted = _numbers(area, available)
    some = wanted > 0
    number, first, available, area, wanted = (each[some] for each in (number, first, available, area, wanted))
    rank = np.arange(wanted.sum()) - np.repeat(np.cumsum(wanted) - wanted, wanted)
    # Evenly along the samples of each face, which lie side by side.
    even = ((rank + 0.5) * np.repeat(available / wanted, wanted)).astype(np.int64)
    chosen = counted[np.repeat(first, wanted) + even]
    points, normals, triangle = samples.points[chosen], field.normals[chosen], samples.triangle[chosen]
    if mesh.has_faces:
        height = mesh.curved_surface.heights(triangle, np.ascontiguousarray(points.T))
        points = points + height[:, None] * mesh.normals[triangle]
    return Outline(points + (mesh.origin - centroid), normals, np.repeat(number, wanted), np.repeat(area / wanted, wanted))


def _numbers(area, available):
    """How many points each face has, of its area and how many there are: ndarray of int64."""
    share = np.round(POINTS * area / area.sum()).astype(np.int64)
    for on_small in range(MOST_ON_SMALL, 0, -1):
        wanted = np.minimum(np.maximum(share, on_small), available)
        if wanted.sum() <= MOST_POINTS:
            return wanted
    wanted[np.argsort(-area, kind="stable")[MOST_POINTS - POINTS:]] = 0
    return wanted

"""Points on the surface, each standing for an equal share of its triangle's area."""

from dataclasses import dataclass

import numpy as np

_INSET = 1e-3
COARSE_PATTERN = np.array([
    [1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0],
    [1.0 - 2.0 * _INSET, _INSET, _INSET],
    [_INSET, 1.0 - 2.0 * _INSET, _INSET],
    [_INSET, _INSET, 1.0 - 2.0 * _INSET],
])
"""Barycentric coordinates of the centroid and of one point just inside each corner: where a wall
tapers, its thinnest place is a corner."""

MINIMUM_SAMPLES = 10_000
"""A part with few triangles still gets this many samples, spread by area."""

MAXIMUM_EXTRA_SAMPLES = 600_000
"""Beyond one sample per triangle no more than this many: cost stays near linear in triangles."""

_GOLDEN = 1.32471795724474602596


@dataclass(frozen=True)
class SurfaceSamples:
    """Samples, those of one triangle in a row.

    Attributes
    ----------
    points : ndarray of shape (m, 3), mm
    triangle : ndarray of shape (m,), int64
    area : ndarray of shape (m,), mm2
        Area each sample stands for; sums to the area of the surface.
    """

    points: np.ndarray
    triangle: np.ndarray
    area: np.ndarray

    @property
    def count(self):
        """Number of samples."""
        return len(self.points)


def surface_samples(mesh, minimum=MINIMUM_SAMPLES):
    """Sample a surface deterministically.

    Parameters
    ----------
    mesh : SurfaceMesh
    minimum : int
        Least number of samples for the whole part.

    Returns
    -------
    SurfaceSamples

    Notes
    -----
    Four per triangle (centroid and one just inside each corner), more on large triangles by the
    R2 low-discrepancy sequence (Roberts 2018, "The unreasonable effectiveness of quasirandom
    sequences"), fewer per triangle on very fine meshes. No random seed enters the result.
    """
    per_triangle = _samples_per_triangle(mesh.areas, minimum)
    triangle = np.repeat(np.arange(mesh.count), per_triangle)
    start = np.cumsum(per_triangle) - per_triangle
    rank = np.arange(len(triangle)) - np.repeat(start, per_triangle)
    barycentric = _barycentric(rank)
    corners = mesh.corners
    points = np.zeros((len(triangle), 3))
    for corner in range(3):
        points += barycentric[:, corner, None] * corners[triangle, corner]
    area = (mesh.areas / per_triangle)[triangle]
    return SurfaceSamples(points, triangle, area)


def centroid_samples(mesh):
    """One sample per triangle, at its centroid: what the paper's pair rule works on."""
    return SurfaceSamples(mesh.corners.mean(axis=1), np.arange(mesh.count), mesh.areas)


def _samples_per_triangle(areas, minimum):
    coarse = len(COARSE_PATTERN)
    wanted = np.maximum(coarse, np.ceil(minimum * areas / areas.sum()).astype(np.int64))
    extra = np.cumsum(np.sort(wanted - 1)[::-1])
    if extra[-1] <= MAXIMUM_EXTRA_SAMPLES:
        return wanted
    # Very fine: the largest triangles keep the full pattern, the others their centroid.
    order = np.argsort(-areas, kind="stable")
    kept = np.cumsum(wanted[order] - 1) <= MAXIMUM_EXTRA_SAMPLES
    per_triangle = np.ones(len(areas), dtype=np.int64)
    per_triangle[order[kept]] = wanted[order[kept]]
    return per_triangle


def _barycentric(rank):
    """ndarray of shape (m, 3): the rank-th sample's place within its triangle."""
    first = (0.5 + (rank + 1) / _GOLDEN) % 1.0
    second = (0.5 + (rank + 1) / _GOLDEN ** 2) % 1.0
    folded = first + second > 1.0
    first, second = np.where(folded, 1.0 - first, first), np.where(folded, 1.0 - second, second)
    barycentric = np.stack([1.0 - first - second, first, second], axis=1)
    coarse = rank < len(COARSE_PATTERN)
    barycentric[coarse] = COARSE_PATTERN[rank[coarse]]
    return barycentric

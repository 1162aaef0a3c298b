"""Points on the surface, each standing for an equal share of its triangle's area."""

from dataclasses import dataclass

import numpy as np

from .analysis_settings import AnalysisSettings

COARSE_SAMPLES = 4
"""Least number of samples on a triangle: its centroid and one point inside each corner."""

PATTERN_BELOW = 6
"""From this many samples on, the sequence alone covers a triangle more evenly than the pattern."""

_INSET = 1e-3
_JUST_INSIDE_CORNERS = np.eye(3) * (1.0 - 3.0 * _INSET) + _INSET

MAXIMUM_EXTRA_SAMPLES = 600_000
"""Beyond one sample per triangle no more than this many: cost stays near linear in triangles."""

_AT_ONCE = 32768

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

    def followed_by(self, other):
        """These samples and then those of another `SurfaceSamples`."""
        return SurfaceSamples(
            np.concatenate([self.points, other.points]),
            np.concatenate([self.triangle, other.triangle]),
            np.concatenate([self.area, other.area]),
        )


def surface_samples(mesh, minimum=AnalysisSettings.minimum_samples):
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
    Four per triangle (the centroid and one inside each corner), more on large triangles by the R2
    low-discrepancy sequence (Roberts 2018, "The unreasonable effectiveness of quasirandom
    sequences"), fewer per triangle on very fine meshes. No random seed enters the result.
    """
    per_triangle = _samples_per_triangle(mesh.areas, minimum)
    triangle = np.repeat(np.arange(mesh.count), per_triangle)
    first = np.cumsum(per_triangle) - per_triangle
    points = np.empty((len(triangle), 3))
    for start in range(0, len(triangle), _AT_ONCE):
        own = triangle[start:start + _AT_ONCE]
        rank = np.arange(start, start + len(own)) - first[own]
        barycentric = _barycentric(rank, own, per_triangle[own])
        points[start:start + len(own)] = np.einsum("ik,ikj->ij", barycentric, mesh.corners[own])
    area = (mesh.areas / per_triangle)[triangle]
    return SurfaceSamples(points, triangle, area)


def centroid_samples(mesh):
    """One sample per triangle, at its centroid: what the paper's pair rule works on."""
    first, second, third = (mesh.corners[:, corner] for corner in range(3))
    return SurfaceSamples((first + second + third) / 3.0, np.arange(mesh.count), mesh.areas)


def corner_samples(mesh, triangles):
    """Samples just inside the corners of some triangles; they stand for no area.

    Parameters
    ----------
    mesh : SurfaceMesh
    triangles : ndarray of shape (k,), int64, ascending

    Returns
    -------
    SurfaceSamples
    """
    points = np.einsum("sc,kcj->ksj", _JUST_INSIDE_CORNERS, mesh.corners[triangles])
    return SurfaceSamples(
        points.reshape(-1, 3), np.repeat(triangles, 3), np.zeros(3 * len(triangles))
    )


def _samples_per_triangle(areas, minimum):
    wanted = np.maximum(COARSE_SAMPLES, np.ceil(minimum * areas / areas.sum()).astype(np.int64))
    extra = np.cumsum(np.sort(wanted - 1)[::-1])
    if extra[-1] <= MAXIMUM_EXTRA_SAMPLES:
        return wanted
    # Very fine: the largest triangles keep the full pattern, the others their centroid.
    order = np.argsort(-areas, kind="stable")
    kept = np.cumsum(wanted[order] - 1) <= MAXIMUM_EXTRA_SAMPLES
    per_triangle = np.ones(len(areas), dtype=np.int64)
    per_triangle[order[kept]] = wanted[order[kept]]
    return per_triangle


def _barycentric(rank, triangle, count):
    """ndarray of shape (m, 3): place of the rank-th sample within its triangle.

    The middles of the sides make four equal triangles. The first sample is the centroid of the
    middle one, the next three lie each in a corner one, all others anywhere. The sequence that says
    where is shifted from triangle to triangle (Cranley and Patterson 1976, doi:10.1137/0713071):
    otherwise a strip of equal slender triangles would be sampled along a few lines only.
    """
    first = (_shift(triangle, 1) + (rank + 1) / _GOLDEN) % 1.0
    second = (_shift(triangle, 2) + (rank + 1) / _GOLDEN ** 2) % 1.0
    folded = first + second > 1.0
    first, second = np.where(folded, 1.0 - first, first), np.where(folded, 1.0 - second, second)
    barycentric = np.stack([1.0 - first - second, first, second], axis=1)
    few = count < PATTERN_BELOW
    barycentric[few & (rank == 0)] = 1.0 / 3.0
    for corner in range(3):
        inside = few & (rank == corner + 1)
        barycentric[inside] = 0.5 * barycentric[inside] + 0.5 * np.eye(3)[corner]
    return barycentric


def _shift(triangle, stream):
    """A number in [0, 1) that depends on the index of the triangle in no regular way.

    The finaliser of SplitMix64 (Steele, Lea, Flood 2014, doi:10.1145/2660193.2660195).
    """
    with np.errstate(over="ignore"):
        mixed = (triangle.astype(np.uint64) * np.uint64(2) + np.uint64(stream)) * np.uint64(
            0x9E3779B97F4A7C15)
        mixed = (mixed ^ (mixed >> np.uint64(30))) * np.uint64(0xBF58476D1CE4E5B9)
        mixed = (mixed ^ (mixed >> np.uint64(27))) * np.uint64(0x94D049BB133111EB)
    return (mixed >> np.uint64(11)).astype(np.float64) * 2.0 ** -53

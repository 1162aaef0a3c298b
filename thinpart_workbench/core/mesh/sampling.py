# SPDX-License-Identifier: LGPL-2.1-or-later
"""Samples of the surface, each with an equal share of the area of its triangle."""

from dataclasses import dataclass
from typing import Optional

import numpy as np

from ..analysis_settings import AnalysisSettings
from .smooth_normals import normals_at

COARSE_SAMPLES = 4
"""Least number of samples on a triangle of a coarse mesh: its centroid and one point inside each corner."""

PATTERN_BELOW = 6
"""From this many samples per triangle on, the sequence alone is more even than the pattern."""

LEAST_ON_FACE = 4
"""Least number of samples on a face of a finer mesh, so that no face goes unseen."""

_INSET = 1e-3
_JUST_INSIDE_CORNERS = np.eye(3) * (1.0 - 3.0 * _INSET) + _INSET

_AT_ONCE = 32768

_PLASTIC, _GOLDEN = 1.32471795724474602596, 0.6180339887498949


@dataclass(frozen=True)
class SurfaceSamples:
    """Samples; those of one triangle are consecutive.

    Attributes
    ----------
    points : ndarray of shape (m, 3), mm
    triangle : ndarray of shape (m,), int64
    area : ndarray of shape (m,), mm2
        Area that each sample represents; the sum is the area of the surface.
    normals : ndarray of shape (m, 3), optional
        Outward unit normals, along which walls are measured; None for those of the triangles.
    """

    points: np.ndarray
    triangle: np.ndarray
    area: np.ndarray
    normals: Optional[np.ndarray] = None

    @property
    def count(self):
        """Number of samples."""
        return len(self.points)

    def chosen(self, which):
        """Some of these samples, by their numbers: `SurfaceSamples`."""
        return SurfaceSamples(self.points[which], self.triangle[which], self.area[which],
                              None if self.normals is None else self.normals[which])

    def followed_by(self, other):
        """These samples and then those of another `SurfaceSamples`."""
        return SurfaceSamples(
            np.concatenate([self.points, other.points]),
            np.concatenate([self.triangle, other.triangle]),
            np.concatenate([self.area, other.area]),
            None if self.normals is None else np.concatenate([self.normals, other.normals]),
        )

    def normals_on(self, mesh):
        """ndarray of shape (m, 3): the normals of these samples of a mesh."""
        return mesh.normals[self.triangle] if self.normals is None else self.normals


def smooth_samples(mesh, points, triangle, area):
    """Samples with the normals of the smooth surface: `SurfaceSamples`."""
    return SurfaceSamples(points, triangle, area, normals_at(mesh, triangle, points))


def surface_samples(mesh, minimum=AnalysisSettings.minimum_samples):
    """Sample a surface deterministically: SurfaceSamples.

    On a coarse mesh, each triangle has four samples (the centroid and one inside each corner), and large ones have more, by
    the R2 low-discrepancy sequence (Roberts 2018, "The unreasonable effectiveness of quasirandom sequences"). On a fine
    mesh, each face has samples by its area, in equal strata along its triangles, which mostly lie side by side as the
    mesher made them (Cochran 1977, Sampling Techniques, 8.1). The result does not depend on a random seed.

    Parameters
    ----------
    mesh : SurfaceMesh
    minimum : int
        Number of samples, to which few are added so that all triangles of a coarse mesh, and all faces of a fine one, have
        some. It does not grow with the number of triangles.
    """
    per_triangle, area = _samples_per_triangle(mesh.areas, mesh.face_of_triangle, minimum)
    triangle = np.repeat(np.arange(mesh.count), per_triangle)
    first = np.cumsum(per_triangle) - per_triangle
    points = np.empty((len(triangle), 3))
    for start in range(0, len(triangle), _AT_ONCE):
        own = triangle[start:start + _AT_ONCE]
        rank = np.arange(start, start + len(own)) - first[own]
        barycentric = _barycentric(rank, own, per_triangle[own])
        points[start:start + len(own)] = np.einsum("ik,ikj->ij", barycentric, mesh.corners[own])
    area = area[triangle]
    return smooth_samples(mesh, points, triangle, area)


def centroid_samples(mesh):
    """One sample per triangle, at its centroid, for the paper's pair rule."""
    first, second, third = (mesh.corners[:, corner] for corner in range(3))
    return SurfaceSamples((first + second + third) / 3.0, np.arange(mesh.count), mesh.areas)


def corner_samples(mesh, triangles):
    """Make samples just inside the corners of some triangles: SurfaceSamples that represent no area.

    Parameters
    ----------
    mesh : SurfaceMesh
    triangles : ndarray of shape (k,), int64, ascending
    """
    points = np.einsum("sc,kcj->ksj", _JUST_INSIDE_CORNERS, mesh.corners[triangles])
    return smooth_samples(mesh, points.reshape(-1, 3), np.repeat(triangles, 3), np.zeros(3 * len(triangles)))


def even_samples(area, count):
    """Choose samples that each stand for the same share of the surface: ndarray of shape (count,), int64.

    Ascending; some may occur twice.

    Parameters
    ----------
    area : ndarray of shape (m,), mm2
    count : int
    """
    cumulative = np.cumsum(area)
    wanted = (np.arange(count) + 0.5) / count * cumulative[-1]
    return np.minimum(np.searchsorted(cumulative, wanted), len(area) - 1)


def _samples_per_triangle(areas, face_of_triangle, minimum):
    """Number of samples on each triangle, and the area that each of those represents: two ndarrays of shape (n,)."""
    count = np.maximum(COARSE_SAMPLES, np.ceil(minimum * areas / areas.sum()).astype(np.int64))
    if (count - 1).sum() <= minimum:
        return count, areas / count
    return _samples_by_face(areas, face_of_triangle, minimum)


def _samples_by_face(areas, face_of_triangle, minimum):
    """As `_samples_per_triangle`, on a fine mesh."""
    order = np.argsort(face_of_triangle, kind="stable")
    of_face = np.bincount(face_of_triangle, areas)
    present = np.count_nonzero(of_face)
    least = LEAST_ON_FACE if LEAST_ON_FACE * present <= minimum else int(present <= minimum)
    on_face = np.where(of_face > 0.0, np.maximum(least, np.rint(minimum * of_face / areas.sum())), 0.0).astype(np.int64)
    # Faces without samples of their own share some.
    group = np.where(on_face > 0, np.arange(len(of_face)), len(of_face))
    in_group, group_area = np.bincount(group, on_face).astype(np.int64), np.bincount(group, of_face)
    if in_group[-1] == 0 and group_area[-1] > 0.0:
        in_group[-1] = max(1, round(minimum * group_area[-1] / areas.sum()))
    own = group[face_of_triangle]
    order = order[np.argsort(own[order], kind="stable")]
    stratum = group_area / np.maximum(in_group, 1)
    # In units of strata, group after group: each stratum has one sample, somewhere inside.
    ends = np.cumsum(areas[order] / stratum[own[order]])
    number = np.arange(in_group.sum())
    position = np.minimum(number + (number * _GOLDEN) % 1.0, ends[-1] * (1.0 - 1e-12))
    count = np.zeros(len(areas), dtype=np.int64)
    count[order] = np.bincount(np.searchsorted(ends, position, side="right"), minlength=len(areas))
    return count, stratum[own]


def _barycentric(rank, triangle, count):
    """ndarray of shape (m, 3): barycentric coordinates of the rank-th sample of its triangle.

    The middles of the sides divide a triangle into four equal ones. The first sample is the centroid of the middle
    one, the next three are each inside one at a corner, all others anywhere. The low-discrepancy sequence is shifted
    for each triangle (Cranley and Patterson 1976, doi:10.1137/0713071); otherwise a strip of equal slender triangles
    would be sampled along a few lines only.
    """
    first = (_shift(triangle, 1) + (rank + 1) / _PLASTIC) % 1.0
    second = (_shift(triangle, 2) + (rank + 1) / _PLASTIC ** 2) % 1.0
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
    """A pseudo-random number in [0, 1) from the index of the triangle.

    The finaliser of SplitMix64 (Steele, Lea, Flood 2014, doi:10.1145/2660193.2660195).
    """
    with np.errstate(over="ignore"):
        mixed = (triangle.astype(np.uint64) * np.uint64(2) + np.uint64(stream)) * np.uint64(
            0x9E3779B97F4A7C15)
        mixed = (mixed ^ (mixed >> np.uint64(30))) * np.uint64(0xBF58476D1CE4E5B9)
        mixed = (mixed ^ (mixed >> np.uint64(27))) * np.uint64(0x94D049BB133111EB)
    return (mixed >> np.uint64(11)).astype(np.float64) * 2.0 ** -53

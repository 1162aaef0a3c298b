# SPDX-License-Identifier: LGPL-2.1-or-later
"""The paper's own rule for pairs of triangles, provided to reproduce the paper."""

from dataclasses import dataclass

import numpy as np

from ..descriptors.distribution import table_key, tabulate
from ..mesh.smooth_normals import normals_at
from ..tolerances import TOLERANCES
from ..walls.thickness_field import ThicknessField
from ..walls.walls import NONPARALLEL_BELOW, PARALLEL_BELOW, angle_between

_ROWS_AT_ONCE = 256
_INSIDE_SLACK = 1e-9


@dataclass(frozen=True)
class PairedFaces:
    """Pairs (i, j) of triangles that enclose material, with their distances.

    Attributes
    ----------
    first, second : ndarray of shape (k,), int64
    distance : ndarray of shape (k,), mm
    wedge_angle : ndarray of shape (k,), radians
    """

    first: np.ndarray
    second: np.ndarray
    distance: np.ndarray
    wedge_angle: np.ndarray


def measure_pairs(mesh, samples, diagonal, report=None):
    """Measure thickness by pairs of triangles.

    Giannini, Petton, Pernot (TMCE 2012), 4.2.2: two nearly parallel triangles face each other if the centroid, or
    else a vertex, of one projects into the other; their distance is the difference of the centroids along the
    normal. Between 10 and 60 degrees it is the least distance of the vertices. The rule considers pairs in isolation:
    it also counts distances across a void between two walls, and its cost grows with the square of the number of
    triangles. Neither is true of `measure_rays`.

    Parameters
    ----------
    mesh : SurfaceMesh
    samples : SurfaceSamples
        One per triangle, its centroid; see `centroid_samples`.
    diagonal : float, mm
    report : callable, optional
        Called with the fraction done; may raise to stop.

    Returns
    -------
    field : ThicknessField
        For each triangle the nearest parallel wall, or else the nearest non-parallel one.
    distribution : Distribution
        All distances of all triangles. A triangle that faces walls at two distances counts for both, so the shares of
        the distribution may add up to more than 1, as in the paper.
    """
    count = mesh.count
    parallel_keys: list[np.ndarray] = []
    slanted_keys: list[np.ndarray] = []
    best = np.full(count, np.inf)
    best_other = np.full(count, -1, dtype=np.int64)
    has_parallel = np.zeros(count, dtype=bool)
    has_slanted = np.zeros(count, dtype=bool)
    for start in range(0, count, _ROWS_AT_ONCE):
        rows = np.arange(start, min(start + _ROWS_AT_ONCE, count))
        parallel, slanted = pairs_of(mesh, rows)
        for pairs, keys, seen in (
            (parallel, parallel_keys, has_parallel), (slanted, slanted_keys, has_slanted)
        ):
            angle = None if pairs is parallel else pairs.wedge_angle
            cell = table_key(pairs.distance / diagonal, angle)
            for triangle in (pairs.first, pairs.second):
                keys.append(np.unique(cell * count + triangle))
                seen[triangle] = True
        _store_nearest(parallel, best, best_other)
        if report is not None:
            report((start + len(rows)) / count)
    # Each triangle counts once per distance, whatever the number of pairs with that distance.
    cell, triangle = np.divmod(np.unique(np.concatenate(parallel_keys + slanted_keys)), count)
    share = mesh.areas / mesh.areas.sum()
    slanted_only = has_slanted & ~has_parallel
    result = tabulate(
        cell, share[triangle], share[has_parallel].sum(), share[slanted_only].sum(), 0.0
    )
    for start in range(0, count, _ROWS_AT_ONCE):
        rows = np.flatnonzero(slanted_only[start:start + _ROWS_AT_ONCE]) + start
        if len(rows):
            _store_nearest(pairs_of(mesh, rows)[1], best, best_other, only=slanted_only)
    angle = _wedge_angles(mesh, samples, best, best_other)
    none_entered = np.empty(0, dtype=np.int64)
    return ThicknessField(mesh, samples, best, angle, best_other, none_entered), result


def _wedge_angles(mesh, samples, distance, opposite):
    """ndarray of shape (m,), radians: between the smooth surfaces at both ends, pi where there is no other end."""
    angle = np.full(samples.count, np.pi)
    met = np.flatnonzero(opposite >= 0)
    triangle, points = samples.triangle[met], samples.points[met]
    there = points - mesh.normals[triangle] * distance[met, None]
    angle[met] = angle_between(normals_at(mesh, triangle, points), -normals_at(mesh, opposite[met], there))
    return angle


def pairs_of(mesh, rows):
    """Find the pairs in which triangle i is one of `rows` and faces any other triangle j.

    Returns `parallel` and `slanted` (PairedFaces).
    """
    centroids = mesh.corners.mean(axis=1)
    normals = mesh.normals
    cosine = -(normals[rows] @ normals.T)
    # There is material between them only if each centroid is behind the other triangle.
    offset = np.einsum("ij,ij->i", centroids, normals)
    behind = (normals[rows] @ centroids.T) < offset[rows, None]
    behind &= (centroids[rows] @ normals.T) < offset[None]
    near_parallel = behind & (cosine > np.cos(PARALLEL_BELOW - TOLERANCES.angle))
    slanted = behind & ~near_parallel & (cosine > np.cos(NONPARALLEL_BELOW - TOLERANCES.angle))
    return (
        _facing(mesh, centroids, *_indices(rows, near_parallel)),
        _nearest_vertices(mesh, *_indices(rows, slanted)),
    )


def _indices(rows, mask):
    row, second = np.nonzero(mask)
    return rows[row], second


def _angle(mesh, first, second):
    cosine = -np.einsum("ij,ij->i", mesh.normals[first], mesh.normals[second])
    return np.arccos(np.clip(cosine, -1.0, 1.0))


def _facing(mesh, centroids, first, second):
    """Select the nearly parallel pairs of which one triangle projects into the other."""
    radius = np.sqrt(((mesh.corners - centroids[:, None]) ** 2).sum(axis=2).max(axis=1))
    apart = centroids[second] - centroids[first]
    along = np.einsum("ij,ij->i", apart, mesh.normals[first])
    sideways = np.einsum("ij,ij->i", apart, apart) - along ** 2
    # Along normals up to 10 degrees apart, a projection may shift by the distance times the tangent of 10 degrees.
    reach = radius[first] + radius[second] + np.abs(along) * np.tan(PARALLEL_BELOW)
    near = np.flatnonzero(sideways <= reach ** 2)
    first, second, along = first[near], second[near], along[near]
    facing = _projects_into(mesh, centroids[first], first, second)
    facing |= _projects_into(mesh, centroids[second], second, first)
    for corner in range(3):
        rest = np.flatnonzero(~facing)
        one, other = first[rest], second[rest]
        facing[rest] = _projects_into(mesh, mesh.corners[one, corner], one, other)
        facing[rest] |= _projects_into(mesh, mesh.corners[other, corner], other, one)
    first, second, along = first[facing], second[facing], along[facing]
    return PairedFaces(first, second, np.abs(along), _angle(mesh, first, second))


def _projects_into(mesh, points, source, target):
    """Whether points of `source` fall into `target` when moved along the normal of `source`."""
    corner = mesh.corners[target, 0]
    edge_u = mesh.corners[target, 1] - corner
    edge_v = mesh.corners[target, 2] - corner
    normal, target_normal = mesh.normals[source], mesh.normals[target]
    travel = np.einsum("ij,ij->i", corner - points, target_normal)
    travel /= np.einsum("ij,ij->i", normal, target_normal)
    inside = points + travel[:, None] * normal - corner
    doubled = 2.0 * mesh.areas[target]
    u = np.einsum("ij,ij->i", np.cross(inside, edge_v), target_normal) / doubled
    v = np.einsum("ij,ij->i", np.cross(edge_u, inside), target_normal) / doubled
    return (u >= -_INSIDE_SLACK) & (v >= -_INSIDE_SLACK) & (u + v <= 1.0 + _INSIDE_SLACK)


def _nearest_vertices(mesh, first, second):
    least = np.full(len(first), np.inf)
    for one in range(3):
        for other in range(3):
            apart = mesh.corners[first, one] - mesh.corners[second, other]
            np.minimum(least, np.einsum("ij,ij->i", apart, apart), out=least)
    return PairedFaces(first, second, np.sqrt(least), _angle(mesh, first, second))


def _store_nearest(pairs, best, best_other, only=None):
    for own, other in ((pairs.first, pairs.second), (pairs.second, pairs.first)):
        distance = pairs.distance
        if only is not None:
            chosen = only[own]
            own, other, distance = own[chosen], other[chosen], distance[chosen]
        order = np.argsort(-distance, kind="stable")
        own, other, distance = own[order], other[order], distance[order]
        nearest = np.full(len(best), np.inf)
        nearest_other = np.full(len(best), -1, dtype=np.int64)
        nearest[own], nearest_other[own] = distance, other
        closer = nearest < best
        best[closer], best_other[closer] = nearest[closer], nearest_other[closer]

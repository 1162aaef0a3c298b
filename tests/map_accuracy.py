# SPDX-License-Identifier: LGPL-2.1-or-later
"""How much of a thickness map differs from what rays meet."""

import numpy as np

from thinpart_workbench.core.maps.seen_walls import seen_walls
from thinpart_workbench.core.rays.inward_rays import InwardRays

POINTS, WITHIN = 20_000, 0.05
"""Random points of the surface, as pixels from all sides; a thickness that is off by more has another colour."""


def share_off(mesh, shown):
    """Shares of the surface where a map shows another thickness than a ray meets, and where only one finds a wall."""
    rng = np.random.default_rng(3)
    facet = rng.choice(shown.count, POINTS, p=shown.areas / shown.areas.sum())
    weights = np.sqrt(rng.random(POINTS)), rng.random(POINTS)
    weights = np.column_stack([1.0 - weights[0], weights[0] * (1.0 - weights[1]), weights[0] * weights[1]])
    points = np.einsum("ij,ijk->ik", weights, shown.corners[facet])
    value = np.einsum("ij,ij->i", weights, shown.corner_thickness[facet])
    real, _ = seen_walls(mesh, InwardRays(mesh), points, _triangles_at(mesh, shown.face[facet], points))
    both = np.isfinite(real) & np.isfinite(value)
    return np.mean(both & (np.abs(value - real) > WITHIN * real)), np.mean(np.isfinite(real) != np.isfinite(value))


def _triangles_at(mesh, faces, points):
    """The triangle of a face that each point lies on."""
    found = np.empty(len(points), dtype=np.int64)
    for face in np.unique(faces):
        own, rows = np.flatnonzero(mesh.face_of_triangle == face), np.flatnonzero(faces == face)
        corners = mesh.corners[own]
        first, second = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
        normal = np.cross(first, second)
        squared = np.einsum("ij,ij->i", normal, normal)
        for start in range(0, len(rows), 100):
            part = rows[start:start + 100]
            off = points[part, None] - corners[:, 0]
            u = np.einsum("abk,bk->ab", np.cross(off, second), normal) / squared
            v = np.einsum("abk,bk->ab", np.cross(first, off), normal) / squared
            height = np.abs(np.einsum("abk,bk->ab", off, normal)) / np.sqrt(squared) / mesh.extent
            outside = np.maximum(np.maximum(-u, -v), u + v - 1.0)
            found[part] = own[np.argmin(outside + 10.0 * height, axis=1)]
    return found

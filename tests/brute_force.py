# SPDX-License-Identifier: LGPL-2.1-or-later
"""Slow and plain versions of what the core does cleverly: the oracles of its tests."""

import numpy as np

from thinpart_workbench.core.tolerances import TOLERANCES


def first_hits(mesh, points, directions):
    """First triangle met from inside by every ray, against every triangle, in float64.

    Returns
    -------
    distance : ndarray of shape (m,); inf for none
    triangle : ndarray of shape (m,); -1 for none
    """
    distance = np.full(len(points), np.inf)
    triangle = np.full(len(points), -1)
    a, b, c = (mesh.corners[:, k] for k in range(3))
    edge_u, edge_v, normals = b - a, c - a, mesh.normals
    doubled = 2.0 * mesh.areas
    for ray, (origin, direction) in enumerate(zip(points, directions)):
        facing = normals @ direction
        hit = np.einsum("ij,ij->i", a - origin, normals) / np.where(facing > 0, facing, 1.0)
        inside = origin + hit[:, None] * direction - a
        u = np.einsum("ij,ij->i", np.cross(inside, edge_v), normals) / doubled
        v = np.einsum("ij,ij->i", np.cross(edge_u, inside), normals) / doubled
        gap = TOLERANCES.gap * mesh.extent if mesh.cracked else 0.0
        # u falls by one over the height of the triangle, and so on.
        heights = [doubled / np.linalg.norm(side, axis=1) for side in (edge_v, edge_u, c - b)]
        u_slack, v_slack, w_slack = (TOLERANCES.edge + gap / height for height in heights)
        met = (facing > TOLERANCES.grazing) & (hit > TOLERANCES.self_hit * mesh.extent)
        met &= (u >= -u_slack) & (v >= -v_slack) & (u + v <= 1 + w_slack)
        if met.any():
            hit = np.where(met, hit, np.inf)
            triangle[ray] = hit.argmin()
            distance[ray] = hit.min()
    return distance, triangle


def pairs(mesh):
    """The paper's pair rule as a literal loop.

    Returns
    -------
    parallel, slanted : dict
        From (triangle, triangle) to the distance, mm.
    """
    parallel, slanted = {}, {}
    for i in range(mesh.count):
        for j in range(mesh.count):
            n_i, n_j = mesh.normals[i], mesh.normals[j]
            c_i, c_j = mesh.corners[i].mean(axis=0), mesh.corners[j].mean(axis=0)
            if i == j or (c_j - c_i) @ n_i >= 0 or (c_i - c_j) @ n_j >= 0:
                continue
            angle = np.degrees(np.arccos(np.clip(-(n_i @ n_j), -1, 1)))
            if angle < 10 and _face_each_other(mesh, i, j):
                parallel[i, j] = abs((c_j - c_i) @ n_i)
            elif 10 <= angle < 60:
                slanted[i, j] = min(
                    np.linalg.norm(p - q) for p in mesh.corners[i] for q in mesh.corners[j]
                )
    return parallel, slanted


def _face_each_other(mesh, i, j):
    def projects(point, source, target):
        a, b, c = mesh.corners[target]
        normal, own = mesh.normals[target], mesh.normals[source]
        place = point + own * (((a - point) @ normal) / (own @ normal))
        return all(
            np.cross(q - p, place - p) @ normal >= -1e-9 * 2 * mesh.areas[target]
            for p, q in ((a, b), (b, c), (c, a))
        )

    points = [(mesh.corners[i].mean(axis=0), i, j), (mesh.corners[j].mean(axis=0), j, i)]
    points += [(mesh.corners[i][k], i, j) for k in range(3)]
    points += [(mesh.corners[j][k], j, i) for k in range(3)]
    return any(projects(*each) for each in points)


def box_volume(points, starts=400, keep=12, seed=0):
    """Least box volume by a dense search over rotations, for comparison with `minimal_box`."""
    from scipy.optimize import minimize
    from scipy.spatial import ConvexHull
    from scipy.spatial.transform import Rotation

    # One row per coordinate: numpy finds extremes along rows many times faster.
    corners = np.ascontiguousarray(points[ConvexHull(points).vertices].T)

    def volume(turn, start):
        axes = start @ Rotation.from_rotvec(turn).as_matrix()
        return float(np.prod(np.ptp(axes.T @ corners, axis=1)))

    rotations = Rotation.random(starts, random_state=seed).as_matrix()
    rotations = sorted(rotations, key=lambda start: volume(np.zeros(3), start))[:keep]
    best = np.inf
    for start in rotations:
        turn = np.zeros(3)
        for spread in (0.2, 0.05, 0.01):
            simplex = np.vstack([turn, turn + spread * np.eye(3)])
            result = minimize(volume, turn, args=(start,), method="Nelder-Mead", options={
                "initial_simplex": simplex, "maxfev": 500, "xatol": 1e-9, "fatol": 1e-12})
            turn = result.x
        best = min(best, result.fun)
    return best


def nearest_depth(corners, width, height):
    """Third coordinate of the nearest triangle at every sample, by trying each on all samples.

    Returns
    -------
    ndarray of shape (height, width); -inf for none
    """
    x, y = np.meshgrid(np.arange(width) + 0.5, np.arange(height) + 0.5)
    nearest = np.full((height, width), -np.inf)
    for a, b, c in corners:
        area = np.linalg.det([b[:2] - a[:2], c[:2] - a[:2]])
        v = ((x - a[0]) * (c[1] - a[1]) - (y - a[1]) * (c[0] - a[0])) / area
        w = ((b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0])) / area
        inside = (v >= -1e-9) & (w >= -1e-9) & (v + w <= 1 + 1e-9)
        depth = a[2] + v * (b[2] - a[2]) + w * (c[2] - a[2])
        nearest = np.where(inside, np.maximum(nearest, depth), nearest)
    return nearest

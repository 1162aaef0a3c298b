# SPDX-License-Identifier: LGPL-2.1-or-later
"""Child process: the paper's comparison of all pairs of triangles, as plainly as numpy allows.

Giannini, Petton, Pernot (TMCE 2012), 4.2.2. One triangle at a time is held against all others, which
costs the square of their number.
"""

from functools import lru_cache

import numpy as np

from .child_process import serve, timed

PARALLEL_COSINE = np.cos(np.radians(10.0))


def nearest_parallel_walls(vertices, triangles):
    """Distance of every triangle to the nearest one that is parallel and lies opposite.

    Parameters
    ----------
    vertices : ndarray of shape (v, 3), mm
    triangles : ndarray of shape (n, 3), int

    Returns
    -------
    ndarray of shape (n,), mm
        inf where there is none.
    """
    first, second, third = (vertices[triangles[:, corner]] for corner in range(3))
    along_u, along_v = second - first, third - first
    doubled = np.cross(along_u, along_v)
    size = np.linalg.norm(doubled, axis=1)
    normals = doubled / size[:, None]
    centroids = (first + second + third) / 3.0
    nearest = np.full(len(triangles), np.inf)
    for row, (centroid, normal) in enumerate(zip(centroids, normals)):
        cosine = -(normals @ normal)
        slant = np.where(cosine > PARALLEL_COSINE, cosine, np.inf)
        # Where the line through the centroid, inwards, crosses the plane of each other triangle.
        distance = np.einsum("ij,ij->i", centroid - first, normals) / -slant
        inside = centroid - distance[:, None] * normal - first
        u = np.einsum("ij,ij->i", np.cross(inside, along_v), normals) / size
        v = np.einsum("ij,ij->i", np.cross(along_u, inside), normals) / size
        faces = (cosine > PARALLEL_COSINE) & (distance > 0.0)
        faces &= (u >= 0.0) & (v >= 0.0) & (u + v <= 1.0)
        nearest[row] = distance[faces].min(initial=np.inf)
    return nearest


@lru_cache(maxsize=1)
def _arrays(file):
    with np.load(file) as arrays:
        return arrays["vertices"], arrays["triangles"]


def time_loop(file):
    """Time the loop on the arrays that `product.load` has left; dict with ``seconds``."""
    seconds, _ = timed(nearest_parallel_walls, *_arrays(file))
    return {"seconds": seconds}


if __name__ == "__main__":
    serve({"time": time_loop})

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The points and triangles of FreeCAD's meshes as arrays."""

from itertools import chain

import numpy as np


def mesh_arrays(mesh):
    """Points, ndarray of shape (v, 3), mm, and triangles, ndarray of shape (n, 3), int64, of a Mesh.Mesh.

    `Mesh.write` to a stream would need no Python object for each point, but loses bytes that are no text; FreeCAD 1.1
    refuses to write to a file in memory. A file in a folder takes as long as this with few triangles.
    """
    points, triangles = mesh.Topology
    return (np.fromiter(chain.from_iterable(points), np.float64, 3 * len(points)).reshape(-1, 3),
            np.fromiter(chain.from_iterable(triangles), np.int64, 3 * len(triangles)).reshape(-1, 3))

# SPDX-License-Identifier: LGPL-2.1-or-later
"""What lies on both sides of points within a wall."""

from typing import NamedTuple

import numpy as np

from ..rays.ray_casting import INNER, first_hits


class Sides(NamedTuple):
    """Distances and faces on either side of points; inf and -1 where there is nothing.

    Attributes
    ----------
    ahead, behind : ndarray of shape (m,), mm
        Along the direction and against it.
    face_ahead, face_behind : ndarray of shape (m,), int64
    """

    ahead: np.ndarray
    behind: np.ndarray
    face_ahead: np.ndarray
    face_behind: np.ndarray

    def is_between(self, pairs, count):
        """Whether points lie between two faces that are one of some pairs: ndarray of shape (m,), bool.

        Parameters
        ----------
        pairs : iterable of (int, int)
        count : int
            Number of faces.
        """
        low, high = np.minimum(self.face_ahead, self.face_behind), np.maximum(self.face_ahead, self.face_behind)
        keys = np.array([first * count + second for first, second in pairs], dtype=np.int64)
        return (low >= 0) & np.isin(low * count + high, keys)


def sides_of(mesh, rays, points, directions):
    """Look both ways from points within the material: Sides.

    Parameters
    ----------
    mesh : SurfaceMesh
    rays : InwardRays
        Of the mesh.
    points : ndarray of shape (m, 3), mm
        In the coordinates of the document.
    directions : ndarray of shape (m, 3)
        Unit vectors.
    """
    origins, along = rays.turned(points - mesh.origin), rays.turned_directions(directions)
    ahead, triangle_ahead = first_hits(rays.tree, origins, along, INNER)
    behind, triangle_behind = first_hits(rays.tree, origins, -along, INNER)
    face = np.append(mesh.face_of_triangle, -1)
    return Sides(ahead, behind, face[triangle_ahead], face[triangle_behind])

# SPDX-License-Identifier: LGPL-2.1-or-later
"""A shell: triangles on the middle of walls, each with the thickness of its wall."""

from dataclasses import dataclass

import numpy as np
from scipy.spatial import cKDTree

from .sound_triangles import groups_by_sides
from .walls_through import sides_of

ALIKE = 1.02
"""Ratio of thicknesses up to which elements share a section."""

FARTHEST = 2.0
"""Thickness under a triangle by that of its wall up to which it is one: farther, it looks along another wall."""


@dataclass(frozen=True)
class ShellMesh:
    """Triangles of first or second order.

    Attributes
    ----------
    points : ndarray of shape (v, 3), mm
        In the coordinates of the document; each is used.
    triangles : ndarray of int64, shape (n, 3) or (n, 6)
        Rows of the points: corners, then the middles of the sides 0-1, 1-2 and 2-0.
    wall : ndarray of shape (n,), int64
        Number of the wall, from 0.
    thickness : ndarray of shape (n,), mm
    """

    points: np.ndarray
    triangles: np.ndarray
    wall: np.ndarray
    thickness: np.ndarray

    @property
    def areas(self):
        """ndarray of shape (n,), mm2"""
        a, b, c = self.points[self.triangles[:, :3].T]
        return 0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1)

    @property
    def volume(self):
        """float, mm3: area by thickness; joints count for each wall."""
        return float(self.areas @ self.thickness)

    @property
    def pieces(self):
        """Number of pieces that share no side."""
        return int(groups_by_sides(self.triangles).max()) + 1

    @property
    def is_tapered(self):
        """ndarray of shape (n,), bool: whether an element is of a wall whose thickness varies."""
        found = np.zeros(len(self.triangles), dtype=bool)
        for number in np.unique(self.wall):
            own = self.wall == number
            found |= own & (self.thickness[own].max() > ALIKE * self.thickness[own].min())
        return found

    def node_thickness(self, rows):
        """Thickness at the nodes of some elements, the mean of these by area.

        Returns `node` (ndarray of int64: rows of the points) and `thickness` (ndarray, mm).
        """
        triangles, weight = self.triangles[rows], np.repeat(self.areas[rows], self.triangles.shape[1])
        node, number = np.unique(triangles, return_inverse=True)
        thickness = np.repeat(self.thickness[rows], self.triangles.shape[1])
        return node, np.bincount(number.ravel(), weight * thickness) / np.bincount(number.ravel(), weight)

    def sections(self):
        """Elements of about one thickness.

        Returns `section` (ndarray of shape (n,), int64) and `thickness` (ndarray of shape (k,), mm; of each section: the
        mean by area).
        """
        section, areas = alike(self.thickness), self.areas
        return section, np.bincount(section, areas * self.thickness) / np.bincount(section, areas)


def alike(thickness):
    """Number of the group of about one thickness that each value is in, the thinnest first: ndarray of int64."""
    number, start, found = -1, 0.0, np.empty(len(thickness), dtype=np.int64)
    for row in np.argsort(thickness, kind="stable"):
        if number < 0 or thickness[row] > ALIKE * start:
            number, start = number + 1, thickness[row]
        found[row] = number
    return found


def shell_mesh(points, triangles, wall, walls, mesh, rays):
    """Measure the thickness under each triangle of a mid-surface: ShellMesh.

    Where a wall goes through a joint, it has no thickness of its own: such a triangle has that of the nearest one of its
    wall that lies between its two sides.

    Parameters
    ----------
    points, triangles, wall
        As of `ShellMesh`.
    walls : list
        Their ``face_pairs`` and ``thickness``, by number.
    mesh : SurfaceMesh
        Of the solid.
    rays : InwardRays
        Of that mesh.
    """
    used, rows = np.unique(triangles, return_inverse=True)
    points, triangles = points[used], rows.reshape(triangles.shape)
    a, b, c = points[triangles[:, :3].T]
    across = np.cross(b - a, c - a)
    # The middles of curved sides lie on the surface, its facet does not: six nodes have a better centroid than three.
    centre = (a + b + c) / 3.0 if triangles.shape[1] == 3 else (4.0 * points[triangles[:, 3:]].sum(axis=1) - a - b - c) / 9.0
    sides = sides_of(mesh, rays, centre, across / np.linalg.norm(across, axis=1)[:, None])
    thickness, count = sides.ahead + sides.behind, int(mesh.face_of_triangle.max()) + 1
    for number, each in enumerate(walls):
        own = np.flatnonzero(wall == number)
        known = (sides.is_between(each.face_pairs, count) & (thickness < FARTHEST * each.thickness))[own]
        if not known.all():
            bare = own[~known]
            thickness[bare] = (thickness[own[known]][cKDTree(centre[own[known]]).query(centre[bare])[1]]
                               if known.any() else each.thickness)
    return ShellMesh(points, triangles, wall, thickness)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Normals of the faces of a B-Rep, as the geometry has them."""

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from scipy.spatial import cKDTree

from ..columns import dot

_APART = 1e3
"""Sizes of a part by which the nodes of different faces are moved apart, so that each is looked for on its own face."""


@dataclass(frozen=True)
class RoundFaces:
    """Cylinders, cones, spheres and tori.

    Attributes
    ----------
    faces : ndarray of shape (k,), int64
        Index of each among the faces of the part.
    centres : ndarray of shape (k, 3), mm
        A point of the axis of a cylinder, the apex of a cone, the centre of a sphere or torus.
    axes : ndarray of shape (k, 3)
        Unit vectors.
    has_centre : ndarray of shape (k,), bool
        Spheres and tori, whose normals are those of circles around a centre or a ring.
    major_radii : ndarray of shape (k,), mm
        Of tori; 0 for others.
    slopes : ndarray of shape (k,)
        Tangent of the angle between a cone and its axis; 0 for others.
    """

    faces: np.ndarray
    centres: np.ndarray
    axes: np.ndarray
    has_centre: np.ndarray
    major_radii: np.ndarray
    slopes: np.ndarray

    def normals(self, row, points):
        """Directions of the normals, not of unit length, to one of both sides: ndarray of shape (3, m).

        Not finite on the axis of a cylinder or cone.

        Parameters
        ----------
        row : ndarray of shape (m,), int64
            Which of these faces each point is on.
        points : ndarray of shape (3, m), mm
        """
        axis = self.axes[row].T
        away = points - self.centres[row].T
        height = dot(away, axis)
        away -= height * axis
        radius = np.sqrt(dot(away, away))
        with np.errstate(divide="ignore", invalid="ignore"):
            major = self.major_radii[row]
            round_both_ways = np.where(major > 0.0, 1.0 - major / radius, 1.0)
            radial = np.where(self.has_centre[row], round_both_ways, 1.0 / radius)
            axial = np.where(self.has_centre[row], height, -np.sign(height) * self.slopes[row])
            return radial * away + axial * axis


@dataclass(frozen=True)
class NodeNormals:
    """Normals of free-form faces at some of their points, among them all nodes of the mesh.

    Attributes
    ----------
    faces : ndarray of shape (k,), int64
        Index of the face of each point.
    points : ndarray of shape (k, 3), mm
    normals : ndarray of shape (k, 3)
        To one of both sides.
    tolerance : float, mm
        How far a node of the mesh may be from the point that it is.
    """

    faces: np.ndarray
    points: np.ndarray
    normals: np.ndarray
    tolerance: float

    @cached_property
    def _tree(self):
        return cKDTree(self._apart(self.faces, self.points))

    @cached_property
    def _step(self):
        return _APART * float(np.ptp(self.points, axis=0).max() + self.tolerance)

    def _apart(self, faces, points):
        return np.column_stack([points, faces * self._step])

    def at(self, faces, points):
        """Normals at nodes of the mesh, ndarray of shape (3, m), not finite where a point is no node.

        Parameters
        ----------
        faces : ndarray of shape (m,), int64
        points : ndarray of shape (3, m), mm
        """
        distance, nearest = self._tree.query(self._apart(faces, points.T), distance_upper_bound=self.tolerance)
        found = np.isfinite(distance)
        normals = np.full(points.shape, np.nan)
        normals[:, found] = self.normals[nearest[found]].T
        return normals


@dataclass(frozen=True)
class FaceNormals:
    """Where the geometry says what the normal of the surface is.

    Facets tell it at points that they surround. At the border of a face they are on one side only, and their mean is off by
    half of the angle at which they meet.

    Attributes
    ----------
    count : int
        Number of faces of the part.
    round_faces : RoundFaces
    nodes : NodeNormals
    """

    count: int
    round_faces: RoundFaces
    nodes: NodeNormals

    @cached_property
    def _row(self):
        """ndarray of shape (f,): which of the round faces each face is; -1 for a free-form one and -2 for others."""
        row = np.full(self.count, -2)
        row[self.nodes.faces] = -1
        row[self.round_faces.faces] = np.arange(len(self.round_faces.faces))
        return row

    def renumbered(self, new, count):
        """The same normals under other numbers of the faces: FaceNormals.

        Parameters
        ----------
        new : ndarray of shape (f,), int64
            New number of each face; those that become one lie on one surface.
        count : int
            Number of faces afterwards.
        """
        return FaceNormals(count, replace(self.round_faces, faces=new[self.round_faces.faces]),
                           replace(self.nodes, faces=new[self.nodes.faces]))

    @property
    def is_known(self):
        """ndarray of shape (f,), bool: faces whose normals are known."""
        return self._row > -2

    def at(self, faces, points):
        """Unit normals at nodes of the mesh, to one of both sides; ndarray of shape (3, m), zeros where none is known.

        Parameters
        ----------
        faces : ndarray of shape (m,), int64
            Some that are known.
        points : ndarray of shape (3, m), mm
            In the coordinates of the document.
        """
        row = self._row[faces]
        normals = np.empty_like(points)
        is_round = row >= 0
        normals[:, is_round] = self.round_faces.normals(row[is_round], points[:, is_round])
        if not is_round.all():
            normals[:, ~is_round] = self.nodes.at(faces[~is_round], points[:, ~is_round])
        length = np.sqrt(dot(normals, normals))
        known = np.isfinite(length) & (length > 0.0)
        normals[:, ~known] = 0.0
        normals[:, known] /= length[known]
        return normals

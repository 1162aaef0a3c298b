# SPDX-License-Identifier: LGPL-2.1-or-later
"""A motion that lays one form upon another: turned, perhaps mirrored and scaled, and moved."""

from typing import NamedTuple

import numpy as np


class Motion(NamedTuple):
    """A similarity transform, between coordinates from the centroids of two forms.

    Attributes
    ----------
    turn : ndarray of shape (3, 3)
        Orthogonal; it mirrors where its determinant is -1.
    scale : float
    shift : ndarray of shape (3,), mm
    """

    turn: np.ndarray
    scale: float = 1.0
    shift: np.ndarray = np.zeros(3)

    @property
    def is_mirrored(self):
        """Whether it makes a mirror image."""
        return bool(np.linalg.det(self.turn) < 0.0)

    def points(self, points):
        """Moved points: ndarray of shape (k, 3), mm."""
        return self.scale * (points @ self.turn.T) + self.shift

    def directions(self, directions):
        """Turned directions: ndarray of shape (k, 3)."""
        return directions @ self.turn.T

    def inverse(self):
        """The motion back."""
        return Motion(self.turn.T, 1.0 / self.scale, -(self.shift @ self.turn) / self.scale)

    def between(self, points, others):
        """The motion of the same kind and scale that lays points upon others best (Kabsch 1976,
        doi:10.1107/S0567739476001873).

        Parameters
        ----------
        points, others : ndarray of shape (k, 3), mm
        """
        middle, other_middle = points.mean(axis=0), others.mean(axis=0)
        left, sizes, right = np.linalg.svd((others - other_middle).T @ (points - middle))
        if sizes[1] <= 1e-9 * sizes[0]:  # on a line: any turn about it is as good
            return self
        side = np.sign(np.linalg.det(left @ right)) * np.sign(np.linalg.det(self.turn))
        turn = left @ np.diag([1.0, 1.0, side]) @ right
        return Motion(turn, self.scale, other_middle - self.scale * turn @ middle)

    def nearer(self, points, distance, normals, weights):
        """The motion turned and moved a little further, so that moved points come nearer to a surface: `Motion`.

        Parameters
        ----------
        points : ndarray of shape (k, 3), mm
            As this motion moves them.
        distance : ndarray of shape (k,), mm
            How far they lie outside of the surface.
        normals : ndarray of shape (k, 3)
            Of the surface there.
        weights : ndarray of shape (k,)
        """
        size = max(float(np.abs(points).max()), np.finfo(float).tiny)
        root = np.sqrt(weights)
        rows = np.hstack([np.cross(points, normals) / size, normals]) * root[:, None]
        # A form that can be turned or moved within itself leaves some of it open: the least motion is taken.
        step = np.linalg.lstsq(rows, -distance * root, rcond=1e-6)[0]
        turn = turn_by(step[:3] / size)
        return Motion(turn @ self.turn, self.scale, turn @ self.shift + step[3:])


def turn_by(vector):
    """The turn about a vector by its length in radians: ndarray of shape (3, 3), by the formula of Rodrigues."""
    angle = float(np.linalg.norm(vector))
    if angle < 1e-15:
        return np.eye(3)
    x, y, z = vector / angle
    cross = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    return np.eye(3) + np.sin(angle) * cross + (1.0 - np.cos(angle)) * cross @ cross

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cameras: the direction of view, and the section of a part that a picture shows."""

from dataclasses import dataclass

import numpy as np

MARGIN = 0.03
"""Share of a picture's height that stays empty on each side of the part."""

ISOMETRIC = np.array([[1.0, 1.0, 0.0], [-1.0, 1.0, 2.0], [1.0, -1.0, 1.0]])
ISOMETRIC /= np.linalg.norm(ISOMETRIC, axis=1)[:, None]
"""Rows are the directions to the right, upwards and towards the viewer: FreeCAD's isometric view."""

FROM_BEHIND = np.array([[-1.0, -1.0, 0.0], [-1.0, 1.0, 2.0], [-1.0, 1.0, -1.0]])
FROM_BEHIND /= np.linalg.norm(FROM_BEHIND, axis=1)[:, None]
"""View from the opposite corner, below, of the sides that the isometric view does not show."""


@dataclass(frozen=True)
class Camera:
    """A parallel projection.

    Attributes
    ----------
    axes : ndarray of shape (3, 3)
        Rows are the directions to the right, upwards and towards the viewer.
    centre : ndarray of shape (3,), mm
        The point in the middle of the picture.
    scale : float
        Pixels per mm.
    width, height : int
        Size of the picture, pixels.
    """

    axes: np.ndarray
    centre: np.ndarray
    scale: float
    width: int
    height: int

    def project(self, points):
        """Project points, ndarray of shape (..., 3), mm, into the picture: ndarray of the same shape.

        To the right and downwards from the upper left corner, and towards the viewer, in pixels.
        """
        projected = (points - self.centre) @ self.axes.T
        projected *= np.array([self.scale, -self.scale, self.scale])
        projected[..., :2] += 0.5 * np.array([self.width, self.height])
        return projected


def framing(points, axes, width, height):
    """Make a camera that shows all points as large as possible.

    Parameters
    ----------
    points : ndarray of shape (n, 3), mm
    axes : ndarray of shape (3, 3)
        See `Camera`.
    width, height : int
        Pixels.
    """
    projected = points @ axes.T
    low, high = projected.min(axis=0), projected.max(axis=0)
    free = np.array([width, height]) - 2.0 * MARGIN * height
    extent = max(float(np.linalg.norm(high - low)), np.finfo(float).tiny)
    scale = (free / np.maximum(high - low, 1e-9 * extent)[:2]).min()
    return Camera(axes, 0.5 * (low + high) @ axes, float(scale), width, height)


def looking_from(towards):
    """Compute the axes of a camera from the direction to the viewer, shape (3,), with z upwards as far as possible."""
    towards = towards / np.linalg.norm(towards)
    up = np.array([0.0, 0.0, 1.0]) if abs(towards[2]) < 0.99 else np.array([0.0, 1.0, 0.0])
    right = np.cross(up, towards)
    right /= np.linalg.norm(right)
    return np.array([right, np.cross(towards, right), towards])

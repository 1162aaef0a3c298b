"""From where a part is looked at, and what of it a picture holds."""

from dataclasses import dataclass

import numpy as np

MARGIN = 0.03
"""Share of a picture's height that stays free on each side of what it shows."""

ISOMETRIC = np.array([[1.0, 1.0, 0.0], [-1.0, 1.0, 2.0], [1.0, -1.0, 1.0]])
ISOMETRIC /= np.linalg.norm(ISOMETRIC, axis=1)[:, None]
"""Rows are the directions to the right, upwards and towards the viewer: FreeCAD's isometric view."""

FROM_BEHIND = np.array([[-1.0, -1.0, 0.0], [-1.0, 1.0, 2.0], [-1.0, 1.0, -1.0]])
FROM_BEHIND /= np.linalg.norm(FROM_BEHIND, axis=1)[:, None]
"""From the opposite corner, below: the sides that the other view does not show."""


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
        Pixels for a mm.
    width, height : int
        Of the picture, in pixels.
    """

    axes: np.ndarray
    centre: np.ndarray
    scale: float
    width: int
    height: int

    def project(self, points):
        """Places in the picture.

        Parameters
        ----------
        points : ndarray of shape (..., 3), mm

        Returns
        -------
        ndarray of shape (..., 3)
            To the right and downwards from the upper left corner, and towards the viewer, in pixels.
        """
        seen = (points - self.centre) @ self.axes.T
        seen *= np.array([self.scale, -self.scale, self.scale])
        seen[..., :2] += 0.5 * np.array([self.width, self.height])
        return seen


def framing(points, axes, width, height):
    """A camera that shows all points as large as possible.

    Parameters
    ----------
    points : ndarray of shape (n, 3), mm
    axes : ndarray of shape (3, 3)
        See `Camera`.
    width, height : int
        Pixels.
    """
    seen = points @ axes.T
    low, high = seen.min(axis=0), seen.max(axis=0)
    free = np.array([width, height]) - 2.0 * MARGIN * height
    extent = max(float(np.linalg.norm(high - low)), np.finfo(float).tiny)
    scale = (free / np.maximum(high - low, 1e-9 * extent)[:2]).min()
    return Camera(axes, 0.5 * (low + high) @ axes, float(scale), width, height)


def looking_from(towards):
    """Axes of a camera, z upwards as far as possible.

    Parameters
    ----------
    towards : ndarray of shape (3,)
        Direction from the part to the viewer.
    """
    towards = towards / np.linalg.norm(towards)
    up = np.array([0.0, 0.0, 1.0]) if abs(towards[2]) < 0.99 else np.array([0.0, 1.0, 0.0])
    right = np.cross(up, towards)
    right /= np.linalg.norm(right)
    return np.array([right, np.cross(towards, right), towards])

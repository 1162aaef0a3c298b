# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which places of thickness maps are seen from an eye, and which ones the parts themselves hide."""

import numpy as np

from ..rays.line_of_sight import Scene
from ..rays.ray_casting import INNER, OUTER
from ..rigid_transform import inverse, transform_directions, transform_points


class MapSight:
    """The surfaces of the parts of a map, at all their occurrences.

    Attributes
    ----------
    scenes : list of Scene
        One for each part, where its first occurrence stands.
    """

    def __init__(self, parts):
        self.scenes = [Scene(part.map.corners + part.map.origin) for part in parts]
        self._back = [np.array([inverse(matrix) for matrix in part.matrices]) for part in parts]

    def are_free(self, points, directions, limits):
        """Whether nothing stands between places and an eye: ndarray of shape (k,), bool.

        Parameters
        ----------
        points : ndarray of shape (k, 3), mm
            In the coordinates of the document when it was measured.
        directions : ndarray of shape (k, 3)
            Unit vectors towards the eye.
        limits : ndarray of shape (k,), mm
            How far the eye is, or what else ends the line of sight; inf where nothing does.
        """
        free = np.ones(len(points), dtype=bool)
        for scene, backs in zip(self.scenes, self._back):
            starts = np.concatenate([transform_points(back, points) for back in backs])
            lines = np.concatenate([transform_directions(back, directions) for back in backs])
            ends = np.tile(limits, len(backs))
            for side in (INNER, OUTER):
                found = scene.distances_within(starts, lines, ends, side) < ends
                free &= ~found.reshape(len(backs), -1).any(axis=0)
        return free

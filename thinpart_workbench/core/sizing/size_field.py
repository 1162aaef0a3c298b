# SPDX-License-Identifier: LGPL-2.1-or-later
"""The element size at any point: smallest at its sources, from there on growing with the distance."""

import numpy as np
from scipy.spatial import cKDTree

LEVELS_PER_FACTOR = 1.1
"""Sources whose sizes differ by up to this factor are searched together, all with the least size among them."""


class SizeField:
    """Element size as a function of the place.

    Parameters
    ----------
    sources : SizeSources
    global_size : float, mm
        Greatest size.
    growth : float
        Greatest ratio of the sizes of neighbouring elements: over the length of one, the size grows by no more.

    Attributes
    ----------
    least : float, mm
        Least size.
    slope : float
        Growth of the size by distance.
    """

    def __init__(self, sources, global_size, growth):
        sources = sources.below(global_size)
        self.global_size, self.slope = global_size, growth - 1.0
        self.least = float(sources.sizes.min()) if sources.count else global_size
        self._trees = []
        if sources.count:
            level = np.floor(np.log(sources.sizes / self.least) / np.log(LEVELS_PER_FACTOR)).astype(np.int64)
            for number in np.unique(level):
                own = level == number
                self._trees.append((float(sources.sizes[own].min()), cKDTree(sources.points[own]),
                                    np.append(sources.radius[own], 0.0)))

    def at(self, points):
        """Size at points, ndarray of shape (n, 3), mm: ndarray of shape (n,), mm."""
        size = np.full(len(points), self.global_size)
        for least, tree, radius in self._trees:
            asking = np.flatnonzero(size > least)
            if not len(asking):
                break
            farthest = (self.global_size - least) / self.slope + radius.max()
            distance, source = tree.query(points[asking], distance_upper_bound=farthest)
            beyond = np.maximum(distance - radius[source], 0.0)
            size[asking] = np.minimum(size[asking], least + self.slope * beyond)
        return size

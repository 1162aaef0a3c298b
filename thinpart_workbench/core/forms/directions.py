# SPDX-License-Identifier: LGPL-2.1-or-later
"""How the faces of a part are turned to each other, whatever its position, its size and its side in a mirror."""

import numpy as np

BINS = 15
"""Intervals of the cosine from -1 to 1: an odd number, so that faces at right angles lie in the middle of one."""

_POINTS = 256


def direction_distribution(outline):
    """Share of pairs of places of a surface whose outward normals have at most a cosine to each other.

    Returns an ndarray of shape (BINS,), the cumulated share at the end of each interval; the last is 1. As the shape
    distributions of Osada et al. 2002 (doi:10.1145/571647.571648), with normals instead of distances.

    Parameters
    ----------
    outline : Outline
    """
    # Evenly along the faces, whose points lie side by side.
    chosen = np.unique(np.linspace(0, outline.count - 1, _POINTS).astype(np.int64))
    few = outline.chosen(chosen)
    cosines = few.normals @ few.normals.T
    place = np.clip(((cosines + 1.0) * (0.5 * BINS)).astype(np.int64), 0, BINS - 1)
    shares = np.bincount(place.ravel(), np.outer(few.area, few.area).ravel(), BINS).cumsum()
    return shares / shares[-1]

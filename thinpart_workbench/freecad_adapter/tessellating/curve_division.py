# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compute into how many pieces a curve has to be divided."""

import math

import numpy as np

_FEWEST_POINTS = 24
_MOST_POINTS = 1 << 17
_LEAST_LENGTH_SHARE = 0.99
"""Least share of a curve's length that the chords between its points must have. With too few points, all of them may
lie on the same side of a helix."""


class CurveDivision:
    """A curve, sampled densely enough to know how much it turns.

    Parameters
    ----------
    point : callable
        Maps a parameter to a point with x, y, z, mm.
    first, last : float
    length : float, mm
        Of the curve.

    Attributes
    ----------
    length : float, mm
    """

    def __init__(self, point, first, last, length):
        self.length = length
        count = _FEWEST_POINTS
        while True:
            chords = np.diff(points_at(point, np.linspace(first, last, count + 1)), axis=0)
            lengths = np.sqrt(np.einsum("ij,ij->i", chords, chords))
            if lengths.sum() >= _LEAST_LENGTH_SHARE * length or count >= _MOST_POINTS:
                break
            count *= 3
        turn = _angles(chords, lengths)
        speed = np.maximum(lengths[1:], lengths[:-1])
        # The turn, and length times turn, if the whole curve were one piece.
        self._turn = float(turn.max(initial=0.0)) * count
        self._bend = float((turn * speed).max(initial=0.0)) * count ** 2
        self._round = self._turn > 1e-6

    def pieces(self, deflection, angle):
        """Number of equal parameter steps that the curve needs.

        Parameters
        ----------
        deflection : float, mm
            Allowed distance between chord and curve: for an arc of length s that turns by a it is s a / 8.
        angle : float, radians
            Allowed turn in one piece.
        """
        if not self._round:
            return 1
        return max(1, math.ceil(self._turn / angle), math.ceil(math.sqrt(self._bend / (8.0 * deflection))))


def points_at(point, parameters):
    """Points of a curve, ndarray of shape (k, 3), mm."""
    return np.array([tuple(point(parameter)) for parameter in parameters.tolist()])


def _angles(chords, lengths):
    """Angles between consecutive chords, radians."""
    directions = chords / np.where(lengths > 0.0, lengths, 1.0)[:, None]
    apart = np.linalg.norm(directions[1:] - directions[:-1], axis=1)
    return 2.0 * np.arcsin(np.clip(0.5 * apart, 0.0, 1.0))

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where lines that are near each other cross a free-form face: each crossing is followed from the one before."""

import numpy as np

from .face_places import parameters

_MOST_TURNS = 12
"""Turns of Newton's method; five are enough from a place near by."""

_MET = 1e-9
"""Distance between line and surface, as a share of the length to the crossing, at which they meet."""

_NEARER = 0.5
"""Share of the distance that is left after a turn, at most; where more is, there is no crossing, or none near."""

_LONGEST = 0.25
"""Share of the range of parameters by which one turn may move on."""


class FollowedCrossing:
    """The crossing of a free-form face, followed from line to line by Newton's method.

    To cut a line with such a surface takes OCC 20 times as long, because it looks for all crossings.

    Parameters
    ----------
    face : Part.Face
    point : ndarray of shape (3,), mm
        Near the first crossing.
    """

    def __init__(self, face, point):
        self._face, self._place = face, parameters(face, point)
        first, last, low, high = face.ParameterRange
        self._range = np.array([last - first, high - low])
        self._place = None if self._place is None else np.array(self._place)

    def along(self, start, way, length):
        """The length, mm, to where a line crosses the surface, near a length that is expected; None where it is not found.

        Parameters
        ----------
        start, way : ndarray of shape (3,), mm
            The line begins there; unit vector.
        length : float, mm
        """
        if self._place is None:
            return None
        place, before = self._place, np.inf
        for turn in range(_MOST_TURNS):
            off = start + length * way - np.array(self._face.valueAt(*place))
            apart = float(off @ off)
            if apart <= (_MET * length) ** 2:
                self._place = place
                return length
            if turn > 1 and apart > _NEARER**2 * before:
                return None
            before = apart
            along, across = (np.array(each) for each in self._face.derivative1At(*place))
            try:
                step = np.linalg.solve(np.column_stack([along, across, -way]), off)
            except np.linalg.LinAlgError:
                return None
            share = np.max(np.abs(step[:2]) / (_LONGEST * self._range))
            if not np.isfinite(share) or not (length := length + step[2] / max(1.0, share)) > 0.0:
                return None
            place = place + step[:2] / max(1.0, share)
        return None

    @property
    def is_on_face(self):
        """bool: whether the last crossing is on the face, not on its surface beyond the border."""
        return self._face.isPartOfDomain(*map(float, self._place))

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the colour bar stands in a view, and how large it is."""

from dataclasses import dataclass, replace

from ...freecad_adapter.preferences import PREFERENCES, preference, set_preference
from ..application.qt import QtCore

_NAMES = {"across": "ColourBarAcross", "down": "ColourBarDown", "size": "ColourBarSize"}


@dataclass(frozen=True)
class BarPlace:
    """Shares of the room that a view has beside the bar, so that the bar is never off the screen, whatever its size.

    Attributes
    ----------
    across, down : float
        From 0 (left, top) to 1 (right, bottom).
    size : float
        Of that which the bar has at first.
    """

    across: float
    down: float
    size: float

    @classmethod
    def kept(cls):
        """Where the user has put it last."""
        return cls(**{field: preference(name) for field, name in _NAMES.items()})

    @classmethod
    def at_first(cls):
        """Where it stands until the user moves it."""
        return cls(**{field: PREFERENCES[name].default for field, name in _NAMES.items()})

    def keep(self):
        """Use this place from now on, also for other maps."""
        for field, name in _NAMES.items():
            set_preference(name, getattr(self, field))

    def of_size(self, size):
        """Here with another size, as far as it is allowed."""
        low, high = PREFERENCES[_NAMES["size"]].range
        return replace(self, size=min(max(float(size), low), high))

    def corner(self, free, width, height, margin):
        """QPoint of the left upper corner of a bar.

        Parameters
        ----------
        free : QRect
            Where it may stand.
        width, height : int
            Its size.
        margin : int
            Distance from the edges.
        """
        across, down = (max(0, room) for room in _rooms(free, width, height, margin))
        left, top = free.left() + margin + round(self.across * across), free.top() + margin + round(self.down * down)
        # A view that has no room for the margins.
        return QtCore.QPoint(max(free.left(), min(left, free.left() + free.width() - width)),
                             max(free.top(), min(top, free.top() + free.height() - height)))

    def with_corner(self, corner, free, width, height, margin):
        """The place at which the left upper corner of a bar is a QPoint, or as near to it as it may stand."""
        found = []
        for now, position, start, room in zip(
                (self.across, self.down), (corner.x(), corner.y()), (free.left(), free.top()),
                _rooms(free, width, height, margin)):
            found.append(now if room <= 0 else min(max((position - start - margin) / room, 0.0), 1.0))
        return replace(self, across=found[0], down=found[1])


def _rooms(free, width, height, margin):
    return free.width() - width - 2 * margin, free.height() - height - 2 * margin

"""The lines of thickness maps, found while the window goes on."""

import threading

from ..core.map_outline import outline
from .qt import QtCore

_POLL = 20  # ms
_AT_ONCE = 5_000
"""Facets of maps whose lines take no time."""


class Outlines(QtCore.QObject):
    """Finds the lines of maps in a thread; numpy leaves Python's lock alone meanwhile.

    Parameters
    ----------
    maps : list of ThicknessMap
    take : callable
        Called in the window's thread with the list of what `outline` returns.
    """

    def __init__(self, maps, take):
        super().__init__()
        self._maps, self._take, self._found = maps, take, None
        self._timer = QtCore.QTimer(self)
        self._timer.timeout.connect(self._look)

    def start(self):
        """Begin."""
        if sum(each.count for each in self._maps) <= _AT_ONCE:
            self._find()
            self._look()
            return
        threading.Thread(target=self._find, daemon=True).start()
        self._timer.start(_POLL)

    def stop(self):
        """Leave it: nothing more is called."""
        self._timer.stop()
        self._take = None

    def _find(self):
        self._found = [outline(each) for each in self._maps]

    def _look(self):
        if self._found is not None and self._take is not None:
            take = self._take
            self.stop()
            take(self._found)

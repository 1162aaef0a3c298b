"""Pictures of parts from the cache, read when they are to be seen."""

import time
from collections import OrderedDict

from .qt import QtCore, QtGui, Signal, colour
from .result_table import FAILED_COLOUR
from .verdict_text import category_colour

MOST_KEPT = 600
SLICE_SECONDS = 0.01
"""After reading pictures for this long the window has its turn."""


class PartPictures(QtCore.QObject):
    """Pictures by the file that they are kept in.

    Signals
    -------
    came
        Pictures that were asked for are there now.
    """

    came = Signal()

    def __init__(self, parent=None):
        super().__init__(parent)
        self._kept, self._wanted = OrderedDict(), OrderedDict()
        self._slice = QtCore.QTimer(self, singleShot=True, interval=0)
        self._slice.timeout.connect(self._read)

    def picture(self, part):
        """The part's picture, a QPixmap; None where there is none, or it is not yet read.

        Parameters
        ----------
        part : object
            With ``thumbnail`` where it may have one.
        """
        path = getattr(part, "thumbnail", None)
        if path is None:
            return None
        if path in self._kept:
            self._kept.move_to_end(path)
            return self._kept[path]
        self._wanted[path] = None
        self._slice.start()
        return None

    def forget(self):
        """Look for all pictures anew."""
        self._kept.clear()

    def _read(self):
        end = time.monotonic() + SLICE_SECONDS
        while self._wanted and time.monotonic() < end:
            # What was asked for last is what is to be seen now.
            path, _ = self._wanted.popitem()
            picture = QtGui.QPixmap(path)
            self._kept[path] = None if picture.isNull() else picture
            if len(self._kept) > MOST_KEPT:
                self._kept.popitem(last=False)
        while len(self._wanted) > MOST_KEPT // 4:
            self._wanted.popitem(last=False)  # scrolled past
        if self._wanted:
            self._slice.start()
        self.came.emit()


def neutral_picture(part, size, ratio):
    """What stands for a part without a picture: a solid in its category's colour.

    Parameters
    ----------
    part : object
        With ``category`` and ``error_kind``.
    size : QSize
    ratio : float
        Pixels of the screen per pixel.
    """
    picture = QtGui.QPixmap(size * ratio)
    picture.setDevicePixelRatio(ratio)
    picture.fill(QtCore.Qt.transparent)
    painter = QtGui.QPainter(picture)
    painter.setRenderHint(QtGui.QPainter.Antialiasing)
    rgb = FAILED_COLOUR if part.error_kind else category_colour(part.category)
    line = colour(rgb)
    fill = QtGui.QColor(line)
    fill.setAlpha(45)
    painter.setPen(QtGui.QPen(line, 1.2))
    painter.setBrush(fill)
    x, y, half = size.width() / 2.0, size.height() / 2.0, 0.36 * size.height()
    corners = [QtCore.QPointF(x + half * a, y + half * b) for a, b in (
        (0, -1), (0.9, -0.5), (0.9, 0.5), (0, 1), (-0.9, 0.5), (-0.9, -0.5))]
    painter.drawPolygon(QtGui.QPolygonF(corners))
    centre = QtCore.QPointF(x, y)
    for corner in corners[1::2]:
        painter.drawLine(centre, corner)
    painter.end()
    return picture

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Thumbnails of parts, loaded on demand and cached, and the rows of tables that show them."""

import time
from collections import OrderedDict

from ..application.qt import QtCore, QtGui, Signal, colour
from ..tables.row_model import FAILED_COLOUR
from ..tables.table_view import TableView
from .verdict_text import category_colour

CACHE_SIZE = 600
SLICE_SECONDS = 0.01
"""Maximum time for loading pictures before returning to the event loop."""

_ROW_LINES = 2.6
"""Height of a row with a picture, in lines of text."""


class Thumbnails(QtCore.QObject):
    """Cache of pictures by file path.

    Signals
    -------
    loaded
        Requested pictures have been loaded.
    """

    loaded = Signal()

    def __init__(self, parent=None):
        super().__init__(parent)
        self._cache, self._requested = OrderedDict(), OrderedDict()
        self._load_timer = QtCore.QTimer(self, singleShot=True, interval=0)
        self._load_timer.timeout.connect(self._load)

    def picture(self, part):
        """The picture of a part: QPixmap, or None if there is none or it is not loaded yet.

        Parameters
        ----------
        part : object
            With attribute ``thumbnail`` if it may have a picture.
        """
        path = getattr(part, "thumbnail", None)
        if path is None:
            return None
        if path in self._cache:
            self._cache.move_to_end(path)
            return self._cache[path]
        self._requested[path] = None
        self._load_timer.start()
        return None

    def clear(self):
        """Clear the cache."""
        self._cache.clear()

    def _load(self):
        end = time.monotonic() + SLICE_SECONDS
        while self._requested and time.monotonic() < end:
            # The latest requests are the rows that are visible now.
            path, _ = self._requested.popitem()
            picture = QtGui.QPixmap(path)
            self._cache[path] = None if picture.isNull() else picture
            if len(self._cache) > CACHE_SIZE:
                self._cache.popitem(last=False)
        while len(self._requested) > CACHE_SIZE // 4:
            self._requested.popitem(last=False)  # no longer visible
        if self._requested:
            self._load_timer.start()
        self.loaded.emit()


class RowPictures:
    """The pictures of the rows of a table, as large as its rows are high.

    Parameters
    ----------
    pictures : Thumbnails

    Attributes
    ----------
    size : QSize
    ratio : float
        Device pixel ratio.
    """

    def __init__(self, pictures):
        self._pictures, self._neutral = pictures, {}
        self.size, self.ratio = QtCore.QSize(48, 36), 1.0

    def of(self, part):
        """The picture of a part, or one that stands for it: QPixmap."""
        picture = self._pictures.picture(part)
        if picture is not None:
            scaled = picture.scaled(self.size * self.ratio, QtCore.Qt.KeepAspectRatio, QtCore.Qt.SmoothTransformation)
            scaled.setDevicePixelRatio(self.ratio)
            return scaled
        key = part.category, bool(part.error_kind), self.ratio, self.size.height()
        if key not in self._neutral:
            self._neutral[key] = neutral_picture(part, self.size, self.ratio)
        return self._neutral[key]


class PicturesView(TableView):
    """Shows rows that are as high as the pictures of their parts.

    Its model has ``pictures``, a RowPictures, which stand in the column ``label``; the model is drawn again by
    `show_pictures` once they are loaded. Only those of rows that are seen are.
    """

    def __init__(self, name, model, parent=None):
        super().__init__(name, model, parent)
        self._fit_rows()

    def changeEvent(self, event):
        """Adapt the row height to the font."""
        super().changeEvent(event)
        if event.type() in (QtCore.QEvent.FontChange, QtCore.QEvent.StyleChange):
            self._fit_rows()

    def _fit_rows(self):
        self.set_row_height(_ROW_LINES)
        height = self.verticalHeader().defaultSectionSize()
        size = QtCore.QSize(round((height - 4) * 4 / 3), height - 4)
        self.setIconSize(size)
        pictures = self.model().pictures
        pictures.size, pictures.ratio = size, self.devicePixelRatioF()


def show_pictures(table):
    """Draw the pictures of a RowModel again, which stand in the column of the part."""
    if table.rowCount():
        column = table.number_of("label")
        table.dataChanged.emit(table.index(0, column), table.index(table.rowCount() - 1, column), [QtCore.Qt.DecorationRole])


def neutral_picture(part, size, ratio):
    """Placeholder for a part without a picture: a solid in the colour of its category.

    Parameters
    ----------
    part : object
        With attributes ``category`` and ``error_kind``.
    size : QSize
    ratio : float
        Device pixel ratio.
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

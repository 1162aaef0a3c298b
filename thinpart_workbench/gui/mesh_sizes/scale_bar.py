# SPDX-License-Identifier: LGPL-2.1-or-later
"""A colour bar of lengths, under the check box that shows them on the part."""

import numpy as np

from ..application.length_unit import MILLIMETRE
from ..application.qt import QtCore, QtGui, QtWidgets, colour
from ..application.theme import text_colour

_HEIGHT = 10


class ScaleBar(QtWidgets.QWidget):
    """The colours of a scale from left to right, with the lengths at its ends and between.

    Attributes
    ----------
    ticks : list of (float, str)
        Position from 0 to 1, and the length there.
    """

    def __init__(self, name, parent=None):
        super().__init__(parent)
        self.setObjectName(name)
        self.setSizePolicy(QtWidgets.QSizePolicy.Expanding, QtWidgets.QSizePolicy.Fixed)
        self._scale, self._unit, self.ticks = None, MILLIMETRE, []
        self.hide()

    def show_scale(self, scale, unit):
        """Show a ColourScale; nothing where it has one value only."""
        self._scale, self._unit = scale, unit
        has_range = scale is not None and scale.high > scale.low * (1.0 + 1e-6)
        self.ticks = [(share, (unit.number, unit.text)[share == 1.0](float(scale.thickness_at(share))))
                      for share in (0.0, 0.5, 1.0)] if has_range else []
        self.setVisible(has_range)
        self.update()

    def sizeHint(self):
        """A bar and a line of text."""
        return QtCore.QSize(120, _HEIGHT + 6 + self.fontMetrics().height())

    def paintEvent(self, _event):
        """Draw bar and lengths."""
        if not self.ticks:
            return
        painter, width = QtGui.QPainter(self), self.width()
        colours = self._scale.bar((np.arange(width) + 0.5) / width)
        for column, rgb in enumerate(colours / 255.0):
            painter.fillRect(column, 0, 1, _HEIGHT, colour(tuple(rgb)))
        painter.setPen(text_colour(self))
        box = QtCore.QRectF(0, _HEIGHT + 2, width, self.fontMetrics().height() + 2)
        for (_, text), side in zip(self.ticks, (QtCore.Qt.AlignLeft, QtCore.Qt.AlignHCenter, QtCore.Qt.AlignRight)):
            painter.drawText(box, side, text)
        painter.end()

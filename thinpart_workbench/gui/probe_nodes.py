"""Probes of a thickness map in a 3D scene: both ends, the line between them, and the thickness."""

import numpy as np
from pivy import coin

from .array_fields import fill_numbers, fill_points
from .map_nodes import set_matrix

_INK = (0.85, 0.0, 0.35)


class ProbeNodes:
    """Dimension lines, drawn over everything since they run inside the material.

    Attributes
    ----------
    root : pivy.coin.SoAnnotation
    """

    def __init__(self):
        self.root = coin.SoAnnotation()
        unpicked = coin.SoPickStyle()
        unpicked.style = coin.SoPickStyle.UNPICKABLE
        light = coin.SoLightModel()
        light.model = coin.SoLightModel.BASE_COLOR
        ink = coin.SoBaseColor()
        ink.rgb = _INK
        style = coin.SoDrawStyle()
        style.lineWidth, style.pointSize = 2.0, 7.0
        self._moved = coin.SoMatrixTransform()
        self._ends, self._lines = coin.SoCoordinate3(), coin.SoIndexedLineSet()
        self._texts = coin.SoGroup()
        for node in (unpicked, light, ink, style, self._moved, self._ends, self._lines, coin.SoPointSet(),
                     self._texts):
            self.root.addChild(node)

    def show(self, probes, unit):
        """Show these and no others, list of Probe, with their thickness in a LengthUnit."""
        ends = np.array([(each.point, each.opposite) for each in probes]).reshape(-1, 3)
        fill_points(self._ends.point, ends)
        rows = np.full((len(probes), 3), -1, dtype=np.int32)
        rows[:, :2] = np.arange(2 * len(probes)).reshape(-1, 2)
        fill_numbers(self._lines.coordIndex, rows.ravel())
        self._texts.removeAllChildren()
        for probe, middle in zip(probes, ends.reshape(-1, 2, 3).mean(axis=1)):
            self._texts.addChild(_text(unit.text(probe.value), middle))

    def move(self, matrix):
        """Show everything moved: ndarray of shape (4, 4)."""
        set_matrix(self._moved, matrix)


def _text(text, middle):
    place = coin.SoSeparator()
    translation = coin.SoTranslation()
    translation.translation = tuple(map(float, middle))
    # FreeCAD's own label, a text on a plate, as it draws distances that are measured.
    label = coin.SoType.fromName("SoFrameLabel").createInstance()
    label.set(f'string "{text}" backgroundColor 1 1 1 textColor 0.1 0.1 0.1 size 13')
    place.addChild(translation)
    place.addChild(label)
    return place

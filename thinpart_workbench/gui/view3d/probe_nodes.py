"""Scene graph nodes for probes: both ends, the line between them, and the thickness."""

import numpy as np
from pivy import coin

from ..scene.coin_arrays import fill_numbers, fill_points, set_matrix

_INK = (0.85, 0.0, 0.35)


class ProbeNodes:
    """Dimension lines, drawn over everything because they run inside the material.

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

    def show(self, probes, unit=None):
        """Show a list of Probe instead of the current ones, with the thickness in a LengthUnit if one is given."""
        ends = np.array([(probe.point, probe.opposite) for probe in probes]).reshape(-1, 3)
        fill_points(self._ends.point, ends)
        rows = np.full((len(probes), 3), -1, dtype=np.int32)
        rows[:, :2] = np.arange(2 * len(probes)).reshape(-1, 2)
        fill_numbers(self._lines.coordIndex, rows.ravel())
        self._texts.removeAllChildren()
        if unit is None:
            return
        for probe, middle in zip(probes, ends.reshape(-1, 2, 3).mean(axis=1)):
            self._texts.addChild(_text(unit.text(probe.value), middle))

    def move(self, matrix):
        """Set the transform of all probes: ndarray of shape (4, 4)."""
        set_matrix(self._moved, matrix)


def _text(text, middle):
    separator = coin.SoSeparator()
    translation = coin.SoTranslation()
    translation.translation = tuple(map(float, middle))
    # FreeCAD's own framed label, as used for measured distances.
    label = coin.SoType.fromName("SoFrameLabel").createInstance()
    label.set(f'string "{text}" backgroundColor 1 1 1 textColor 0.1 0.1 0.1 size 13')
    separator.addChild(translation)
    separator.addChild(label)
    return separator

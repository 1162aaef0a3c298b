"""Scene graph nodes of the line through the wall under the mouse."""

import numpy as np
from pivy import coin

from ..scene.coin_arrays import fill_numbers, fill_points

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
        self._ends, self._lines = coin.SoCoordinate3(), coin.SoIndexedLineSet()
        for node in (unpicked, light, ink, style, self._ends, self._lines, coin.SoPointSet()):
            self.root.addChild(node)

    def show(self, probes):
        """Show a list of Probe instead of the current ones."""
        ends = np.array([(probe.point, probe.opposite) for probe in probes]).reshape(-1, 3)
        fill_points(self._ends.point, ends)
        rows = np.full((len(probes), 3), -1, dtype=np.int32)
        rows[:, :2] = np.arange(2 * len(probes)).reshape(-1, 2)
        fill_numbers(self._lines.coordIndex, rows.ravel())

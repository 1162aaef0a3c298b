# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scene graph nodes of the line through the wall under the mouse."""

import numpy as np
from pivy import coin

from ..scene.coin_arrays import fill_points, fill_rows
from ..scene.coin_nodes import add_children, flat_colours, painted, unpickable

_INK = (0.85, 0.0, 0.35)


class ProbeNodes:
    """Dimension lines, drawn over everything because they run inside the material.

    Attributes
    ----------
    root : pivy.coin.SoAnnotation
    """

    def __init__(self):
        self.root = coin.SoAnnotation()
        style = coin.SoDrawStyle()
        style.lineWidth, style.pointSize = 2.0, 7.0
        self._ends, self._lines = coin.SoCoordinate3(), coin.SoIndexedLineSet()
        add_children(self.root, unpickable(), flat_colours(), painted(_INK), style, self._ends, self._lines,
                     coin.SoPointSet())

    def show(self, probes):
        """Show a list of Probe instead of the current ones."""
        ends = np.array([(probe.point, probe.opposite) for probe in probes]).reshape(-1, 3)
        fill_points(self._ends.point, ends)
        fill_rows(self._lines.coordIndex, np.arange(2 * len(probes)).reshape(-1, 2))

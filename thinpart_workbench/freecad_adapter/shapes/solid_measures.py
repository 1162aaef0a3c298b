# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measures for comparing solids, cached per solid because an assembly compares each solid with many others."""

from functools import cached_property

import numpy as np


class SolidMeasures:
    """Measures of one solid, in the order of its faces, edges and corners."""

    def __init__(self, shape):
        self._shape = shape

    @cached_property
    def counts(self):
        """Numbers of faces, edges and corners."""
        return tuple(len(getattr(self._shape, kind)) for kind in ("Faces", "Edges", "Vertexes"))

    @cached_property
    def volume(self):
        """float, mm3."""
        return self._shape.Volume

    @cached_property
    def area(self):
        """float, mm2."""
        return self._shape.Area

    @cached_property
    def face_areas(self):
        """list of float, mm2."""
        return [face.Area for face in self._shape.Faces]

    @cached_property
    def points(self):
        """Points on corners, edges and faces, in this order, ndarray of shape (k, 3), mm."""
        points = [corner.Point for corner in self._shape.Vertexes]
        for edge in self._shape.Edges:
            if not edge.Degenerated:
                first, last = edge.ParameterRange
                points += [edge.valueAt(first + share * (last - first)) for share in (0.3, 0.7)]
        for face in self._shape.Faces:
            left, right, low, high = face.ParameterRange
            points += [face.valueAt(left + share * (right - left), low + share * (high - low))
                       for share in (0.4, 0.7)]
        return np.array([tuple(point) for point in points]).reshape(-1, 3)

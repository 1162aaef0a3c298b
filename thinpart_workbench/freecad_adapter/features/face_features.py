# SPDX-License-Identifier: LGPL-2.1-or-later
"""The label of the feature that made each face of a part."""

import numpy as np

from ...core.rigid_transform import inverse, transform_points
from ..shapes.tolerances import SHAPE_TOLERANCES

_GRIDS = (1, 2, 3, 5, 9, 17)
"""Numbers of points along each parameter of a face, tried in turn until one lies within its borders."""


def face_features(shape, history):
    """The label of the feature that made each face: list of str.

    One label per face, empty if the feature is not known. The list is empty if there is no history.

    Going back from the last feature, a face was made by the first one none of whose sources has it. A source has
    the face if a point within the face lies on the source's boundary: names of faces do not survive an operation,
    surfaces do.

    Parameters
    ----------
    shape : Part.Shape
        Shape of the part.
    history : list of Feature
        From `feature_history`.
    """
    if not history:
        return []
    tolerance = SHAPE_TOLERANCES.moved * shape.BoundBox.DiagonalLength
    boundaries = {}

    def has(number, point):
        if number not in boundaries:
            boundaries[number] = _Boundary(history[number], tolerance)
        return boundaries[number].meets(point)

    return [_feature_label(history, _point_within(face), has) for face in shape.Faces]


def _feature_label(history, point, has):
    if point is None:
        return ""
    number = 0
    while True:
        source = next((index for index in history[number].sources if has(index, point)), None)
        if source is None:
            return history[number].label
        number = source


class _Boundary:
    """The faces of a feature, and the boxes around them."""

    def __init__(self, feature, tolerance):
        self._tolerance = tolerance
        self._inward = inverse(feature.frame)
        self._faces = feature.shape.Faces
        boxes = [face.BoundBox for face in self._faces]
        self._low = np.array([(box.XMin, box.YMin, box.ZMin) for box in boxes]).reshape(-1, 3) - tolerance
        self._high = np.array([(box.XMax, box.YMax, box.ZMax) for box in boxes]).reshape(-1, 3) + tolerance

    def meets(self, point):
        import Part

        point = transform_points(self._inward, point)
        near = np.flatnonzero(((self._low <= point) & (point <= self._high)).all(axis=1))
        vertex = Part.Vertex(*point)
        return any(self._faces[face].distToShape(vertex)[0] <= self._tolerance for face in near)


def _point_within(face):
    """A point of a face that is not on its border, ndarray of shape (3,); None if none was found."""
    left, right, low, high = face.ParameterRange
    for count in _GRIDS:
        shares = (np.arange(count) + 0.5) / count
        for across in shares:
            for up in shares:
                u, v = left + across * (right - left), low + up * (high - low)
                if face.isPartOfDomain(u, v):
                    return np.array(face.valueAt(u, v))
    return None

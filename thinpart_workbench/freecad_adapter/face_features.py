"""The label of the feature that made each face of a part."""

import numpy as np

_SAME_PLACE = 1e-6
"""Share of the diagonal by which a point may lie off a face that it is on."""

_GRIDS = (1, 2, 3, 5, 9, 17)
"""Points along each parameter of a face among which one within its borders is looked for."""


def face_features(shape, history):
    """What made each face.

    Parameters
    ----------
    shape : Part.Shape
        Of the part.
    history : list of Feature
        From `feature_history`.

    Returns
    -------
    list of str
        By face; empty where that is not known. The list is empty where there is no history.

    Notes
    -----
    A face was made by the first object, going back, none of whose sources has it. Whether a source has it is
    asked for one point within the face: names of faces do not survive an operation, surfaces do.
    """
    if not history:
        return []
    slack = _SAME_PLACE * shape.BoundBox.DiagonalLength
    boundaries = {}

    def has(number, point):
        if number not in boundaries:
            boundaries[number] = _Boundary(history[number], slack)
        return boundaries[number].meets(point)

    return [_made_by(history, _point_within(face), has) for face in shape.Faces]


def _made_by(history, point, has):
    if point is None:
        return ""
    number = 0
    while True:
        source = next((each for each in history[number].sources if has(each, point)), None)
        if source is None:
            return history[number].label
        number = source


class _Boundary:
    """The faces of a feature, and the boxes around them."""

    def __init__(self, feature, slack):
        self._slack = slack
        self._inward = np.linalg.inv(feature.frame)
        self._faces = feature.shape.Faces
        boxes = [face.BoundBox for face in self._faces]
        self._low = np.array([(box.XMin, box.YMin, box.ZMin) for box in boxes]).reshape(-1, 3) - slack
        self._high = np.array([(box.XMax, box.YMax, box.ZMax) for box in boxes]).reshape(-1, 3) + slack

    def meets(self, point):
        import Part

        point = self._inward[:3, :3] @ point + self._inward[:3, 3]
        near = np.flatnonzero(((self._low <= point) & (point <= self._high)).all(axis=1))
        vertex = Part.Vertex(*point)
        return any(self._faces[face].distToShape(vertex)[0] <= self._slack for face in near)


def _point_within(face):
    """A point of a face that is not on its border, ndarray of shape (3,); None where none was found."""
    left, right, low, high = face.ParameterRange
    for count in _GRIDS:
        shares = (np.arange(count) + 0.5) / count
        for across in shares:
            for up in shares:
                u, v = left + across * (right - left), low + up * (high - low)
                if face.isPartOfDomain(u, v):
                    return np.array(face.valueAt(u, v))
    return None

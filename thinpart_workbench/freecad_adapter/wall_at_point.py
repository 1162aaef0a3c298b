"""The wall at one place of a solid: exact, by one line through the shape and not through a mesh."""

from dataclasses import dataclass

from .bootstrap import load_freecad

_START = 1e-7
"""Share of the solid's diagonal within which the line meets the face that it starts on."""

_GRID = 9
"""Places of a face that are tried in each direction where its middle is a hole."""


@dataclass(frozen=True)
class Wall:
    """A wall.

    Attributes
    ----------
    thickness : float, mm
    opposite : FreeCAD.Vector
        Where the line leaves the material.
    """

    thickness: float
    opposite: object


def point_on_face(face, place=None):
    """The place of a face that is next to another place.

    Parameters
    ----------
    face : Part.Face
    place : FreeCAD.Vector, optional
        Beside the face where the user clicked on its facets, or where it has moved since.

    Returns
    -------
    FreeCAD.Vector
        In the middle of the face without a place.
    """
    import Part

    if place is not None:
        _, pairs, _ = face.distToShape(Part.Vertex(place))
        return pairs[0][0]
    u, v = _middle(face)
    return face.valueAt(u, v)


def wall_at_point(solid, face, place):
    """The material under a place of a solid, along the normal of the face there.

    Parameters
    ----------
    solid : Part.Solid
    face : Part.Face
        One of the solid's, turned as it is there.
    place : FreeCAD.Vector
        On the face.

    Returns
    -------
    Wall or None
        None where the face has no normal, or nothing lies opposite.
    """
    import Part

    solid_face = next(each for each in solid.Faces if each.isSame(face))
    u, v = solid_face.Surface.parameter(place)
    normal = solid_face.normalAt(u, v)
    diagonal = solid.BoundBox.DiagonalLength
    if normal.Length < 0.5:
        return None  # a pole
    inward = normal * -1.0
    far = place + inward * (2.0 * diagonal)
    line = Part.LineSegment(place, far)
    met = []
    for other in solid.Faces:
        box = other.BoundBox
        box.enlarge(_START * diagonal)
        if not box.intersect(place, inward):
            continue
        met += [(point - place).dot(inward) for point in _crossings(line, other)]
    distances = [each for each in met if each > _START * diagonal]
    if not distances:
        return None
    thickness = min(distances)
    return Wall(thickness, place + inward * thickness)


def _crossings(line, face):
    """Where a line crosses a face: list of Vector."""
    App = load_freecad()
    points, _ = line.intersectCS(face.Surface)
    found = [App.Vector(each.X, each.Y, each.Z) for each in points]
    return [each for each in found if face.isInside(each, face.Tolerance, True)]


def _middle(face):
    """Parameters of a place of a face that is no hole, near its middle."""
    low_u, high_u, low_v, high_v = face.ParameterRange
    shares = sorted(((i + 0.5) / _GRID for i in range(_GRID)), key=lambda each: abs(each - 0.5))
    places = sorted(((su, sv) for su in shares for sv in shares),
                    key=lambda each: (each[0] - 0.5) ** 2 + (each[1] - 0.5) ** 2)
    inside = [(low_u + su * (high_u - low_u), low_v + sv * (high_v - low_v)) for su, sv in places]
    return next((each for each in inside if face.isPartOfDomain(*each)), inside[0])

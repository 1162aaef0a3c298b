# SPDX-License-Identifier: LGPL-2.1-or-later
"""The exact wall thickness at one point of a solid, by intersecting a line with the shape instead of a mesh."""

from dataclasses import dataclass

from ..exact_walls.face_crossings import crossings

_START = 1e-7
"""Share of the solid's diagonal: intersections closer than this belong to the face that the line starts on."""

_GRID = 9
"""Points per direction that are tried on a face whose middle is a hole."""


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


def point_on_face(face, point=None):
    """The point of a face that is nearest to a given point: FreeCAD.Vector.

    Near the middle of the face if no point is given.

    Parameters
    ----------
    face : Part.Face
    point : FreeCAD.Vector, optional
        May lie beside the face: the user clicks on facets, and the face may have moved since.
    """
    import Part

    if point is not None:
        _, pairs, _ = face.distToShape(Part.Vertex(point))
        return pairs[0][0]
    u, v = _middle(face)
    return face.valueAt(u, v)


def wall_at_point(solid, face, point):
    """The wall under a point of a solid, measured along the normal of the face there: Wall or None.

    None if the face has no normal there or no face lies opposite.

    Parameters
    ----------
    solid : Part.Solid
    face : Part.Face
        A face of the solid.
    point : FreeCAD.Vector
        On the face.
    """
    import Part

    solid_face = next(candidate for candidate in solid.Faces if candidate.isSame(face))
    u, v = solid_face.Surface.parameter(point)
    normal = solid_face.normalAt(u, v)
    diagonal = solid.BoundBox.DiagonalLength
    if normal.Length < 0.5:
        return None  # a pole
    inward = normal * -1.0
    far = point + inward * (2.0 * diagonal)
    line = Part.LineSegment(point, far)
    depths = []
    for other in solid.Faces:
        box = other.BoundBox
        box.enlarge(_START * diagonal)
        if not box.intersect(point, inward):
            continue
        depths += [(crossing - point).dot(inward) for crossing in crossings(line, other)]
    distances = [depth for depth in depths if depth > _START * diagonal]
    if not distances:
        return None
    thickness = min(distances)
    return Wall(thickness, point + inward * thickness)


def _middle(face):
    """Parameters of a point near the middle of a face that lies in no hole."""
    low_u, high_u, low_v, high_v = face.ParameterRange
    shares = sorted(((i + 0.5) / _GRID for i in range(_GRID)), key=lambda share: abs(share - 0.5))
    cells = sorted(((su, sv) for su in shares for sv in shares),
                    key=lambda cell: (cell[0] - 0.5) ** 2 + (cell[1] - 0.5) ** 2)
    inside = [(low_u + su * (high_u - low_u), low_v + sv * (high_v - low_v)) for su, sv in cells]
    return next((parameters for parameters in inside if face.isPartOfDomain(*parameters)), inside[0])

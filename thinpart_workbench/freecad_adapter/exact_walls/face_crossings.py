# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where lines cross faces."""

from ..bootstrap import load_freecad


def crossings(line, face):
    """Where a line crosses a face: list of Vector."""
    return [each for each in surface_crossings(line, face) if is_on(face, each)]


def surface_crossings(line, face):
    """Where a line crosses the surface of a face, which may go on beyond it: list of Vector."""
    App = load_freecad()
    import Part

    try:
        points, _ = line.intersectCS(face.Surface)
    except Part.OCCError:
        return []  # a surface that OCC cannot cut
    return [App.Vector(each.X, each.Y, each.Z) for each in points]


def has_formula(face):
    """Whether a face lies on a surface for which crossings have a formula: a plane, cylinder, cone, ball or torus."""
    import Part

    return isinstance(face.Surface, (Part.Plane, Part.Cylinder, Part.Cone, Part.Sphere, Part.Toroid))


def is_on(face, point):
    """Whether a point of the surface of a face is on the face; this takes three times as long as cutting the surface."""
    return face.isInside(point, face.Tolerance, True)

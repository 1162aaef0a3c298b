# SPDX-License-Identifier: LGPL-2.1-or-later
"""On which kinds of surfaces the faces of a solid lie, and on which curves its edges."""

from ...core.forms import face_surfaces as kinds

PLANE = "Part::GeomPlane"
LINE = "Part::GeomLine"

FREE_FORM = ("Part::GeomBSplineSurface", "Part::GeomBezierSurface", "Part::GeomToroid", "Part::GeomOffsetSurface",
             "Part::GeomSurfaceOfRevolution", "Part::GeomSurfaceOfExtrusion")
"""Surfaces on which OCC's mesher is slow or fails. Rods of cylinders and planes take it no time."""


_KINDS = {
    PLANE: (kinds.PLANE, None),
    "Part::GeomCylinder": (kinds.CYLINDER, "Radius"),
    "Part::GeomCone": (kinds.CONE, None),
    "Part::GeomSphere": (kinds.SPHERE, "Radius"),
    "Part::GeomToroid": (kinds.TORUS, "MinorRadius"),
}
"""By FreeCAD's name of a type: the kind in records, and the property that is its radius."""


def face_surfaces(shape):
    """On which kind of surface each face lies, as records name it, and its radius, mm: list of (str, float or None)."""
    return [_face_surface(face) for face in shape.Faces]


def surface_types(shape):
    """FreeCAD's name of the type of each face's surface, list of str; None for a surface without a Python class."""
    return [_surface_type(face) for face in shape.Faces]


def curve_type(edge):
    """FreeCAD's name of the type of an edge's curve, str; None for a curve without a Python class."""
    try:
        return edge.Curve.TypeId
    except (TypeError, RuntimeError):  # the exception differs between versions of FreeCAD
        return None


def _face_surface(face):
    kind, radius = _KINDS.get(_surface_type(face), (kinds.FREE_FORM, None))
    return kind, None if radius is None else float(getattr(face.Surface, radius))


def _surface_type(face):
    try:
        return face.Surface.TypeId
    except (TypeError, RuntimeError):  # the exception differs between versions of FreeCAD
        return None

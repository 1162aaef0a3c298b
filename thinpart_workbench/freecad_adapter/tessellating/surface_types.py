# SPDX-License-Identifier: LGPL-2.1-or-later
"""On which kinds of surfaces the faces of a solid lie, and on which curves its edges."""

PLANE = "Part::GeomPlane"
LINE = "Part::GeomLine"

FREE_FORM = ("Part::GeomBSplineSurface", "Part::GeomBezierSurface", "Part::GeomToroid", "Part::GeomOffsetSurface",
             "Part::GeomSurfaceOfRevolution", "Part::GeomSurfaceOfExtrusion")
"""Surfaces on which OCC's mesher is slow or fails. Rods of cylinders and planes take it no time."""


def surface_types(shape):
    """FreeCAD's name of the type of each face's surface, list of str; None for a surface without a Python class."""
    return [_surface_type(face) for face in shape.Faces]


def curve_type(edge):
    """FreeCAD's name of the type of an edge's curve, str; None for a curve without a Python class."""
    try:
        return edge.Curve.TypeId
    except (TypeError, RuntimeError):  # the exception differs between versions of FreeCAD
        return None


def _surface_type(face):
    try:
        return face.Surface.TypeId
    except (TypeError, RuntimeError):  # the exception differs between versions of FreeCAD
        return None

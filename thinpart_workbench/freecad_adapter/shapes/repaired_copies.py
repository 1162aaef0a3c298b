# SPDX-License-Identifier: LGPL-2.1-or-later
"""Copies of a solid with the same surface, for OCC's mesher, which leaves out faces of some sound solids.

A cone is left out whole where one of its borders, in its parameters, is a rounding error off straight; as a spline it is
meshed. Edges that do not lie on their faces are fitted to them, which divides some faces.
"""

from dataclasses import dataclass

import numpy as np

from ...core.message import message

MOST_FACES = 1000
"""Faces of a solid above which no copies are made: converting takes 10 ms for each of them, and meshing splines as long."""

_PRECISION = 1e-6
"""Relative precision with which a shape is repaired; OCC's own tolerance for edges on their faces."""

_LARGEST_TOLERANCE = 1e-2
"""mm, to which the tolerances of edges may grow while a shape is repaired."""


@dataclass(frozen=True)
class Repair:
    """A way to copy a solid.

    Attributes
    ----------
    copy : callable
        Of a Part.Shape; gives another one, and leaves the solid as it is.
    sentence : callable
        Of what the mesher left out; gives what was done.
    """

    copy: object
    sentence: object


def repaired_copies(solid):
    """Copies of a solid, one after the other, with the `Repair` that made each.

    Yields `copy` (Part.Shape; one solid) and `repair` (Repair).
    """
    import Part

    if len(solid.Faces) > MOST_FACES:
        return
    for repair in REPAIRS:
        try:
            solids = repair.copy(solid).Solids
        except (Part.OCCError, RuntimeError):  # the exception differs between versions of FreeCAD
            continue
        if len(solids) == 1:
            yield solids[0], repair


def faces_of_copy(solid, copy, surface):
    """Which face of the solid each face of a copy came of: ndarray of shape (f,), int64, index into the faces of the solid.

    Parameters
    ----------
    solid, copy : Part.Shape
    surface : Tessellation
        Of the copy.
    """
    import FreeCAD
    import Part

    faces, tolerance = solid.Faces, 2.0 * surface.linear_deflection
    boxes = [face.BoundBox for face in faces]
    for box in boxes:
        box.enlarge(tolerance)
    points = surface.point_of_each_face(len(copy.Faces))
    same_order, found = len(points) == len(faces), np.zeros(len(points), dtype=np.int64)
    for number, point in enumerate(points):
        if not np.isfinite(point).all():
            continue  # it has no triangles, so it does not matter
        place = FreeCAD.Vector(*point)
        if same_order and boxes[number].isInside(place):
            found[number] = number
            continue
        near = [other for other, box in enumerate(boxes) if box.isInside(place)]
        corner = Part.Vertex(place)
        found[number] = min(near, key=lambda other: faces[other].distToShape(corner)[0], default=0)
    return found


def _with_splines(solid):
    return solid.toNurbs()


def _with_fitted_edges(solid):
    copy = solid.copy(True, False)
    copy.fix(_PRECISION, _PRECISION, _LARGEST_TOLERANCE)
    return copy


REPAIRS = (
    Repair(_with_splines, lambda left_out: message(
        "FreeCAD's mesher left out {left_out}: a copy was measured whose surfaces were converted to splines; its volume "
        "agrees with that of the part.", left_out=left_out)),
    Repair(_with_fitted_edges, lambda left_out: message(
        "FreeCAD's mesher left out {left_out}: a copy was measured whose edges were fitted to its faces; check the shape of "
        "the part, and export it again if it is damaged.", left_out=left_out)),
)
"""In the order in which they are tried."""

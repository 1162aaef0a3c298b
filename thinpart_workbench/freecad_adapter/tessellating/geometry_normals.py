"""The normals of curved faces at the nodes of their tessellation."""

import math

import numpy as np

from ...core.mesh.face_normals import FaceNormals, NodeNormals, RoundFaces
from .surface_types import PLANE

_ROUND = {
    "Part::GeomCylinder": lambda surface: (surface.Center, surface.Axis, False, 0.0, 0.0),
    "Part::GeomCone": lambda surface: (surface.Apex, surface.Axis, False, 0.0, math.tan(abs(surface.SemiAngle))),
    "Part::GeomSphere": lambda surface: (surface.Center, (0.0, 0.0, 1.0), True, 0.0, 0.0),
    "Part::GeomToroid": lambda surface: (surface.Center, surface.Axis, True, surface.MajorRadius, 0.0),
}
"""Centre, axis, whether normals go through a centre or ring, major radius in mm and slope of each kind of `RoundFaces`."""


def geometry_normals(shape, offset, tolerance):
    """Normals of the curved faces of a tessellated shape.

    Parameters
    ----------
    shape : Part.Shape
        With its triangulation, if it has free-form faces whose normals are wanted.
    offset : ndarray of shape (3,), mm
        By which the mesh is moved against the shape.
    tolerance : float, mm
        How far a node of the mesh may be from its place on a free-form face.

    Returns
    -------
    FaceNormals
    """
    round_numbers, round_rows, node_counts, node_points, node_normals = [], [], [], [], []
    free_numbers = []
    faces = shape.Faces
    for number, face in enumerate(faces):
        try:
            surface = face.Surface
        except (TypeError, RuntimeError):  # a surface without a Python class; the exception differs between versions
            continue
        kind = surface.TypeId
        if kind == PLANE:
            continue
        if kind in _ROUND:
            centre, axis, has_centre, major, slope = _ROUND[kind](surface)
            round_numbers.append(number)
            round_rows.append((*centre, *axis, has_centre, major, slope))
            continue
        points, normals = _nodes(face, surface)
        free_numbers.append(number)
        node_counts.append(len(points))
        node_points += points
        node_normals += normals
    rows = np.array(round_rows, dtype=float).reshape(-1, 9)
    return FaceNormals(
        len(faces),
        RoundFaces(np.array(round_numbers, dtype=np.int64), rows[:, :3] + offset, rows[:, 3:6], rows[:, 6] > 0.0,
                   rows[:, 7], rows[:, 8]),
        NodeNormals(np.repeat(np.array(free_numbers, dtype=np.int64), node_counts),
                    np.array(node_points, dtype=float).reshape(-1, 3) + offset,
                    np.array(node_normals, dtype=float).reshape(-1, 3), tolerance),
    )


def _nodes(face, surface):
    """Points and normals of the nodes of a face's triangulation."""
    points, normals = [], []
    for u, v in face.getUVNodes():
        try:
            normal = surface.normal(u, v)
        except Exception:  # where a face is drawn together to a point, it has none
            continue
        points.append(surface.value(u, v))
        normals.append(normal)
    return [tuple(point) for point in points], [tuple(normal) for normal in normals]

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The normals of curved faces at the nodes of their tessellation."""

import math

import numpy as np

from ...core.mesh.face_normals import FaceNormals, NodeNormals, RoundFaces
from .surface_types import PLANE

_ANY = (0.0, 0.0, 1.0)

_ROUND = {
    "Part::GeomCylinder": lambda surface: (*surface.Center, *surface.Axis, False, 0.0, 0.0),
    "Part::GeomCone": lambda surface: (*surface.Apex, *surface.Axis, False, 0.0, math.tan(abs(surface.SemiAngle))),
    "Part::GeomSphere": lambda surface: (*surface.Center, *_ANY, True, 0.0, 0.0),
    "Part::GeomToroid": lambda surface: (*surface.Center, *surface.Axis, True, surface.MajorRadius, 0.0),
}
"""What `RoundFaces` has of each kind of surface: centre, axis, whether it counts as a centre, major radius, slope."""


def geometry_normals(faces, parameters, tolerance, offset=(0.0, 0.0, 0.0)):
    """Normals of the curved faces of a tessellated shape: FaceNormals.

    Parameters
    ----------
    faces : list of Part.Face
    parameters : callable
        Of the index of a free-form face; gives the parameters (u, v) of the nodes on it.
    tolerance : float, mm
        How far a node of the mesh may be from its place on a free-form face.
    offset : tuple of three float, mm
        By which the mesh is moved against the faces.
    """
    round_faces, round_rows, free_faces, nodes = [], [], [], []
    for number, face in enumerate(faces):
        try:
            surface = face.Surface
        except (TypeError, RuntimeError):  # it has no Python class; the exception differs between versions
            continue
        kind = surface.TypeId
        if kind in _ROUND:
            round_faces.append(number)
            round_rows.append(_ROUND[kind](surface))
        elif kind != PLANE:
            of_face = _node_rows(surface, parameters(number))
            free_faces += [number] * len(of_face)
            nodes += of_face
    row = np.array(round_rows, dtype=float).reshape(-1, 9)
    node = np.array(nodes, dtype=float).reshape(-1, 6)
    return FaceNormals(
        len(faces),
        RoundFaces(np.array(round_faces, dtype=np.int64), row[:, :3] + offset, row[:, 3:6], row[:, 6] > 0.0, row[:, 7],
                   row[:, 8]),
        NodeNormals(np.array(free_faces, dtype=np.int64), node[:, :3] + offset, node[:, 3:], tolerance),
    )


def _node_rows(surface, parameters):
    """Point and normal of a surface for each of many parameters: list of tuples of six float, mm."""
    rows = []
    for u, v in parameters:
        try:
            normal = surface.normal(u, v)
        except Exception:  # where a surface is drawn together to a point it has none; FreeCAD raises classes of its own
            continue
        rows.append((*surface.value(u, v), *normal))
    return rows

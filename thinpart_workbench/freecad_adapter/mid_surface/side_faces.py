# SPDX-License-Identifier: LGPL-2.1-or-later
"""The faces of one side of a wall: which meet, their shape, and their normals."""

import numpy as np
from scipy.spatial import cKDTree

from .smooth_cuts import edges_between

MOST = 0.75
"""Share of the places of a face that are curved no more than its radius says."""

_BENT_ONCE = ("Part::GeomPlane", "Part::GeomCylinder", "Part::GeomCone")

_GRID = [(0.1 + 0.16 * u, 0.1 + 0.16 * v) for u in range(6) for v in range(6)]


def face_meetings(shape):
    """Length of the edges that two faces share, mm: dict by the indices of the faces, the lower first."""
    return {faces: sum(edge.Length for edge in edges) for faces, edges in edges_between(shape.Faces).items()}


def face_radii(shape):
    """Radius of each face that is curved in both directions, the geometric mean of the two: ndarray of shape (faces,), mm.

    inf where it is flat or bent in one direction only, or FreeCAD has no surface for it.
    """
    return np.array([_radius(face) for face in shape.Faces])


def _radius(face):
    try:
        if face.Surface.TypeId in _BENT_ONCE:
            return np.inf
        low_u, high_u, low_v, high_v = face.ParameterRange
    except (TypeError, RuntimeError):
        return np.inf
    found = []
    for u, v in _GRID:
        try:
            one, other = face.curvatureAt(low_u + u * (high_u - low_u), low_v + v * (high_v - low_v))
        except Exception:  # OCC's errors have several classes: no curvature at a pole
            continue
        found.append(abs(one * other) ** 0.5)
    most = np.quantile(found, MOST) if found else 0.0
    return 1.0 / most if most > 0.0 else np.inf


def side_shape(shape, side):
    """The faces of a WallSide as a shape of their own: those that meet share their edges."""
    import Part

    faces = shape.Faces
    return Part.makeCompound([faces[number] for number in side.faces])


def side_normals(shape, nodes, points, field):
    """Outward normals at nodes, as exact as their faces: ndarray of shape (k, 3).

    Parameters
    ----------
    shape : Part.Shape
    nodes : SideNodes
    points : ndarray of shape (v, 3), mm
    field : ThicknessField
        Its samples say which way is out.
    """
    faces, found = shape.Faces, np.empty((len(nodes.node), 3))
    for face in np.unique(nodes.face):
        rows = np.flatnonzero(nodes.face == face)
        places = points[nodes.node[rows]]
        samples = np.flatnonzero(field.face == face)
        near = samples[cKDTree(field.samples.points[samples] + field.mesh.origin).query(places)[1]]
        rough = field.normals[near]
        exact = _normals(faces[face], places)
        if exact is None:
            exact = rough
        else:
            bad = ~np.isfinite(exact).all(axis=1) | (np.abs(np.einsum("ij,ij->i", exact, rough)) < 0.3)
            exact[bad] = rough[bad]
        turned = np.einsum("ij,ij->i", exact, rough) < 0.0
        found[rows] = np.where(turned[:, None], -exact, exact)
    return found


def _normals(face, places):
    """Normals of a face at places of it; not a number at a pole. None where FreeCAD has no surface for it."""
    import FreeCAD

    try:
        surface = face.Surface
    except (TypeError, RuntimeError):
        return None
    found = np.full((len(places), 3), np.nan)
    for row, place in enumerate(places.tolist()):
        try:
            found[row] = tuple(face.normalAt(*surface.parameter(FreeCAD.Vector(*place))))
        except Exception:  # OCC's errors have several classes: no normal at a pole
            continue
    length = np.linalg.norm(found, axis=1)
    return np.where(length[:, None] > 0.5, found, np.nan)

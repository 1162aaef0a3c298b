"""From a B-Rep solid to triangles."""

import math
from dataclasses import dataclass

import numpy as np

from ..core.errors import MeshError
from .bootstrap import load_freecad


@dataclass(frozen=True)
class Tessellation:
    """Triangles of a shape.

    Attributes
    ----------
    points : ndarray of shape (v, 3), mm
    triangles : ndarray of shape (n, 3), int64
    face_of_triangle : ndarray of shape (n,), int64
        Index into ``shape.Faces``.
    planar_faces : ndarray of shape (f,), bool
    linear_deflection : float, mm
    """

    points: np.ndarray
    triangles: np.ndarray
    face_of_triangle: np.ndarray
    planar_faces: np.ndarray
    linear_deflection: float


def tessellate(shape, linear_deflection, angular_deflection):
    """Tessellate a solid.

    Parameters
    ----------
    shape : Part.Shape
    linear_deflection : float
        Chord error as a share of the diagonal of the bounding box.
    angular_deflection : float, degrees

    Returns
    -------
    Tessellation

    Raises
    ------
    MeshError
        kind ``zero_volume`` or ``unreadable``.

    Notes
    -----
    FreeCAD's meshes are float32: a shape far from the origin is brought there first, or it would
    lose its walls to rounding. The copy carries no triangulation, since a finer one that is already
    on a shape would be used instead of the one asked for.
    """
    load_freecad()
    import MeshPart

    bounds = shape.BoundBox
    diagonal = bounds.DiagonalLength
    if not math.isfinite(diagonal) or diagonal <= 0.0:
        raise MeshError("Its bounding box is empty or not finite.", "zero_volume")
    centre = bounds.Center
    local = shape.copy(True, False)
    local.translate(centre * -1.0)
    deflection = linear_deflection * diagonal
    try:
        mesh = MeshPart.meshFromShape(
            Shape=local, LinearDeflection=deflection,
            AngularDeflection=math.radians(angular_deflection), Relative=False, Segments=True,
        )
    except Exception as error:  # FreeCAD raises its own classes, which differ between versions
        raise MeshError(f"FreeCAD could not tessellate it ({error}).") from None
    if mesh.CountFacets == 0:
        raise MeshError("FreeCAD could not tessellate any of its faces.")
    points, triangles = mesh.Topology
    points = np.array([(p.x, p.y, p.z) for p in points], dtype=np.float64)
    faces = local.Faces
    return Tessellation(
        points + np.array([centre.x, centre.y, centre.z]), np.array(triangles, dtype=np.int64),
        _face_of_triangle(mesh, len(faces)),
        np.array([_is_plane(face) for face in faces], dtype=bool), deflection,
    )


def _face_of_triangle(mesh, faces):
    """Segments come one per face, in the order of the faces, empty ones included."""
    if mesh.countSegments() != faces:
        raise MeshError("FreeCAD did not say which triangle belongs to which face.")
    face_of_triangle = np.zeros(mesh.CountFacets, dtype=np.int64)
    for face in range(faces):
        face_of_triangle[list(mesh.getSegment(face))] = face
    return face_of_triangle


def _is_plane(face):
    try:
        return face.Surface.TypeId == "Part::GeomPlane"
    except (TypeError, RuntimeError):
        # FreeCAD's versions differ in what they raise for a surface that they have no class for. It is
        # taken as curved: its chord error is then measured rather than left out.
        return False

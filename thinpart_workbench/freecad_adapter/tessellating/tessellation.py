# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tessellate a B-Rep solid."""

import math
from dataclasses import dataclass, replace
from itertools import chain
from typing import Optional

import numpy as np

from ...core.errors import MeshError
from ...core.mesh.face_normals import FaceNormals
from ...core.message import message
from ...core.problem import problem_of
from ...system.exit_cause import is_out_of_memory
from ..bootstrap import load_freecad
from ..mesh_arrays import mesh_arrays
from .geometry_normals import geometry_normals

COMFORTABLE_TRIANGLES = 100_000
"""Triangles of a wire or coil above which facets may meet at greater angles. The chord error does not change."""

WIDEST_ANGLE_AT_FIRST = 6.0
"""Greatest angle between facets of a wire with few triangles, degrees."""

WIDEST_ANGLE = math.radians(8.0)
"""Greatest angle between facets around a wire, radians. Its opposite sides appear tilted by this angle, and walls
within 10 degrees count as parallel."""

WIDEST_ANGLE_ALONG = math.radians(30.0)
"""Greatest angle between facets along a wire, where both sides turn alike, radians."""

_DEFLECTION_SHARE = 0.8
"""Share of the requested deflection that grids are made for, because twisted grids deviate a little more."""

_NODE_TOLERANCE = 0.1
"""Share of the requested deflection by which a node of the mesh may be off its place on a free-form face."""


@dataclass(frozen=True)
class Tessellation:
    """Triangles of a shape.

    Attributes
    ----------
    points : ndarray of shape (v, 3), mm
    triangles : ndarray of shape (n, 3), int64
    face_of_triangle : ndarray of shape (n,), int64
        Index into ``shape.Faces``.
    linear_deflection : float, mm
    face_normals : FaceNormals or None
    """

    points: np.ndarray
    triangles: np.ndarray
    face_of_triangle: np.ndarray
    linear_deflection: float
    face_normals: Optional[FaceNormals] = None

    def point_of_each_face(self, count):
        """The centre of the largest triangle of each face, ndarray of shape (count, 3), mm; nan where it has none."""
        corners = self.points[self.triangles]
        doubled = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
        order = np.argsort(doubled)
        found = np.full((count, 3), np.nan)
        found[self.face_of_triangle[order]] = corners[order].mean(axis=1)  # of a face, the last and largest stays
        return found

    def renumbered(self, new, count):
        """The same triangles with other numbers of their faces: Tessellation.

        Parameters
        ----------
        new : ndarray of shape (f,), int64
            New number of each face; several may become one.
        count : int
            Number of faces afterwards.
        """
        return replace(self, face_of_triangle=new[self.face_of_triangle],
                       face_normals=self.face_normals and self.face_normals.renumbered(new, count))


def tessellate(shape, linear_deflection, angular_deflection):
    """Tessellate a solid: Tessellation; raises MeshError of kind ``zero_volume`` or ``unreadable``.

    FreeCAD's meshes are float32, so a shape far from the origin is moved there first; otherwise rounding would
    destroy its walls. The copy is made without triangulation, because FreeCAD would use a finer triangulation that
    the shape already has instead of the requested one.

    Parameters
    ----------
    shape : Part.Shape
    linear_deflection : float
        Chord error as a share of the diagonal of the bounding box.
    angular_deflection : float, degrees
    """
    load_freecad()
    import MeshPart

    bounds = shape.BoundBox
    diagonal = bounds.DiagonalLength
    if not math.isfinite(diagonal) or diagonal <= 0.0:
        raise MeshError(message("Its bounding box is empty or not finite."), "zero_volume")
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
        if is_out_of_memory(error):
            raise MemoryError from None
        raise MeshError(message("FreeCAD could not tessellate it ({problem}).", problem=problem_of(error, message(
            "look in FreeCAD what 'Check geometry' says about it")))) from None
    if mesh.CountFacets == 0:
        raise MeshError(message("FreeCAD could not tessellate any of its faces."))
    points, triangles = mesh_arrays(mesh)
    points += (centre.x, centre.y, centre.z)
    faces = local.Faces
    normals = geometry_normals(
        faces, lambda number: _node_parameters(faces[number]), _NODE_TOLERANCE * deflection, tuple(centre))
    return Tessellation(points, triangles, _face_of_triangle(mesh, len(faces)), deflection, normals)


def tessellate_mapped(faces, diagonal, linear_deflection, angular_deflection):
    """Tessellate a solid on grids: Tessellation; see the module `mapped_faces`. Raises NotMapped.

    Parameters
    ----------
    faces : MappedFaces
    diagonal : float, mm
        Of the solid's bounding box.
    linear_deflection : float
        Chord error as a share of that diagonal.
    angular_deflection : float, degrees
        Widened if there would be too many triangles, as far as the chord error allows.
    """
    deflection = linear_deflection * diagonal
    pieces, _ = mapped_division(faces, deflection, angular_deflection)
    normals = geometry_normals(
        faces.faces, lambda number: faces.parameters(number, pieces), _NODE_TOLERANCE * deflection)
    return Tessellation(*faces.surface(pieces), deflection, normals)


def mapped_division(faces, deflection, angular_deflection):
    """Division of the edges of `MappedFaces`, and the estimated number of triangles.

    Parameters
    ----------
    faces : MappedFaces
    deflection : float, mm
    angular_deflection : float, degrees
    """
    around = along = math.radians(min(angular_deflection, WIDEST_ANGLE_AT_FIRST))
    while True:
        pieces, triangles = faces.divided(_DEFLECTION_SHARE * deflection, around, along)
        if triangles <= COMFORTABLE_TRIANGLES or along >= WIDEST_ANGLE_ALONG:
            return pieces, triangles
        along = min(1.3 * along, WIDEST_ANGLE_ALONG)
        around = max(around, min(along, WIDEST_ANGLE))


def _node_parameters(face):
    """Parameters of the nodes on a face, list of (u, v); none where OCC could not tessellate it."""
    try:
        return face.getUVNodes()
    except RuntimeError:  # it has no triangulation
        return []


def _face_of_triangle(mesh, faces):
    """The face of each triangle. The mesh has one segment per face in the same order, including empty ones."""
    if mesh.countSegments() != faces:
        raise MeshError(message("FreeCAD did not say which triangle belongs to which face."))
    segments = [mesh.getSegment(face) for face in range(faces)]
    sizes = [len(segment) for segment in segments]
    face_of_triangle = np.zeros(mesh.CountFacets, dtype=np.int64)
    face_of_triangle[np.fromiter(chain.from_iterable(segments), np.int64, sum(sizes))] = np.repeat(np.arange(faces), sizes)
    return face_of_triangle

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Surface meshes of a solid, by OCC's mesher or on grids, and of copies of it where faces are left out."""

import math
from dataclasses import replace
from functools import cached_property

import numpy as np

from ...core.analysis_settings import MOST_TRIANGLES
from ...core.errors import MeshError
from ...core.mesh.chord_error import chord_errors
from ...core.mesh.mass_properties import area, volume
from ...core.mesh.surface_mesh import surface_mesh
from ...core.message import message
from ..tessellating.mapped_faces import MappedFaces, NotMapped
from ..tessellating.surface_types import FREE_FORM, PLANE, surface_types
from ..tessellating.tessellation import mapped_division, tessellate, tessellate_mapped
from .repaired_copies import faces_of_copy, repaired_copies

_SLOW_TO_MESH = 10_000
"""Triangles on grids from which free-form faces go straight to grids: OCC makes ten times as many, in minutes."""

_OTHER_ANGLES = (0.7, 0.45)
"""Shares of the angle between facets at which a solid whose mesh is open is tried again: OCC leaves out faces and triangles
of some parts, others at other angles."""

_LAST_ANGLE = 0.33
"""The share that is tried where no copy of the solid has a closed mesh: it makes nine times as many triangles."""

_SAME_AREA = 0.9999
"""Least share of the area of an open mesh that one has which is closed because nothing is left out, not because more is."""

_LEAST_AREA = 0.95
"""Least share of the area that a complete tessellation has; facets reduce the area by less than 1 %, and what a repair
cuts off is little."""

_SAME_VOLUME = 1e-3
"""Relative difference, beside the chord error, up to which a copy has the volume that OCC integrates over its faces."""

_SAME_EXTENT = 0.01
"""Relative difference up to which a copy is as large as the solid, of which the outermost facets may be left out."""

_COARSER = 1.25
"""Factor by which a grid is made coarser until it has few enough triangles."""

_MOST_NAMED = 5
"""Faces that a warning names."""


class SolidMesher:
    """Makes the surface meshes of one solid.

    Parameters
    ----------
    shape : Part.Shape
        One solid.
    measures : SolidMeasures
        Of the shape.
    """

    def __init__(self, shape, measures):
        self._shape, self._measures = shape, measures
        self._repaired = None
        """Copy of which a mesh was closed, and its `Repair`: finer meshes are made of it at once."""

    def surface_mesh(self, settings, linear_deflection):
        """Tessellate.

        Returns `mesh` (SurfaceMesh; its warnings say where it is that of a repaired copy) and `deflections` (ndarray of
        shape (f,), mm; chord error of each face).

        Parameters
        ----------
        settings : AnalysisSettings
        linear_deflection : float
            Share of the diagonal.
        """
        refined = linear_deflection < settings.linear_deflection
        if refined or self._is_slow_to_mesh(settings, linear_deflection):
            mesh = self._mapped_mesh(settings, linear_deflection)
            if mesh is not None:
                return mesh
        if self._repaired is not None:
            again = self._repaired_mesh(*self._repaired, linear_deflection, settings.angular_deflection)
            if again is not None:
                return again
        mesh, _ = first = self._tessellated(linear_deflection, settings.angular_deflection)
        if mesh.watertight and not self._lacks_surface(mesh):
            return first
        mapped = self._mapped_mesh(settings, linear_deflection)
        return mapped or self._closed_mesh(settings, linear_deflection, mesh) or first

    def _tessellated(self, linear_deflection, angular_deflection):
        return self._checked(tessellate(self._shape, linear_deflection, angular_deflection))

    def _checked(self, surface):
        mesh = surface_mesh(
            surface.points, surface.triangles, surface.face_of_triangle, face_normals=surface.face_normals, of_solid=True)
        planar = np.array([kind == PLANE for kind in self._surface_types])
        return mesh, chord_errors(mesh, planar, surface.linear_deflection)

    def _closed_mesh(self, settings, linear_deflection, open_mesh):
        """A watertight surface mesh at a lesser angle or of a copy, and the chord error of each face in mm, or None."""
        if open_mesh.watertight or not self._shape.isClosed():
            return None
        return (self._mesh_at_another_angle(settings, linear_deflection, open_mesh, _OTHER_ANGLES)
                or self._mesh_of_a_copy(settings, linear_deflection, open_mesh)
                or self._mesh_at_another_angle(settings, linear_deflection, open_mesh, (_LAST_ANGLE,)))

    def _mesh_at_another_angle(self, settings, linear_deflection, open_mesh, turns):
        for turn in turns:
            if open_mesh.count > turn ** 2 * MOST_TRIANGLES:
                break
            found = self._tessellated(linear_deflection, turn * settings.angular_deflection)
            if found[0].watertight and area(found[0]) > _SAME_AREA * area(open_mesh):
                return found
        return None

    def _mesh_of_a_copy(self, settings, linear_deflection, open_mesh):
        names = missing_faces(self._shape, open_mesh)
        left_out = named(names) if names else message("parts of its surface")
        for copy, repair in repaired_copies(self._shape):
            warning = repair.sentence(left_out)
            found = self._repaired_mesh(copy, warning, linear_deflection, settings.angular_deflection)
            if found and _has_size_of(open_mesh, found[0]) and self._has_volume_of(copy, *found):
                self._repaired = copy, warning
                return found
        return None

    def _repaired_mesh(self, copy, warning, linear_deflection, angular_deflection):
        """A watertight surface mesh of a copy, with a warning, and the chord error of each face of the solid; or None."""
        try:
            surface = tessellate(copy, linear_deflection, angular_deflection)
            own = faces_of_copy(self._shape, copy, surface)
            mesh, deflections = self._checked(surface.renumbered(own, len(self._surface_types)))
        except MeshError:
            return None
        return (replace(mesh, warnings=(*mesh.warnings, warning)), deflections) if mesh.watertight else None

    def _has_volume_of(self, copy, mesh, deflections):
        """Whether a mesh encloses what OCC integrates over the faces of the solid, or over those of the copy.

        Either integral may be off where an edge is not on its face.
        """
        error = float(deflections @ np.bincount(mesh.face_of_triangle, mesh.areas, minlength=len(deflections)))
        enclosed = volume(mesh)
        return any(abs(enclosed - each) <= error + _SAME_VOLUME * enclosed for each in (self._measures.volume, copy.Volume))

    def finest_deflection(self, settings, target, mesh, deflections):
        """The linear deflection nearest to a target that keeps the mesh within `MOST_TRIANGLES`: float or None.

        Share of the diagonal of the shape's box; None if every finer mesh would have more than `MOST_TRIANGLES`.

        Parameters
        ----------
        settings : AnalysisSettings
        target : float
            Share of the extent of the mesh.
        mesh : SurfaceMesh
            The present mesh.
        deflections : ndarray of shape (f,), mm
            Chord error of each face of the present mesh.
        """
        # FreeCAD's box of a coil or of a spline is larger than what it holds, and so would be a share of its diagonal.
        target *= mesh.extent / self._diagonal
        if self._mapped is None:
            # Assume that every face is doubly curved, and that those that are fine enough stay as they are.
            triangles = np.bincount(mesh.face_of_triangle, minlength=len(deflections))
            expected = (triangles * np.maximum(1.0, deflections / (target * self._diagonal))).sum()
            return None if expected > MOST_TRIANGLES else target
        while target < settings.linear_deflection:
            _, expected = mapped_division(self._mapped, target * self._diagonal, settings.angular_deflection)
            if expected <= MOST_TRIANGLES:
                return target
            target *= _COARSER
        return None

    @cached_property
    def _mapped(self):
        """The `MappedFaces` of the shape, or None if some of its faces cannot be mapped."""
        try:
            return MappedFaces(self._shape, self._surface_types)
        except NotMapped:
            return None

    @cached_property
    def _surface_types(self):
        return surface_types(self._shape)

    @property
    def _has_free_form(self):
        return not set(FREE_FORM).isdisjoint(self._surface_types)

    @property
    def _diagonal(self):
        return self._shape.BoundBox.DiagonalLength

    def _is_slow_to_mesh(self, settings, linear_deflection):
        if not self._has_free_form or self._mapped is None:
            return False
        deflection = linear_deflection * self._diagonal
        angle = math.radians(settings.angular_deflection)
        return self._mapped.divided(deflection, angle, angle)[1] > _SLOW_TO_MESH

    def _lacks_surface(self, mesh):
        """Whether OCC left out surface, as it does with most of a one-turn coil, whose mesh still looks closed."""
        if not self._has_free_form or self._mapped is None:
            return False
        return area(mesh) < _LEAST_AREA * self._measures.area

    def _mapped_mesh(self, settings, linear_deflection):
        """A watertight surface mesh of grids and the chord error of each face in mm, or None."""
        if self._mapped is None:
            return None
        try:
            surface = tessellate_mapped(
                self._mapped, self._diagonal, linear_deflection, settings.angular_deflection)
            mesh = surface_mesh(surface.points, surface.triangles, surface.face_of_triangle, rounding=0.0,
                                face_normals=surface.face_normals)
        except (NotMapped, MeshError):
            return None
        if not mesh.watertight:
            return None
        return mesh, chord_errors(mesh, self._mapped.planar, surface.linear_deflection)


def _has_size_of(open_mesh, mesh):
    """Whether a mesh is as large as one that lacks faces. That may have more area, where its faces cross their borders."""
    return abs(mesh.extent - open_mesh.extent) <= _SAME_EXTENT * mesh.extent and area(mesh) > _LEAST_AREA * area(open_mesh)


def missing_faces(shape, mesh):
    """Names of the faces of a shape that have no triangles in a mesh: list of str."""
    meshed = np.unique(mesh.face_of_triangle)
    return [f"Face{index + 1}" for index in np.setdiff1d(np.arange(len(shape.Faces)), meshed)]


def named(faces):
    """Faces, list of str, as part of a sentence: str."""
    first = ", ".join(faces[:_MOST_NAMED])
    if len(faces) <= _MOST_NAMED:
        return first
    return message("{faces} and {count} more", faces=first, count=len(faces) - _MOST_NAMED)

"""A part as read from a file or document, before it is measured."""

import math
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np

from ...core.analysis_settings import FIRST_LOOK, MOST_TRIANGLES
from ...core.errors import MeshError, ThinPartError
from ...core.mesh.chord_error import chord_errors
from ...core.mesh.mass_properties import area
from ...core.mesh.surface_mesh import surface_mesh, unchecked_mesh
from ...core.mesh.thinned_facets import thinned_facets
from ...core.message import message
from ..tessellating.mapped_faces import MappedFaces, NotMapped
from ..tessellating.surface_types import FREE_FORM, PLANE, surface_types
from ..tessellating.tessellation import mapped_division, tessellate, tessellate_mapped
from .exact_wall import exact_wall
from .solid_measures import SolidMeasures

_SLOW_TO_MESH = 10_000
"""Triangles on grids from which free-form faces go straight to grids: OCC makes ten times as many, in minutes."""

_OTHER_ANGLES = (0.7, 0.45)
"""Shares of the angle between facets at which a solid whose mesh is open is tried again: OCC leaves out faces and triangles
of some parts, others at other angles."""

_SAME_AREA = 0.9999
"""Least share of the area of an open mesh that a finer one has which is closed because nothing is left out, not because
more is."""

_LEAST_AREA = 0.95
"""Least share of the area that a complete tessellation has; facets reduce the area by less than 1 %."""

_MOST_CHECKED = 60_000
"""Triangles up to which a mesh is checked before its first colours: that takes half a second for so many."""

_COARSER = 1.25
"""Factor by which a grid is made coarser until it has few enough triangles."""


@dataclass
class Part:
    """Names and occurrences of a part; `SolidPart` and `MeshedPart` add its geometry.

    Attributes
    ----------
    name, label : str
        Unique name within the document, and the label that people see.
    occurrences : list of Occurrence
    warnings : tuple of str
    """

    name: str
    label: str
    occurrences: list = field(default_factory=list)
    warnings: tuple = ()

    @property
    def instances(self):
        """Number of occurrences, at least 1."""
        return max(1, len(self.occurrences))


@dataclass
class SolidPart(Part):
    """A B-Rep solid.

    Attributes
    ----------
    shape : Part.Shape
        One solid, placed as in its first occurrence.
    """

    shape: object = None

    @cached_property
    def measures(self):
        """The `SolidMeasures` of the shape."""
        return SolidMeasures(self.shape)

    @property
    def can_be_finer(self):
        """Whether the part can be meshed more finely."""
        return True

    def surface_mesh(self, settings, linear_deflection):
        """Tessellate.

        Parameters
        ----------
        settings : AnalysisSettings
        linear_deflection : float
            Share of the diagonal.

        Returns
        -------
        mesh : SurfaceMesh
        deflections : ndarray of shape (f,), mm
            Chord error of each face.
        """
        refined = linear_deflection < settings.linear_deflection
        if refined or self._is_slow_to_mesh(settings, linear_deflection):
            mesh = self._mapped_mesh(settings, linear_deflection)
            if mesh is not None:
                return mesh
        mesh, deflections = first = self._tessellated(linear_deflection, settings.angular_deflection)
        if mesh.watertight and not self._lacks_surface(mesh):
            return first
        mapped = self._mapped_mesh(settings, linear_deflection)
        return mapped or self._closed_mesh(settings, linear_deflection, mesh) or first

    def _tessellated(self, linear_deflection, angular_deflection):
        surface = tessellate(self.shape, linear_deflection, angular_deflection)
        mesh = surface_mesh(
            surface.points, surface.triangles, surface.face_of_triangle, face_normals=surface.face_normals, of_solid=True)
        planar = np.array([kind == PLANE for kind in self._surface_types])
        return mesh, chord_errors(mesh, planar, surface.linear_deflection)

    def _closed_mesh(self, settings, linear_deflection, open_mesh):
        """A watertight surface mesh at a lesser angle and the chord error of each face in mm, or None."""
        if open_mesh.watertight or not self.shape.isClosed():
            return None
        for turn in _OTHER_ANGLES:
            if open_mesh.count > turn ** 2 * MOST_TRIANGLES:
                break
            found = self._tessellated(linear_deflection, turn * settings.angular_deflection)
            if found[0].watertight and area(found[0]) > _SAME_AREA * area(open_mesh):
                return found
        return None

    def coarse_mesh(self):
        """A `SurfaceMesh` for the first colours."""
        return self.surface_mesh(FIRST_LOOK, FIRST_LOOK.linear_deflection)[0]

    def finest_deflection(self, settings, target, mesh, deflections):
        """The linear deflection nearest to a target that keeps the mesh within `MOST_TRIANGLES`.

        Parameters
        ----------
        settings : AnalysisSettings
        target : float
            Share of the extent of the mesh.
        mesh : SurfaceMesh
            The present mesh.
        deflections : ndarray of shape (f,), mm
            Chord error of each face of the present mesh.

        Returns
        -------
        float or None
            Share of the diagonal of the shape's box; None if every finer mesh would have more than `MOST_TRIANGLES`.
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
            return MappedFaces(self.shape, self._surface_types)
        except NotMapped:
            return None

    @cached_property
    def _surface_types(self):
        return surface_types(self.shape)

    @property
    def _has_free_form(self):
        return not set(FREE_FORM).isdisjoint(self._surface_types)

    @property
    def _diagonal(self):
        return self.shape.BoundBox.DiagonalLength

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
        return area(mesh) < _LEAST_AREA * self.measures.area

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

    def exact_wall(self, wall, error):
        """A wall between facets as the faces have it, None where they have none; see `exact_wall`.

        Parameters
        ----------
        wall : Witness
        error : float, mm
            How far facets lie from their faces.
        """
        return exact_wall(self.shape, wall, error)

    def write_brep(self, path):
        """Write the solid to a BREP file; an OSError where that cannot be done."""
        # FreeCAD's exception does not say that a disk is full; Python's does.
        with open(path, "w", encoding="utf-8") as file:
            file.write(self.shape.exportBrepToString())

    def missing_faces(self, mesh):
        """Names of the faces that have no triangles in a mesh."""
        meshed = np.unique(mesh.face_of_triangle)
        missing = np.setdiff1d(np.arange(len(self.shape.Faces)), meshed)
        return [f"Face{index + 1}" for index in missing]


@dataclass
class MeshedPart(Part):
    """A part given as triangles.

    Attributes
    ----------
    points : ndarray of shape (v, 3), mm
    triangles : ndarray of shape (n, 3), int64
    """

    points: np.ndarray = None
    triangles: np.ndarray = None

    @property
    def can_be_finer(self):
        """False: a mesh cannot be refined."""
        return False

    def surface_mesh(self, settings, linear_deflection):
        """The unchanged triangles; see `SolidPart.surface_mesh`."""
        return surface_mesh(self.points, self.triangles), np.zeros(1)

    def coarse_mesh(self):
        """A `SurfaceMesh` for the first colours."""
        if len(self.triangles) > _MOST_CHECKED:
            points, triangles, _ = thinned_facets(self.points, self.triangles, _MOST_CHECKED // 2)
            return unchecked_mesh(points, triangles)
        return surface_mesh(self.points, self.triangles)

    def exact_wall(self, wall, error):
        """The wall as it is: there is no geometry but the triangles."""
        return wall

    def write_brep(self, path):
        """Raise a ThinPartError: triangles are no solid."""
        raise ThinPartError(message("{part} is made of triangles, which are no solid to mesh.", part=self.label), "no_solid")

    def missing_faces(self, mesh):
        """Empty: a mesh has no faces."""
        return []

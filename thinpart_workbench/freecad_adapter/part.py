"""One part as it was found in a file or document, before anything is measured."""

from dataclasses import dataclass, field
from functools import cached_property

import numpy as np

from ..core.chord_error import chord_error
from ..core.surface_mesh import surface_mesh
from .solid_measures import SolidMeasures
from .tessellation import tessellate


@dataclass
class Occurrence:
    """One place at which a part stands in a document.

    Attributes
    ----------
    root : str
        Name of the top object.
    path : str
        Sub-object path below it, empty for the object itself.
    solid : int
        Index of the solid within the object's shape.
    document : str
        Name of the open document that the top object is in; empty for parts of other files.
    """

    root: str
    path: str
    solid: int
    document: str = ""


@dataclass
class Part:
    """What a part is called and where it stands; its geometry is a `SolidPart`'s or `MeshedPart`'s.

    Attributes
    ----------
    name, label : str
        Unique name within the document, and what people call it.
    occurrences : list of Occurrence
    warnings : tuple of str
    """

    name: str
    label: str
    occurrences: list = field(default_factory=list)
    warnings: tuple = ()

    @property
    def instances(self):
        """How often the part occurs."""
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
        """Whether a finer surface mesh can be had."""
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
        deflection : float, mm
            Chord error reached.
        """
        surface = tessellate(self.shape, linear_deflection, settings.angular_deflection)
        mesh = surface_mesh(surface.points, surface.triangles, surface.face_of_triangle)
        return mesh, chord_error(mesh, surface.planar_faces, surface.linear_deflection)

    def missing_faces(self, mesh):
        """Names of faces that came out without triangles."""
        there = np.unique(mesh.face_of_triangle)
        missing = np.setdiff1d(np.arange(len(self.shape.Faces)), there)
        return [f"Face{index + 1}" for index in missing]


@dataclass
class MeshedPart(Part):
    """A part that came as triangles.

    Attributes
    ----------
    points : ndarray of shape (v, 3), mm
    triangles : ndarray of shape (n, 3), int64
    """

    points: np.ndarray = None
    triangles: np.ndarray = None

    @property
    def can_be_finer(self):
        """A mesh is what it is."""
        return False

    def surface_mesh(self, settings, linear_deflection):
        """The triangles as they are; see `SolidPart.surface_mesh`."""
        return surface_mesh(self.points, self.triangles), 0.0

    def missing_faces(self, mesh):
        """None: there are no faces."""
        return []

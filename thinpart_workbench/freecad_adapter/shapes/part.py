# SPDX-License-Identifier: LGPL-2.1-or-later
"""A part as read from a file or document, before it is measured."""

from dataclasses import dataclass, field
from functools import cached_property

import numpy as np

from ...core.analysis_settings import FIRST_LOOK
from ...core.errors import ThinPartError
from ...core.mesh.surface_mesh import surface_mesh, unchecked_mesh
from ...core.mesh.thinned_facets import thinned_facets
from ...core.message import message
from ..exact_walls.exact_place import ExactPlace, exact_place
from ..exact_walls.exact_wall import exact_wall
from ..exact_walls.face_places import wedge_angle
from ..exact_walls.wall_width import goes_on, is_as_wide_as_thick
from ..tessellating.surface_types import face_surfaces
from .brep_file import write_brep
from .edge_lengths import edge_lengths
from .nearest_on_shape import NearestOnSolid, NearestOnTriangles
from .solid_measures import SolidMeasures
from .solid_mesher import SolidMesher, missing_faces

_QUITE_PARALLEL = np.radians(1.0)
"""Angle between its sides up to which a wall is not asked whether it is one."""

_MOST_CHECKED = 60_000
"""Triangles up to which a mesh is checked before its first colours: that takes half a second for so many."""


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

    @cached_property
    def edge_lengths(self):
        """The `EdgeLengths` of the shape."""
        return edge_lengths(self.shape)

    @cached_property
    def face_surfaces(self):
        """The kind and the radius of the surface of each face; see `face_surfaces`."""
        return face_surfaces(self.shape)

    @property
    def can_be_finer(self):
        """Whether the part can be meshed more finely."""
        return True

    @cached_property
    def _mesher(self):
        return SolidMesher(self.shape, self.measures)

    def surface_mesh(self, settings, linear_deflection):
        """A `SurfaceMesh` and the chord error of each face in mm; see `SolidMesher.surface_mesh`."""
        return self._mesher.surface_mesh(settings, linear_deflection)

    def coarse_mesh(self):
        """A `SurfaceMesh` for the first colours."""
        return self.surface_mesh(FIRST_LOOK, FIRST_LOOK.linear_deflection)[0]

    def finest_deflection(self, settings, target, mesh, deflections):
        """The linear deflection nearest to a target that is not too fine; see `SolidMesher.finest_deflection`."""
        return self._mesher.finest_deflection(settings, target, mesh, deflections)

    def exact_wall(self, wall, error):
        """A wall between facets as the faces have it, None where they have none; see `exact_wall`.

        Parameters
        ----------
        wall : Witness
        error : float, mm
            How far facets lie from their faces.
        """
        return exact_wall(self.shape, wall, error)

    def exact_place(self, wall, error, kind, depth, step, least):
        """The thinnest place near a wall between facets, as the faces have it: ExactPlace; see `exact_place`."""
        return exact_place(self.shape, wall, error, kind, depth, step, least)

    def is_more_than_an_edge(self, wall, depth, seems_wide):
        """Whether a tapered wall is more than a broken edge, such as a chamfer: bool.

        It goes on where it is thinnest, `goes_on`, or it `is_as_wide_as_thick`.
        """
        return goes_on(self.shape, wall, depth) or is_as_wide_as_thick(self.shape, wall)

    def rounds_off(self, wall, depth):
        """Whether a wall between nearly parallel sides is the beginning of a rounded edge: bool."""
        faces = self.shape.Faces[wall.face], self.shape.Faces[wall.opposite_face]
        return wedge_angle(faces, wall) > _QUITE_PARALLEL and not self.is_more_than_an_edge(wall, depth, True)

    def nearest_points(self):
        """What finds the points of its faces nearest to others: `NearestOnSolid`."""
        return NearestOnSolid(self.shape)

    def write_brep(self, path):
        """Write the solid to a BREP file; an OSError where that cannot be done."""
        write_brep(self.shape, path)

    def missing_faces(self, mesh):
        """Names of the faces that have no triangles in a mesh."""
        return missing_faces(self.shape, mesh)


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

    edge_lengths = face_surfaces = None
    """There are no edges and faces, only triangles."""

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

    def exact_place(self, wall, error, kind, depth, step, least):
        """The wall as it is, as `exact_wall`: ExactPlace."""
        return ExactPlace(wall)

    def is_more_than_an_edge(self, wall, depth, seems_wide):
        """As samples show it."""
        return seems_wide

    def rounds_off(self, wall, depth):
        """False: what triangles have is not asked."""
        return False

    def nearest_points(self):
        """What finds its points nearest to others: `NearestOnTriangles`."""
        return NearestOnTriangles(self)

    def write_brep(self, path):
        """Raise a ThinPartError: triangles are no solid."""
        raise ThinPartError(message("{part} is made of triangles, which are no solid to mesh.", part=self.label), "no_solid")

    def missing_faces(self, mesh):
        """Empty: a mesh has no faces."""
        return []

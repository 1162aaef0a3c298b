# SPDX-License-Identifier: LGPL-2.1-or-later
"""The points of a part's own geometry nearest to given points."""

import numpy as np

from ...core.analysis_settings import AnalysisSettings
from ...core.forms.nearest_on_mesh import NearestOnMesh
from ..bootstrap import load_freecad
from ..tessellating.surface_types import FREE_FORM

MOST_FREE_FORM = 96
"""Points of free-form faces that are looked at: to find the nearest point of one takes OCC milliseconds."""


class NearestOnSolid:
    """Finds the nearest points of a Part.Solid, in the coordinates of its document."""

    def __init__(self, solid):
        load_freecad()
        import Part

        # Not the solid itself, from which a point in its material is at no distance.
        self._faces, self._vertex = Part.makeCompound(solid.Faces), Part.Vertex
        self._surfaces = [_surface(face) for face in solid.Faces]

    def quick(self, outline):
        """An `Outline` without most of its points on free-form faces."""
        is_slow = np.array([surface is None or surface.TypeId in FREE_FORM for surface in self._surfaces])
        slow = np.flatnonzero(is_slow[np.minimum(outline.face, len(is_slow) - 1)])
        if len(slow) <= MOST_FREE_FORM:
            return outline
        left_out = np.delete(slow, np.linspace(0, len(slow) - 1, MOST_FREE_FORM).astype(np.int64))
        return outline.chosen(np.delete(np.arange(outline.count), left_out))

    def on_faces(self, points, faces):
        """The point of the whole surface on which each face lies nearest to a point: ndarray of shape (k, 3), mm.

        A point stays where it is where the surface has none.

        Parameters
        ----------
        points : ndarray of shape (k, 3), mm
        faces : ndarray of shape (k,), int64
        """
        from FreeCAD import Vector

        found = np.array(points)
        for row, face in enumerate(faces):
            surface = self._surfaces[face] if face < len(self._surfaces) else None
            if surface is None:
                continue
            try:
                found[row] = surface.value(*surface.parameter(Vector(*points[row])))
            except Exception:  # where a surface has no such point; FreeCAD raises classes of its own
                continue
        return found

    def anywhere(self, points):
        """The points of the solid nearest to points: ndarray of shape (k, 3), mm. It takes long."""
        from FreeCAD import Vector

        return np.array([tuple(self._faces.distToShape(self._vertex(Vector(*point)))[1][0][0]) for point in points])


class NearestOnTriangles:
    """Finds the nearest points of a part that is given as triangles, in the coordinates of its document."""

    def __init__(self, part):
        mesh, _ = part.surface_mesh(AnalysisSettings(), None)
        self._nearest, self._origin = NearestOnMesh(mesh), mesh.origin

    def quick(self, outline):
        """The `Outline` as it is."""
        return outline

    def on_faces(self, points, _faces):
        """The points of all triangles nearest to points."""
        return self.anywhere(points)

    def anywhere(self, points):
        """The points of the triangles nearest to points: ndarray of shape (k, 3), mm."""
        return self._nearest.nearest(points - self._origin) + self._origin


def _surface(face):
    try:
        return face.Surface
    except (TypeError, RuntimeError):  # it has no Python class; the exception differs between versions of FreeCAD
        return None
